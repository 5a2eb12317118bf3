/* SPDX-License-Identifier: MIT
 *
 * drive.h: a session is led by the fuzzer's bytes: rests, moves, any samples, gaps and whatever
 * else can be asked of it. After every event it is looked at.
 */
#ifndef DRIVE_H
#define DRIVE_H

#include "fuzz.h"

/* Until the bytes end. The background's ages, and its own way to feed, count only if there is one; its
 * session is the session then. */
void drive(invcal_session *session, invcal_background *background, source *s);

#endif
