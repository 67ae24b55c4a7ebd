/* test_lost_input.c -- checks that a controller fault during a scoop pauses the round and does not
 * tear the paper.
 *
 * The test combines two devices (a noisy sensor and a pointer), two situations (deep in the water,
 * and carrying a fish), three states of the weakest paper (dry, wet, half wet) and each kind of
 * fault. */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

#include <cmocka.h>

#include "core/base/rng.h"
#include "core/core.h"
#include "core/game/control/controller.h"
#include "core/game/phases.h"

enum device { SENSOR, POINTER, DEVICE_COUNT };
enum wetness { DRY, WET, HALF_WET, WETNESS_COUNT };
enum whereabouts { DEEP, CARRYING, WHEREABOUTS_COUNT };
enum fault {
    JUMP,
    JUMP_AND_BACK,
    SPIKE,
    UNPLUG,
    SILENCE,
    STUCK,
    NOT_A_NUMBER,
    FLIP,
    TURN,
    TURN_AND_BACK,
    LATE_BURST,
    FAULT_COUNT
};

struct scene_of {
    enum device device;
    enum wetness wetness;
    enum whereabouts place;
    enum fault fault;
};

static struct core core;
static struct input input;
static struct output output;
static vec3 hand_m;    /* True position of the player's controller, in m. */
static float roll_rad; /* True roll of the player's controller. */
static enum device device;
static uint32_t still_ticks; /* Number of ticks in which the clock of the round was stopped. */

/* ---- A player with a working controller ----------------------------------------------------- */

static float tremble(uint32_t what)
{
    return rng_range((struct rng_key){ 11, core.game.tick, what, RNG_TEST }, -5e-5f, 5e-5f);
}

/* Reports the true pose. The controller sways slowly and trembles. */
static void report_true_pose(void)
{
    const float sway_m_s = core.game.tick / 240u % 2u ? 0.04f : -0.04f;
    hand_m.z += sway_m_s * CORE_TICK_S;
    struct poi_input *poi = &input.poi[0];
    *poi = (struct poi_input){ .link = POI_SOURCE_LIVE, .target.position_m = hand_m };
    poi->target.angles.roll_rad = roll_rad;
    if (device == SENSOR) {
        poi->has_wrist = poi->trembles = 1;
        poi->target.position_m = v3_add(hand_m, v3(tremble(0), tremble(1), tremble(2)));
        poi->target.angles.roll_rad += 0.2f * tremble(3);
    }
}

static void check_numbers(void)
{
    const struct poi *poi = &core.world.poi[0];
    assert_true(v3_is_finite(poi->position_m) && v3_is_finite(poi->velocity_m_s));
    assert_true(f_is_finite(poi->pressure_pa + poi->water_kg + poi->sheet.sag_m));
}

static void run_tick(void)
{
    const float before_s = game_seconds_left(&core.game, core.game.tick);
    output.sound_count = 0;
    core_tick(&core, &input, &output);
    input.pressed = 0;
    still_ticks += before_s == game_seconds_left(&core.game, core.game.tick);
    check_numbers();
}

static void move_to(vec3 goal_m, float pace_m_s)
{
    while (v3_length(v3_sub(goal_m, hand_m)) > 1e-3f) {
        const vec3 way_m = v3_sub(goal_m, hand_m);
        hand_m = v3_add(hand_m, v3_limit(way_m, pace_m_s * CORE_TICK_S));
        report_true_pose();
        run_tick();
    }
}

static void wait(uint32_t ticks)
{
    for (uint32_t i = 0; i < ticks; i++) {
        report_true_pose();
        run_tick();
    }
}

static void soak(struct sheet *sheet, enum wetness wetness)
{
    const float dry_share = wetness == DRY ? 1.0f : wetness == WET ? 0.0f : 0.5f;
    for (uint32_t cell = 0; cell < SHEET_CELL_COUNT; cell++) {
        const uint32_t column = cell % SHEET_SIDE;
        sheet->wetness[cell] = (float)column < dry_share * (float)SHEET_SIDE ? 0.0f : 1.0f;
    }
    sheet->touched = wetness != DRY;
    sheet->soaked = wetness == WET;
}

