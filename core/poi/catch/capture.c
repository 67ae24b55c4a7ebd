/* capture.c -- tests which fish in the water touch the paper, captures fish, and moves a fish that
 * falls a few centimetres into a bowl or into the water. */
#include "core/poi/catch/capture.h"

#include "core/base/panic.h"
#include "core/base/physics.h"
#include "core/base/rng.h"
#include "core/input.h"
#include "core/tank/tank.h"

#define ZONE_M 0.06f /* Distance from the paper's plane beyond which no fish can touch the paper. */
#define SQUEEZE_GAP_M 0.0005f
/* Smallest height of the hand's target above the ring at which a ring blocked by fish counts as
 * jammed. At this height, the hand pulls the ring up with 6.5 N. */
#define JAM_PULL_M 0.03f
/* Number of ticks (0.1 s) after which all fish over a jammed ring have left. The fish leave from
 * the edge inward. */
#define JAM_TICKS 12.0f
#define JAM_M (0.02f * CORE_TICK_S)
/* Largest gap between fish and paper at which the fish can be captured. A fish that lies across the
 * ring is 3 mm above the paper. */
#define TOUCH_M 0.005f

bool capture_touches(const struct poi *poi, const struct basis *axes, const struct fish *fish)
{
    /* The distance is tested first, because this cheap test already rejects most fish. */
    const vec3 away = v3_sub(fish->position_m, poi->position_m);
    if (v3_dot(away, away) >= ZONE_M * ZONE_M + poi_radius_m(poi) * poi_radius_m(poi)) {
        return false;
    }
    const vec3 place = vec_basis_to_body(axes, away);
    if (place.y < 0.0f || place.y >= ZONE_M || !sheet_holds(&poi->sheet, place.x, place.z)) {
        return false;
    }
    const struct basis body = vec_basis_from_angles(fish->angles);
    const float clear_m = carried_fish_half_extent_m(fish, vec_basis_to_body(&body, axes->up));
    return place.y < clear_m + TOUCH_M;
}

static bool at_surface(const struct fish *fish)
{
    const struct box box = fish_box(fish);
    return fish->position_m.y + box_extent_m(&box).y > -SQUEEZE_GAP_M;
}

/* Returns true if the ring touches the fish. If `from_below` is true, only a contact from below
 * counts. */
static bool ring_touches(const struct poi *poi, const struct fish *fish, bool from_below)
{
    const struct box box = fish_box(fish);
    const struct obstacle ring = poi_obstacle(poi);
    const struct touch touch = obstacle_touch(&ring, &box);
    return touch.gap_m < SQUEEZE_GAP_M && (!from_below || touch.out.y > 0.0f);
}

bool capture_is_jammed(const struct poi *poi)
{
    const vec3 made_m = v3_sub(poi->position_m, poi->before_m);
    return poi->reaction & REACTION_POSITION && poi->hand_m.y > poi->position_m.y + JAM_PULL_M &&
           v3_dot(made_m, made_m) < JAM_M * JAM_M;
}

bool capture_is_squeezed(const struct poi *poi, const struct fish *fish)
{
    const vec3 away = v3_sub(fish->position_m, poi->position_m);
    const float reach_m = poi_outer_radius_m(poi) + fish->length_m;
    return poi->reaction & REACTION_POSITION && v3_dot(away, away) < reach_m * reach_m &&
           at_surface(fish) && ring_touches(poi, fish, true);
}

bool capture_releases(const struct poi *poi, const struct basis *axes, const struct fish *fish)
{
    const vec3 away = v3_sub(fish->position_m, poi->position_m);
    const float left = 1.0f - (float)poi->jam_ticks / JAM_TICKS;
    /* Tests whether the fish is above the disc. The horizontal distance of the fish from the disc's
     * centre must be at least `from_m` and below the outer radius. The fish may be at any height
     * above the disc. */
    const float from_m = f_max(left, 0.0f) * poi_outer_radius_m(poi);
    const float side_m2 = away.x * away.x + away.z * away.z;
    if ((side_m2 < poi_outer_radius_m(poi) * poi_outer_radius_m(poi) &&
         side_m2 >= from_m * from_m && v3_dot(away, axes->up) > 0.0f) &&
        at_surface(fish)) {
        return true;
    }
    const float reach_m = poi_outer_radius_m(poi) + fish->length_m;
    return left <= 0.0f && v3_dot(away, away) < reach_m * reach_m &&
           (ring_touches(poi, fish, false) || capture_touches(poi, axes, fish));
}

/* Lowest vertical component of the paper's unit normal at which a poi captures fish. At this value,
 * the tilt is 70 degrees. */
#define LEVEL_MIN 0.35f
/* Depth of water over the paper above which a fish can stand upright, in body heights. */
#define STAND_SHARE 1.05f
/* Additional depth of water that a fish needs to stand upright, because a fish may lie across the
 * ring, which is 3 mm higher than the paper. */
