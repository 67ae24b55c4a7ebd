/* paper_lab.c -- simulates a poi (a paper scoop) on a carriage. Each tick updates the poi, the
 * paper and the fish on the paper in the order of core_tick(). */
#include "platform/ctl/play/paper_lab.h"

#include <string.h>

#include "core/base/panic.h"
#include "core/poi/catch/carried_fish.h"
#include "core/poi/ring.h"

#define DEPTH_M 0.20f /* Depth at which the water surface has no effect on the poi. */
#define HEIGHT_M 0.10f
/* A tear within this number of ticks counts as immediate. 6 ticks are 0.05 s. */
#define INSTANT_TICKS 6u
#define NEVER_S 1e6f

/* ---- Initial state --------------------------------------------------------------------------- */

/* Sets the wetness of the sheet's cells, column by column from the left, until the requested
 * fraction of the paper is wet. */
static void wet_paper(struct paper_lab *lab)
{
    const struct paper_options *plan = lab->plan;
    struct sheet *sheet = &lab->poi.sheet;
    const float wanted = plan->wet_fraction * (float)sheet->paper_cells;
    uint32_t wetted = 0;
    for (uint32_t column = 0; column < SHEET_SIDE && (float)wetted + 0.5f <= wanted; column++) {
        for (uint32_t row = 0; row < SHEET_SIDE; row++) {
            const uint32_t cell = row * SHEET_SIDE + column;
            if (sheet->state[cell] == CELL_PAPER) {
                lab->wetness[cell] = plan->wetness;
                wetted++;
            }
        }
    }
    memcpy(sheet->wetness, lab->wetness, sizeof sheet->wetness);
    sheet->touched = plan->wetness > 0.0f && wetted > 0;
    sheet->soaked = plan->wetness >= 1.0f && wetted == sheet->paper_cells;
}

/* Places the fish on the paper in the spiral pattern of sunflower seeds. No fish lies on another if
 * the paper has room for all of them. */
static void place_fish(struct paper_lab *lab)
{
    const struct paper_options *plan = lab->plan;
    const struct basis axes = vec_basis_from_angles(lab->poi.angles);
    for (uint32_t i = 0; i < plan->fish_count; i++) {
        struct fish *fish = &lab->tank.fish[lab->tank.fish_count++];
        const float share = ((float)i + 0.5f) / (float)plan->fish_count;
        const float away = plan->fish_count > 1u ? 0.030f * f_sqrt(share) : 0.0f;
        const float turn = 2.39996f * (float)i;
        fish_grow(fish, plan->fish_m, tank_behavior_params(&lab->tank));
        fish->stamina = 1.0f;
        fish->angles.yaw_rad = turn;
        const vec3 place = v3(away * f_cos(turn), 0.5f * fish->height_m, away * f_sin(turn));
        fish->position_m = v3_add(lab->poi.position_m, vec_basis_to_world(&axes, place));
        fish->velocity_m_s = lab->poi.velocity_m_s;
    }
}

void paper_lab_open(struct paper_lab *lab, const struct paper_options *plan)
{
    CORE_ASSERT(plan->grade >= SHEET_GRADE_MIN && plan->grade <= SHEET_GRADE_MAX);
    CORE_ASSERT(plan->fish_count <= POI_CARRIED_MAX && plan->wetness >= 0.0f);
    memset(lab, 0, sizeof *lab);
    lab->plan = plan;
    lab->tank.seed = plan->seed;
    lab->tank.size_m = v3(0.9f, 0.5f, 0.6f);
    lab->tank.wall_height_m = 0.55f;
    struct poi *poi = &lab->poi;
    poi_init(poi, plan->grade, v3(0.0f, plan->in_air ? HEIGHT_M : -DEPTH_M, 0.0f), plan->seed);
    if (plan->ideal) {
        sheet_idealise(&poi->sheet);
    }
    poi->link = POI_SOURCE_LIVE;
    poi->velocity_m_s = v3(0.0f, plan->speed_m_s, 0.0f);
    poi->angles.roll_rad = 0.5f * F_PI - plan->tilt_rad;
    if (plan->upside_down) {
        poi->angles.roll_rad = F_PI - poi->angles.roll_rad;
    }
    wet_paper(lab);
    const float up_y = vec_basis_from_angles(poi->angles).up.y;
    /* Fills the poi with water. Dry paper carries no water. Wet paper carries a film of water, and
     * also the water that lies on the paper in its present pose. */
    const float wet = plan->wetness * plan->wet_fraction;
    poi->immersed = 1.0f;
    carried_water_tick(poi, up_y);
    poi->film_kg *= wet;
    poi->pool_kg *= wet > 0.0f ? 1.0f : 0.0f;
    poi->water_kg = poi->film_kg + poi->pool_kg;
    poi->immersed = disc_immersed(POI_RADIUS_M, poi->position_m.y, up_y);
    if (plan->in_air) {
        place_fish(lab);
    }
}

