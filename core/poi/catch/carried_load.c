/* carried_load.c -- computes the loads of carried fish on the paper, tests the support of the fish,
 * and computes the carried water.
 *
 * Each carried fish has one load for its body and one load for a slap. The support of a fish is
 * tested at five places along its body, with three points across the body at each place. The
 * carried water is the film and the pool of a tilted poi. */
#include "core/poi/catch/carried_fish.h"

#include "core/base/panic.h"
#include "core/base/physics.h"
#include "core/poi/poi.h"

#define BODY_FOOT_M 0.020f /* Diameter of the patch of paper that carries the body of a fish. */

float carried_load_dryness(const struct poi *poi, const struct basis *axes,
                           const struct carried_fish *carried, const struct fish *fish)
{
    CORE_ASSERT(fish->width_m > 0.0f);
    const float paper_y =
        poi->position_m.y + carried->x_m * axes->right.y + carried->z_m * axes->back.y;
    return f_clamp(1.0f + paper_y / fish->width_m, 0.0f, 1.0f);
}

static void add_load(struct poi *poi, struct sheet_load load)
{
    if (load.force_n != 0.0f) {
        CORE_ASSERT(poi->load_count < SHEET_LOAD_MAX);
        poi->loads[poi->load_count++] = load;
    }
}

void carried_load_gather(struct poi *poi, const struct basis *axes, float pull_m_s2,
                         const struct fish *fish)
{
    CORE_ASSERT(poi->carried_count <= POI_CARRIED_MAX);
    poi->load_count = 0;
    poi->carried_kg = 0.0f;
    for (uint32_t i = 0; i < poi->carried_count; i++) {
        /* Computes the load of the fish's slap, which acts at the fish's tail or body. If the slap
         * ends during this tick, the force is reduced in proportion to its remaining time. */
        const struct carried_fish *carried = &poi->carried_fish[i];
        const float share = f_min(1.0f, carried->slap_s * (float)CORE_TICK_HZ);
        if (carried->state == CARRIED_LYING && share > 0.0f) {
            const float force_n = -carried->slap_n * share;
            float x, z;
            carried_fish_tail(carried, fish[carried->fish].length_m, &x, &z);
            add_load(poi,
                     sheet_holds(&poi->sheet, x, z)
                         ? (struct sheet_load){ x, z, carried->slap_d_m, force_n }
                         : (struct sheet_load){ carried->x_m, carried->z_m, BODY_FOOT_M, force_n });
        }
    }
    poi->slap_count = poi->load_count;
    for (uint32_t i = 0; i < poi->carried_count; i++) {
        const struct carried_fish *carried = &poi->carried_fish[i];
        const struct fish *who = &fish[carried->fish];
        if (carried->state == CARRIED_LYING) {
            const float kg =
                fish_mass_kg(who->length_m) * carried_load_dryness(poi, axes, carried, who);
            poi->carried_kg += kg;
            add_load(poi, (struct sheet_load){ carried->x_m, carried->z_m, BODY_FOOT_M,
                                               f_min(kg * pull_m_s2, 0.0f) });
        }
    }
}

/* ---- Support of a fish by paper and ring ----------------------------------------------------- */

/* Distance between neighbouring test points along the body of a fish, in body lengths. The points
 * reach from 0.36 body lengths in front of the fish's centre to 0.36 body lengths behind the
 * centre. */
#define ALONG_STEP 0.18f
/* Distance of the outer test points from the midline of the fish's body, as a fraction of the
 * body's girth. The fraction is less than one half, because a body tapers. */
#define ACROSS 0.30f

static bool is_borne(const struct sheet *sheet, float x_m, float z_m)
{
    const float square = x_m * x_m + z_m * z_m;
    if (square >= sheet->radius_m * sheet->radius_m) {
        const float outer_m = ring_outer_radius_m(sheet->radius_m);
        return square <= outer_m * outer_m;
    }
    return sheet_holds(sheet, x_m, z_m);
}

