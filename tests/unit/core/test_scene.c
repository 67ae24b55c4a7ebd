/* test_scene.c -- checks that the scene, which the renderer draws, shows the state of the core.
 * Computing the scene must not change the state. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include <cmocka.h>

#include "core/core.h"
#include "core/morph/morph.h"

static struct core core;
static struct scene scene;

static int setup(void **state)
{
    (void)state;
    const struct core_config config = {
        .seed = 11,
        .persistent.ranking.row[MODE_FESTIVAL][RANK_DAY][0].caught = 8,
        .language = LANGUAGE_EN,
    };
    assert_int_equal(core_init(&core, &config), CORE_OK);
    /* Fills the scene with the byte 0xa5 before each test, so that a field that core_scene() does
     * not write is detected. */
    memset(&scene, 0xa5, sizeof scene);
    return 0;
}

static void tick(uint32_t count)
{
    static struct input input;
    static struct output output;
    for (uint32_t i = 0; i < count; i++) {
        output.sound_count = 0;
        core_tick(&core, &input, &output);
    }
}

static void test_the_shape_of_every_fish_follows_its_age(void **state)
{
    (void)state;
    /* Makes fish 0 too small for its age. The scene must still show it with the shape of its
     * age. */
    core.world.tank.fish[0].age_days = 60.0f;
    core.world.tank.fish[0].length_m = 0.02f;
    core_scene(&core, &scene);
    assert_int_equal(scene.fish_count, core.world.tank.fish_count);
    for (uint32_t i = 0; i < scene.fish_count; i++) {
        const struct scene_fish *fish = &scene.fish[i];
        const float length_m = life_length_m(&species_wakin.card, fish->progress);
        assert_float_equal(fish->age_days, core.world.tank.fish[i].age_days, 0.0f);
        assert_float_equal(fish->progress, life_progress(&species_wakin.card, fish->age_days),
                           0.0f);
        if (i > 0) { /* All fish except fish 0 have the length that belongs to their age. */
            assert_float_equal(length_m, fish->length_m, 1e-3f * length_m);
        }
    }
}

static void test_the_fish_of_a_festival_have_many_ages(void **state)
{
    (void)state;
    float youngest = 1.0f, oldest = 0.0f;
    core_scene(&core, &scene);
    for (uint32_t i = 0; i < scene.fish_count; i++) {
        youngest = f_min(youngest, scene.fish[i].progress);
        oldest = f_max(oldest, scene.fish[i].progress);
    }
    /* The growth progress (0 at hatching, 1 at the last key shape) of the oldest fish must exceed
     * that of the youngest fish by more than 0.1. */
    assert_true(oldest - youngest > 0.1f);
}

static void test_fish_have_the_positions_of_the_tank(void **state)
{
    (void)state;
    core.world.tank.fish[3].gait = GAIT_HELD;
    core.world.tank.fish[4].gait = GAIT_BOWL;
    core.world.tank.fish[5].gait = GAIT_SWIM;
    core_scene(&core, &scene);
    assert_int_equal(scene.fish[3].place, SCENE_ON_POI);
    assert_int_equal(scene.fish[4].place, SCENE_IN_BOWL);
    assert_int_equal(scene.fish[5].place, SCENE_IN_TANK);
    assert_memory_equal(&scene.fish[5].position_m, &core.world.tank.fish[5].position_m,
                        sizeof(vec3));
    assert_float_equal(scene.fish[5].length_m, core.world.tank.fish[5].length_m, 0.0f);
}

static void test_a_lifted_fish_thrashes_from_its_first_tick_on_the_paper(void **state)
{
    (void)state;
    struct poi *poi = &core.world.poi[0];
    struct fish *fish = &core.world.tank.fish[7];
    fish->gait = GAIT_HELD;
    fish->bend_rad = fish->tail_amplitude = 0.0f;
    poi->carried_count = 1;
    poi->carried_fish[0] = (struct carried_fish){ .fish = 7, .side = -1, .vigour = 0.55f };
    float least = 10.0f, most = 0.0f;
    const uint64_t hash = core_hash(&core);
    for (uint32_t i = 0; i < CORE_TICK_HZ; i++) {
        core_scene(&core, &scene);
        const float bend_rad = -scene.fish[7].bend_rad; /* The fish lies on its left side, so that
                                                           a bend to its left raises the tail. */
        least = f_min(least, bend_rad);
        most = f_max(most, bend_rad);
        assert_true(scene.fish[7].tail_amplitude > 0.2f);
        assert_float_equal(scene.fish[8].bend_rad, core.world.tank.fish[8].bend_rad, 0.0f);
        if (i == 0) {
            assert_true(core_hash(&core) == hash);
        }
        core.game.tick++;
    }
    assert_true(least > 0.1f);
    assert_true(most > least + 0.6f);
    poi->carried_fish[0].vigour = 0.08f; /* The fish has calmed down and moves little. */
    core_scene(&core, &scene);
    assert_true(f_abs(scene.fish[7].bend_rad) < 0.2f);
    fish->gait = GAIT_BOWL; /* A fish that has left the paper is shown as it is. */
    core_scene(&core, &scene);
    assert_float_equal(scene.fish[7].bend_rad, 0.0f, 0.0f);
}

