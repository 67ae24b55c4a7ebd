/* paper_contact.c -- tests the contact of the paper with the fish in the water above the paper. */
#include "core/poi/catch/paper_contact.h"

#define ZONE_M 0.06f /* Distance from the paper's plane beyond which no fish can touch the paper. */
#define SQUEEZE_GAP_M 0.0005f
/* Height of the hand's target above a ring that fish block. From this height on, the ring counts as
 * jammed (a pull of 6.5 N). */
#define JAM_PULL_M 0.03f
/* Number of ticks (0.1 s) after which all fish over a jammed ring have left. The fish leave from
 * the edge inward. */
#define JAM_TICKS 12.0f
#define JAM_M (0.02f * CORE_TICK_S)
/* Largest gap between fish and paper at which the fish can be captured. A fish that lies across the
 * ring is 3 mm above the paper. */
#define TOUCH_M 0.005f

/* Returns 1 if a point is less than ZONE_M above the paper's plane and near the poi, otherwise 0.
 * `away` is the vector from the ring's centre to the point in world axes. Writes the coordinates of
 * the point in the poi's axes to `place`. For most fish, the cheap test of the distance is
 * sufficient. */
static int over_paper(const struct basis *axes, vec3 away, vec3 *place)
{
    if (v3_dot(away, away) >= ZONE_M * ZONE_M + POI_RADIUS_M * POI_RADIUS_M) {
        return 0;
    }
    *place = vec_basis_to_body(axes, away);
    return place->y >= 0.0f && place->y < ZONE_M;
}

int paper_contact_fish(const struct poi *poi, const struct basis *axes, const struct fish *fish)
{
    vec3 place;
    if (!over_paper(axes, v3_sub(fish->position_m, poi->position_m), &place) ||
        !sheet_holds(&poi->sheet, place.x, place.z)) {
        return 0;
    }
    const struct basis body = vec_basis_from_angles(fish->angles);
    const float clear_m = carried_fish_half_extent_m(fish, vec_basis_to_body(&body, axes->up));
    return place.y < clear_m + TOUCH_M;
}

static int at_surface(const struct fish *fish)
{
    const struct box box = fish_box(fish);
    return fish->position_m.y + box_extent_m(&box).y > -SQUEEZE_GAP_M;
}

/* Returns 1 if the ring touches the fish, otherwise 0. If `from_below` is 1, only a contact from
 * below counts. */
static int ring_touches(const struct poi *poi, const struct fish *fish, int from_below)
{
    const struct box box = fish_box(fish);
    const struct obstacle ring = poi_obstacle(poi);
    const struct touch touch = obstacle_touch(&ring, &box);
    return touch.gap_m < SQUEEZE_GAP_M && (!from_below || touch.out.y > 0.0f);
}

int paper_contact_jams(const struct poi *poi)
{
    const vec3 made_m = v3_sub(poi->position_m, poi->before_m);
    return poi->reaction & REACTION_POSITION && poi->hand_m.y > poi->position_m.y + JAM_PULL_M &&
           v3_dot(made_m, made_m) < JAM_M * JAM_M;
}

static int is_near(const struct fish *fish, vec3 away)
{
    const float reach_m = POI_OUTER_RADIUS_M + fish->length_m;
    return v3_dot(away, away) < reach_m * reach_m;
}

int paper_contact_squeezed(const struct poi *poi, const struct fish *fish)
{
    const vec3 away = v3_sub(fish->position_m, poi->position_m);
    return poi->reaction & REACTION_POSITION && is_near(fish, away) && at_surface(fish) &&
           ring_touches(poi, fish, 1);
}

/* Returns 1 if the fish is above the disc, inside its outer radius, and at least `from_m`
 * horizontally from its centre. Otherwise returns 0. The height of the fish above the disc has no
 * effect. */
static int lies_over(const struct basis *axes, vec3 away, float from_m)
{
    const float side_m2 = away.x * away.x + away.z * away.z;
    return side_m2 < POI_OUTER_RADIUS_M * POI_OUTER_RADIUS_M && side_m2 >= from_m * from_m &&
           v3_dot(away, axes->up) > 0.0f;
}

int paper_contact_releases(const struct poi *poi, const struct basis *axes, const struct fish *fish)
{
    const vec3 away = v3_sub(fish->position_m, poi->position_m);
    const float left = 1.0f - (float)poi->jam_ticks / JAM_TICKS;
    if (lies_over(axes, away, f_max(left, 0.0f) * POI_OUTER_RADIUS_M) && at_surface(fish)) {
        return 1;
    }
    return left <= 0.0f && is_near(fish, away) &&
           (ring_touches(poi, fish, 0) || paper_contact_fish(poi, axes, fish));
}