/* Returns true if paper or ring supports at least one of three points across the body.
 * `along` is the distance of the points behind the fish's centre, in body lengths. */
static bool slice_holds(const struct sheet *sheet, const struct carried_fish *carried,
                        const struct fish *fish, float along)
{
    const float tail_x = f_sin(carried->heading_rad), tail_z = f_cos(carried->heading_rad);
    const float x = carried->x_m + along * fish->length_m * tail_x;
    const float z = carried->z_m + along * fish->length_m * tail_z;
    const float aside = ACROSS * f_lerp(fish->width_m, fish->height_m, carried->lie);
    return is_borne(sheet, x, z) || is_borne(sheet, x + aside * tail_z, z - aside * tail_x) ||
           is_borne(sheet, x - aside * tail_z, z + aside * tail_x);
}

bool carried_support_holds(const struct sheet *sheet, const struct carried_fish *carried,
                           const struct fish *fish)
{
    CORE_ASSERT(sheet->paper_cells <= sheet->paper_cells_new);
    const float square = carried->x_m * carried->x_m + carried->z_m * carried->z_m;
    const float outer_m = ring_outer_radius_m(sheet->radius_m);
    if (square > outer_m * outer_m) {
        return false;
    }
    if (sheet->paper_cells == sheet->paper_cells_new) {
        return true; /* The paper has no hole, which is the case in most ticks of a round. */
    }
    return slice_holds(sheet, carried, fish, 0.0f) &&
           (slice_holds(sheet, carried, fish, -ALONG_STEP) ||
            slice_holds(sheet, carried, fish, -2.0f * ALONG_STEP) ||
            slice_holds(sheet, carried, fish, ALONG_STEP) ||
            slice_holds(sheet, carried, fish, 2.0f * ALONG_STEP));
}

/* ---- Carried water --------------------------------------------------------------------------- */

/* Mass of the complete film of water on wet paper: 0.3 mm thick on each of the two faces. */
#define FILM_KG 0.003f
/* Mass of the water film on the paper that does not drain, because the paper fibres hold it. */
#define FILM_KEEP_KG 0.0008f
/* Ratio of two drainage time constants: that of the thin water film on the paper, divided by that
 * of the pool in the sag of the paper. */
#define FILM_SLOW 4.0f
/* Drainage time constant of a pool on a vertical ring. At a smaller tilt, the time constant is
 * divided by the sine of the tilt. */
#define DRAIN_TAU_S 0.15f
/* Rate at which a level ring loses the water that is more than the pool can hold. This water drains
 * over the whole rim. */
#define RIM_PER_S 3.3f
/* Sine of the tilt above which water drains only over the lowest point of the rim. */
#define RIM_SINE 0.1f
#define SEEP_TAU_S 15.0f /* Time constant with which water seeps through wet paper. */
/* Rate at which water would drain through the holes if the whole paper were torn. The actual rate
 * is this value times the torn fraction of the paper. */
#define HOLES_PER_S 8.0f
#define DROP_KG 0.00005f /* Mass of a drop with a diameter of 4.6 mm. */
/* Largest number of drops in one tick. More drops would merge into a trickle, which is not
 * louder. */
#define DROPS_MAX 4u
/* Mass of the water that an upside-down, level ring holds: pi * a^2 * 3 mm times the density of
 * water. a is the radius of the ring, and 3 mm is its height. */
#define RING_KG 0.0151f

/* Returns the largest mass of water that can collect in a pool on the paper. The mass is about 3 g
 * in the sag of a level poi, 15 g on an upside-down poi, and 0 on a steep poi. `up_y` is the
 * vertical component of the poi's unit normal. */
