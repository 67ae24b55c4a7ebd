/* fall.c -- moves a fish that falls a few centimetres into a bowl or into the water. */
#include "core/poi/catch/fall.h"

#include "core/base/physics.h"
#include "core/input.h"
#include "core/tank/collision/reentry.h"

/* Highest horizontal speed with which a fish that is beyond a tank wall moves back over the
 * tank. */
#define FALL_HOME_M_S 1.5f
#define PLOP_M 0.004f /* Depth of the dent that a falling fish makes in the water surface. */

/* Full alarm makes the fish flee as soon as no other fish is in its way. */
void fall_set_free(struct tank *tank, struct fish *fish, vec3 velocity_m_s)
{
    fish->alarm = 1.0f;
    reentry_begin(tank, fish, velocity_m_s);
}

/* Returns 1 if the path from `before_m` to `now_m` passes down through the bowl's mouth, otherwise
 * 0. Because the bowl also moves, each position is taken relative to the bowl at the same time. */
static int through_mouth(const struct bowl *bowl, vec3 before_m, vec3 now_m)
{
    const vec3 from = v3_sub(before_m, bowl->before_m), to = v3_sub(now_m, bowl->position_m);
    return from.y > 0.0f && to.y <= 0.0f &&
           to.x * to.x + to.z * to.z < BOWL_RADIUS_M * BOWL_RADIUS_M;
}

/* Moves a fish that misses the bowl's mouth out of the hull, so that the fish slides down outside
 * the bowl. */
static void off_hull(const struct bowl *bowl, struct fish *fish, struct carried_fish *carried)
{
    const vec3 away =
        v3(fish->position_m.x - bowl->position_m.x, 0.0f, fish->position_m.z - bowl->position_m.z);
    const float below = bowl->position_m.y - fish->position_m.y;
    const float apart = bowl_hull_radius_m(below) + 0.5f * fish->width_m;
    const float far = v3_length(away);
    if (below <= 0.0f || below > BOWL_DEPTH_M || far >= apart) {
        return;
    }
    const vec3 out = v3_normalize_or(away, v3(-1.0f, 0.0f, 0.0f));
    const float inward = f_min(v3_dot(carried->fall_m_s, out), 0.0f);
    fish->position_m = v3_muladd(fish->position_m, out, apart - far);
    carried->fall_m_s = v3_muladd(carried->fall_m_s, out, -inward);
}

/* Returns the speed on one axis with which a fish beyond a tank wall moves back over the tank; 0
 * inside the walls. At a real stall, people also put a fish back that jumped out. */
static float homeward(float at_m, float room_m)
{
    const float out = at_m - f_clamp(at_m, -room_m, room_m);
    return -f_clamp(out / CORE_TICK_S, -FALL_HOME_M_S, FALL_HOME_M_S);
}

void fall_begin(struct carried_fish *carried, vec3 velocity_m_s)
{
    carried->state = CARRIED_FALLING;
    carried->slap_s = 0.0f;
    carried->fall_m_s = velocity_m_s;
}

enum fall_end fall_tick(struct carried_fish *carried, const struct stall *stall,
                        uint32_t *bowl_index)
{
    struct tank *tank = stall->tank;
    struct fish *fish = &tank->fish[carried->fish];
    const vec3 before = fish->position_m;
    const vec3 home = v3(homeward(before.x, 0.5f * (tank->size_m.x - fish->length_m)), 0.0f,
                         homeward(before.z, 0.5f * (tank->size_m.z - fish->length_m)));
    carried->fall_m_s.y -= GRAVITY_M_S2 * CORE_TICK_S;
    fish->velocity_m_s = v3_add(carried->fall_m_s, home);
    fish->position_m = v3_muladd(before, fish->velocity_m_s, CORE_TICK_S);
    fish->tail_amplitude = 1.0f;
    for (uint32_t i = 0; i < stall->bowl_count; i++) {
        struct bowl *bowl = &stall->bowls[i];
        if (bowl->present && through_mouth(bowl, before, fish->position_m)) {
            bowl_take(bowl, i, tank, fish, carried->fall_m_s);
            *bowl_index = i;
            return FALL_INTO_BOWL;
        }
        if (bowl->present) {
            off_hull(bowl, fish, carried);
        }
    }
    if (fish->position_m.y > -0.5f * fish->width_m) {
        return FALL_GOES_ON;
    }
    water_press(&tank->water, tank->size_m, fish->position_m, 0.4f * fish->length_m, PLOP_M);
    fall_set_free(tank, fish, carried->fall_m_s);
    return FALL_INTO_WATER;
}