/* Lifts the ring under a fish, so that the poi carries the fish. */
static void take_a_fish(void)
{
    struct fish *fish = &core.world.tank.fish[0];
    move_to(v3(hand_m.x, -0.02f, hand_m.z), 0.1f);
    for (uint32_t i = 0; i < 400 && core.world.poi[0].carried_count == 0; i++) {
        fish->position_m = v3_add(core.world.poi[0].position_m, v3(0.0f, 0.008f, 0.0f));
        fish->velocity_m_s = v3(0.0f, 0.0f, 0.0f);
        hand_m.y += 0.05f * CORE_TICK_S;
        wait(1);
    }
    assert_int_equal(core.world.poi[0].carried_count, 1);
    move_to(v3(hand_m.x, 0.05f, hand_m.z), 0.08f);
}

static void begin(const struct scene_of *of)
{
    const struct core_config config = { .seed = 5, .fish_count = 20, .round_s = 600 };
    memset(&input, 0, sizeof input);
    device = of->device;
    hand_m = v3(-0.08f, 0.06f, 0.04f);
    roll_rad = 0.0f;
    assert_int_equal(core_init(&core, &config), CORE_OK);
    wait(5);
    input.pressed = INPUT_START;
    run_tick();
    while (core.game.phase != PHASE_ROUND) {
        wait(1);
    }
    sheet_init(&core.world.poi[0].sheet, SHEET_GRADE_MAX, POI_RADIUS_M, 3);
    if (of->place == DEEP) {
        move_to(v3(-0.08f, -0.07f, 0.04f), 0.1f);
    } else {
        take_a_fish();
    }
    wait(60);
    soak(&core.world.poi[0].sheet, of->wetness);
}

/* ---- Simulated controller faults ------------------------------------------------------------ */

/* Writes the report that the controller sends `tick` ticks after the fault began. Returns 1 while
 * the fault lasts. */
static int report_fault(enum fault fault, uint32_t tick)
{
    struct poi_input *poi = &input.poi[0];
    const uint16_t age = (uint16_t)(tick + 1u);
    const struct poi_input before = *poi;
    report_true_pose();
    switch (fault) {
    /* The fault JUMP: the controller's true position changes by 1 m and stays there. */
    case JUMP:
        hand_m.x += tick == 0 ? (hand_m.x > 0.0f ? -1.0f : 1.0f) : 0.0f;
        report_true_pose();
        return tick < 1;
    case JUMP_AND_BACK:
        poi->target.position_m = v3_add(poi->target.position_m, v3(0.7f, 0.3f, -0.7f));
        return tick < 12;
    case SPIKE:
        poi->target.position_m.y -= 1.0f;
        return tick < 1;
    case UNPLUG:
        poi->link = POI_SOURCE_LOST;
        return tick < 200;
    case SILENCE:
        *poi = before;
        poi->age_ticks = age;
        return tick < 200;
    /* The fault STUCK: the controller repeats its last report. For a pointer this is not a fault,
     * because a resting mouse repeats its report too. */
    case STUCK:
        *poi = before;
        return tick < 300;
    case NOT_A_NUMBER:
        poi->target.position_m.z = tick % 2u ? NAN : INFINITY;
        poi->target.angles.pitch_rad = NAN;
        return tick < 30;
    case FLIP:
        poi->target.angles.roll_rad += F_PI;
        poi->target.angles.pitch_rad -= 1.0f;
        return tick < 6;
    /* The fault TURN: the controller turns by 1.2 rad and keeps its new roll angle. */
    case TURN:
        roll_rad += tick == 0 ? 1.2f : 0.0f;
        report_true_pose();
        return tick < 1;
    case TURN_AND_BACK:
        poi->target.angles.pitch_rad += 1.0f;
        return tick < 3;
    /* The fault LATE_BURST: the reports stop for less than the timeout, and the next position is 20
     * cm away. */
    case LATE_BURST:
        *poi = before;
        poi->age_ticks = age;
        hand_m.x += tick == 50 ? 0.20f : 0.0f;
        return tick < 50;
    default:
        return 0;
    }
}

/* ---- Permitted effects ---------------------------------------------------------------------- */

static int loses_input(const struct scene_of *of)
{
    const int is_away = of->fault == UNPLUG || of->fault == SILENCE || of->fault == NOT_A_NUMBER;
    /* A mouse may jump to any place, so a jump counts as a fault only if the device is a sensor. */
    return is_away || (of->fault != LATE_BURST && of->device == SENSOR);
}

static float damage_sum(void)
{
    float sum = 0.0f;
    for (uint32_t cell = 0; cell < SHEET_CELL_COUNT; cell++) {
        sum += core.world.poi[0].sheet.damage[cell];
    }
    return sum;
}

/* Returns 1 if the fish lies on wet paper for so long that its slaps may tear the paper, even
 * without a controller fault. */
