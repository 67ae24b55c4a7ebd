/* swim_simd.h -- the rates and time constants with which a fish approaches its goals (speed,
 * heading, pitch), and the SIMD kernels of swim_move() and swim_settle().
 *
 * Only swim.c, swim_move.c and swim_simd.c include this file. core/base/simd.h describes SIMD
 * kernels. */
#pragma once

#include "core/base/simd.h"
#include "core/input.h"
#include "core/tank/behavior/swim.h"

#define DT CORE_TICK_S

#define TURN_GAIN_PER_S 3.0f
#define TURN_TAU_S 0.12f
/* Roll angle of a turning fish in radians, divided by its yaw rate in rad/s. The value is negative,
 * so the fish leans into its turn, as fish with a high back do. */
#define BANK_PER_RAD_S (-0.07f)
#define BANK_MAX_RAD 0.2f
#define BANK_TAU_S 0.20f

#define CLIMB_TAU_S 0.35f
#define PITCH_TAU_S 0.30f
/* Deceleration of a fish that brakes with spread pectoral fins: each tick multiplies the difference
 * between the speed and a lower speed goal by this factor. The value is exp(-8.33 ms / 80 ms),
 * because a tick lasts 8.33 ms and the time constant of braking is 80 ms. */
#define BRAKE_KEEP 0.9010756f

/* Fraction by which a blocked fish loses speed in one tick. If an obstacle blocks a fish, its real
 * speed is lower than `speed_m_s`, and `speed_m_s` falls by this fraction of the difference. */
#define BLOCKED_SHARE 0.25f
#define TAIL_TAU_S 0.15f
#define STROKE_TAU_S 0.20f
/* Bend of a turning fish's body in radians, divided by its yaw rate in rad/s. The body bends along
 * the arc of the turn: in a left turn the tail lies to the left. */
#define BEND_PER_RAD_S (-0.20f)
#define BEND_TAU_S 0.08f

/* Value of `haste` (fish.h) in a C-start, the escape of a startled fish. With this value, the yaw
 * and the bend of the body reach their goals within one tick, so that the fish follows the
 * prescribed path exactly. The prescribed bend is the whole bend: the bend along the arc of a turn
 * (BEND_PER_RAD_S) is not added. */
#define HASTE_START (1.0f / (TURN_GAIN_PER_S * DT))

/* The next three constants define the frequency f of the tail beat at speed U and length L
 * (Bainbridge 1958). f is U / (BEAT_LENGTHS * L) for U / L up to BEAT_FAST_LENGTHS_PER_S, and 4/3 *
 * (U / L + 1) above, but at least BEAT_MIN_HZ. */
#define BEAT_LENGTHS 0.6f
#define BEAT_FAST_LENGTHS_PER_S 4.0f
#define BEAT_MIN_HZ 0.5f

/* The next constants define the amplitude of the tail. An amplitude of 1 means that the tail swings
 * over a fifth of the body length from tip to tip. The amplitude grows with the frequency of the
 * tail beat up to 5 Hz and then stays constant (Bainbridge 1958). In a glide the tail only trails
 * behind the body. */
#define STROKE_SLOW 0.25f /* Amplitude of the tail at the lowest frequency of the tail beat. */
#define STROKE_FULL_HZ 5.0f
#define STROKE_GLIDE 0.15f
/* Factor, in a glide, on the part of the amplitude that grows with the frequency of the tail
 * beat. */
#define STROKE_TRAIL 0.35f

SIMD_BEGIN
/* Does the work of swim_move_all() for the block of fish that begins at `first`: moves the fish and
 * updates their bodies. The caller guarantees that all fish of the block swim and that none falls.
 * The suffix is the number of lanes. */
void swim_move_block_4(const struct shoal *shoal, uint32_t first);
void swim_move_block_8(const struct shoal *shoal, uint32_t first);

/* Does the work of swim_settle_all() for the block of fish that begins at `first`. The caller
 * guarantees that all fish of the block swim and that none falls. */
void swim_settle_block_4(const struct shoal *shoal, uint32_t first);
void swim_settle_block_8(const struct shoal *shoal, uint32_t first);
SIMD_END
