/* poi_fixture.h -- test fixture of a poi (paper scoop) with a scripted motion, in a tank of fish
 * that do not swim. One tick runs the same steps in the same order as the core: poi, bowl, contact
 * solver, haptics and catch. The test puts fish into the tank. */
#ifndef KINGYO_TESTS_UNIT_SUPPORT_POI_FIXTURE_H
#define KINGYO_TESTS_UNIT_SUPPORT_POI_FIXTURE_H

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

struct poi_fixture {
    struct tank tank;
    struct poi poi;
    struct bowl bowl;
    struct output output;
    struct poi_target hand;
    struct poi_force force;
    int has_wrist;
    /* 1 if the poi counts as loaded, so that it tips toward the bowl; otherwise 0. */
    int laden;
    uint32_t tick;
    uint32_t landed, poured, walled; /* Number of fish that entered the bowl since fixture_init().
                                        The counters are for the cases of struct catch_result. */
    float tension_max_n_m, tension_sum_n_m;
};

/* Initializes a tank of 0.9 m x 0.55 m with 15 cm of water and no fish. The poi has the paper grade
 * `grade` and is 6 cm above the middle of the tank. */
static inline void fixture_init(struct poi_fixture *fixture, uint8_t grade, uint32_t seed)
{
    memset(fixture, 0, sizeof *fixture);
    fixture->tank.seed = seed;
    fixture->tank.size_m = v3(0.90f, 0.15f, 0.55f);
    fixture->tank.wall_height_m = 0.20f;
    fixture->hand.position_m = v3(0.0f, 0.06f, 0.0f);
    poi_init(&fixture->poi, grade, fixture->hand.position_m, seed);
    fixture->poi.link = POI_SOURCE_LIVE;
    bowl_init(&fixture->bowl, v3(0.30f, 0.02f, 0.15f));
}

/* Adds a fish of length `length_m` at `position_m` to the tank. Returns the index of the fish. */
static inline uint32_t fixture_add_fish(struct poi_fixture *fixture, vec3 position_m,
                                        float length_m)
{
    const uint32_t index = fixture->tank.fish_count++;
    struct fish *fish = &fixture->tank.fish[index];
    fish->position_m = position_m;
    fish_grow(fish, length_m, tank_behavior_params(&fixture->tank));
    fish->stamina = 1.0f;
    return index;
}

/* Runs one tick of the contact solver, with the poi and the bowl as the two obstacles. A fish moves
 * only if an obstacle or another fish overlaps it. */
static inline void fixture_solve_contacts(struct tank *tank, struct obstacle around_it[2])
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
static inline void fixture_tick(struct poi_fixture *fixture)
{
    struct poi *poi = &fixture->poi;
    fixture->output.sound_count = 0;
    const struct poi_grip grip = { fixture->hand, fixture->has_wrist };
    poi->laden_ticks = fixture->laden ? UINT8_MAX : poi->laden_ticks;
    poi_tick(poi, &grip, &fixture->tank, &fixture->bowl);
    const struct stall stall = { &fixture->tank, &fixture->bowl, 1, false };
    const uint8_t live = 1;
    bowl_buoyancy_tick(&stall, poi, &live, 1);
    struct obstacle around[2] = { poi_obstacle(poi), bowl_obstacle(&fixture->bowl) };
    fixture_solve_contacts(&fixture->tank, around);
    poi_apply_reaction(poi, &around[0]);
    poi_haptics(poi, &fixture->force);
    bowl_apply_reaction(&fixture->bowl, &around[1]);
    bowl_fish_tick(&fixture->bowl, 0, &fixture->tank);
    struct catch_result caught[POI_MAX] = { 0 };
    catch_tick(poi, 0, &stall, fixture->tick, &fixture->output, caught);
    fixture->landed += caught[0].landed;
    fixture->poured += caught[0].poured;
    fixture->walled += caught[0].walled;
    fixture->tick++;
    fixture->tension_max_n_m = f_max(fixture->tension_max_n_m, poi->strain.tension_max_n_m);
    fixture->tension_sum_n_m += poi->strain.tension_max_n_m;
}

/* Runs ticks for `seconds` seconds with a constant target pose. */
static inline void fixture_wait(struct poi_fixture *fixture, float seconds)
{
    for (uint32_t i = 0; (float)i < seconds * (float)CORE_TICK_HZ; i++) {
        fixture_tick(fixture);
    }
}

