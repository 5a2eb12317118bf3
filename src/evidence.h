/* SPDX-License-Identifier: MIT
 *
 * Internal: the parts of the quality room's judgement, for those who have other equations behind
 * the nine parameters.
 */
#ifndef INVCAL_EVIDENCE_H
#define INVCAL_EVIDENCE_H

#include "invcal/quality.h"

#define INVCAL_ABSURD_RESIDUAL INVCAL_REAL(0.1) /* rms; above: no readings of one field */

/* What the judgement is made from. */
typedef struct {
    const invcal_residuals *residuals;
    const invcal_settings *settings;
    invcal_real share; /* stored positions over used ones */
    invcal_real noise; /* of one equation, times sqrt(share): the stored ones stand for all */
    invcal_real l[INVCAL_PACKED_SIZE(INVCAL_PARAMETERS)]; /* of H'H in calibrated units (+ prior);
                                                             L^-1 once it has been judged */
} invcal_evidence;

/* noise (also that of e), dof and coverage.
 *
 * stated      in calibrated units over field.
 * parameters  how many the data had to determine: what the prior supplied does not count. */
void invcal_evidence_noise(invcal_evidence *e, invcal_real stated, invcal_real parameters,
                           invcal_quality *q);

/* undetermined, from_prior and the verdict, from L^-1 in e->l; INVCAL_UNDETERMINED. */
invcal_status invcal_evidence_parameters(const invcal_evidence *e, invcal_quality *q);

/* All sigma, from L^-1 in e->l, at the deviation s. */
void invcal_evidence_spread_offset(const invcal_evidence *e, const invcal_real s[6],
                                   invcal_quality *q);
void invcal_evidence_spread_matrix(const invcal_evidence *e, const invcal_real s[6],
                                   invcal_quality *q);

/* INVCAL_BAD_SETTING if a sigma does not fit the number type: raw units, or a prior, beyond reason. */
invcal_status invcal_evidence_check(const invcal_quality *q);

#endif