#define STAND_SPARE_M 0.0045f
#define HELD_SHARE (CAPTURE_FLOAT_SHARE - 0.05f)
/* Horizontal speed of a fish that slips off over the ring because the paper has no room. */
#define SPILL_M_S 0.4f
#define WALL_GAP_M 0.015f
/* Lowest speed of the ring toward a wall that counts as a motion toward the wall. The motion of a
 * trembling hand is slower. */
#define WALL_M_S 0.02f
/* Distance from the ring to the hand's target in the direction of a wall, above which the hand
 * counts as pushing the ring toward the wall. At this distance the hand spring (HAND_N_M in poi.c)
 * pushes the ring with 0.9 N. */
#define WALL_PRESS_M 0.004f
/* Slap strength of a fish that was calm before its capture, as a fraction of the slap strength of a
 * fish that fled. */
#define CALM_VIGOUR 0.55f

void capture_slip_off(const struct poi *poi, struct tank *tank, struct fish *fish)
{
    const vec3 away = v3_sub(fish->position_m, poi->position_m);
    const vec3 out = v3_normalize_or(v3_flat(away), v3(1.0f, 0.0f, 0.0f));
    catch_set_free(tank, fish, v3_scale(out, SPILL_M_S));
}

/* Returns true if the ring presses the fish against one wall of the tank. `out` is the unit
 * vector from the tank's centre toward the wall, and `half_m` is the distance to the wall. */
static bool is_pressed_to_wall(const struct poi *poi, const struct basis *axes,
                               const struct fish *fish, vec3 out, float half_m)
{
    CORE_ASSERT(half_m > 0.0f);
    const struct box box = fish_box(fish);
    const vec3 extent = box_extent_m(&box);
    const float ring_m = v3_dot(poi->position_m, out), fish_m = v3_dot(fish->position_m, out);
    const float ring_gap_m = half_m - ring_m - poi_half_extent_m(poi, v3_dot(axes->up, out));
    const float fish_gap_m = half_m - fish_m - f_abs(v3_dot(extent, out));
    const bool pushes = v3_dot(poi->velocity_m_s, out) > WALL_M_S ||
                        v3_dot(v3_sub(poi->hand_m, poi->position_m), out) > WALL_PRESS_M;
    return ring_gap_m < WALL_GAP_M && fish_gap_m < WALL_GAP_M && fish_m > ring_m && pushes;
}

bool capture_is_walled(const struct poi *poi, const struct basis *axes, const struct tank *tank,
                       const struct fish *fish)
{
    const float half_x = 0.5f * tank->size_m.x, half_z = 0.5f * tank->size_m.z;
    return is_pressed_to_wall(poi, axes, fish, v3(1.0f, 0.0f, 0.0f), half_x) ||
           is_pressed_to_wall(poi, axes, fish, v3(-1.0f, 0.0f, 0.0f), half_x) ||
           is_pressed_to_wall(poi, axes, fish, v3(0.0f, 0.0f, 1.0f), half_z) ||
           is_pressed_to_wall(poi, axes, fish, v3(0.0f, 0.0f, -1.0f), half_z);
}

void capture_fish(struct poi *poi, uint32_t poi_index, const struct basis *axes, struct tank *tank,
                  uint32_t index, uint32_t tick)
{
    CORE_ASSERT(poi_index < POI_MAX);
    CORE_ASSERT(index < tank->fish_count);
    CORE_ASSERT(poi->carried_count <= POI_CARRIED_MAX);
    struct fish *fish = &tank->fish[index];
    const vec3 place = vec_basis_to_body(axes, v3_sub(fish->position_m, poi->position_m));
    /* Captures the fish only if the water over the paper is too shallow for the fish to stand
     * upright. If fish jam the ring, the fish is also captured in deeper water, up to HELD_SHARE
     * body heights. HELD_SHARE is smaller than CAPTURE_FLOAT_SHARE, so that the captured fish does
     * not float off again immediately. */
    const float paper_y = poi->position_m.y + place.x * axes->right.y + place.z * axes->back.y;
    const float stands_m = STAND_SHARE * fish->height_m + STAND_SPARE_M;
    const float held_m = capture_is_jammed(poi) ? HELD_SHARE * fish->height_m : 0.0f;
    if (axes->up.y < LEVEL_MIN || (-paper_y > f_max(stands_m, held_m))) {
        return;
    }
    if (poi->carried_count == POI_CARRIED_MAX) {
        capture_slip_off(poi, tank, fish);
        return;
    }
    struct carried_fish *carried = &poi->carried_fish[poi->carried_count++];
    const struct rng_key key = { poi->seed, tick, index, RNG_CARRIED_REST };
    const struct basis body = vec_basis_from_angles(fish->angles);
    const vec3 tail = vec_basis_to_body(axes, body.back);
    const vec3 speed = vec_basis_to_body(axes, v3_sub(fish->velocity_m_s, poi->velocity_m_s));
    /* The initial slap strength [0, 1] of a captured fish depends on the fish's stamina and
     * alarm. */
    const bool flees = fish->gait == GAIT_BURST || fish->gait == GAIT_ESCAPE;
    const float fear = flees ? 1.0f : f_clamp(fish->alarm, 0.0f, 1.0f);
    *carried = (struct carried_fish){
        .fish = (uint16_t)index,
        .state = CARRIED_LYING,
        .side = vec_basis_to_body(axes, body.right).y > 0.0f ? 1 : -1,
        .walled = capture_is_walled(poi, axes, tank, fish),
        .x_m = place.x,
        .z_m = place.z,
        .height_m = f_max(place.y, 0.0f),
        .slide_x_m_s = f_clamp(speed.x, -0.2f, 0.2f),
        .slide_z_m_s = f_clamp(speed.z, -0.2f, 0.2f),
        .heading_rad = f_atan2(tail.x, tail.z),
        .vigour = (0.5f + 0.5f * fish->stamina) * f_lerp(CALM_VIGOUR, 1.0f, fear),
        .rest_s = 0.05f + 0.2f * rng_unit(key),
    };
    fish->gait = GAIT_HELD;
    fish->holder = (uint8_t)poi_index;
}

