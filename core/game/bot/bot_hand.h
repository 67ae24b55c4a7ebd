/* bot_hand.h -- moves the bot's arm and wrist, with limited acceleration and tremor. */
#ifndef KINGYO_CORE_GAME_BOT_BOT_HAND_H
#define KINGYO_CORE_GAME_BOT_BOT_HAND_H

#include <stdint.h>

#include "core/input.h"

#define BOT_HAND_M_S_MAX 2.0f   /* Highest arm speed over a water tank, in m/s. */
#define BOT_HAND_M_S2_MAX 14.0f /* Highest arm acceleration, in m/s2. */
#define BOT_WRIST_RAD_S_MAX 7.0f

struct bot_hand {
    struct poi_target pose; /* Current pose without tremor. */
    vec3 velocity_m_s;
    struct angles turning; /* Angular velocity of each angle in rad/s. */
};

/* Advances the arm by one tick toward `goal` with a bell-shaped speed profile. `speed_m_s` is the
 * maximum speed, and `ease_s` is the time to reach it. The arm comes to rest at `goal`. */
void bot_hand_move(struct bot_hand *hand, const struct poi_target *goal, float speed_m_s,
                   float ease_s);

/* Returns the tremor offset at `tick`. Each component is smaller than `tremor_m`. The tremor is the
 * sum of slow sway, the 9 Hz muscle tremor and noise. `seed` determines the phases. */
vec3 bot_hand_tremor(float tremor_m, uint32_t seed, uint32_t tick);

uint64_t bot_hand_hash(uint64_t hash, const struct bot_hand *hand);

#endif
