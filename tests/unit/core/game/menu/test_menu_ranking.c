/* test_menu_ranking.c -- checks the menu pages for the leaderboards. The operator must be able to
 * reach each score with two buttons, and to leave the pages. */
#include "core/game/menu/menu_pages.h"
#include "core/game/phases.h"
#include "tests/unit/support/game_fixture.h"
#include "tests/unit/support/menu_tag.h"

static int setup_pages(void **state)
{
    static const struct rank_row rows[] = {
        { .caught = 12, .round_id = 40, .slot = 1, .name = "さくら" },
        { .caught = 9, .round_id = 41, .slot = 0, .name = "" },
        { .caught = 7, .round_id = 40, .slot = 0, .name = "たろう" },
    };
    setup(state);
    memset(&core.game.accounts.ranking, 0, sizeof core.game.accounts.ranking);
    for (uint32_t period = RANK_DAY; period < RANK_PERIOD_COUNT; period += 2u) {
        memcpy(core.game.accounts.ranking.row[MODE_FESTIVAL][period], rows, sizeof rows);
    }
    return 0;
}

static void take(uint32_t tag)
{
    struct menu *menu = &core.game.menu;
    for (uint32_t i = 0; i < MENU_TAG_MAX && menu->tag[menu->page] != tag; i++) {
        press(INPUT_SERVICE);
    }
    assert_int_equal(menu->tag[menu->page], tag);
    steps(MENU_TAKE_TICKS);
    press(INPUT_TEST);
}

static void open_ranking(void)
{
    press(INPUT_TEST);
    assert_int_equal(core.game.phase, PHASE_MENU);
    take(menu_tag_of(MENU_BOOKS));
    take(menu_tag_of(MENU_RANKING));
    assert_int_equal(core.game.menu.page, MENU_RANKING);
}

static const char *name_in(enum rank_period period, uint32_t row)
{
    return core.game.accounts.ranking.row[MODE_FESTIVAL][period][row].name;
}

static void test_only_rows_with_a_score_can_be_activated(void **state)
{
    (void)state;
    open_ranking();
    assert_int_equal(menu_enabled(&core.game.menu), 7u | 3u << RANKING_NEXT);
    /* The next leaderboard is that of the week. This leaderboard has no score, so none of its rows
     * can be selected. */
    take(RANKING_NEXT);
    assert_int_equal(menu_enabled(&core.game.menu), 3u << RANKING_NEXT);
    take(RANKING_BACK);
    assert_int_equal(core.game.menu.page, MENU_BOOKS);
}

static void test_the_leaderboards_cycle_and_practice_has_none(void **state)
{
    (void)state;
    static struct scene scene;
    open_ranking();
    for (uint32_t i = 0; i < 2u * 6u; i++) {
        core_scene(&core, &scene);
        assert_true(scene.leaderboard.shown);
        assert_int_equal(scene.leaderboard.period, i % 3u);
        /* NEXT shows the three periods of the festival, and then the three periods of the
         * championship. */
        assert_int_equal(scene.leaderboard.mode, i / 3u % 2u);
        take(RANKING_NEXT);
    }
}

static void test_a_score_is_identified_by_its_round(void **state)
{
    (void)state;
    open_ranking();
    take(1);
    assert_int_equal(core.game.menu.page, MENU_SCORE);
    const uint32_t before = output.command_count;
    take(SCORE_REPLAY);
    assert_int_equal(output.command_count, before + 1u);
    const struct controller_command *order = &output.commands[before % CONTROLLER_COMMAND_MAX];
    assert_int_equal(order->kind, COMMAND_REPLAY);
    assert_int_equal(order->round_id, 41);
}

static void test_a_confirmed_removal_deletes_a_name_from_every_leaderboard(void **state)
{
    (void)state;
    open_ranking();
    take(2);
    const uint32_t before = output.entry_id;
    take(SCORE_UNNAME);
    /* The menu first asks for a confirmation, so no ledger entry has been written yet. */
    assert_int_equal(output.entry_id, before);
    assert_false(menu_enabled(&core.game.menu) >> SCORE_UNNAME & 1u);
    take(SCORE_CONFIRM);
    assert_int_equal(output.entry_id, before + 1u);
    const struct ledger_entry *entry = &output.entries[output.entry_id % LEDGER_RING];
    assert_int_equal(entry->kind, LEDGER_NAME);
    assert_int_equal(entry->count, 40);
    assert_int_equal(entry->detail, 0);
    assert_string_equal(entry->name, "");
    assert_string_equal(name_in(RANK_DAY, 2), "");
    assert_string_equal(name_in(RANK_EVER, 2), "");
    assert_string_equal(name_in(RANK_DAY, 0),
                        "さくら"); /* The name of the other player of this round is kept. */
    assert_int_equal(core.game.accounts.ranking.row[MODE_FESTIVAL][RANK_DAY][2].caught, 7);
}

static void test_a_cancelled_removal_deletes_no_name(void **state)
{
    (void)state;
    open_ranking();
    take(0);
    take(SCORE_UNNAME);
    take(SCORE_BACK);
    take(0);
    /* The confirmation was cancelled, so the page offers SCORE_UNNAME again. */
    assert_true(menu_enabled(&core.game.menu) >> SCORE_UNNAME & 1u);
    assert_string_equal(name_in(RANK_DAY, 0), "さくら");
}

static void test_an_unnamed_score_disables_the_removal(void **state)
{
    (void)state;
    open_ranking();
    take(1);
    assert_int_equal(menu_enabled(&core.game.menu), 1u << SCORE_REPLAY | 1u << SCORE_BACK);
}

static void test_a_removal_after_the_end_of_the_day_does_nothing(void **state)
{
    (void)state;
    open_ranking();
    memset(core.game.accounts.ranking.row[MODE_FESTIVAL][RANK_DAY], 0,
           sizeof core.game.accounts.ranking.row[MODE_FESTIVAL][RANK_DAY]);
    take(0);
    assert_int_equal(core.game.menu.page, MENU_RANKING);
    setup_pages(NULL);
    open_ranking();
    take(0);
    memset(core.game.accounts.ranking.row[MODE_FESTIVAL][RANK_DAY], 0,
           sizeof core.game.accounts.ranking.row[MODE_FESTIVAL][RANK_DAY]);
    const uint32_t before = output.command_count;
    take(SCORE_REPLAY);
    assert_int_equal(output.command_count, before);
    assert_int_equal(core.game.menu.page, MENU_RANKING);
}

#define ON_PAGES(test) cmocka_unit_test_setup(test, setup_pages)

int main(void)
{
    const struct CMUnitTest tests[] = {
        ON_PAGES(test_only_rows_with_a_score_can_be_activated),
        ON_PAGES(test_the_leaderboards_cycle_and_practice_has_none),
        ON_PAGES(test_a_score_is_identified_by_its_round),
        ON_PAGES(test_a_confirmed_removal_deletes_a_name_from_every_leaderboard),
        ON_PAGES(test_a_cancelled_removal_deletes_no_name),
        ON_PAGES(test_an_unnamed_score_disables_the_removal),
        ON_PAGES(test_a_removal_after_the_end_of_the_day_does_nothing),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
