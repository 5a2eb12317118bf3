/* SPDX-License-Identifier: MIT */
#include "digest.h"
#include "invcal/result.h"

void digest_calibration(const invcal_calibration *calibration, const invcal_calibration *nominal)
{
    float x[INVCAL_PARAMETERS];

    invcal_deviation(calibration, nominal, x);
    digest_reals("offset", calibration->offset, 3);
    digest_reals("matrix", &calibration->matrix[0][0], 9);
    digest_reals("deviation", x, INVCAL_PARAMETERS);
}

void digest_quality(const invcal_quality *quality, const invcal_calibration *nominal)
{
    const float coverage = invcal_coverage(quality->sigma_dof);
    const float accuracy = invcal_accuracy(quality, 1e-3f);
    float sigma[3];

    invcal_sigma_offset(quality, nominal, sigma);
    digest_reals("sigma_offset", sigma, 3);
    digest_reals("sigma", quality->sigma, INVCAL_PARAMETERS);
    digest_reals("noise", &quality->noise, 1);
    digest_reals("rms", &quality->rms, 1);
    digest_reals("max", &quality->max, 1);
    digest_reals("condition", &quality->condition, 1);
    digest_reals("coverage", &coverage, 1);
    digest_reals("accuracy", &accuracy, 1);
    digest_reals("size", &quality->size, 1);
    digest_bits("left_out", (uint32_t)quality->left_out);
    digest_bits("suspected", (uint32_t)quality->suspected);
    digest_bits("weak", quality->weak);
    digest_bits("held", quality->held);
    digest_bits("positions", quality->positions);
    digest_bits("dof", quality->dof);
    digest_bits("sigma_dof", quality->sigma_dof);
    digest_bits("worst", quality->worst);
    digest_bits("systematic", quality->systematic);
    digest_bits("axis", quality->axis);
    digest_bits("unchecked", quality->unchecked);
    digest_bits("verdict", quality->verdict);
}
