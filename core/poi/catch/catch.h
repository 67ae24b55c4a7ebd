/* catch.h -- decides which fish lie on a poi (paper scoop), slip off, fall through or are caught.
 *
 * Under water, the paper is a wall for fish. A fish over the paper without enough water to stand
 * upright becomes a carried fish. */
#pragma once

#include "core/output.h"
#include "core/poi/bowl/bowl.h"
#include "core/poi/poi.h"
#include "core/tank/tank.h"

/* Number of fish that fell into bowls in this tick, by cause. Each fish is counted in exactly one
 * of `landed`, `poured` and `walled`. `landed` and `bowled` count for the owner of the bowl, even
 * if another player's poi dropped the fish. `poured` and `walled` are fouls and count for the
 * player whose poi dropped the fish. */
struct catch_result {
    /* Valid catches: the whole ring of the poi was above the water with the fish on it. */
    uint32_t landed;
    /* Fouls: the ring had not been completely above the water, so that the fish was washed into the
     * bowl. */
    uint32_t poured;
    /* Fouls: the ring pressed the fish against a wall of the tank when the fish was captured. */
    uint32_t walled;
    /* All fish that fell into this player's bowl, from any poi and for any cause. */
    uint32_t bowled;
    /* Fish that fell from this player's poi into the water after the whole ring had been above the
     * water with the fish on it. */
    uint32_t slipped;
    /* Place at which a fish fell from this player's poi into the water or into a bowl in this tick,
     * and the velocity of the fish. The velocity is 0 if no fish fell. For display only. */
    vec3 fell_m, fell_m_s;
    uint8_t fell_in_bowl; /* 1 if the fish fell into a bowl. */
};

/* Returns true if fish number `fish` lies on the poi or is falling from the poi. */
bool catch_has_carried(const struct poi *poi, uint32_t fish);

/* Adds a fish that fell from poi number `poi` into bowl number `bowl` to `results`. Asserts that
 * both numbers are below POI_MAX. */
void catch_count(const struct carried_fish *carried, uint32_t poi, uint32_t bowl,
                 struct catch_result results[POI_MAX]);

/* Advances the fish of one poi by one tick (1/120 s). The caller must call this function after the
 * tick of the fish. The function moves and drops the carried fish, captures new fish, and computes
 * the loads on the paper for the next tick.
 *
 * A fish that lay on an earlier poi of the same player returns to the water. Fish that fell into a
 * bowl are added to `results`. Asserts that `poi_index` < POI_MAX. */
void catch_tick(struct poi *poi, uint32_t poi_index, const struct stall *stall, uint32_t tick,
                struct output *output, struct catch_result results[POI_MAX]);
