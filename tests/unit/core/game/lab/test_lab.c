/* test_lab.c -- checks the growth lab as a user operates it, through the inputs of a poi, a mouse
 * or buttons. */
#include "tests/unit/support/lab_fixture.h"

#include "core/base/rng.h"
#include "tests/unit/support/newest_record.h"

/* ---- Opening and leaving the lab ------------------------------------------------------------ */

static void test_a_kiosk_with_only_the_lab_opens_the_lab(void **state)
{
    (void)state;
    assert_int_equal(look()->phase, PHASE_LAB);
    assert_int_equal(scene.lab.species_count, species_table_count);
    tap(LAB_LEAVE);
    assert_int_equal(core.game.phase, PHASE_ATTRACT);
    /* The lab is the kiosk's only choice, so START opens it again. */
    press(INPUT_START);
    assert_int_equal(core.game.phase, PHASE_LAB);
}

/* The dip on LEAVE continues downward for some ticks after the lab has closed. This motion must not
 * count as a new dip, because a new dip would open the lab again. */
static void test_a_poi_that_keeps_sinking_after_leaving_opens_nothing(void **state)
{
    (void)state;
    hover(middle_of(LAB_LEAVE));
    for (int32_t mm = 30; mm >= -60; mm -= 5) {
        input.poi[0].target.position_m.y = 0.001f * (float)mm;
        tick();
    }
    come_up();
    assert_int_equal(core.game.phase, PHASE_ATTRACT);
    ticks(60);
    assert_int_equal(core.game.phase, PHASE_ATTRACT);
    lead(0, v3(0.0f, BELOW_M, 0.0f));
    assert_int_equal(core.game.phase, PHASE_LAB);
}

/* Moves a poi from the middle of the tank to a point on the tag that opens the lab, and dips
 * there. */
static void dip_at_the_tag(struct layout_point over)
{
    const struct layout_point canvas = pointer_layout_size(0);
    const vec3 at_m = v3((over.x / canvas.x - 0.5f) * core.world.tank.size_m.x, ABOVE_M,
                         (over.y / canvas.y - 0.5f) * core.world.tank.size_m.z);
    hold(0, v3(0.0f, ABOVE_M, 0.0f));
    ticks(60);
    lead(0, at_m);
    dip(0, at_m.x, at_m.z);
}

static void test_a_dip_in_the_mode_selection_opens_the_lab(void **state)
{
    (void)state;
    const struct core_config config = { .seed = 5, .fish_count = 12, .modes = ALL };
    open_core(&config);
    press(INPUT_START);
    assert_int_equal(core.game.phase, PHASE_MODE_SELECT);
    ticks(GAME_MODE_SELECT_TICKS_MIN);
    for (uint32_t i = 0; i < 3; i++) {
        press(INPUT_RIGHT);
    }
    assert_int_equal(look()->choice, CHOICE_LAB);
    /* The lab is a choice but not a mode, because scores are stored by mode. While the lab is
     * selected, the scene shows the tank of practice mode. */
    assert_int_equal(scene.mode, MODE_PRACTICE);
    press(INPUT_RIGHT);
    assert_int_equal(look()->choice, MODE_FESTIVAL);
    dip_at_the_tag(middle_of(LAB_SMOOTH));
    assert_int_equal(core.game.phase, PHASE_LAB);
}

static void test_the_dip_that_opens_the_lab_presses_no_part(void **state)
{
    (void)state;
    const struct core_config config = { .seed = 5, .fish_count = 12, .modes = ALL };
    open_core(&config);
    press(INPUT_START);
    ticks(GAME_MODE_SELECT_TICKS_MIN);
    /* The tag of the lab contains this point too. */
    dip_at_the_tag(middle_of(LAB_SMOOTH));
    ticks(30);
    assert_int_equal(core.game.phase, PHASE_LAB);
    assert_int_equal(core.game.lab.holds, HOLD_BUTTON);
    assert_int_equal(look()->lab.template_id, TEMPLATE_OWN);
    assert_int_equal(scene.lab.playing, 1);
    come_up();
    /* This dip is a new one, so it presses the part of the page under the poi. */
    go_down();
    assert_int_equal(look()->lab.template_id, TEMPLATE_SMOOTH);
}

