/* SPDX-License-Identifier: MIT
 *
 * Moves and their solution with tables of another size, which the suite has chosen: compiled into
 * it, in addition to those of the library.
 */
#ifndef GYRO_TABLES_H
#define GYRO_TABLES_H

/* In a double library they have other names already. */
#include "invcal/double.h"

#undef invcal_imu_init
#define invcal_imu_init other_init
#undef invcal_imu_init_nominal
#define invcal_imu_init_nominal other_init_nominal
#undef invcal_imu_set_limits
#define invcal_imu_set_limits other_set_limits
#undef invcal_imu_feed_gyro
#define invcal_imu_feed_gyro other_feed_gyro
#undef invcal_imu_feed
#define invcal_imu_feed other_feed
#undef invcal_imu_gap
#define invcal_imu_gap other_gap
#undef invcali_imu_follow
#define invcali_imu_follow other_follow
#undef invcal_imu_move_reason
#define invcal_imu_move_reason other_move_reason
#undef invcali_moves_empty
#define invcali_moves_empty other_moves_empty
#undef invcali_moves_restart
#define invcali_moves_restart other_moves_restart
#undef invcali_unpack
#define invcali_unpack other_unpack
#undef invcali_replay_move
#define invcali_replay_move other_replay_move
#undef invcali_imu_begin
#define invcali_imu_begin other_begin
#undef invcali_imu_sum
#define invcali_imu_sum other_sum
#undef invcali_imu_settings_check
#define invcali_imu_settings_check other_settings_check
#undef invcali_imu_positions
#define invcali_imu_positions other_positions
#undef invcal_imu_solve
#define invcal_imu_solve other_solve
#undef invcali_imu_solve_of
#define invcali_imu_solve_of other_solve_of
#include "imu/imu.c"
#include "imu/moves.c"

#endif