static float height_of_present(uint32_t elapsed)
{
    core.game.phase_tick = core.game.tick - elapsed;
    core_scene(&core, &scene);
    return scene.fish[9].position_m.y - core.world.tank.fish[9].position_m.y;
}

static void test_a_present_falls_into_its_bowl_in_half_a_second(void **state)
{
    (void)state;
    core.game.tick = 1000;
    core.game.phase = PHASE_RESULT;
    core.game.player[0].plays = 1;
    core.game.album.fish_count = 1;
    core.game.album.fish[0] = (struct album_fish){ .fish = 9, .owner = 0 };
    core.world.tank.fish[9].gait = GAIT_BOWL;
    assert_float_equal(height_of_present(0), 0.20f, 1e-5f);
    assert_true(height_of_present(30) > 0.1f); /* The present falls slowly at first. */
    assert_true(height_of_present(50) < height_of_present(30));
    assert_float_equal(height_of_present(60), 0.0f, 1e-6f);
    assert_float_equal(height_of_present(600), 0.0f, 0.0f);
    core.game.player[0].caught = 1; /* A caught fish is no present and already lies in the bowl. */
    assert_float_equal(height_of_present(0), 0.0f, 0.0f);
}

static float maturity_at(float age_days)
{
    core.world.tank.fish[0].age_days = age_days;
    core_scene(&core, &scene);
    return scene.fish[0].maturity;
}

static void test_fish_redden_between_fifty_and_a_hundred_and_twenty_days(void **state)
{
    (void)state;
    assert_float_equal(maturity_at(0.0f), 0.0f, 0.0f);
    assert_float_equal(maturity_at(50.0f), 0.0f, 0.0f);
    assert_true(maturity_at(60.0f) > 0.0f);
    assert_in_range((int)(100.0f * maturity_at(100.0f)), 70, 95);
    assert_float_equal(maturity_at(120.0f), 1.0f, 1e-6f);
    assert_float_equal(maturity_at(4000.0f), 1.0f, 0.0f);
}

static void test_paper_shows_wetness_damage_and_holes(void **state)
{
    (void)state;
    core.world.poi[0].link = POI_SOURCE_BOT;
    struct sheet *sheet = &core.world.poi[0].sheet;
    const uint32_t middle = SHEET_SIDE / 2u * SHEET_SIDE + SHEET_SIDE / 2u;
    sheet->wetness[middle] = 1.0f;
    sheet->damage[middle + 1u] = 0.999f;
    sheet->state[middle + 2u] = CELL_HOLE;
    core_scene(&core, &scene);
    assert_int_equal(scene.poi[0].present, 1);
    assert_int_equal(scene.poi[0].wetness[middle], 255);
    assert_int_equal(scene.poi[0].wetness[middle + 1u], 0);
    assert_int_equal(scene.poi[0].integrity[middle], 255);
    /* The scene uses the value 0 for a hole, so paper that is nearly torn must have at least the
     * value 1. */
    assert_int_equal(scene.poi[0].integrity[middle + 1u], 1);
    assert_int_equal(scene.poi[0].integrity[middle + 2u], 0);
}

