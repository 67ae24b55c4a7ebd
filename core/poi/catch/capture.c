/* capture.c -- decides whether a fish becomes a carried fish, and initializes the carried fish. */
#include "core/poi/catch/capture.h"

#include "core/base/rng.h"
#include "core/poi/catch/fall.h"
#include "core/poi/catch/paper_contact.h"

/* Lowest vertical component of the paper's unit normal at which a poi captures fish. At this value,
 * the tilt is 70 degrees. */
#define LEVEL_MIN 0.35f
/* Depth of water over the paper above which a fish can stand upright, in body heights. */
#define STAND_SHARE 1.05f
/* Additional depth of water that a fish needs, because a fish may lie across the ring, which is
 * 3 mm higher than the paper. */
#define STAND_SPARE_M 0.0045f
#define HELD_SHARE (CAPTURE_FLOAT_SHARE - 0.05f)
/* Horizontal speed of a fish that slips off over the ring because the paper has no room. */
#define SPILL_M_S 0.4f
#define WALL_GAP_M 0.015f
/* Lowest speed of the ring toward a wall that counts as a motion toward the wall. The motion of a
 * trembling hand is slower. */
#define WALL_M_S 0.02f
/* Distance by which the hand's target must be ahead of the ring, toward a wall, so that the hand
 * counts as pushing the ring toward the wall (0.9 N). */
#define WALL_PRESS_M 0.004f
/* Slap strength of a fish that was calm before its capture, relative to a fleeing fish. */
#define CALM_VIGOUR 0.55f

/* Returns 1 if the water over the paper is deep enough for the fish to stand upright, otherwise 0.
 * If fish jam the ring (paper_contact_jams()), the limit is deeper: the fish is captured unless it
 * would float off again immediately. */
static int can_stand(const struct poi *poi, const struct basis *axes, vec3 place,
                     const struct fish *fish)
{
    const float paper_y = poi->position_m.y + place.x * axes->right.y + place.z * axes->back.y;
    const float stands_m = STAND_SHARE * fish->height_m + STAND_SPARE_M;
    const float held_m = paper_contact_jams(poi) ? HELD_SHARE * fish->height_m : 0.0f;
    return -paper_y > f_max(stands_m, held_m);
}

void capture_slip_off(const struct poi *poi, struct tank *tank, struct fish *fish)
{
    const vec3 away = v3_sub(fish->position_m, poi->position_m);
    const vec3 out = v3_normalize_or(v3(away.x, 0.0f, away.z), v3(1.0f, 0.0f, 0.0f));
    fall_set_free(tank, fish, v3_scale(out, SPILL_M_S));
}

/* Returns 1 if the ring presses the fish against one wall of the tank, otherwise 0. `out` is the
 * unit vector from the tank's centre toward the wall, and `half_m` is the distance to the wall. */
static int is_pressed(const struct poi *poi, const struct basis *axes, const struct fish *fish,
                      vec3 out, float half_m)
{
    const struct box box = fish_box(fish);
    const vec3 extent = box_extent_m(&box);
    const float ring_m = v3_dot(poi->position_m, out), fish_m = v3_dot(fish->position_m, out);
    const float ring_gap_m = half_m - ring_m - poi_half_extent_m(v3_dot(axes->up, out));
    const float fish_gap_m = half_m - fish_m - f_abs(v3_dot(extent, out));
    const int pushes = v3_dot(poi->velocity_m_s, out) > WALL_M_S ||
                       v3_dot(v3_sub(poi->hand_m, poi->position_m), out) > WALL_PRESS_M;
    return ring_gap_m < WALL_GAP_M && fish_gap_m < WALL_GAP_M && fish_m > ring_m && pushes;
}

int capture_is_walled(const struct poi *poi, const struct basis *axes, const struct tank *tank,
                      const struct fish *fish)
{
    const float half_x = 0.5f * tank->size_m.x, half_z = 0.5f * tank->size_m.z;
    return is_pressed(poi, axes, fish, v3(1.0f, 0.0f, 0.0f), half_x) ||
           is_pressed(poi, axes, fish, v3(-1.0f, 0.0f, 0.0f), half_x) ||
           is_pressed(poi, axes, fish, v3(0.0f, 0.0f, 1.0f), half_z) ||
           is_pressed(poi, axes, fish, v3(0.0f, 0.0f, -1.0f), half_z);
}

/* Returns the initial slap strength [0, 1] of a captured fish. The strength depends on the fish's
 * stamina and alarm. */
static float vigour_of(const struct fish *fish)
{
    const int flees = fish->gait == GAIT_BURST || fish->gait == GAIT_ESCAPE;
    const float fear = flees ? 1.0f : f_clamp(fish->alarm, 0.0f, 1.0f);
    return (0.5f + 0.5f * fish->stamina) * f_lerp(CALM_VIGOUR, 1.0f, fear);
}

static struct carried_fish rider_of(const struct poi *poi, const struct basis *axes,
                                    const struct fish *fish, vec3 place)
{
    const struct basis body = vec_basis_from_angles(fish->angles);
    const vec3 tail = vec_basis_to_body(axes, body.back);
    const vec3 right = vec_basis_to_body(axes, body.right);
    const vec3 speed = vec_basis_to_body(axes, v3_sub(fish->velocity_m_s, poi->velocity_m_s));
    return (struct carried_fish){
        .state = CARRIED_LYING,
        .side = right.y > 0.0f ? 1 : -1,
        .x_m = place.x,
        .z_m = place.z,
        .height_m = f_max(place.y, 0.0f),
        .slide_x_m_s = f_clamp(speed.x, -0.2f, 0.2f),
        .slide_z_m_s = f_clamp(speed.z, -0.2f, 0.2f),
        .heading_rad = f_atan2(tail.x, tail.z),
        .vigour = vigour_of(fish),
    };
}

void capture_fish(struct poi *poi, uint32_t poi_index, const struct basis *axes, struct tank *tank,
                  uint32_t index, uint32_t tick)
{
    struct fish *fish = &tank->fish[index];
    const vec3 place = vec_basis_to_body(axes, v3_sub(fish->position_m, poi->position_m));
    if (axes->up.y < LEVEL_MIN || can_stand(poi, axes, place, fish)) {
        return;
    }
    if (poi->carried_count == POI_CARRIED_MAX) {
        capture_slip_off(poi, tank, fish);
        return;
    }
    struct carried_fish *carried = &poi->carried_fish[poi->carried_count++];
    const struct rng_key key = { poi->seed, tick, index, RNG_CARRIED_REST };
    *carried = rider_of(poi, axes, fish, place);
    carried->fish = (uint16_t)index;
    carried->rest_s = 0.05f + 0.2f * rng_unit(key);
    carried->walled = (uint8_t)capture_is_walled(poi, axes, tank, fish);
    fish->gait = GAIT_HELD;
    fish->holder = (uint8_t)poi_index;
}
