/* SPDX-License-Identifier: MIT
 *
 * Moves and their solution with tables of another size, which the suite has chosen: compiled into
 * it, in addition to those of the library.
 */
#ifndef GYRO_TABLES_H
#define GYRO_TABLES_H

#define invcal_moves_rails other_rails
#define invcal_moves_feed other_feed
#define invcal_moves_gap other_gap
#define invcal_moves_follow other_follow
#define invcal_moves_reason other_reason
#define invcal_unpack other_unpack
#define invcal_replay_move other_replay_move
#define invcal_imu_begin other_begin
#define invcal_imu_sum other_sum
#define invcal_imu_settings_check other_settings_check
#define invcal_moves_restart other_restart
#include "imu.c"
#include "moves.c"

#endif
