/* near_miss.c -- detects that a player almost caught a fish. */
#include "core/poi/catch/near_miss.h"

#include "core/base/panic.h"
#include "core/tank/tank.h"

/* Height over the ring's centre up to which a fish counts as over the paper. */
#define OVER_M 0.06f
/* Ticks between two searches for a fish over the paper. */
#define SEARCH_TICKS 6u

/* Stores the index of the fish over the paper that is nearest to the ring's centre. */
static void note_fish_over(struct near_miss *miss, const struct poi *poi, const struct tank *tank,
                           uint32_t tick)
{
    float nearest_m2 = poi_radius_m(poi) * poi_radius_m(poi);
    for (uint32_t i = 0; i < tank->fish_count; i++) {
        const struct fish *fish = &tank->fish[i];
        const vec3 away = v3_sub(fish->position_m, poi->position_m);
        const float side_m2 = away.x * away.x + away.z * away.z;
        if (side_m2 < nearest_m2 && away.y > 0.0f && away.y < OVER_M && fish_swims(fish)) {
            nearest_m2 = side_m2;
            miss->fish = (uint16_t)i;
            miss->over_tick = tick;
        }
    }
}

/* Returns true if the poi leaves the water without a fish, while the last fish that swam over the
 * paper is still near the rim. */
static bool is_missed(const struct near_miss *miss, const struct poi *poi, const struct tank *tank,
                      uint32_t tick)
{
    if (poi->splash_m_s >= 0.0f || poi->carried_count > 0 || miss->over_tick == 0 ||
        tick - miss->over_tick > NEAR_MISS_LIFT_TICKS || miss->fish >= tank->fish_count) {
        return false;
    }
    const struct fish *fish = &tank->fish[miss->fish];
    const vec3 away = v3_flat(v3_sub(fish->position_m, poi->position_m));
    return fish_swims(fish) && v3_length(away) < poi_outer_radius_m(poi) + NEAR_MISS_RIM_M;
}

bool near_miss_tick(struct near_miss *miss, const struct poi *poi, const struct tank *tank,
                    uint32_t slipped, uint32_t tick)
{
    CORE_ASSERT(tick > 0);
    if (poi->is_in && tick % SEARCH_TICKS == 0) {
        note_fish_over(miss, poi, tank, tick);
    }
    const bool is_near = slipped > 0 || is_missed(miss, poi, tank, tick);
    if (!is_near || (miss->tick != 0 && tick - miss->tick < NEAR_MISS_APART_TICKS)) {
        return false;
    }
    miss->tick = tick;
    return true;
}
