/* test_slow_reports.c -- checks that the paper also wears if the controller is slow, late or
 * loosely connected. */
#include "tests/unit/support/core_fixture.h"

#define SWING_M 0.025f
#define SWING_HZ 1.5f
#define DEEP_M (-0.05f)

static struct tally {
    /* Tick of the round in which the first cell tore; 0 means that no cell tore. */
    uint32_t torn_tick;
    uint32_t damage_immune, paused, spared_in_play;
} tally;

/* Starts a round of one player with wet paper of the weakest grade. */
static int begin(void **state)
{
    (void)state;
    const struct core_config config = { .seed = 7, .fish_count = 1, .round_s = 60, .grade = 7 };
    open_core(&config);
    tally = (struct tally){ 0 };
    hold(0, v3(-0.2f, ABOVE_M, 0.0f));
    tick();
    press(INPUT_START);
    wait_for_phase(PHASE_ROUND, 4u * CORE_TICK_HZ);
    lead(0, v3(-0.2f, DEEP_M, 0.0f));
    struct sheet *sheet = &core.world.poi[0].sheet;
    for (uint32_t i = 0; i < SHEET_CELL_COUNT; i++) {
        sheet->wetness[i] = 1.0f;
    }
    sheet->touched = sheet->soaked = 1;
    return 0;
}

/* Returns the true position of the controller at a tick. The controller moves up and down under
 * water, and the paper is broadside to the motion. */
static vec3 hand_at(uint32_t tick_of_play)
{
    const float turns = SWING_HZ * CORE_TICK_S * (float)tick_of_play;
    return v3(-0.2f, DEEP_M + SWING_M * f_sin(f_wrap_angle(F_TAU * turns)), 0.0f);
}

static void play_tick(uint32_t i)
{
    const struct sheet *sheet = &core.world.poi[0].sheet;
    tick();
    tally.damage_immune += core.world.poi[0].damage_immune;
    tally.paused += core.game.paused;
    tally.spared_in_play += core.world.poi[0].damage_immune && !core.game.paused;
    if (tally.torn_tick == 0 && sheet->paper_cells < sheet->paper_cells_new) {
        tally.torn_tick = i + 1u;
    }
}

/* Returns the number of ticks after which the paper tears. The controller sends a report every
 * `period` ticks. If `period` is 0, the intervals are uneven, between 4 and 50 ticks. */
static uint32_t lasts_at(uint32_t period)
{
    uint32_t next = 0, age = 0;
    begin(NULL);
    for (uint32_t i = 0; i < 20u * CORE_TICK_HZ && tally.torn_tick == 0; i++, age++) {
        if (i == next) {
            input.poi[0].target.position_m = hand_at(i);
            age = 0;
            next += period > 0 ? period : 4u + i * 37u % 47u;
        }
        input.poi[0].age_ticks = (uint16_t)age;
        play_tick(i);
    }
    assert_int_equal(tally.damage_immune, 0);
    assert_int_equal(tally.paused, 0);
    return tally.torn_tick;
}

static void test_a_slow_controller_wears_paper_like_a_fast_one(void **state)
{
    static const uint32_t periods[] = { 1, 3, 4, 5, 6, 8, 9, 10, 11, 12, 13, 16, 20, 24 };
    const float at_60_hz = (float)lasts_at(2);
    (void)state;
    assert_true(at_60_hz > 0.0f);
    print_message("60 reports a second: torn after %.2f s\n", (double)(at_60_hz * CORE_TICK_S));
    for (size_t i = 0; i < sizeof periods / sizeof periods[0]; i++) {
        const float here = (float)lasts_at(periods[i]);
        print_message("one each %u ticks: %.2f s\n", periods[i], (double)(here * CORE_TICK_S));
        assert_true(here > 0.6f * at_60_hz && here < 2.0f * at_60_hz);
    }
}

static void test_repeated_late_reports_give_no_protection(void **state)
{
    (void)state;
    const uint32_t lasts = lasts_at(0);
    print_message("reports come unevenly: torn after %u ticks\n", lasts);
    assert_true(lasts > 0);
}

/* Disconnects the controller for one tick in each `period` ticks, so that the poi must return to
 * the controller's position again and again. */
static void play_with_a_loose_plug(uint32_t period, uint32_t ticks_max)
{
    begin(NULL);
    for (uint32_t i = 0; i < ticks_max && core.game.phase == PHASE_ROUND; i++) {
        input.poi[0].target.position_m = hand_at(i);
        input.poi[0].link = i % period == 0 ? POI_SOURCE_LOST : POI_SOURCE_LIVE;
        play_tick(i);
    }
}

static void test_a_loose_plug_protects_for_6_s_and_an_eighth_of_the_time(void **state)
{
    static const uint32_t periods[] = { 60, 120, 360, 600 };
    (void)state;
    for (size_t i = 0; i < sizeof periods / sizeof periods[0]; i++) {
        const uint32_t ticks_max = 40u * CORE_TICK_HZ;
        play_with_a_loose_plug(periods[i], ticks_max);
        print_message("away each %u ticks: protected in play for %u of %u, torn at %u\n",
                      periods[i], tally.spared_in_play, ticks_max - tally.paused, tally.torn_tick);
        assert_true(tally.paused > 0);
        assert_in_range(tally.spared_in_play, 1, 720u + (ticks_max - tally.paused) / 8u);
    }
    /* In the last case, the controller is lost for only one tick in 5 s, so the paper must tear as
     * usual. */
    assert_true(tally.torn_tick > 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_a_slow_controller_wears_paper_like_a_fast_one),
        cmocka_unit_test(test_repeated_late_reports_give_no_protection),
        cmocka_unit_test(test_a_loose_plug_protects_for_6_s_and_an_eighth_of_the_time),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