static void test_the_lab_gives_no_score(void **state)
{
    (void)state;
    const uint32_t rounds = core.game.round_count;
    tap(LAB_SAVE);
    tap(LAB_LEAVE);
    assert_int_equal(newest_record(&output)->id, 0);
    assert_int_equal(core.game.round_count, rounds);
    for (uint32_t mode = 0; mode < MODE_COUNT; mode++) {
        assert_int_equal(core.game.accounts.ranking.row[mode][RANK_DAY][0].caught, 0);
    }
}

static void test_a_minute_without_input_closes_the_lab(void **state)
{
    (void)state;
    tap(LAB_PLAY);
    input.poi[0].link = POI_SOURCE_ABSENT;
    ticks(LAB_IDLE_TICKS - 60u);
    assert_int_equal(core.game.phase, PHASE_LAB);
    ticks(61);
    assert_int_equal(core.game.phase, PHASE_ATTRACT);
}

/* A poi that swings on its cord moves but presses nothing. The lab must therefore close after
 * LAB_SWING_TICKS. */
static void test_a_swinging_poi_does_not_keep_the_lab_open(void **state)
{
    (void)state;
    const uint32_t begin = core.game.tick;
    while (core.game.phase == PHASE_LAB && core.game.tick - begin <= LAB_SWING_TICKS + 120u) {
        hover((struct layout_point){ core.game.tick / 60u % 2u ? 300.0f : 400.0f, 72.0f });
        ticks(20);
    }
    assert_int_equal(core.game.phase, PHASE_ATTRACT);
    assert_in_range(core.game.tick - begin, LAB_SWING_TICKS - 60u, LAB_SWING_TICKS + 120u);
}

static void test_start_plays_and_a_held_start_leaves(void **state)
{
    (void)state;
    assert_int_equal(core.game.lab.playing, 1);
    press(INPUT_START);
    assert_int_equal(core.game.lab.playing, 0);
    input.held = INPUT_START;
    ticks(LAB_END_TICKS - 1u);
    assert_int_equal(core.game.phase, PHASE_LAB);
    ticks(1);
    assert_int_equal(core.game.phase, PHASE_ATTRACT);
}

/* ---- The animated life of a fish ------------------------------------------------------------ */

static void test_a_life_plays_to_its_end_pauses_and_restarts(void **state)
{
    (void)state;
    ticks(LAB_LIFE_TICKS + 2u);
    assert_float_equal(core.game.lab.progress, 1.0f, 0.0f);
    ticks(LAB_REST_TICKS - 10u);
    assert_float_equal(look()->lab.progress, 1.0f, 0.0f);
    assert_float_equal(scene.lab.age_days, card()->key_age_days[card()->key_count - 1u], 1.0f);
    ticks(20);
    assert_true(core.game.lab.progress < 0.05f);
}

static void test_the_life_line_can_be_scrubbed(void **state)
{
    (void)state;
    const struct layout_box box = lab_box(0, card()->key_count, LAB_AGE);
    const float y = box.y + 20.0f;
    drag_down((struct layout_point){ lab_age_x(0, card()->key_count, 0.1f), y },
              (struct layout_point){ lab_age_x(0, card()->key_count, 0.65f), y });
    assert_float_equal(core.game.lab.progress, 0.65f, 1e-3f);
    assert_int_equal(core.game.lab.playing, 0);
    drag_down((struct layout_point){ lab_age_x(0, card()->key_count, 0.65f), y },
              (struct layout_point){ 5.0f, y });
    assert_float_equal(core.game.lab.progress, 0.0f, 0.0f);
}

static void test_the_growth_curve_can_be_scrubbed_by_age(void **state)
{
    (void)state;
    const struct layout_box chart = lab_box(0, card()->key_count, LAB_CHART);
    tap(LAB_CHART);
    const float half_days = 0.5f * card()->key_age_days[card()->key_count - 1u];
    assert_true(chart.width > 0.0f);
    assert_float_equal(look()->lab.age_days, half_days, 0.01f * half_days);
}