/* Moves the target position in a straight line to `to_m` at `speed_m_s`. */
static inline void fixture_move(struct poi_fixture *fixture, vec3 to_m, float speed_m_s)
{
    const vec3 from = fixture->hand.position_m;
    const vec3 way = v3_sub(to_m, from);
    const uint32_t ticks = (uint32_t)(v3_length(way) / speed_m_s * (float)CORE_TICK_HZ) + 1u;
    for (uint32_t i = 1; i <= ticks; i++) {
        fixture->hand.position_m = v3_muladd(from, way, (float)i / (float)ticks);
        fixture_tick(fixture);
    }
}

/* Turns the target linearly to the given pitch and roll within `seconds`. */
static inline void fixture_turn(struct poi_fixture *fixture, float pitch_rad, float roll_rad,
                                float seconds)
{
    const struct angles from = fixture->hand.angles;
    const uint32_t ticks = (uint32_t)(seconds * (float)CORE_TICK_HZ) + 1u;
    for (uint32_t i = 1; i <= ticks; i++) {
        const float share = (float)i / (float)ticks;
        fixture->hand.angles.pitch_rad = f_lerp(from.pitch_rad, pitch_rad, share);
        fixture->hand.angles.roll_rad = f_lerp(from.roll_rad, roll_rad, share);
        fixture_tick(fixture);
    }
}

/* Dips the poi to a depth of 6 cm until it is level, at rest and completely wet. Then resets the
 * tension statistics. */
static inline void fixture_dip(struct poi_fixture *fixture)
{
    fixture_turn(fixture, 0.6f, 0.0f, 0.2f);
    fixture_move(fixture, v3(fixture->hand.position_m.x, -0.06f, fixture->hand.position_m.z), 0.2f);
    fixture_turn(fixture, 0.0f, 0.0f, 0.4f);
    fixture_wait(fixture, 4.0f);
    fixture->tension_max_n_m = fixture->tension_sum_n_m = 0.0f;
}

/* Lifts one struggling fish of 45 mm out of the water with a new poi. At the end, the poi is level
 * and 6 cm above the water. The fish lies `off_x_m` to the right of the poi's middle, and its nose
 * has the yaw `yaw_rad`. Returns the index of the fish. */
static inline uint32_t fixture_lift(struct poi_fixture *fixture, uint8_t grade, uint32_t seed,
                                    float off_x_m, float yaw_rad)
{
    fixture_init(fixture, grade, seed);
    fixture_dip(fixture);
    const uint32_t index = fixture_add_fish(fixture, v3(off_x_m, -0.045f, 0.005f), 0.045f);
    fixture->tank.fish[index].angles.yaw_rad = yaw_rad;
    /* Makes the fish fully alarmed, as after a chase. */
    fixture->tank.fish[index].alarm = 1.0f;
    fixture_move(fixture, v3(0.0f, 0.06f, 0.0f), 0.18f);
    return index;
}

/* Puts a new fish on the paper at (x_m, z_m) in the plane of the poi. The fish lies flat on its
 * side, and does not slap for the next 1000 s. Returns the carried fish. */
static inline struct carried_fish *fixture_place_fish(struct poi_fixture *fixture, float length_m,
                                                      float x_m, float z_m, float heading_rad)
{
    const uint32_t index = fixture_add_fish(fixture, fixture->poi.position_m, length_m);
    struct carried_fish *carried = &fixture->poi.carried_fish[fixture->poi.carried_count++];
    fixture->tank.fish[index].gait = GAIT_HELD;
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

/* Turns the paper into holes within `radius_m` of the point (x_m, z_m) in the plane of the poi. */
static inline void fixture_tear_hole(struct poi_fixture *fixture, float x_m, float z_m,
                                     float radius_m)
{
    struct sheet *sheet = &fixture->poi.sheet;
    for (uint32_t cell = 0; cell < SHEET_CELL_COUNT; cell++) {
        const float x = sheet_line_m(sheet, cell % SHEET_SIDE) - x_m;
        const float z = sheet_line_m(sheet, cell / SHEET_SIDE) - z_m;
        if (sheet->state[cell] == CELL_PAPER && x * x + z * z < radius_m * radius_m) {
            sheet->state[cell] = CELL_HOLE;
            sheet->paper_cells--;
        }
    }
}

/* Sets the strength of all paper to 1 and its wetness to `wetness`, because the membrane formulas
 * assume uniform paper. */
static inline void fixture_plain_paper(struct sheet *sheet, float wetness)
{
    for (uint32_t i = 0; i < SHEET_CELL_COUNT; i++) {
        sheet->strength[i] = 1.0f;
        sheet->wetness[i] = wetness;
    }
    sheet->strength_min = 1.0f;
    sheet->touched = wetness > 0.0f;
}

#endif
