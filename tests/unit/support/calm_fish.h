/* calm_fish.h -- selects the fish that a test tries to catch with a scripted poi (paper scoop). */
#ifndef KINGYO_TESTS_UNIT_SUPPORT_CALM_FISH_H
#define KINGYO_TESTS_UNIT_SUPPORT_CALM_FISH_H

#include "core/tank/tank.h"

/* Returns the best target for a simple vertical dip: a slow fish near the ring that swims above the
 * depth `dip_m`, away from the walls. Returns NULL if there is no such fish. */
static inline const struct fish *calmest_fish(const struct tank *tank, vec3 ring_m, float dip_m)
{
    const struct fish *best = NULL;
    float least = 1e9f;
    for (uint32_t i = 0; i < tank->fish_count; i++) {
        const struct fish *fish = &tank->fish[i];
        const vec3 at = fish->position_m;
        const vec3 way = v3_sub(v3(at.x, 0.0f, at.z), v3(ring_m.x, 0.0f, ring_m.z));
        const float effort = v3_length(fish->velocity_m_s) + 0.3f * v3_length(way);
        if (fish->gait < GAIT_HELD && f_abs(at.x) < 0.25f && f_abs(at.z) < 0.17f && at.y > dip_m &&
            effort < least) {
            least = effort;
            best = fish;
        }
    }
    return best;
}

#endif