static bool may_slap(const struct scene_of *of)
{
    const int is_long = of->fault == STUCK || of->fault == LATE_BURST || of->fault == SILENCE ||
                        of->device == POINTER;
    return of->place == CARRYING && is_long;
}

/* Checks every tick from the fault until the player controls the poi again. While damage is
 * disabled, the damage of each cell of the paper must stay the same. */
static void check_fault(const struct scene_of *of)
{
    static float damage[SHEET_CELL_COUNT];
    const struct poi *poi = &core.world.poi[0];
    uint32_t cells = poi->sheet.paper_cells;
    uint32_t lost_ticks = 0, tick = 0;
    int broken = 1, leads;
    memcpy(damage, poi->sheet.damage, sizeof damage);
    still_ticks = 0;
    do {
        broken = broken && report_fault(of->fault, tick);
        if (!broken) {
            report_true_pose();
        }
        run_tick();
        tick++;
        lost_ticks += (uint32_t)controller_is_lost(&core.world, 0);
        const int is_led =
            !controller_is_lost(&core.world, 0) && core.game.control[0].return_ticks == 0;
        leads = is_led && !broken;
        if (poi->damage_immune) {
            /* While the controller is lost, it must get no force feedback. */
            assert_true(v3_length(output.poi[0].force_n) == 0.0f);
            assert_memory_equal(poi->sheet.damage, damage, sizeof damage);
        } else {
            /* The player controls the poi in this tick, so the paper may wear. */
            memcpy(damage, poi->sheet.damage, sizeof damage);
            /* The number of cells is not compared if the fish's slaps may tear the paper. */
            cells = may_slap(of) ? poi->sheet.paper_cells : cells;
        }
        assert_true(poi->damage_immune || !loses_input(of) || leads || broken);
        assert_int_equal(poi->sheet.paper_cells, cells);
        assert_true(tick < 1200);
    } while (!leads);
    /* The clock of the round must stop in exactly those ticks in which the controller is lost. */
    assert_int_equal(still_ticks, lost_ticks);
    assert_int_equal(lost_ticks > 0, loses_input(of));
    /* After the fault TURN, the ring stays tilted by 69 degrees, so the fish may slide off. */
    if (of->fault != TURN) {
        /* The fish that the poi carried before the fault must still be on the paper. No other fish
         * may be on it. */
        assert_int_equal(poi->carried_count, of->place == CARRYING);
    }
    if (of->fault == SPIKE && of->device == SENSOR) {
        assert_in_range(lost_ticks, INPUT_AGREE_TICKS, INPUT_AGREE_TICKS + 1u);
    }
}

/* Checks that the fault does not damage the paper later. For example, moving water or the spring
 * that pulls the poi could damage it. */
static void check_aftermath(const struct scene_of *of)
{
    const uint32_t cells = core.world.poi[0].sheet.paper_cells;
    const float before = damage_sum();
    if (of->place == CARRYING) {
        /* The slaps of the carried fish may tear the wet paper, so the damage is not compared. */
        return;
    }
    wait(120);
    assert_int_equal(core.world.poi[0].sheet.paper_cells, cells);
    /* After the fault JUMP, the poi moves through the water to the wall, so more wear is
     * allowed. */
    assert_true(damage_sum() - before < (of->fault == JUMP ? 0.05f : 1e-3f));
    /* After the fault JUMP, the true position is beyond the wall, where the poi cannot go. */
    assert_true(v3_length(v3_sub(core.world.poi[0].position_m, hand_m)) < 0.05f ||
                of->fault == JUMP);
}

static void check(const struct scene_of *of)
{
    begin(of);
    check_fault(of);
    check_aftermath(of);
}

static void test_no_controller_fault_tears_paper_in_any_place(void **state)
{
    (void)state;
    for (uint32_t i = 0; i < DEVICE_COUNT * WETNESS_COUNT * WHEREABOUTS_COUNT * FAULT_COUNT; i++) {
        const struct scene_of of = {
            .device = (enum device)(i % DEVICE_COUNT),
            .wetness = (enum wetness)(i / DEVICE_COUNT % WETNESS_COUNT),
            .place = (enum whereabouts)(i / (DEVICE_COUNT * WETNESS_COUNT) % WHEREABOUTS_COUNT),
            .fault = (enum fault)(i / (DEVICE_COUNT * WETNESS_COUNT * WHEREABOUTS_COUNT)),
        };
        check(&of);
    }
}

/* ---- Pose errors below the limits ----------------------------------------------------------- */

/* A small error of the reported pose. The error amounts to some centimetres or degrees, and lasts
 * for some ticks or for ever. */
