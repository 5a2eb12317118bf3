/* SPDX-License-Identifier: MIT
 *
 * Moves and their solution with tables of another size, which the suite has chosen: compiled into
 * it, in addition to those of the library.
 */
#ifndef GYRO_TABLES_H
#define GYRO_TABLES_H

/* In a double library they have other names already. */
#include "invcal/double.h"

#undef invcal_moves_init
#define invcal_moves_init other_init
#undef invcal_moves_set_limits
#define invcal_moves_set_limits other_rails
#undef invcal_moves_feed
#define invcal_moves_feed other_feed
#undef invcal_moves_gap
#define invcal_moves_gap other_gap
#undef invcal_moves_follow
#define invcal_moves_follow other_follow
#undef invcal_moves_reason
#define invcal_moves_reason other_reason
#undef invcal_moves_empty
#define invcal_moves_empty other_empty
#undef invcal_moves_restart
#define invcal_moves_restart other_restart
#undef invcal_unpack
#define invcal_unpack other_unpack
#undef invcal_replay_move
#define invcal_replay_move other_replay_move
#undef invcal_imu_begin
#define invcal_imu_begin other_begin
#undef invcal_imu_sum
#define invcal_imu_sum other_sum
#undef invcal_imu_settings_check
#define invcal_imu_settings_check other_settings_check
#undef invcal_imu_solve
#define invcal_imu_solve other_solve
#include "imu/imu.c"
#include "imu/moves.c"

#endif