/* ---- Fall of a fish -------------------------------------------------------------------------- */

/* Highest horizontal speed with which a fish that is beyond a tank wall moves back over the
 * tank. */
#define FALL_HOME_M_S 1.5f
#define PLOP_M 0.004f /* Depth of the dent that a falling fish makes in the water surface. */

/* Gives the fish the full alarm, so that it flees as soon as no other fish is in its way. */
void catch_set_free(struct tank *tank, struct fish *fish, vec3 velocity_m_s)
{
    CORE_ASSERT(v3_is_finite(velocity_m_s));
    fish->alarm = 1.0f;
    reentry_begin(tank, fish, velocity_m_s);
}

/* Returns the speed on one axis with which a fish that fell beyond a tank wall moves back over the
 * tank. Returns 0 inside the walls. At a real stall, people also put a fish back that jumped out of
 * the tank. */
static float return_speed_m_s(float at_m, float room_m)
{
    const float out = at_m - f_clamp(at_m, -room_m, room_m);
    return -f_clamp(out / CORE_TICK_S, -FALL_HOME_M_S, FALL_HOME_M_S);
}

void catch_fall_begin(struct carried_fish *carried, vec3 velocity_m_s)
{
    CORE_ASSERT(v3_is_finite(velocity_m_s));
    carried->state = CARRIED_FALLING;
    carried->slap_s = 0.0f;
    carried->fall_m_s = velocity_m_s;
}

enum fall_end catch_fall_tick(struct carried_fish *carried, const struct stall *stall,
                              uint32_t *bowl_index)
{
    CORE_ASSERT(carried->fish < stall->tank->fish_count);
    CORE_ASSERT(stall->bowl_count <= POI_MAX);
    struct tank *tank = stall->tank;
    struct fish *fish = &tank->fish[carried->fish];
    const vec3 before = fish->position_m;
    const vec3 home = v3(return_speed_m_s(before.x, 0.5f * (tank->size_m.x - fish->length_m)), 0.0f,
                         return_speed_m_s(before.z, 0.5f * (tank->size_m.z - fish->length_m)));
    carried->fall_m_s.y -= GRAVITY_M_S2 * CORE_TICK_S;
    fish->velocity_m_s = v3_add(carried->fall_m_s, home);
    fish->position_m = v3_muladd(before, fish->velocity_m_s, CORE_TICK_S);
    fish->tail_amplitude = 1.0f;
    for (uint32_t i = 0; i < stall->bowl_count; i++) {
        struct bowl *bowl = &stall->bowls[i];
        if (!bowl->present) {
            continue;
        }
        /* The fish falls into the bowl if its path passes down through the bowl's mouth. Because
         * the bowl also moves, each position is taken relative to the bowl at the same time. */
        const vec3 from = v3_sub(before, bowl->before_m);
        const vec3 to = v3_sub(fish->position_m, bowl->position_m);
        if (from.y > 0.0f && to.y <= 0.0f &&
            to.x * to.x + to.z * to.z < BOWL_RADIUS_M * BOWL_RADIUS_M) {
            bowl_take(bowl, i, tank, fish, carried->fall_m_s);
            *bowl_index = i;
            return FALL_INTO_BOWL;
        }
        /* Moves a fish that misses the bowl's mouth out of the hull, so that the fish slides down
         * outside the bowl. */
        const float below = -to.y, far = v3_length(v3_flat(to));
        const float apart = bowl_hull_radius_m(below) + 0.5f * fish->width_m;
        if (below > 0.0f && below <= BOWL_DEPTH_M && far < apart) {
            const vec3 out = v3_normalize_or(v3_flat(to), v3(-1.0f, 0.0f, 0.0f));
            const float inward = f_min(v3_dot(carried->fall_m_s, out), 0.0f);
            fish->position_m = v3_muladd(fish->position_m, out, apart - far);
            carried->fall_m_s = v3_muladd(carried->fall_m_s, out, -inward);
        }
    }
    if (fish->position_m.y > -0.5f * fish->width_m) {
        return FALL_GOES_ON;
    }
    water_press(&tank->water, tank->size_m, fish->position_m, 0.4f * fish->length_m, PLOP_M);
    catch_set_free(tank, fish, carried->fall_m_s);
    return FALL_INTO_WATER;
}
