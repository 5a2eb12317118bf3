/* SPDX-License-Identifier: MIT
 *
 * drive.h: the fuzzer's bytes drive a session: rests, moves, any samples, gaps and anything else that
 * can happen to it. Checks it after every event.
 */
#ifndef DRIVE_H
#define DRIVE_H

#include "fuzz.h"
#include "invcal/background.h"

/* Until the bytes end. The background's ages, and its own way to feed, count only if there is one; its
 * session is the session then. */
void drive(invcal_session *session, invcal_background *background, source *s);

#endif
