/* parking.c -- decides which pois are parked, computes their motion and their remaining effect on
 * fish and other pois, and releases the fish of a poi that disappears. */
#include "core/game/control/controller.h"

#include "core/base/panic.h"
#include "core/poi/catch/capture.h"
#include "core/poi/world.h"
#include "core/tank/preset.h"

/* Distance along the side wall of the tank between the bowl's centre and the parked ring, which
 * lies farther from the player. The handle points toward the player and therefore lies beside the
 * bowl. */
#define ALONG_M 0.105f
/* Distance from the tank wall to the parked ring. The ring lies inside the wall, so that it stays
 * visible. */
#define INSIDE_M 0.005f
#define ON_RIM_M 0.004f
/* Height of the poi above the tank's rim on its way to the rest position. */
#define OVER_RIM_M 0.020f
/* Upward speed of a poi on its way to the rest position. The paper takes no damage. */
#define LIFT_M_S 0.30f
#define AWAY_M_S 0.80f
/* Fraction of the remaining distance to the rest position that the poi moves per tick. The poi
 * therefore slows down near the rest position. */
#define AWAY_SHARE 0.06f
/* Number of ticks in which a poi accelerates on its way to the rest position. */
#define START_TICKS 36.0f
#define TURN_RAD_S 3.0f
/* Horizontal distance to the rest position within which the poi is lowered to the rim. */
#define NEAR_M 0.03f
#define DOWN_M_S 0.08f /* Speed at which the poi is lowered to its rest position. */
/* Smallest distance between a poi that moves up to its rest position and a bowl. */
#define CLEAR_M 0.010f
#define FADE_TICKS 60.0f

struct poi_target parking_place(const struct world *world, uint32_t index)
{
    CORE_ASSERT(index < POI_MAX);
    const struct bowl *bowl = &world->bowl[index];
    const vec3 preset_m = tank_preset(world->tank.preset)->bowl_m[index];
    const float side = (bowl->present ? bowl->home_m.x : preset_m.x) < 0.0f ? -1.0f : 1.0f;
    const float wall_m = 0.5f * world->tank.size_m.x;
    const float rim_m = world->tank.wall_height_m - world->tank.size_m.y;
    return (struct poi_target){
        .position_m = v3(side * (wall_m - INSIDE_M), rim_m + ON_RIM_M, preset_m.z - ALONG_M),
    };
}

/* Returns the number of ticks since the poi of player `index` was parked; 0 if it is not parked. */
static uint32_t held_ticks(const struct game *game, uint32_t index)
{
    CORE_ASSERT(index < POI_MAX);
    const uint32_t linger = game->player[index].out ? PARKING_LINGER_TICKS : 0u;
    const uint32_t ticks = game->control[index].rest_ticks;
    return ticks > linger ? ticks - linger : 0u;
}

bool parking_is_parked(const struct game *game, uint32_t index)
{
    return held_ticks(game, index) > 0;
}

/* Counts the ticks for which the poi of player `index` has not been used. Returns true if the poi
 * is parked. A bot uses its poi only during a game. A person uses the poi, also as a pointer, until
 * the person is out. */
bool parking_tick(struct control *control, const struct game *game, const struct world *world,
                  uint32_t index)
{
    CORE_ASSERT(index < POI_MAX);
    uint32_t *ticks = &control->rest_ticks;
    const bool in_play = game->phase == PHASE_ATTRACT || game->phase == PHASE_ROUND;
    const bool is_out =
        game->player[index].out && game->phase >= PHASE_READY && game->phase <= PHASE_RESULT;
    const bool is_idle = is_out || (!in_play && world->poi[index].link == POI_SOURCE_BOT);
    *ticks = is_idle ? *ticks + 1u : 0u;
    return parking_is_parked(game, index);
}

/* ---- Motion to the rest position ------------------------------------------------------------ */

static float turn_level(float angle_rad)
{
    const float step_rad = TURN_RAD_S * CORE_TICK_S;
    return angle_rad - f_clamp(angle_rad, -step_rad, step_rad);
}

static float step_of(float way_m, float pace_m_s)
{
    CORE_ASSERT(pace_m_s > 0.0f);
    return f_clamp(way_m, -pace_m_s * CORE_TICK_S, pace_m_s * CORE_TICK_S);
}

/* Returns the next target pose of a poi on its way to the rest position. The path has four steps:
 * toward the middle of the tank, up, over the rims, and down. The ring's actual position selects
 * the step. The step toward the middle is needed only while the ring is below a bowl or between two
 * bowls, where the ring cannot move up. */