struct stray {
    float up_m, aside_m, roll_rad, pitch_rad;
    /* 1 if the error is so small that the poi must accept it as the new true pose when it is
     * permanent. */
    int may_stay;
};

static const struct stray strays[] = {
    { 0.04f, 0.0f, 0.0f, 0.0f, 0 },  { 0.05f, 0.0f, 0.0f, 0.0f, 0 }, { 0.06f, 0.0f, 0.0f, 0.0f, 0 },
    { 0.08f, 0.0f, 0.0f, 0.0f, 0 },  { 0.0f, 0.08f, 0.0f, 0.0f, 0 }, { 0.25f, 0.0f, 0.0f, 0.0f, 0 },
    { 0.0f, 0.40f, 0.0f, 0.0f, 1 },  { 0.0f, 0.0f, 0.30f, 0.0f, 1 }, { 0.0f, 0.0f, 0.0f, 0.50f, 1 },
    { 0.0f, 0.0f, 0.80f, 0.0f, 1 },  { 0.0f, 0.0f, 0.0f, 1.05f, 1 }, { 0.0f, 0.0f, 1.22f, 0.0f, 1 },
    { 0.05f, 0.0f, 0.40f, 0.0f, 0 },
};

static void stray_for(const struct stray *stray, uint32_t ticks)
{
    for (uint32_t i = 0; i < ticks; i++) {
        report_true_pose();
        struct poi_target *target = &input.poi[0].target;
        target->position_m = v3_add(target->position_m, v3(stray->aside_m, stray->up_m, 0.0f));
        target->angles.roll_rad += stray->roll_rad;
        target->angles.pitch_rad += stray->pitch_rad;
        run_tick();
    }
}

/* Checks each small error of the pose. Each check begins with a poi that rests deep in the
 * water. */
static void check_strays(const struct core *from, enum wetness wetness, uint8_t grade)
{
    static const uint32_t lasts[] = { 1, 2, 3, 6, 8, 300 };
    const vec3 there_m = hand_m;
    for (size_t i = 0; i < sizeof strays / sizeof strays[0]; i++) {
        for (size_t k = 0; k < sizeof lasts / sizeof lasts[0]; k++) {
            const int turns = strays[i].roll_rad != 0.0f || strays[i].pitch_rad != 0.0f;
            if ((lasts[k] > 8u && !strays[i].may_stay) || (turns && device == POINTER)) {
                /* A pointer reports no angles, so errors of the angles cannot occur. */
                continue;
            }
            core = *from;
            hand_m = there_m;
            sheet_init(&core.world.poi[0].sheet, grade, POI_RADIUS_M, 3);
            soak(&core.world.poi[0].sheet, wetness);
            stray_for(&strays[i], lasts[k]);
            wait(lasts[k] > 8u ? 1u : 90u);
            if (core.world.poi[0].sheet.paper_cells != core.world.poi[0].sheet.paper_cells_new) {
                fail_msg("grade %u, wetness %d, device %d: stray %zu for %u ticks: %u cells left",
                         grade, (int)wetness, (int)device, i, lasts[k],
                         core.world.poi[0].sheet.paper_cells);
            }
        }
    }
}

static void test_no_small_pose_error_tears_wet_paper_of_any_grade(void **state)
{
    static struct core still;
    (void)state;
    for (uint32_t i = 0; i < DEVICE_COUNT * 2u; i++) {
        const struct scene_of of = {
            .device = (enum device)(i % DEVICE_COUNT),
            .wetness = i / DEVICE_COUNT ? WET : HALF_WET,
            .place = DEEP,
        };
        begin(&of);
        still = core;
        for (uint8_t grade = 5; grade <= SHEET_GRADE_MAX; grade++) {
            check_strays(&still, of.wetness, grade);
        }
    }
}

static void test_a_fish_carried_during_a_fault_can_be_landed_and_counts(void **state)
{
    (void)state;
    for (uint32_t i = 0; i < FAULT_COUNT; i++) {
        const struct scene_of of = {
            .device = POINTER,
            .wetness = DRY,
            .place = CARRYING,
            .fault = (enum fault)i,
        };
        if (of.fault == TURN) {
            continue;
        }
        begin(&of);
        check_fault(&of);
        const vec3 bowl_m = core.world.bowl[0].position_m;
        move_to(v3(hand_m.x, 0.06f, hand_m.z), 0.2f);
        move_to(v3(bowl_m.x, 0.06f, bowl_m.z), 0.3f);
        wait(200);
        assert_int_equal(core.game.player[0].caught, 1);
    }
}

