/* swim_rates.h -- the time constants with which a fish follows its goals; for swim*.c only. */
#ifndef KINGYO_CORE_TANK_BEHAVIOR_SWIM_RATES_H
#define KINGYO_CORE_TANK_BEHAVIOR_SWIM_RATES_H

#include "core/input.h"

#define DT CORE_TICK_S

#define TURN_GAIN_PER_S 3.0f
#define TURN_TAU_S 0.12f
#define BANK_PER_RAD_S (-0.07f) /* Negative as for fish with a high back. */
#define BANK_MAX_RAD 0.2f
#define BANK_TAU_S 0.20f

#define CLIMB_TAU_S 0.35f
#define PITCH_TAU_S 0.30f
#define BRAKE_KEEP 0.9010756f /* exp(-tick / 80 ms): braking with spread pectoral fins. */

#define BLOCKED_SHARE 0.25f /* Share of the blocked speed that is lost in a tick. */
#define TAIL_TAU_S 0.15f
#define STROKE_TAU_S 0.20f
#define BEND_PER_RAD_S (-0.20f) /* In a left turn the tail lies to the left, along the arc. */
#define BEND_TAU_S 0.08f

/* Haste from which turn and bend equal their goals at once and no arc bends the body, because a
 * C-start follows its path exactly in every tick. */
#define HASTE_START (1.0f / (TURN_GAIN_PER_S * DT))

/* Bainbridge 1958 and its low-speed range: f = U / 0.6 L up to 4 L/s, 4/3 (U / L + 1) above. */
#define BEAT_LENGTHS 0.6f
#define BEAT_FAST_LENGTHS_PER_S 4.0f
#define BEAT_MIN_HZ 0.5f

/* Bainbridge 1958: the stroke widens with the beat up to 5 Hz and then keeps its width, a fifth of
 * the length from tip to tip (1 here). The tail trails in a glide. */
#define STROKE_SLOW 0.25f /* Width at the slowest beat. */
#define STROKE_FULL_HZ 5.0f
#define STROKE_GLIDE 0.15f
#define STROKE_TRAIL 0.35f /* Factor on the width beyond the slowest beat. */

#endif
