/* contact.c -- paper against fish that lie in the water over it. */
#include "core/poi/contact.h"

#define ZONE_M 0.06f /* Farther from the plane none can touch. */
#define SQUEEZE_GAP_M 0.0005f
#define JAM_PULL_M 0.03f /* A hand so far over a ring that stands still pulls at a jam. */
#define JAM_M_S 0.02f
#define TOUCH_M 0.005f /* Who lies across the ring is held 3 mm over the paper by it. */

/* Whether a point, seen from the ring's centre, is in the cylinder of ZONE_M over the paper; if so,
 * `place` is where in the poi's axes. Most fish are far and cost a dot product. */
static int over_paper(const struct basis *axes, vec3 away, vec3 *place)
{
    if (v3_dot(away, away) >= ZONE_M * ZONE_M + POI_RADIUS_M * POI_RADIUS_M) {
        return 0;
    }
    *place = basis_to_body(axes, away);
    return place->y >= 0.0f && place->y < ZONE_M;
}

int contact_fish(const struct poi *poi, const struct basis *axes, const struct fish *fish)
{
    vec3 place;
    if (!over_paper(axes, v3_sub(fish->position_m, poi->position_m), &place) ||
        !sheet_holds(&poi->sheet, place.x, place.z)) {
        return 0;
    }
    const struct basis body = basis_from_angles(fish->angles);
    const float clear_m = fish_half_extent_m(fish, basis_to_body(&body, axes->up));
    return place.y < clear_m + TOUCH_M;
}

static int at_surface(const struct fish *fish)
{
    const struct box box = fish_box(fish);
    return fish->position_m.y + box_extent_m(&box).y > -SQUEEZE_GAP_M;
}

static int ring_presses(const struct poi *poi, const struct fish *fish)
{
    const struct box box = fish_box(fish);
    const struct obstacle ring = poi_obstacle(poi);
    const struct touch touch = obstacle_touch(&ring, &box);
    return touch.gap_m < SQUEEZE_GAP_M && touch.out.y > 0.0f;
}

/* Fish upon fish between paper and surface. */
static int is_jammed(const struct poi *poi)
{
    return poi->hand_m.y > poi->position_m.y + JAM_PULL_M && poi->velocity_m_s.y < JAM_M_S;
}

int contact_squeezed(const struct poi *poi, const struct fish *fish)
{
    const vec3 away = v3_sub(fish->position_m, poi->position_m);
    const float reach_m = POI_OUTER_RADIUS_M + fish->length_m;
    if (!(poi->gave & OBSTACLE_GAVE_PLACE) || v3_dot(away, away) > reach_m * reach_m ||
        !at_surface(fish)) {
        return 0;
    }
    return ring_presses(poi, fish) ||
           (is_jammed(poi) && v3_dot(away, away) < POI_OUTER_RADIUS_M * POI_OUTER_RADIUS_M);
}