/* When the controller returns, the poi is 20 cm away from it under water. The poi must reach the
 * controller's position within 1.5 s, and must not move faster than a careful player. */
static void test_the_poi_glides_back_without_a_jump(void **state)
{
    (void)state;
    const struct scene_of of = { .device = SENSOR, .place = DEEP, .fault = UNPLUG };
    begin(&of);
    input.poi[0].link = POI_SOURCE_LOST;
    for (uint32_t tick = 0; tick < 400; tick++) {
        run_tick();
    }
    assert_float_equal(core.world.poi[0].position_m.y, FAILSAFE_HOVER_M, 0.005f);
    float fastest_m_s = 0.0f;
    uint32_t ticks = 0;
    for (; controller_is_lost(&core.world, 0) || core.world.poi[0].damage_immune; ticks++) {
        wait(1);
        fastest_m_s = f_max(fastest_m_s, v3_length(core.world.poi[0].velocity_m_s));
        assert_true(ticks < 240);
    }
    print_message("back after %u ticks, at %.2f m/s at most\n", ticks, (double)fastest_m_s);
    assert_true(fastest_m_s < 0.8f);
    assert_true(v3_length(v3_sub(core.world.poi[0].position_m, hand_m)) < 0.02f);
}

/* The poi of an absent player must leave the water soon, because it would be in the way of other
 * players. */
static void test_a_lost_poi_leaves_the_water(void **state)
{
    (void)state;
    const struct scene_of of = { .device = SENSOR, .place = DEEP, .fault = UNPLUG };
    uint32_t ticks = 0;
    begin(&of);
    input.poi[0].link = POI_SOURCE_LOST;
    for (; core.world.poi[0].immersed > 0.0f; ticks++) {
        run_tick();
        assert_true(ticks < 360);
    }
    print_message("clear of the water after %u ticks\n", ticks);
    for (uint32_t i = 0; i < 240; i++) {
        run_tick();
    }
    const vec3 hovers_m = core.world.poi[0].position_m;
    for (uint32_t i = 0; i < 600; i++) {
        run_tick();
        assert_true(v3_length(v3_sub(core.world.poi[0].position_m, hovers_m)) < 0.001f);
    }
    assert_true(core.world.poi[0].immersed <= 0.0f);
}

/* The lost poi starts in corners, at walls, on the floor or at the bowl, and at different
 * angles. */
static void test_a_lost_poi_leaves_the_water_from_any_position(void **state)
{
    (void)state;
    const struct scene_of of = { .device = POINTER, .place = DEEP };
    uint32_t slowest = 0;
    begin(&of);
    static struct core there;
    there = core;
    for (uint32_t i = 0; i < 5u * 3u * 2u * 5u; i++) {
        core = there;
        struct poi *poi = &core.world.poi[0];
        const vec3 half_m = v3_scale(core.world.tank.size_m, 0.5f);
        poi->position_m =
            v3(half_m.x * (-0.9f + 0.45f * (float)(i % 5u)), i / 15u % 2u ? -0.03f : -0.11f,
               half_m.z * (-0.85f + 0.85f * (float)(i / 5u % 3u)));
        poi->angles.pitch_rad = -1.2f + 0.6f * (float)(i / 30u);
        poi->angles.roll_rad = 0.4f - 0.2f * (float)(i / 30u);
        poi->velocity_m_s = v3(0.0f, 0.0f, 0.0f);
        core.game.control[0].target_pose = (struct poi_target){ poi->position_m, poi->angles };
        input.poi[0].link = POI_SOURCE_LOST;
        uint32_t ticks = 0;
        while (poi->immersed > 0.0f || poi->position_m.y < 0.9f * FAILSAFE_HOVER_M) {
            run_tick();
            assert_true(++ticks < 6u * CORE_TICK_HZ);
        }
        slowest = ticks > slowest ? ticks : slowest;
        assert_int_equal(poi->sheet.paper_cells, there.world.poi[0].sheet.paper_cells);
    }
    print_message("hovers after %u ticks at the latest\n", slowest);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_no_controller_fault_tears_paper_in_any_place),
        cmocka_unit_test(test_no_small_pose_error_tears_wet_paper_of_any_grade),
        cmocka_unit_test(test_a_fish_carried_during_a_fault_can_be_landed_and_counts),
        cmocka_unit_test(test_the_poi_glides_back_without_a_jump),
        cmocka_unit_test(test_a_lost_poi_leaves_the_water),
        cmocka_unit_test(test_a_lost_poi_leaves_the_water_from_any_position),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
