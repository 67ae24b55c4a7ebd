/* contact.c -- a fish remembers on which side of the paper it is; see poi.near_bits. */
#include "core/poi/contact.h"

#define ZONE_M 0.06f       /* Farther from the plane no fish and poi can meet in one tick. */
#define SIDE_GAP_M 0.0005f /* A fish's centre never gets nearer to the paper than this ... */
#define PUSH_M 0.0025f     /* ... and a body that slid in over the ring is freed at this a tick. */
#define TOUCH_M 0.003f
#define PIN_M_S 0.12f     /* Paper that comes at a fish so fast takes it half along. */
#define SQUEEZE_M_S 0.25f /* Out from between ring and floor. */

static int bit(const uint32_t *bits, uint32_t index)
{
    return (int)(bits[index / 32u] >> (index % 32u) & 1u);
}

static void set_bit(uint32_t *bits, uint32_t index, int value)
{
    const uint32_t mask = 1u << (index % 32u);
    bits[index / 32u] = value ? bits[index / 32u] | mask : bits[index / 32u] & ~mask;
}

/* Half the height of water that a fish needs for itself at the surface and the floor. */
static float half_tall(const struct fish *fish)
{
    const struct basis axes = basis_from_angles(fish->angles);
    return fish_half_extent_m(fish, v3(axes.right.y, axes.up.y, axes.back.y));
}

void contact_stay_in_tank(struct fish *fish, const struct tank *tank)
{
    const struct box box = fish_box(fish);
    const vec3 extent = box_extent_m(&box);
    const float room_x = 0.5f * tank->size_m.x - extent.x;
    const float room_z = 0.5f * tank->size_m.z - extent.z;
    fish->position_m.x = f_clamp(fish->position_m.x, -room_x, room_x);
    fish->position_m.z = f_clamp(fish->position_m.z, -room_z, room_z);
    const float half = half_tall(fish);
    const float low = half - tank->size_m.y;
    fish->position_m.y = f_clamp(fish->position_m.y, low, f_max(low, -half));
}

/* A fish between ring and floor holds the ring up and works its way out. */
static void squeeze(struct poi *poi, struct fish *fish, vec3 up, float clear_m, vec3 place)
{
    const vec3 out = v3_normalize_or(
        v3(fish->position_m.x - poi->position_m.x, 0.0f, fish->position_m.z - poi->position_m.z),
        v3(1.0f, 0.0f, 0.0f));
    fish->position_m = v3_mad(fish->position_m, out, SQUEEZE_M_S * CORE_TICK_S);
    const float needed = (clear_m + place.y) * up.y; /* place.y < 0: below. */
    if (needed > 0.0f) {
        poi->floor_m = f_max(poi->floor_m, f_min(0.0f, poi->position_m.y + f_min(needed, PUSH_M)));
    }
}

/* The stream through which the paper comes presses a fish flat on it: at 0.3 m/s with 0.04 N, more
 * than it weighs in air. Friction then takes it along with the paper, sideways too. */
static vec3 pinned_along(const struct poi *poi, vec3 up, float closing_m_s)
{
    const vec3 v = poi->velocity_m_s;
    const vec3 along = v3_mad(v, up, -v3_dot(v, up));
    const float square = closing_m_s * closing_m_s;
    return closing_m_s > 0.0f ? v3_scale(along, square / (square + PIN_M_S * PIN_M_S))
                              : v3(0.0f, 0.0f, 0.0f);
}

/* Moves the fish along the normal until it clears the paper, and gives it the paper's speed. */
static void push(struct poi *poi, struct fish *fish, vec3 up, float side, float height_m,
                 float goal_m)
{
    const float paper = v3_dot(poi->velocity_m_s, up), own = v3_dot(fish->velocity_m_s, up);
    const vec3 along = pinned_along(poi, up, side * paper);
    fish->position_m = v3_mad(fish->position_m, up, side * (goal_m - height_m));
    fish->position_m = v3_mad(fish->position_m, along, CORE_TICK_S);
    if (side * (own - paper) < 0.0f) {
        fish->velocity_m_s = v3_mad(fish->velocity_m_s, up, paper - own);
    }
}

/* After the surface or floor pushed back: rather aside than through the paper. */
static void never_through(const struct poi *poi, struct fish *fish, vec3 up, float side)
{
    const float height = side * v3_dot(v3_sub(fish->position_m, poi->position_m), up);
    const float level = f_sqrt(up.x * up.x + up.z * up.z);
    if (height < SIDE_GAP_M && level > 0.1f) {
        const vec3 aside = v3(up.x / level, 0.0f, up.z / level);
        fish->position_m = v3_mad(fish->position_m, aside, side * (SIDE_GAP_M - height) / level);
    } else if (height < SIDE_GAP_M) { /* Level paper, no room: it stays on its side all the same. */
        fish->position_m = v3_mad(fish->position_m, up, side * (SIDE_GAP_M - height));
    }
}

/* Whether a point, seen from the ring's centre, is in the cylinder of ZONE_M over and under the
 * paper; if so, `place` is where in the poi's axes. Most fish are far and cost a dot product. */
static int over_paper(const struct basis *axes, vec3 away, vec3 *place)
{
    if (v3_dot(away, away) >= ZONE_M * ZONE_M + POI_RADIUS_M * POI_RADIUS_M) {
        return 0;
    }
    *place = basis_to_body(axes, away);
    return f_abs(place->y) < ZONE_M &&
           place->x * place->x + place->z * place->z < POI_RADIUS_M * POI_RADIUS_M;
}

int contact_fish(struct poi *poi, const struct basis *axes, uint32_t index, struct tank *tank)
{
    struct fish *fish = &tank->fish[index];
    const vec3 away = v3_sub(fish->position_m, poi->position_m);
    const int was_near = bit(poi->near_bits, index);
    vec3 place;
    if (!over_paper(axes, away, &place)) {
        set_bit(poi->near_bits, index, 0);
        return 0;
    }
    const int holds = sheet_holds(&poi->sheet, place.x, place.z);
    const int above = was_near && holds ? bit(poi->above_bits, index) : place.y >= 0.0f;
    set_bit(poi->near_bits, index, 1);
    set_bit(poi->above_bits, index, above);
    if (!holds) {
        return 0;
    }
    const float side = above ? 1.0f : -1.0f;
    const float height = side * place.y;
    const struct basis body = basis_from_angles(fish->angles);
    const float clear = fish_half_extent_m(fish, basis_to_body(&body, axes->up));
    if (height < clear) {
        const float goal = f_min(clear, f_max(height, SIDE_GAP_M) + PUSH_M);
        push(poi, fish, axes->up, side, height, goal);
        contact_stay_in_tank(fish, tank);
        if (!above && fish->position_m.y <= half_tall(fish) - tank->size_m.y + 1e-4f) {
            squeeze(poi, fish, axes->up, clear, place);
        }
        never_through(poi, fish, axes->up, side);
        contact_stay_in_tank(fish, tank);
    }
    return above && height < clear + TOUCH_M;
}