static void test_left_and_right_step_through_life_and_ok_turns_the_page(void **state)
{
    (void)state;
    input.held = INPUT_RIGHT;
    ticks(540);
    assert_float_equal(core.game.lab.progress, 0.5f, 0.01f);
    input.held = INPUT_LEFT;
    ticks(60);
    assert_float_equal(core.game.lab.progress, 0.444f, 0.01f);
    input.held = 0;
    press(INPUT_OK);
    assert_int_equal(core.game.lab.species, 1u % species_table_count);
    assert_float_equal(core.game.lab.progress, 0.0f, 0.01f);
}

static void test_the_species_cycle_in_both_directions(void **state)
{
    (void)state;
    for (uint32_t i = 1; i <= species_table_count; i++) {
        tap(LAB_NEXT);
        assert_int_equal(core.game.lab.species, i % species_table_count);
        assert_true(lab_edit_is_valid(&core.game.lab.edit, card()));
    }
    tap(LAB_BACK);
    assert_int_equal(core.game.lab.species, species_table_count - 1u);
}

static void test_a_key_selects_its_time_and_its_curve(void **state)
{
    (void)state;
    tap((enum lab_part)(LAB_KEY + 2));
    assert_int_equal(core.game.lab.layer, 2);
    assert_float_equal(core.game.lab.progress, 2.0f / (float)(card()->key_count - 1u), 1e-6f);
    assert_float_equal(look()->lab.length_m, card()->key_length_m[2],
                       1e-3f * card()->key_length_m[2]);
}

/* ---- Random inputs -------------------------------------------------------------------------- */

static void play_wildly(uint32_t seed, uint32_t count)
{
    for (uint32_t i = 0; i < count; i++) {
        const uint32_t bits = rng_u32((struct rng_key){ seed, i / 12u, 0, RNG_TEST });
        const float x = (float)(bits & 255u) / 255.0f - 0.5f;
        const float z = (float)(bits >> 8 & 255u) / 255.0f - 0.5f;
        hold(0, v3(x * core.world.tank.size_m.x, bits >> 16 & 1u ? DOWN_M : UP_M,
                   z * core.world.tank.size_m.z));
        input.upright = (bits >> 20 & 15u) == 0;
        input.pressed = bits >> 24 == 7u || i % 97u == 0 ? INPUT_OK : 0;
        tick();
        if (core.game.phase != PHASE_LAB) {
            press(INPUT_START);
        }
        assert_true(lab_edit_is_valid(&core.game.lab.edit, card()));
        assert_true(core.game.lab.progress >= 0.0f && core.game.lab.progress <= 1.0f);
        look();
    }
}

static void test_the_same_inputs_repeat_the_same_lab_and_random_inputs_are_safe(void **state)
{
    uint64_t hashes[2];
    for (uint32_t i = 0; i < 2; i++) {
        open_lab(state);
        play_wildly(11, 3000);
        hashes[i] = core_hash(&core);
    }
    assert_true(hashes[0] == hashes[1]);
    open_lab(state);
    play_wildly(12, 3000);
    assert_true(core_hash(&core) != hashes[0]);
}

int main(void)
{
#define TEST(name) cmocka_unit_test_setup(name, open_lab)
    const struct CMUnitTest tests[] = {
        TEST(test_a_kiosk_with_only_the_lab_opens_the_lab),
        TEST(test_a_poi_that_keeps_sinking_after_leaving_opens_nothing),
        TEST(test_a_dip_in_the_mode_selection_opens_the_lab),
        TEST(test_the_dip_that_opens_the_lab_presses_no_part),
        TEST(test_the_lab_gives_no_score),
        TEST(test_a_minute_without_input_closes_the_lab),
        TEST(test_a_swinging_poi_does_not_keep_the_lab_open),
        TEST(test_start_plays_and_a_held_start_leaves),
        TEST(test_a_life_plays_to_its_end_pauses_and_restarts),
        TEST(test_the_life_line_can_be_scrubbed),
        TEST(test_the_growth_curve_can_be_scrubbed_by_age),
        TEST(test_left_and_right_step_through_life_and_ok_turns_the_page),
        TEST(test_the_species_cycle_in_both_directions),
        TEST(test_a_key_selects_its_time_and_its_curve),
        TEST(test_the_same_inputs_repeat_the_same_lab_and_random_inputs_are_safe),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