static void test_a_poi_is_shown_with_its_position_belly_and_remaining_paper(void **state)
{
    (void)state;
    struct poi *poi = &core.world.poi[0];
    poi->link = POI_SOURCE_BOT;
    poi->position_m = v3(0.11f, -0.02f, 0.07f);
    poi->angles = (struct angles){ .yaw_rad = 0.1f, .pitch_rad = 0.2f, .roll_rad = 0.3f };
    poi->sheet.sag_m = 0.0021f;
    core_scene(&core, &scene);
    const struct scene_poi *shown = &scene.poi[0];
    assert_int_equal(shown->present, 1);
    assert_memory_equal(&shown->position_m, &poi->position_m, sizeof(vec3));
    assert_memory_equal(&shown->angles, &poi->angles, sizeof poi->angles);
    assert_float_equal(shown->ring_radius_m, POI_RADIUS_M, 0.0f);
    assert_float_equal(shown->sag_m, 0.0021f, 0.0f);
    assert_float_equal(shown->paper_left, 1.0f, 0.0f);
    /* A negative sag means that water from below bulges the paper upward. */
    poi->sheet.sag_m = -0.0013f;
    core_scene(&core, &scene);
    assert_float_equal(shown->sag_m, -0.0013f, 0.0f);
}

static void test_cells_beyond_the_ring_continue_the_paper_inside(void **state)
{
    (void)state;
    core.world.poi[0].link = POI_SOURCE_BOT;
    core_scene(&core, &scene);
    const uint32_t row = SHEET_SIDE / 4u * SHEET_SIDE;
    assert_int_equal(core.world.poi[0].sheet.state[row], CELL_OUTSIDE);
    assert_int_equal(scene.poi[0].integrity[row], 255);
}

static void test_paper_shows_its_stress_and_holes_show_none(void **state)
{
    (void)state;
    core.world.poi[0].link = POI_SOURCE_BOT;
    struct sheet *sheet = &core.world.poi[0].sheet;
    const uint32_t middle = SHEET_SIDE / 2u * SHEET_SIDE + SHEET_SIDE / 2u;
    memset(sheet->stress, 40, sizeof sheet->stress);
    sheet->stress[middle] = 255;
    sheet->stress[middle + 1u] = 200;
    sheet->state[middle + 1u] = CELL_HOLE;
    core_scene(&core, &scene);
    assert_int_equal(scene.poi[0].stress[middle], 255);
    assert_int_equal(scene.poi[0].stress[middle + 1u], 0);
    assert_int_equal(scene.poi[0].stress[middle + 2u], 40);
    /* A cell outside the ring must get the stress of the nearest paper, so that the colour
     * continues to the edge of the picture. */
    assert_int_equal(scene.poi[0].stress[SHEET_SIDE / 4u * SHEET_SIDE], 40);
}

static void test_the_stress_colour_is_shown_only_in_practice(void **state)
{
    (void)state;
    core.world.poi[0].link = POI_SOURCE_BOT;
    for (uint8_t mode = 0; mode < MODE_COUNT; mode++) {
        for (uint8_t phase = PHASE_ATTRACT; phase <= PHASE_RESULT; phase++) {
            core.game.mode = mode;
            core.game.phase = phase;
            core_scene(&core, &scene);
            assert_int_equal(scene.poi[0].shows_stress,
                             mode == MODE_PRACTICE && phase == PHASE_ROUND);
        }
    }
}

static void test_paper_in_danger_warns_and_sags_deeper(void **state)
{
    (void)state;
    struct sheet *sheet = &core.world.poi[0].sheet;
    core.world.poi[0].link = POI_SOURCE_BOT;
    sheet->sag_m = 0.003f;
    core_scene(&core, &scene);
    assert_float_equal(scene.poi[0].warning, 0.0f, 0.0f);
    assert_float_equal(scene.poi[0].sag_m, 0.003f, 0.0f);
    sheet->damage[SHEET_CELL_COUNT / 2u + SHEET_SIDE / 2u] = 0.9f;
    core_scene(&core, &scene);
    assert_float_equal(scene.poi[0].warning, 1.0f, 0.0f);
    assert_float_equal(scene.poi[0].sag_m, 0.006f, 1e-6f);
}

static void test_the_tear_is_shown_only_on_the_result_screen(void **state)
{
    (void)state;
    core.world.tear_clip[2].cause = TEAR_SLAP;
    core.world.tear_clip[2].count = core.world.tear_clip[2].next = 1;
    for (uint8_t phase = PHASE_ATTRACT; phase <= PHASE_RESULT; phase++) {
        core.game.phase = phase;
        core_scene(&core, &scene);
        assert_int_equal(scene.tear[2].cause, phase == PHASE_RESULT ? TEAR_SLAP : TEAR_NONE);
        assert_int_equal(scene.tear[0].cause, TEAR_NONE);
    }
}

