/* bot_hand.h -- a bot's arm and wrist: they take time to start, turn and stop, and tremble. */
#ifndef KINGYO_CORE_GAME_BOT_HAND_H
#define KINGYO_CORE_GAME_BOT_HAND_H

#include <stdint.h>

#include "core/input.h"

#define BOT_HAND_M_S_MAX 2.0f     /* No stroke over a tank of water is faster ... */
#define BOT_HAND_M_S2_MAX 14.0f   /* ... nor set going harder. */
#define BOT_WRIST_RAD_S_MAX 7.0f

struct bot_hand {
    struct poi_target pose; /* Where it is, without its tremor. */
    vec3 velocity_m_s;
    struct angles turning;  /* rad/s of each angle. */
};

/* One tick of the way to `goal`, in a bell of speed of `speed_m_s` at most; it is there when it
 * stands there. */
void bot_hand_move(struct bot_hand *hand, const struct poi_target *goal, float speed_m_s,
                   float ease_s);

/* The tremor in a tick: below `tremor_m` along each axis. A sway, the beat of the muscles at 9 Hz
 * and noise, `seed`'s own. */
vec3 bot_hand_tremor(float tremor_m, uint32_t seed, uint32_t tick);

uint64_t bot_hand_hash(uint64_t hash, const struct bot_hand *hand);

#endif
