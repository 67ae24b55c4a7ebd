/* poi_stand.h -- test fixture of a poi (paper scoop) with a scripted motion in a tank of fish that
 * do not swim.
 *
 * One tick runs the same steps in the same order as the core: poi, bowl, contact solver, haptics
 * and catch. The test puts the fish into the tank. */
#ifndef KINGYO_TESTS_UNIT_SUPPORT_POI_STAND_H
#define KINGYO_TESTS_UNIT_SUPPORT_POI_STAND_H

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include <cmocka.h>

#include "core/base/hash.h"
#include "core/base/physics.h"
#include "core/poi/bowl/bowl.h"
#include "core/poi/catch/catch.h"
#include "core/poi/poi.h"
#include "core/poi/ring.h"
#include "core/tank/behavior/swim.h"
#include "core/tank/tank.h"

struct stand {
    struct tank tank;
    struct poi poi;
    struct bowl bowl;
    struct output output;
    struct poi_target hand;
    struct poi_force force;
    int has_wrist;
    int laden; /* 1 if the poi tips toward the bowl as if it carried a fish, otherwise 0. */
    uint32_t tick;
    uint32_t landed, poured, walled; /* Number of fish that came into the bowl since stand_init(),
                                        by cause (struct catch_result). */
    float tension_max_n_m, tension_sum_n_m;
};

/* Initializes a tank of 0.9 m x 0.55 m with 15 cm of water and no fish. The poi has the paper grade
 * `grade` and is 6 cm above the middle of the tank. */
static inline void stand_init(struct stand *stand, uint8_t grade, uint32_t seed)
{
    memset(stand, 0, sizeof *stand);
    stand->tank.seed = seed;
    stand->tank.size_m = v3(0.90f, 0.15f, 0.55f);
    stand->tank.wall_height_m = 0.20f;
    stand->hand.position_m = v3(0.0f, 0.06f, 0.0f);
    poi_init(&stand->poi, grade, stand->hand.position_m, seed);
    stand->poi.link = POI_SOURCE_LIVE;
    bowl_init(&stand->bowl, v3(0.30f, 0.02f, 0.15f));
}

/* Adds a fish of length `length_m` to the tank. Returns its index. */
static inline uint32_t stand_fish(struct stand *stand, vec3 position_m, float length_m)
{
    const uint32_t index = stand->tank.fish_count++;
    struct fish *fish = &stand->tank.fish[index];
    fish->position_m = position_m;
    fish_grow(fish, length_m, tank_behavior_params(&stand->tank));
    fish->stamina = 1.0f;
    return index;
}

/* Runs one tick of the contact solver. A fish moves only if one of the two obstacles or another
 * fish overlaps it. */
static inline void stand_part(struct tank *tank, struct obstacle around_it[2])
{
    struct broad_phase *broad_phase = &tank->broad_phase;
    const struct perception around = tank_perception(tank, 0, around_it, 2);
    const struct solver_context place = { tank->fish, tank_bounds(tank), around_it,
                                          2,          SOLVER_PUSH_M,     tank->lanes };
    contact_solver_begin(&tank->solver, tank->fish, tank->fish_count);
    broad_phase_gather(broad_phase, tank->fish, tank->fish_count, tank->space);
    const uint32_t stations = contact_solver_substep_count(&tank->solver, &place);
    for (uint32_t station = 0; station < stations; station++) {
        contact_solver_substep(&tank->solver, broad_phase, &place, station);
        contact_solver_project(&tank->solver, broad_phase, &place);
        broad_phase_update(broad_phase, tank->fish, tank_search(tank), &around);
        contact_solver_finish(&tank->solver, broad_phase, &place);
    }
    contact_solver_end(&tank->solver, broad_phase, &place);
    const struct shoal shoal = {
        .fish = tank->fish,
        .body = broad_phase->body,
        .way_m = broad_phase->way_m,
        .before_m = tank->solver.began_m,
        .count = tank->fish_count,
    };
    swim_settle_all(&shoal, tank->lanes);
    reentry_tick(tank, around_it, 2);
}

/* Runs one tick of the poi, the bowl, the contact solver, the haptics and the catch. */
static inline void stand_tick(struct stand *stand)
{
    struct poi *poi = &stand->poi;
    stand->output.sound_count = 0;
    const struct poi_grip grip = { stand->hand, stand->has_wrist };
    poi->laden_ticks = stand->laden ? UINT8_MAX : poi->laden_ticks;
    poi_tick(poi, &grip, &stand->tank, &stand->bowl);
    const struct stall stall = { &stand->tank, &stand->bowl, 1 };
    const uint8_t live = 1;
    bowl_buoyancy_tick(&stall, poi, &live, 1);
    struct obstacle around[2] = { poi_obstacle(poi), bowl_obstacle(&stand->bowl) };
    stand_part(&stand->tank, around);
    poi_apply_reaction(poi, &around[0]);
    poi_haptics(poi, &stand->force);
    bowl_apply_reaction(&stand->bowl, &around[1]);
    bowl_fish_tick(&stand->bowl, 0, &stand->tank);
    struct catch_result caught[POI_MAX] = { 0 };
    catch_tick(poi, 0, &stall, stand->tick, &stand->output, caught);
    stand->landed += caught[0].landed;
    stand->poured += caught[0].poured;
    stand->walled += caught[0].walled;
    stand->tick++;
    stand->tension_max_n_m = f_max(stand->tension_max_n_m, poi->strain.tension_max_n_m);
    stand->tension_sum_n_m += poi->strain.tension_max_n_m;
}

