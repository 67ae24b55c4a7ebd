/* surface_disturbance.c -- computes how a poi (paper scoop) disturbs the water surface.
 *
 * A ring that cuts through the surface presses the surface down at two points of its edge. If the
 * ring is faster than the ripples (0.23 m/s), a V-shaped wake forms at each point. */
#include "core/base/panic.h"
#include "core/poi/world.h"

/* Ratio of the vertical motion of the water surface above an immersed disc to the vertical motion
 * of the disc. */
#define HEAVE_SHARE 0.5f
#define HEAVE_DEPTH_M 0.03f /* Depth of the disc at which HEAVE_SHARE is reduced to 1/e. */
/* Largest rise or fall of the water surface that an immersed disc causes in one tick. */
#define HEAVE_MAX_M 0.003f
#define PLUNGE_MAX_M 0.004f
#define BOW_RADIUS_M 0.012f
/* Depth by which the edge of the ring presses the water surface down, divided by the ring's
 * horizontal motion in the tick. The edge presses at each point where the edge cuts through the
 * surface. */
#define BOW_SHARE 0.25f
/* Largest depth by which the edge of the ring presses the water surface down at one point in one
 * tick. */
#define BOW_MAX_M 0.0012f
/* Sine of the tilt (9 degrees) below which a ring counts as level. The edge of a level ring does
 * not cut through the surface. */
#define LEVEL_SLOPE 0.15f
#define DROP_RADIUS_M 0.008f
#define DROP_M 0.0005f

/* Returns the unit vector in the plane of the paper that points up the slope. Writes the sine of
 * the tilt to `slope`. */
static vec3 slope_direction(vec3 up, float *slope)
{
    const vec3 rise = v3_muladd(v3(0.0f, 1.0f, 0.0f), up, -up.y);
    *slope = v3_length(rise);
    return v3_normalize_or(rise, v3(0.0f, 0.0f, 0.0f));
}

/* Presses the water surface down at the two points where the edge of the ring passes through the
 * surface. */
static void press_waterline_points(const struct poi *poi, struct water *water, vec3 tank_size_m,
                                   vec3 up)
{
    float slope;
    const vec3 rise = slope_direction(up, &slope);
    const vec3 along = v3_cross(up, rise);
    const float reach =
        slope > LEVEL_SLOPE ? -poi->position_m.y / (poi_outer_radius_m(poi) * slope) : 1.0f;
    if (f_abs(reach) >= 1.0f) {
        return;
    }
    const float aside = f_sqrt(1.0f - reach * reach);
    const vec3 level_m_s = v3(poi->velocity_m_s.x, 0.0f, poi->velocity_m_s.z);
    const float press = f_min(BOW_SHARE * v3_length(level_m_s) * CORE_TICK_S, BOW_MAX_M);
    for (int side = -1; side <= 1; side += 2) {
        const vec3 edge = v3_muladd(v3_scale(rise, reach), along, (float)side * aside);
        water_press(water, tank_size_m, v3_muladd(poi->position_m, edge, poi_outer_radius_m(poi)),
                    BOW_RADIUS_M, press);
    }
}

void surface_disturbance_tick(const struct poi *poi, struct water *water, vec3 tank_size_m)
{
    CORE_ASSERT(tank_size_m.x > 0.0f && tank_size_m.z > 0.0f);
    const vec3 up = vec_basis_from_angles(poi->angles).up;
    const float heave_m = HEAVE_SHARE * poi->velocity_m_s.y * CORE_TICK_S;
    float press_m = 0.0f;
    if (poi->immersed >= 1.0f) {
        const float near = f_exp(poi->position_m.y / HEAVE_DEPTH_M);
        press_m = f_clamp(-heave_m * near, -HEAVE_MAX_M, HEAVE_MAX_M);
    } else if (poi->immersed > 0.0f) {
        const float sweep_m = HEAVE_SHARE * v3_length(poi->velocity_m_s) * CORE_TICK_S;
        press_m = f_clamp(sweep_m - heave_m, -PLUNGE_MAX_M, PLUNGE_MAX_M);
        press_waterline_points(poi, water, tank_size_m, up);
    }
    if (press_m != 0.0f) {
        water_press(water, tank_size_m, poi->position_m, poi_outer_radius_m(poi), press_m);
    }
    if (poi->drops > 0) {
        /* Drops fall from the lowest point of a tilted ring, or from the sag of a level ring. */
        float slope;
        const vec3 rise = slope_direction(up, &slope);
        const float off_m = poi_outer_radius_m(poi) * f_min(1.0f, slope / LEVEL_SLOPE);
        water_press(water, tank_size_m, v3_muladd(poi->position_m, rise, -off_m), DROP_RADIUS_M,
                    DROP_M * (float)poi->drops);
    }
}

/* ---- Splashes -------------------------------------------------------------------------------- */

/* Largest number of drops of a poi that enters the water, and that leaves the water. */
#define ENTRY_DROPS 28u
#define EXIT_DROPS 12u
/* Distance of the splash of a tilted ring from the ring's centre, in outer radii. */
#define SPLASH_PART 0.55f

