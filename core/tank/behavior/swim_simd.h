/* swim_simd.h -- the rates and time constants with which a fish follows its goals, and the SIMD
 * kernels of swim_move() and swim_settle().
 *
 * Only swim.c, swim_move.c and swim_simd.c include this file. core/base/simd.h describes SIMD
 * kernels. */
#ifndef KINGYO_CORE_TANK_BEHAVIOR_SWIM_SIMD_H
#define KINGYO_CORE_TANK_BEHAVIOR_SWIM_SIMD_H

#include "core/base/simd.h"
#include "core/input.h"
#include "core/tank/behavior/swim.h"

#define DT CORE_TICK_S

#define TURN_GAIN_PER_S 3.0f
#define TURN_TAU_S 0.12f
/* Roll per yaw rate. The negative value rolls the fish into its turn, as fish with a high back
 * do. */
#define BANK_PER_RAD_S (-0.07f)
#define BANK_MAX_RAD 0.2f
#define BANK_TAU_S 0.20f

#define CLIMB_TAU_S 0.35f
#define PITCH_TAU_S 0.30f
/* Fraction of the difference to a lower speed goal that remains after one tick of braking with
 * spread pectoral fins: exp(-tick / 80 ms). */
#define BRAKE_KEEP 0.9010756f

/* Fraction by which the speed of a blocked fish approaches its real speed in one tick. The real
 * speed is lower because an obstacle blocks the fish. */
#define BLOCKED_SHARE 0.25f
#define TAIL_TAU_S 0.15f
#define STROKE_TAU_S 0.20f
/* Bend per yaw rate. In a left turn the tail lies to the left, along the arc. */
#define BEND_PER_RAD_S (-0.20f)
#define BEND_TAU_S 0.08f

/* Value of `haste` from which turn and bend reach their goals within one tick, and the arc of the
 * turn does not bend the body. A C-start uses this value, because it must follow its path exactly
 * in every tick. */
#define HASTE_START (1.0f / (TURN_GAIN_PER_S * DT))

/* The next three constants define the frequency f of the tail beat at speed U and length L
 * (Bainbridge 1958). f is U / (0.6 * L) for U up to 4 * L per second, and (4 / 3) * (U / L + 1)
 * above. */
#define BEAT_LENGTHS 0.6f
#define BEAT_FAST_LENGTHS_PER_S 4.0f
#define BEAT_MIN_HZ 0.5f

/* Unit of the next constants: a stroke width of 1 means that the tail swings over a fifth of the
 * body length from tip to tip. The stroke widens with the frequency up to 5 Hz and then keeps its
 * width (Bainbridge 1958). In a glide the tail only trails. */
#define STROKE_SLOW 0.25f /* Stroke width at the lowest frequency. */
#define STROKE_FULL_HZ 5.0f
#define STROKE_GLIDE 0.15f
/* Fraction of the stroke width above STROKE_SLOW that remains in a glide. */
#define STROKE_TRAIL 0.35f

SIMD_BEGIN
/* Moves the block of fish that begins at `first` and updates its bodies. The caller guarantees that
 * all fish of the block swim and that none falls. The suffix is the number of lanes. */
void swim_move_block_4(const struct shoal *shoal, uint32_t first);
void swim_move_block_8(const struct shoal *shoal, uint32_t first);

/* Moves each fish of the block that begins at `first` to the position of its body, and does for
 * each fish what swim_settle() does. The caller guarantees that all fish of the block swim and that
 * none falls. */
void swim_settle_block_4(const struct shoal *shoal, uint32_t first);
void swim_settle_block_8(const struct shoal *shoal, uint32_t first);
SIMD_END

#endif