/* Runs ticks for `seconds` with a constant target pose. */
static inline void stand_wait(struct stand *stand, float seconds)
{
    for (uint32_t i = 0; (float)i < seconds * (float)CORE_TICK_HZ; i++) {
        stand_tick(stand);
    }
}

/* Moves the target position in a straight line to `to_m` at `speed_m_s`. */
static inline void stand_move(struct stand *stand, vec3 to_m, float speed_m_s)
{
    const vec3 from = stand->hand.position_m;
    const vec3 way = v3_sub(to_m, from);
    const uint32_t ticks = (uint32_t)(v3_length(way) / speed_m_s * (float)CORE_TICK_HZ) + 1u;
    for (uint32_t i = 1; i <= ticks; i++) {
        stand->hand.position_m = v3_muladd(from, way, (float)i / (float)ticks);
        stand_tick(stand);
    }
}

/* Turns the target linearly to the given pitch and roll within `seconds`. */
static inline void stand_turn(struct stand *stand, float pitch_rad, float roll_rad, float seconds)
{
    const struct angles from = stand->hand.angles;
    const uint32_t ticks = (uint32_t)(seconds * (float)CORE_TICK_HZ) + 1u;
    for (uint32_t i = 1; i <= ticks; i++) {
        const float share = (float)i / (float)ticks;
        stand->hand.angles.pitch_rad = f_lerp(from.pitch_rad, pitch_rad, share);
        stand->hand.angles.roll_rad = f_lerp(from.roll_rad, roll_rad, share);
        stand_tick(stand);
    }
}

/* Dips the poi until the poi is level, at rest and completely wet at a depth of 6 cm. Then resets
 * the tension statistics. */
static inline void stand_dip(struct stand *stand)
{
    stand_turn(stand, 0.6f, 0.0f, 0.2f);
    stand_move(stand, v3(stand->hand.position_m.x, -0.06f, stand->hand.position_m.z), 0.2f);
    stand_turn(stand, 0.0f, 0.0f, 0.4f);
    stand_wait(stand, 4.0f);
    stand->tension_max_n_m = stand->tension_sum_n_m = 0.0f;
}

/* Lifts one struggling fish of 45 mm out of the water with a new poi. The poi ends level, 6 cm
 * above the water. The fish lies `off_x_m` to the right of the poi's middle with its nose at the
 * yaw `yaw_rad`. Returns the index of the fish. */
static inline uint32_t stand_lift(struct stand *stand, uint8_t grade, uint32_t seed, float off_x_m,
                                  float yaw_rad)
{
    stand_init(stand, grade, seed);
    stand_dip(stand);
    const uint32_t index = stand_fish(stand, v3(off_x_m, -0.045f, 0.005f), 0.045f);
    stand->tank.fish[index].angles.yaw_rad = yaw_rad;
    stand->tank.fish[index].alarm = 1.0f; /* The fish is fully alarmed, as after a chase. */
    stand_move(stand, v3(0.0f, 0.06f, 0.0f), 0.18f);
    return index;
}

/* Puts a new fish on the paper at (x_m, z_m) in the plane of the poi. The fish lies flat on its
 * side and does not slap for 1000 s. Returns the carried fish. */
static inline struct carried_fish *stand_lay(struct stand *stand, float length_m, float x_m,
                                             float z_m, float heading_rad)
{
    const uint32_t index = stand_fish(stand, stand->poi.position_m, length_m);
    struct carried_fish *carried = &stand->poi.carried_fish[stand->poi.carried_count++];
    stand->tank.fish[index].gait = GAIT_HELD;
    *carried = (struct carried_fish){ .fish = (uint16_t)index,
                                      .side = 1,
                                      .x_m = x_m,
                                      .z_m = z_m,
                                      .heading_rad = heading_rad,
                                      .height_m = 0.1f * length_m,
                                      .lie = 1.0f,
                                      .rest_s = 1e3f,
                                      .slap_d_m = 0.003f };
    return carried;
}

/* Turns the paper within `radius_m` of the point (x_m, z_m) in the plane of the poi into holes. */
static inline void stand_punch(struct stand *stand, float x_m, float z_m, float radius_m)
{
    struct sheet *sheet = &stand->poi.sheet;
    for (uint32_t cell = 0; cell < SHEET_CELL_COUNT; cell++) {
        const float x = sheet_line_m(sheet, cell % SHEET_SIDE) - x_m;
        const float z = sheet_line_m(sheet, cell / SHEET_SIDE) - z_m;
        if (sheet->state[cell] == CELL_PAPER && x * x + z * z < radius_m * radius_m) {
            sheet->state[cell] = CELL_HOLE;
            sheet->paper_cells--;
        }
    }
}

/* Gives all paper the strength 1 and the given wetness, as the membrane formulas assume. */
static inline void stand_plain_paper(struct sheet *sheet, float wetness)
{
    for (uint32_t i = 0; i < SHEET_CELL_COUNT; i++) {
        sheet->strength[i] = 1.0f;
        sheet->wetness[i] = wetness;
    }
    sheet->strength_min = 1.0f;
    sheet->touched = wetness > 0.0f;
}

#endif