static void test_every_mode_shows_its_time_and_paper(void **state)
{
    (void)state;
    core_scene(&core, &scene);
    assert_int_equal(scene.offer[MODE_FESTIVAL].round_s, 60);
    assert_int_equal(scene.offer[MODE_FESTIVAL].grade, 6);
    assert_int_equal(scene.offer[MODE_CHAMPIONSHIP].round_s, 180);
    assert_int_equal(scene.offer[MODE_CHAMPIONSHIP].grade, 5);
    core.config.grade = 4;
    core.config.round_s = 90;
    core_scene(&core, &scene);
    assert_int_equal(scene.offer[MODE_FESTIVAL].grade, 4);
    /* The championship always uses paper of grade 5, as its rules prescribe, whatever grade the
     * operator has set. */
    assert_int_equal(scene.offer[MODE_CHAMPIONSHIP].grade, 5);
    assert_int_equal(scene.offer[MODE_PRACTICE].round_s, 90);
}

static void test_the_water_of_a_poi_is_shown_as_a_depth(void **state)
{
    (void)state;
    core.world.poi[0].link = POI_SOURCE_BOT;
    core.world.poi[0].film_kg = 0.0f;
    /* 5 g of water on 50 cm^2 of paper are 1 mm deep. */
    core.world.poi[0].water_kg = core.world.poi[0].pool_kg = 0.005f;
    core_scene(&core, &scene);
    assert_float_equal(scene.poi[0].water_m, 0.001f, 2e-5f);
}

static void test_announcements_and_fouls_are_shown_with_their_age(void **state)
{
    (void)state;
    core.game.tick = 1200;
    core.game.phase = PHASE_ROUND;
    core.game.call = CALL_ONE_MINUTE;
    core.game.call_tick = 1080;
    core.game.player[2].plays = 1;
    core.game.player[2].fouls = 2;
    core.game.player[2].foul = FOUL_WALL;
    core.game.player[2].foul_tick = 960;
    core.world.near_miss[2].tick = 1140;
    core_scene(&core, &scene);
    assert_int_equal(scene.call, CALL_ONE_MINUTE);
    assert_float_equal(scene.call_s, 1.0f, 1e-5f);
    assert_int_equal(scene.player[2].plays, 1);
    assert_int_equal(scene.player[2].fouls, 2);
    assert_int_equal(scene.player[2].foul, FOUL_WALL);
    assert_float_equal(scene.player[2].foul_s, 2.0f, 1e-5f);
    assert_float_equal(scene.player[2].miss_s, 0.5f, 1e-5f);
    assert_float_equal(scene.player[1].miss_s, 0.0f, 0.0f);
    assert_int_equal(scene.player[1].plays, 0);
    assert_int_equal(scene.player[1].foul, FOUL_NONE);
}

static void test_an_absent_poi_and_bowl_are_not_shown(void **state)
{
    (void)state;
    core_scene(&core, &scene);
    assert_int_equal(scene.poi[3].present, 0);
    assert_int_equal(scene.bowl[3].present, 0);
    assert_int_equal(scene.bowl[0].present, 1);
}

static void test_a_bowl_is_shown_with_its_heel_and_its_water_level(void **state)
{
    (void)state;
    core.world.bowl[0].heel_x = 0.10f;
    core.world.bowl[0].heel_z = -0.05f;
    core_scene(&core, &scene);
    const vec3 up = vec_basis_from_angles(scene.bowl[0].angles).up;
    assert_float_equal(up.x, 0.10f, 2e-3f);
    assert_float_equal(up.z, -0.05f, 2e-3f);
    assert_true(scene.bowl[0].water_below_m > 0.0f);
    assert_true(scene.bowl[0].water_below_m < scene.bowl[0].depth_m);
    core.world.bowl[0].water_kg *= 0.5f;
    const float before_m = scene.bowl[0].water_below_m;
    core_scene(&core, &scene);
    assert_true(scene.bowl[0].water_below_m > before_m);
}