static float pool_room_kg(const struct poi *poi, float up_y)
{
    const float level = f_max(f_abs(up_y), 1e-3f);
    const float tangent = f_sqrt(f_max(0.0f, 1.0f - level * level)) / level;
    const float paper = sheet_left(&poi->sheet);
    if (up_y > 0.0f) {
        /* The sag of the paper is a paraboloid of depth w0 = sag_m. The lowest point of the rim
         * limits the pool to (1 - a * tangent / (2 * w0))^4 times the volume of a level sag,
         * where a is the radius of the paper. */
        const float sag_m = f_max(0.0f, poi->sheet.sag_m);
        const float whole_kg =
            0.5f * F_PI * poi_radius_m(poi) * poi_radius_m(poi) * sag_m * WATER_KG_M3;
        const float lost = f_min(1.0f, 0.5f * poi_radius_m(poi) * tangent / f_max(sag_m, 1e-5f));
        const float left = (1.0f - lost) * (1.0f - lost);
        return paper * (whole_kg * left * left);
    }
    /* An upside-down ring is a flat drum that the tilt empties in part. The water reaches up to the
     * lowest point of the rim. If the water does not cover the whole bottom, the water forms a
     * wedge whose volume is proportional to the wedge's length to the power 3/2. The mass of the
     * film is subtracted. */
    const float fall = poi_radius_m(poi) * tangent / POI_THICKNESS_M;
    const float wedge = 0.5f / f_max(fall, 0.5f);
    const float share = fall < 0.5f ? 1.0f - fall : 0.5f * wedge * f_sqrt(wedge);
    return paper * f_max(0.0f, RING_KG * share - FILM_KG);
}

/* Returns the mass of water that remains of `mass_kg` after one tick. The mass above `keep_kg`
 * drains at the rate `per_s`. */
static float run_off(float mass_kg, float keep_kg, float per_s)
{
    CORE_ASSERT(keep_kg >= 0.0f && per_s >= 0.0f);
    const float more_kg = f_max(0.0f, mass_kg - keep_kg);
    return f_min(mass_kg, keep_kg) + more_kg / (1.0f + per_s * CORE_TICK_S);
}

/* Refills the carried water on the immersed fraction of the disc immediately. The water on the rest
 * of the disc drains. */
void carried_water_tick(struct poi *poi, float up_y)
{
    CORE_ASSERT(poi->immersed >= 0.0f && poi->immersed <= 1.0f);
    const float left = sheet_left(&poi->sheet);
    const float tilt_sine = f_sqrt(f_max(0.0f, 1.0f - up_y * up_y));
    const float room_kg = pool_room_kg(poi, up_y);
    const float tilt_per_s = tilt_sine / DRAIN_TAU_S;
    const float seep_per_s = 1.0f / SEEP_TAU_S;
    const float rim_per_s = RIM_PER_S * f_max(0.0f, 1.0f - tilt_sine / RIM_SINE);
    poi->pool_kg = run_off(poi->pool_kg, room_kg, tilt_per_s + rim_per_s);
    poi->pool_kg = run_off(poi->pool_kg, 0.0f, seep_per_s + HOLES_PER_S * (1.0f - left));
    poi->film_kg = run_off(f_min(poi->film_kg, left * FILM_KG), left * FILM_KEEP_KG,
                           tilt_per_s / FILM_SLOW + seep_per_s);
    if (poi->immersed > 0.0f) {
        poi->film_kg = f_max(poi->film_kg, left * FILM_KG * poi->immersed);
        poi->pool_kg = f_max(poi->pool_kg, room_kg * poi->immersed);
    }
    const float before_kg = poi->water_kg;
    poi->water_kg = poi->film_kg + poi->pool_kg;
    /* Drained water falls in drops. No drops fall while the poi touches the water. */
    poi->drops = 0;
    if (poi->immersed > 0.0f) {
        poi->drip_kg = 0.0f;
        return;
    }
    poi->drip_kg += f_max(0.0f, before_kg - poi->water_kg);
    while (poi->drip_kg >= DROP_KG && poi->drops < DROPS_MAX) {
        poi->drip_kg -= DROP_KG;
        poi->drops++;
    }
}

float carried_water_m(const struct poi *poi)
{
    const float area_m2 = F_PI * poi_radius_m(poi) * poi_radius_m(poi);
    return (1.0f - poi->immersed) * poi->water_kg / (WATER_KG_M3 * area_m2);
}
