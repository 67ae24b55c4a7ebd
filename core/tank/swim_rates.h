/* swim_rates.h -- how quickly a fish follows its orders: for swim*.c, nobody else. */
#ifndef KINGYO_CORE_TANK_SWIM_RATES_H
#define KINGYO_CORE_TANK_SWIM_RATES_H

#include "core/input.h"

#define DT CORE_TICK_S

#define TURN_GAIN_PER_S 3.0f
#define TURN_TAU_S 0.12f
#define BANK_PER_RAD_S (-0.07f) /* As fish with a high back do. */
#define BANK_MAX_RAD 0.2f
#define BANK_TAU_S 0.20f

#define CLIMB_TAU_S 0.35f
#define PITCH_TAU_S 0.30f
#define BRAKE_KEEP 0.9010756f /* exp(-tick / 80 ms): with spread pectorals. */

#define BLOCKED_SHARE 0.25f /* Of the speed that it could not make, lost in a tick. */
#define TAIL_TAU_S 0.15f
#define STROKE_TAU_S 0.20f
#define BEND_PER_RAD_S (-0.20f) /* In a left turn the tail lies to the left, along the arc. */
#define BEND_TAU_S 0.08f

/* A C-start is a path, which is followed to the tick: from this haste on, turn and bend are at once
 * what they are ordered to be, and no arc bends the body. */
#define HASTE_START (1.0f / (TURN_GAIN_PER_S * DT))

/* Bainbridge 1958 and its low-speed end: f = U / 0.6 L up to 4 L/s, 4/3 (U / L + 1) above. */
#define BEAT_LENGTHS 0.6f
#define BEAT_FAST_LENGTHS_PER_S 4.0f
#define BEAT_MIN_HZ 0.5f

/* Bainbridge 1958: the stroke widens with the beat up to 5 Hz and then keeps its width, a fifth of
 * the length from tip to tip, which is 1 here. A glide lets the tail trail. */
#define STROKE_SLOW 0.25f /* Of a tail that beats at its slowest. */
#define STROKE_FULL_HZ 5.0f
#define STROKE_GLIDE 0.15f
#define STROKE_TRAIL 0.35f /* Of what the beat is wider than the slowest. */

#endif
