/* throng.h -- many fish at random places in a tank with the size of the 2013 thesis' tank, for
 * tests of the neighbour search. */
#ifndef KINGYO_TESTS_UNIT_SUPPORT_THRONG_H
#define KINGYO_TESTS_UNIT_SUPPORT_THRONG_H

#include "core/base/rng.h"
#include "core/tank/collision/broad_phase.h"
#include "tests/unit/support/pond.h"

static struct broad_phase broad_phase;
static struct fish fish[768];
static const vec3 tank_m = { 1.36f, 0.20f, 0.65f };

/* Updates the broad phase, which is the spatial index of the neighbour search, with all fish at
 * tick `tick`. */
static inline void look(uint32_t tick)
{
    struct perception around = *pond_at(1, tick);
    around.size_m = tank_m;
    broad_phase_update(&broad_phase, fish, (struct broad_phase_search){ 0 }, &around);
}

/* Returns a random number in [low, high] for fish `who`. Equal arguments give equal numbers. */
static inline float draw(uint32_t who, uint32_t purpose, float low, float high)
{
    return rng_range((struct rng_key){ 21, 0, who, purpose }, low, high);
}

/* Places the first `count` fish at random. Their pitch is at most `pitch_max` rad, and their length
 * is at most `length_max` m. */
static inline void fill_at_random(uint32_t count, float pitch_max, float length_max)
{
    for (uint32_t i = 0; i < count; i++) {
        fish[i] = (struct fish){
            .position_m =
                v3(draw(i, 1, -0.65f, 0.65f), draw(i, 2, -0.19f, -0.01f), draw(i, 3, -0.3f, 0.3f)),
            .angles = { draw(i, 4, -F_PI, F_PI), draw(i, 5, -pitch_max, pitch_max), 0.0f },
            WAKIN(draw(i, 6, 0.03f, length_max)),
        };
    }
}

#endif