static void test_the_scene_shows_the_state_of_the_game(void **state)
{
    (void)state;
    core.game.phase = PHASE_ROUND;
    core.game.phase_tick = 240;
    core.game.tick = 360;
    core.game.player[0].caught = 5;
    core.game.hints.shown = HINT_LOST_POI;
    core_scene(&core, &scene);
    assert_int_equal(scene.tick, 360);
    assert_int_equal(scene.phase, PHASE_ROUND);
    assert_float_equal(scene.phase_s, 1.0f, 1e-6f);
    assert_float_equal(scene.seconds_left, 59.0f, 1e-4f);
    assert_int_equal(scene.caught[0], 5);
    assert_int_equal(scene.best_today, 8);
    assert_int_equal(scene.hint, HINT_LOST_POI);
    /* A hint that is shown beside the poi must not also appear as the hint of the whole screen. */
    core.game.hints.shown = HINT_BOWL;
    core_scene(&core, &scene);
    assert_int_equal(scene.hint, HINT_NONE);
    assert_int_equal(scene.language, LANGUAGE_EN);
}

static void test_building_the_scene_does_not_change_the_state(void **state)
{
    (void)state;
    tick(200);
    static struct core before;
    before = core;
    core_scene(&core, &scene);
    assert_memory_equal(&before, &core, sizeof core);
}

/* The bot plays in attract mode with every yaw that its technique chooses. The players 0 and 1
 * stand at the near side of the tank, the players 2 and 3 at its ends. On a portrait screen, player
 * 0 stands at the near end. */
static void test_hand_and_handle_of_a_bot_fit_its_place_and_bowl(void **state)
{
    (void)state;
    float least = 1.0f;
    for (uint32_t i = 0; i < 400; i++) {
        const bool is_turned = i % 2u != 0;
        tick(5);
        core_scene(&core, &scene);
        vec3 place_m = v3(0.335f, 0.0f, 0.5f * scene.tank_size_m.z + 0.4f);
        if (is_turned) {
            scene_use_turned(&scene);
            place_m = v3(0.5f * scene.tank_size_m.x + 0.4f, 0.0f, 0.185f);
        }
        const struct scene_poi *const poi = &scene.poi[0];
        assert_int_equal(poi->present, 1);
        /* The bowl of player 0 is on the right of a wide screen, and on the left of a portrait
         * screen. */
        assert_int_equal(poi->left_hand, is_turned);
        const struct basis axes = scene_handle_axes(poi);
        const vec3 way = v3_sub(place_m, poi->position_m);
        /* The handle lies in the plane of the ring. Seen along the axis of the ring, it points to
         * the place. */
        assert_true(f_abs(v3_dot(axes.back, vec_basis_from_angles(poi->angles).up)) < 1e-3f);
        assert_true(f_abs(v3_dot(axes.right, way)) < 1e-3f);
        assert_true(v3_dot(axes.back, way) > 0.0f);
        least = f_min(least, is_turned ? axes.back.x : axes.back.z);
    }
    assert_true(least > 0.3f);
}

int main(void)
{
#define TEST(name) cmocka_unit_test_setup(name, setup)
    const struct CMUnitTest tests[] = {
        TEST(test_hand_and_handle_of_a_bot_fit_its_place_and_bowl),
        TEST(test_the_shape_of_every_fish_follows_its_age),
        TEST(test_the_fish_of_a_festival_have_many_ages),
        TEST(test_fish_have_the_positions_of_the_tank),
        TEST(test_a_lifted_fish_thrashes_from_its_first_tick_on_the_paper),
        TEST(test_a_present_falls_into_its_bowl_in_half_a_second),
        TEST(test_fish_redden_between_fifty_and_a_hundred_and_twenty_days),
        TEST(test_paper_shows_wetness_damage_and_holes),
        TEST(test_a_poi_is_shown_with_its_position_belly_and_remaining_paper),
        TEST(test_cells_beyond_the_ring_continue_the_paper_inside),
        TEST(test_paper_shows_its_stress_and_holes_show_none),
        TEST(test_the_stress_colour_is_shown_only_in_practice),
        TEST(test_paper_in_danger_warns_and_sags_deeper),
        TEST(test_the_tear_is_shown_only_on_the_result_screen),
        TEST(test_every_mode_shows_its_time_and_paper),
        TEST(test_the_water_of_a_poi_is_shown_as_a_depth),
        TEST(test_announcements_and_fouls_are_shown_with_their_age),
        TEST(test_an_absent_poi_and_bowl_are_not_shown),
        TEST(test_a_bowl_is_shown_with_its_heel_and_its_water_level),
        TEST(test_the_scene_shows_the_state_of_the_game),
        TEST(test_building_the_scene_does_not_change_the_state),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
