/* easy_fish.c -- finds the fish that are easy to catch. */
#include "core/base/panic.h"
#include "core/game/lesson/lesson.h"
#include "core/game/phases.h"

/* Largest speed of an easy fish. Fish that rest or swim slowly are below this speed. */
#define CALM_M_S 0.05f
/* Largest depth of the middle of an easy fish. A dipped ring is about 5 cm below the surface. */
#define NEAR_SURFACE_M 0.035f
/* Factor by which a marked fish may exceed CALM_M_S and NEAR_SURFACE_M, so that its mark does not
 * flicker. */
#define MARKED_GAIN 1.4f
/* Smallest distances from the fish to a wall and to the rim of a bowl, at which a ring still fits
 * beside the fish. */
#define WALL_ROOM_M 0.06f
#define BOWL_ROOM_M 0.05f

/* Weights of the cost of a fish; the fish with the lowest cost is the easiest. The cost in metres
 * is the distance from the ring to the fish, plus the depth, length and speed of the fish, each
 * multiplied by its weight. */
#define COST_DEPTH 8.0f
#define COST_LENGTH 3.0f
#define COST_SPEED_S 2.0f

/* A fish counts as over the paper if its horizontal distance from the ring's centre is below
 * OVER_SHARE of the ring's radius, and its height above the ring is between OVER_MIN_M and
 * OVER_MAX_M. */
#define OVER_SHARE 0.6f
#define OVER_MIN_M 0.003f
#define OVER_MAX_M 0.045f
#define OVER_M_S 0.10f /* Largest speed of a fish that stays over the paper during a lift. */

static float level_gap_m(vec3 a, vec3 b)
{
    return v3_length(v3(a.x - b.x, 0.0f, a.z - b.z));
}

static bool is_in_reach(const struct world *world, uint32_t player, vec3 at_m)
{
    const struct tank *tank = &world->tank;
    const float own_m = level_gap_m(at_m, world->bowl[player].position_m);
    bool is_free = f_abs(at_m.x) < 0.5f * tank->size_m.x - WALL_ROOM_M &&
                   f_abs(at_m.z) < 0.5f * tank->size_m.z - WALL_ROOM_M;
    for (uint32_t i = 0; i < POI_MAX; i++) {
        const float gap_m = level_gap_m(at_m, world->bowl[i].position_m);
        is_free = is_free && (!world->bowl[i].present ||
                              (gap_m > BOWL_RADIUS_M + BOWL_ROOM_M && gap_m >= own_m));
    }
    return is_free;
}

bool lesson_is_easy(const struct fish *fish, const struct world *world, uint32_t player,
                    bool is_marked)
{
    const float gain = is_marked ? MARKED_GAIN : 1.0f;
    const bool is_calm = fish->gait == GAIT_REST || fish->gait == GAIT_SWIM ||
                         (fish->gait == GAIT_SURFACE && fish->air == AIR_GULPS);
    CORE_ASSERT(player < POI_MAX);
    return is_calm && !fish->falls && fish->startle == 0 && fish->refractory_s <= 0.0f &&
           v3_length(fish->velocity_m_s) < gain * CALM_M_S &&
           fish->position_m.y > -gain * NEAR_SURFACE_M &&
           is_in_reach(world, player, fish->position_m);
}

static bool is_others(const struct lessons *lessons, uint32_t player, uint32_t fish)
{
    bool is_taken = false;
    for (uint32_t i = 0; i < POI_MAX; i++) {
        const struct lesson *other = &lessons->player[i];
        is_taken = is_taken || (i != player && (other->fish == fish || other->ghost.fish == fish));
    }
    return is_taken;
}

uint16_t lesson_easiest_fish(const struct lessons *lessons, const struct world *world,
                             uint32_t player)
{
    uint16_t best = LESSON_NO_FISH;
    float best_m = 0.0f;
    for (uint32_t i = 0; i < world->tank.fish_count; i++) {
        const struct fish *fish = &world->tank.fish[i];
        if (!lesson_is_easy(fish, world, player, false) || is_others(lessons, player, i)) {
            continue;
        }
        const float cost_m = level_gap_m(world->poi[player].position_m, fish->position_m) -
                             COST_DEPTH * fish->position_m.y + COST_LENGTH * fish->length_m +
                             COST_SPEED_S * v3_length(fish->velocity_m_s);
        if (best == LESSON_NO_FISH || cost_m < best_m) {
            best = (uint16_t)i;
            best_m = cost_m;
        }
    }
    return best;
}

bool lesson_fish_is_over(const struct world *world, const struct poi *poi)
{
    bool is_over = false;
    for (uint32_t i = 0; i < world->tank.fish_count; i++) {
        const struct fish *fish = &world->tank.fish[i];
        const float up_m = fish->position_m.y - poi->position_m.y;
        is_over = is_over ||
                  (up_m > OVER_MIN_M && up_m < OVER_MAX_M && fish->gait < GAIT_HELD &&
                   v3_length(fish->velocity_m_s) < OVER_M_S &&
                   level_gap_m(fish->position_m, poi->position_m) < OVER_SHARE * poi_radius_m(poi));
    }
    return is_over;
}