void surface_splash(struct splashes *splashes, vec3 at_m, bool in_bowl, vec3 push_m_s,
                    float radius_m, uint8_t drops_max, uint32_t tick)
{
    CORE_ASSERT(splashes->next < SCENE_SPLASH_MAX && radius_m >= 0.0f);
    const float strong =
        (v3_length(push_m_s) - SPLASH_FROM_M_S) / (SPLASH_FULL_M_S - SPLASH_FROM_M_S);
    const float drops = (float)drops_max * f_clamp(strong, 0.0f, 1.0f);
    if (drops < 1.0f) {
        return;
    }
    splashes->latest[splashes->next] = (struct scene_splash){
        .position_m = at_m,
        .in_bowl = in_bowl,
        .push_m_s = push_m_s,
        .radius_m = radius_m,
        .seed = tick * 0x9e3779b9u + splashes->next,
        .drops = (uint8_t)drops,
    };
    splashes->ticks[splashes->next] = tick + 1u;
    splashes->next = (splashes->next + 1u) % SCENE_SPLASH_MAX;
}

void surface_splash_poi(struct splashes *splashes, const struct poi *poi, uint32_t tick)
{
    if (poi->splash_m_s != 0.0f) {
        /* A tilted ring touches the surface with its lowest part only. */
        float slope;
        const vec3 rise = slope_direction(vec_basis_from_angles(poi->angles).up, &slope);
        const float part_m =
            poi_outer_radius_m(poi) * SPLASH_PART * f_min(1.0f, slope / LEVEL_SLOPE);
        surface_splash(splashes, v3_flat(v3_muladd(poi->position_m, rise, -part_m)), false,
                       poi->velocity_m_s, poi_outer_radius_m(poi) - part_m,
                       poi->splash_m_s > 0.0f ? ENTRY_DROPS : EXIT_DROPS, tick);
    }
}

/* Returns the middle of the hole number `which` % (number of holes) of a poi's sheet in the world.
 * A hole is one cell. Returns the centre of the ring if the sheet has no hole. */
static vec3 hole_m(const struct poi *poi, uint32_t which)
{
    const struct sheet *const sheet = &poi->sheet;
    const struct basis axes = vec_basis_from_angles(poi->angles);
    uint32_t count = 0;
    for (uint32_t i = 0; i < SHEET_CELL_COUNT; i++) {
        count += sheet->state[i] == CELL_HOLE;
    }
    uint32_t left = count > 0 ? which % count : 0;
    for (uint32_t i = 0; i < SHEET_CELL_COUNT; i++) {
        if (sheet->state[i] == CELL_HOLE && left-- == 0) {
            const vec3 at =
                v3(sheet_line_m(sheet, i % SHEET_SIDE), 0.0f, sheet_line_m(sheet, i / SHEET_SIDE));
            return v3_add(poi->position_m, vec_basis_to_world(&axes, at));
        }
    }
    return poi->position_m;
}

void surface_splash_scrap(struct splashes *splashes, const struct poi *poi, uint32_t tick)
{
    const uint32_t last = (splashes->next_scrap + SCENE_SCRAP_MAX - 1u) % SCENE_SCRAP_MAX;
    const uint32_t seed = tick * 0x9e3779b9u;
    CORE_ASSERT(splashes->next_scrap < SCENE_SCRAP_MAX);
    if (poi->strain.cells_torn > 0 &&
        (splashes->scrap_ticks[last] == 0 ||
         tick + 1u - splashes->scrap_ticks[last] >= SPLASH_SCRAP_TICKS)) {
        splashes->scraps[splashes->next_scrap] = (struct scene_scrap){
            .position_m = hole_m(poi, seed >> 8), .push_m_s = poi->velocity_m_s, .seed = seed
        };
        splashes->scrap_ticks[splashes->next_scrap] = tick + 1u;
        splashes->next_scrap = (splashes->next_scrap + 1u) % SCENE_SCRAP_MAX;
    }
}

void surface_splash_show(const struct splashes *splashes, uint32_t tick, struct scene *scene)
{
    scene->splash_count = 0;
    for (uint32_t i = 1; i <= SCENE_SPLASH_MAX; i++) {
        const uint32_t at = (splashes->next + SCENE_SPLASH_MAX - i) % SCENE_SPLASH_MAX;
        const float age_s = (float)(tick + 1u - splashes->ticks[at]) * CORE_TICK_S;
        if (splashes->ticks[at] != 0 && age_s <= SCENE_SPLASH_S) {
            scene->splash[scene->splash_count] = splashes->latest[at];
            scene->splash[scene->splash_count++].age_s = age_s;
        }
    }
    scene->scrap_count = 0;
    for (uint32_t i = 0; i < SCENE_SCRAP_MAX; i++) {
        const float age_s = (float)(tick + 1u - splashes->scrap_ticks[i]) * CORE_TICK_S;
        if (splashes->scrap_ticks[i] != 0 && age_s <= SCENE_SCRAP_S) {
            scene->scrap[scene->scrap_count] = splashes->scraps[i];
            scene->scrap[scene->scrap_count++].age_s = age_s;
        }
    }
}