/* ---- One tick -------------------------------------------------------------------------------- */

/* Returns the force on the paper in N. `whole` is the fraction of the paper without holes. The
 * force perpendicular to the paper is the load on the sheet. The force in the plane of the paper is
 * the friction of the water. */
static float paper_force_n(const struct poi *poi, const struct basis *axes, float whole)
{
    const float area_m2 = whole * F_PI * POI_RADIUS_M * POI_RADIUS_M;
    const vec3 v = vec_basis_to_body(axes, poi->velocity_m_s);
    const float normal_n = poi->pressure_pa * area_m2;
    const float plane_n = poi->edge_n_s_m * f_sqrt(v.x * v.x + v.z * v.z);
    return f_sqrt(normal_n * normal_n + plane_n * plane_n);
}

static void catch_fish(struct paper_lab *lab)
{
    struct output output = { 0 };
    struct catch_result results[POI_MAX] = { 0 };
    const struct stall stall = { &lab->tank, &lab->bowl, 0, false };
    for (uint32_t i = 0; lab->plan->still && i < lab->poi.carried_count; i++) {
        lab->poi.carried_fish[i].rest_s = NEVER_S;
    }
    catch_tick(&lab->poi, 0, &stall, lab->tick, &output, results);
}

void paper_lab_tick(struct paper_lab *lab)
{
    struct poi *poi = &lab->poi;
    CORE_ASSERT(lab->plan && poi->carried_count <= POI_CARRIED_MAX);
    const struct basis axes = vec_basis_from_angles(poi->angles);
    const vec3 carriage_m_s = v3(0.0f, lab->plan->speed_m_s, 0.0f);
    poi->before_m = poi->position_m;
    poi->before_m_s = carriage_m_s;
    poi->before_angles = poi->angles;
    if (lab->tick == 0) {
        catch_fish(lab); /* Puts the fish on the paper before the first tick. */
    }
    lab->tick++;
    /* Computes the forces of the water on the poi's ring. */
    poi_spring_tick(poi, poi->position_m, &axes, poi->immersed);
    /* Restores the constant speed, because the carriage does not yield to forces. */
    poi->velocity_m_s = carriage_m_s;
    /* `whole` is the fraction of the paper without holes at the time when the force was
     * computed. */
    const float whole = poi_whole(poi);
    const struct obstacle ring = poi_obstacle(poi);
    poi_apply_reaction(poi, &ring);
    lab->force_n = f_max(lab->force_n, paper_force_n(poi, &axes, whole));
    lab->tension_n_m = f_max(lab->tension_n_m, poi->strain.tension_max_n_m);
    lab->water_kg = f_max(lab->water_kg, poi->water_kg);
    if (lab->tore_tick == 0 && poi->strain.cells_torn > 0) {
        lab->tore_tick = lab->tick;
    }
    memcpy(poi->sheet.wetness, lab->wetness, sizeof lab->wetness);
    catch_fish(lab);
}

/* ---- Results --------------------------------------------------------------------------------- */

double paper_lab_tore_s(const struct paper_lab *lab)
{
    return lab->tore_tick > 0 ? (double)lab->tore_tick / CORE_TICK_HZ : -1.0;
}

bool paper_lab_is_instant(const struct paper_lab *lab)
{
    return lab->tore_tick > 0 && lab->tore_tick <= INSTANT_TICKS;
}

double paper_lab_hole_mm2(const struct paper_lab *lab)
{
    return 1e6 * (double)sheet_hole_m2(&lab->poi.sheet);
}