struct poi_target parking_path(const struct game *game, const struct world *world, uint32_t index,
                               struct poi_target hand)
{
    const float begun = f_min((float)held_ticks(game, index) / START_TICKS, 1.0f);
    const float clear_m = BOWL_RADIUS_M + POI_OUTER_RADIUS_M + CLEAR_M;
    const vec3 place_m = parking_place(world, index).position_m;
    const vec3 ring_m = world->poi[index].position_m;
    const vec3 way_m = v3_sub(place_m, hand.position_m);
    vec3 at_m = hand.position_m;
    bool is_under = false;
    CORE_ASSERT(begun > 0.0f);
    for (uint32_t i = 0; i < POI_MAX; i++) {
        const struct bowl *bowl = &world->bowl[i];
        const float x_m = ring_m.x - bowl->position_m.x, z_m = ring_m.z - bowl->position_m.z;
        is_under |= bowl->present && ring_m.y < bowl->position_m.y &&
                    x_m * x_m + z_m * z_m < clear_m * clear_m;
    }
    if (is_under) {
        at_m.x -= step_of(at_m.x, LIFT_M_S) * begun;
    } else if (f_min(at_m.y, ring_m.y) < place_m.y - ON_RIM_M) {
        at_m.y += step_of(place_m.y + OVER_RIM_M - at_m.y, LIFT_M_S) * begun;
    } else {
        const vec3 aside_m = v3_scale(v3(way_m.x, 0.0f, way_m.z), AWAY_SHARE);
        const bool is_over = way_m.x * way_m.x + way_m.z * way_m.z < NEAR_M * NEAR_M;
        const float high_m = f_max(at_m.y, place_m.y + OVER_RIM_M);
        at_m.y += is_over ? step_of(way_m.y, DOWN_M_S) : step_of(high_m - at_m.y, LIFT_M_S);
        at_m = v3_muladd(at_m, v3_limit(aside_m, AWAY_M_S * CORE_TICK_S), begun);
    }
    return (struct poi_target){
        .position_m = at_m,
        .angles = { turn_level(hand.angles.yaw_rad), turn_level(hand.angles.pitch_rad),
                    turn_level(hand.angles.roll_rad) },
    };
}

/* ---- Effect of a parked poi on fish, pois and light ------------------------------------------ */

bool parking_collides(const struct game *game, const struct world *world, uint32_t index)
{
    return !parking_is_parked(game, index) || world->poi[index].immersed > 0.0f;
}

float parking_shade(const struct game *game, uint32_t index)
{
    return f_max(1.0f - (float)held_ticks(game, index) / FADE_TICKS, 0.0f);
}

/* ---- Release of fish from pois that disappear ------------------------------------------------ */

#define THROW_M_S_MAX 0.3f /* Highest speed of a released fish, so that the fish is not thrown. */

void parking_release_all(struct poi *poi, const struct tank *tank)
{
    CORE_ASSERT(poi->carried_count <= POI_CARRIED_MAX);
    for (uint32_t i = 0; i < poi->carried_count; i++) {
        struct carried_fish *carried = &poi->carried_fish[i];
        if (carried->state == CARRIED_LYING) {
            const vec3 velocity_m_s = tank->fish[carried->fish].velocity_m_s;
            catch_fall_begin(carried, v3_limit(velocity_m_s, THROW_M_S_MAX));
        }
        carried->state = CARRIED_RELEASED;
    }
    poi->carried_kg = 0.0f;
    poi->load_count = poi->slap_count = 0;
}

static bool is_fish_held_by(const struct fish *fish, uint32_t poi_index)
{
    return fish->gait == GAIT_HELD && fish->holder == poi_index;
}

void parking_release_tick(struct poi *poi, uint32_t poi_index, const struct stall *stall,
                          struct catch_result results[POI_MAX])
{
    CORE_ASSERT(poi_index < POI_MAX);
    struct tank *tank = stall->tank;
    uint32_t i = 0;
    parking_release_all(poi, tank);
    while (i < poi->carried_count) {
        struct carried_fish *carried = &poi->carried_fish[i];
        const bool is_ours = is_fish_held_by(&tank->fish[carried->fish], poi_index);
        uint32_t bowl = 0;
        const enum fall_end end =
            is_ours ? catch_fall_tick(carried, stall, &bowl) : FALL_INTO_WATER;
        if (end == FALL_INTO_BOWL) {
            catch_count(carried, poi_index, bowl, results);
        }
        if (end == FALL_GOES_ON) {
            i++;
        } else {
            poi->carried_count--;
            *carried = poi->carried_fish[poi->carried_count];
        }
    }
    /* Fish that are marked as held by this poi but are missing in the poi's list are set free,
     * because no other code would let these fish fall. */
    for (uint32_t fish = 0; fish < tank->fish_count; fish++) {
        if (is_fish_held_by(&tank->fish[fish], poi_index) && !catch_has_carried(poi, fish)) {
            catch_set_free(tank, &tank->fish[fish], v3(0.0f, 0.0f, 0.0f));
        }
    }
}
