/* test_name.c -- checks how players with a rank enter their names: with a poi, with three buttons,
 * or not at all. */
#include "core/game/ranking/name.h"
#include "core/game/phases.h"
#include "core/game/ranking/name_filter.h"
#include "core/game/ranking/name_keyboard.h"
#include "tests/unit/support/game_fixture.h"

/* ---- Test setup ----------------------------------------------------------------------------- */

static int setup_names(void **state)
{
    const struct core_config config = {
        .seed = 7,
        .fish_count = 12,
        .round_s = ROUND_S,
        .players = POI_MAX,
        .persistent.ledger.boots = 1,
    };
    setup(state);
    assert_int_equal(core_init(&core, &config), CORE_OK);
    return 0;
}

/* Plays a round of `slots` players until the result screen. Player i has caught `caught[i]`
 * fish. */
static void play(uint32_t slots, const uint32_t *caught)
{
    for (uint32_t i = 0; i < slots; i++) {
        input.poi[i].link = POI_SOURCE_LIVE;
        input.poi[i].target.position_m = v3(0.05f, ABOVE_M, 0.02f + 0.1f * (float)i);
    }
    play_into_round();
    step();
    for (uint32_t i = 0; i < slots; i++) {
        core.game.player[i].caught = caught[i];
    }
    steps(ROUND_S * CORE_TICK_HZ);
    assert_int_equal(core.game.phase, PHASE_RESULT);
}

static void play_alone(uint32_t caught)
{
    play(1, &caught);
}

/* Goes from the result screen to the page on which the best player enters a name. */
static void begin_name_entry(void)
{
    steps(GAME_AGAIN_TICKS);
    press(INPUT_START);
    assert_int_equal(core.game.phase, PHASE_NAME);
    steps(NAME_SEEN_TICKS);
}

/* Returns the cell of a letter on the visible name keyboard. */
static uint32_t cell_of(uint16_t letter)
{
    for (uint32_t cell = 0; cell < NAME_CELLS; cell++) {
        if (name_letter(core.game.name.alphabet, cell) == letter) {
            return cell;
        }
    }
    fail();
    return 0;
}

static void press_key(uint32_t key)
{
    for (uint32_t i = 0; i < NAME_KEY_COUNT && core.game.name.key != key; i++) {
        press(INPUT_RIGHT);
    }
    assert_int_equal(core.game.name.key, key);
    press(INPUT_OK);
}

static void write_letters(const uint16_t *letters)
{
    for (; *letters != 0; letters++) {
        press_key(cell_of(*letters));
    }
}

/* Holds a player's poi over the middle of a key, `y_m` above the water. If the controller measures
 * angles (`has_wrist`), the position is mapped from the tank seen from above to the whole
 * screen. */
static void lead(uint32_t slot, uint32_t key, float y_m)
{
    const struct layout_point canvas = pointer_layout_size(0);
    const struct layout_box box = name_box(0, core.game.name.alphabet, key);
    const float x = (box.x + 0.5f * box.width) / canvas.x - 0.5f;
    const float z = (box.y + 0.5f * box.height) / canvas.y - 0.5f;
    input.poi[slot].has_wrist = 1;
    input.poi[slot].target.position_m =
        v3(x * core.world.tank.size_m.x, y_m, z * core.world.tank.size_m.z);
    step();
}

static void dip_at(uint32_t slot, uint32_t key)
{
    lead(slot, key, 0.04f);
    lead(slot, key, 0.0f);
    lead(slot, key, 0.04f);
}

static const struct ledger_entry *newest_entry(void)
{
    return &output.entries[output.entry_id % LEDGER_RING];
}

static const char *name_on_board(enum rank_period period, uint32_t place)
{
    return core.game.accounts.ranking.row[MODE_FESTIVAL][period][place].name;
}

/* ---- Conditions for the name entry ---------------------------------------------------------- */

static void test_a_ranked_player_is_asked_after_the_result(void **state)
{
    (void)state;
    play_alone(3);
    steps(GAME_RESULT_TICKS);
    assert_int_equal(core.game.phase, PHASE_NAME);
    assert_int_equal(core.game.name.slot, 0);
}

static void test_a_player_without_a_catch_is_not_asked(void **state)
{
    (void)state;
    play_alone(0);
    steps(GAME_RESULT_TICKS);
    assert_int_equal(core.game.phase, PHASE_ALBUM);
}

static void test_no_player_is_asked_when_the_setting_is_off(void **state)
{
    (void)state;
    core.config.persistent.settings.value[SET_NAMES] = 0;
    play_alone(3);
    steps(GAME_RESULT_TICKS);
    assert_int_equal(core.game.phase, PHASE_ATTRACT);
}

static void test_no_player_is_asked_without_a_store(void **state)
{
    (void)state;
    core.game.accounts.ledger.boot = 0;
    play_alone(3);
    steps(GAME_RESULT_TICKS);
    assert_int_equal(core.game.phase, PHASE_ATTRACT);
}

static void test_an_unranked_player_is_not_asked(void **state)
{
    (void)state;
    /* Marks all stored scores as scores since the current start, so that no leaderboard is
     * cleared. */
    core.game.accounts.ranking.boot = core.game.accounts.ledger.boot;
    for (uint32_t period = 0; period < RANK_PERIOD_COUNT; period++) {
        for (uint32_t i = 0; i < RANK_ROWS; i++) {
            core.game.accounts.ranking.row[MODE_FESTIVAL][period][i].caught = 5;
            core.game.accounts.ranking.row[MODE_FESTIVAL][period][i].round_id = 900u + i;
        }
    }
    /* The player only equals the earlier scores. These keep their ranks, so the player gets no
     * rank. */
    play_alone(5);
    steps(GAME_RESULT_TICKS);
    assert_int_equal(core.game.phase, PHASE_ATTRACT);
}

static void test_players_are_asked_once_each_with_the_best_first(void **state)
{
    (void)state;
    const uint32_t caught[3] = { 2, 7, 0 };
    play(3, caught);
    begin_name_entry();
    assert_int_equal(core.game.name.slot, 1);
    press_key(NAME_DONE);
    assert_int_equal(core.game.phase, PHASE_NAME);
    assert_int_equal(core.game.name.slot, 0);
    steps(NAME_SEEN_TICKS);
    press_key(NAME_DONE);
    assert_int_equal(core.game.phase, PHASE_LEADERBOARD);
    steps(LEADERBOARD_TICKS);
    /* The third player gets a fish as a present, so the album opens. */
    assert_int_equal(core.game.phase, PHASE_ALBUM);
}

/* ---- Entering a name ------------------------------------------------------------------------ */

static void test_buttons_enter_a_name_for_every_leaderboard(void **state)
{
    (void)state;
    play_alone(3);
    const uint32_t round_id = output.entry_id;
    begin_name_entry();
    write_letters(u"きんき");
    press_key(NAME_CHANGE);
    write_letters(u"よ");
    press_key(NAME_CHANGE);
    press_key(NAME_DONE);
    assert_int_equal(newest_entry()->kind, LEDGER_NAME);
    assert_int_equal(newest_entry()->count, round_id);
    assert_int_equal(newest_entry()->detail, 0);
    assert_string_equal(newest_entry()->name, "きんぎょ");
    for (uint32_t period = 0; period < RANK_PERIOD_COUNT; period++) {
        assert_string_equal(name_on_board((enum rank_period)period, 0), "きんぎょ");
    }
    assert_int_equal(core.game.phase, PHASE_LEADERBOARD);
}

static void test_dips_enter_a_name(void **state)
{
    (void)state;
    play_alone(3);
    begin_name_entry();
    dip_at(0, cell_of(u'あ'));
    dip_at(0, NAME_ALPHABET);
    dip_at(0, cell_of(u'ヨ'));
    dip_at(0, NAME_CHANGE);
    dip_at(0, NAME_ALPHABET);
    dip_at(0, cell_of('Q'));
    dip_at(0, NAME_CHANGE);
    dip_at(0, cell_of('7'));
    dip_at(0, NAME_ERASE);
    dip_at(0, NAME_DONE);
    assert_string_equal(name_on_board(RANK_DAY, 0), "あョq");
}

static void test_a_poi_and_the_buttons_reach_every_cell_and_key(void **state)
{
    (void)state;
    play_alone(3);
    begin_name_entry();
    for (uint8_t alphabet = 0; alphabet < ALPHABET_COUNT; alphabet++) {
        core.game.name.alphabet = alphabet;
        for (uint32_t key = 0; key < NAME_KEY_COUNT; key++) {
            if (key < NAME_CELLS && name_letter(alphabet, key) == 0) {
                continue;
            }
            core.game.name.act_tick = core.game.name.start_tick = core.game.tick - NAME_SEEN_TICKS;
            lead(0, key, 0.04f);
            assert_int_equal(core.game.name.key, key);
            press(INPUT_RIGHT);
            press(INPUT_LEFT);
            assert_int_equal(core.game.name.key, key);
        }
    }
}

static void test_another_players_poi_enters_nothing(void **state)
{
    (void)state;
    const uint32_t caught[2] = { 5, 0 };
    play(2, caught);
    begin_name_entry();
    dip_at(1, cell_of(u'あ'));
    assert_int_equal(core.game.name.letter_count, 0);
    dip_at(0, cell_of(u'あ'));
    assert_int_equal(core.game.name.letter_count, 1);
}

static void test_the_next_players_poi_highlights_its_key_at_once(void **state)
{
    (void)state;
    const uint32_t caught[2] = { 5, 3 };
    play(2, caught);
    begin_name_entry();
    lead(1, NAME_DONE, 0.04f);
    assert_int_equal(core.game.name.slot, 0);
    dip_at(0, NAME_DONE);
    assert_int_equal(core.game.name.slot, 1);
    steps(NAME_SEEN_TICKS);
    /* The poi of the next player is over the key that the previous player has pressed. */
    assert_int_equal(core.game.name.key, NAME_DONE);
}

static void test_the_dip_that_ended_the_result_enters_nothing(void **state)
{
    (void)state;
    play_alone(3);
    steps(GAME_AGAIN_DIP_TICKS);
    dip();
    assert_int_equal(core.game.phase, PHASE_NAME);
    /* The poi is still under water after the dip that opened the page. This dip must not also
     * select a letter. */
    steps(NAME_SEEN_TICKS + 10u);
    assert_int_equal(core.game.name.letter_count, 0);
    /* The poi has risen above the water first, so this dip selects a letter. */
    dip_at(0, cell_of(u'か'));
    assert_int_equal(core.game.name.letter_count, 1);
}

static void test_a_held_button_repeats_and_a_tap_does_not(void **state)
{
    (void)state;
    play_alone(3);
    begin_name_entry();
    lead(0, 0, 0.04f);
    press(INPUT_RIGHT);
    steps(NAME_RUN_TICKS);
    assert_int_equal(core.game.name.key, 1);
    input.held = INPUT_RIGHT;
    steps(NAME_RUN_TICKS + 5u * NAME_STEP_TICKS);
    assert_in_range(core.game.name.key, 6, 7);
    input.held = 0;
}

static void test_a_full_name_accepts_no_letter_and_selects_done(void **state)
{
    (void)state;
    play_alone(3);
    begin_name_entry();
    write_letters(u"あいうえおかきく");
    assert_int_equal(core.game.name.key, NAME_DONE);
    write_letters(u"け");
    press_key(NAME_DONE);
    assert_string_equal(name_on_board(RANK_DAY, 0), "あいうえおかきく");
}

static void test_erase_and_change_do_nothing_on_an_empty_name(void **state)
{
    (void)state;
    play_alone(3);
    begin_name_entry();
    press_key(NAME_ERASE);
    press_key(NAME_CHANGE);
    assert_int_equal(core.game.name.letter_count, 0);
    const uint32_t before = output.entry_id;
    press_key(NAME_DONE);
    /* The name is empty, so no ledger entry is written. */
    assert_int_equal(output.entry_id, before);
    assert_int_equal(core.game.phase, PHASE_LEADERBOARD);
}

static void test_the_forms_of_a_letter_cycle(void **state)
{
    (void)state;
    static const uint16_t rounds[][5] = { u"かがか",   u"はばぱは", u"つっづつ", u"よょよ",
                                          u"ハバパハ", u"ツッヅツ", u"ワヮワ",   u"aAa",
                                          u"んん",     u"ンン",     u"ーー",     u"77" };
    for (size_t i = 0; i < sizeof rounds / sizeof *rounds; i++) {
        for (uint32_t k = 0; rounds[i][k + 1u] != 0; k++) {
            assert_int_equal(name_changed(rounds[i][k]), rounds[i][k + 1u]);
        }
    }
}

/* ---- Rejected names ------------------------------------------------------------------------- */

static void test_a_rejected_name_can_be_replaced_once(void **state)
{
    (void)state;
    play_alone(3);
    begin_name_entry();
    const uint32_t before = output.entry_id;
    write_letters(u"うんこ");
    press_key(NAME_DONE);
    assert_int_equal(core.game.phase, PHASE_NAME);
    assert_int_equal(core.game.name.letter_count, 0);
    steps(NAME_SEEN_TICKS);
    write_letters(u"うんこ");
    press_key(NAME_DONE);
    assert_int_equal(core.game.phase, PHASE_LEADERBOARD);
    assert_int_equal(output.entry_id, before);
    assert_string_equal(name_on_board(RANK_DAY, 0), "");
}

static void test_an_accepted_second_name_is_stored(void **state)
{
    (void)state;
    play_alone(3);
    begin_name_entry();
    write_letters(u"うんこ");
    press_key(NAME_DONE);
    steps(NAME_SEEN_TICKS);
    write_letters(u"さくら");
    press_key(NAME_DONE);
    assert_string_equal(name_on_board(RANK_EVER, 0), "さくら");
}

static void test_a_timeout_does_not_bypass_the_name_filter(void **state)
{
    (void)state;
    play_alone(3);
    begin_name_entry();
    write_letters(u"うんこ");
    steps(NAME_IDLE_TICKS);
    assert_int_equal(core.game.phase, PHASE_LEADERBOARD);
    assert_string_equal(name_on_board(RANK_DAY, 0), "");
}

/* ---- Time limits of the name entry ---------------------------------------------------------- */

static void test_a_timeout_keeps_the_entered_letters(void **state)
{
    (void)state;
    play_alone(3);
    begin_name_entry();
    write_letters(u"さく");
    steps(NAME_IDLE_TICKS - 2u);
    assert_int_equal(core.game.phase, PHASE_NAME);
    steps(2);
    assert_int_equal(core.game.phase, PHASE_LEADERBOARD);
    assert_string_equal(name_on_board(RANK_DAY, 0), "さく");
    steps(LEADERBOARD_TICKS);
    assert_int_equal(core.game.phase, PHASE_ATTRACT);
}

static void test_the_name_entry_has_a_total_time_limit(void **state)
{
    (void)state;
    play_alone(3);
    begin_name_entry();
    for (uint32_t i = NAME_SEEN_TICKS; i < NAME_TICKS_MAX; i++) {
        input.pressed = i % 60u == 0 ? INPUT_RIGHT : 0u;
        assert_int_equal(core.game.phase, PHASE_NAME);
        step();
    }
    step();
    assert_int_equal(core.game.phase, PHASE_LEADERBOARD);
}

static void test_the_operators_button_keeps_the_entered_letters(void **state)
{
    (void)state;
    play_alone(3);
    begin_name_entry();
    write_letters(u"さくら");
    press(INPUT_TEST);
    assert_int_equal(core.game.phase, PHASE_MENU);
    assert_string_equal(name_on_board(RANK_DAY, 0), "さくら");
}

static void test_a_round_without_a_ledger_entry_gets_no_name(void **state)
{
    (void)state;
    input.store_well = 1;
    steps(2);
    /* The ring buffer of unsaved ledger entries is full. The round therefore gets no ledger entry,
     * and no name can be stored for it. */
    core.game.accounts.ledger.last_id += LEDGER_RING;
    play_alone(3);
    steps(GAME_RESULT_TICKS);
    assert_int_equal(core.game.phase, PHASE_ATTRACT);
}

/* The name entry must end with any motion and any buttons. The stored name must consist of whole
 * letters and pass the name filter. */
static void test_the_name_entry_ends_with_any_input(void **state)
{
    for (uint32_t seed = 1; seed <= 24; seed++) {
        uint32_t bits = seed * 2654435761u;
        setup_names(state);
        play_alone(3);
        steps(GAME_AGAIN_TICKS);
        press(INPUT_START);
        for (uint32_t i = 0; core.game.phase == PHASE_NAME; i++) {
            bits = bits * 1664525u + 1013904223u;
            input.pressed = bits >> 24 == 0 ? bits >> 8 & (INPUT_BUTTON_ALL & ~INPUT_TEST) : 0u;
            input.held = bits >> 20 & (INPUT_LEFT | INPUT_RIGHT);
            input.upright = bits >> 30 & 1u;
            lead(0, (bits >> 10) % NAME_CELLS, (float)(bits >> 28) * 0.004f - 0.01f);
            assert_true(i <= (1u + NAME_REFUSALS_MAX) * NAME_TICKS_MAX);
            assert_true(core.game.name.letter_count <= NAME_LETTERS_MAX);
        }
        assert_false(name_is_refused(name_on_board(RANK_DAY, 0)));
    }
}

/* ---- The leaderboard ------------------------------------------------------------------------ */

static struct scene scene;

static void test_the_leaderboard_shows_the_best_rank_and_highlights_the_round(void **state)
{
    (void)state;
    /* Four earlier scores are better, so the round gets only rank 5 of all time. */
    for (uint32_t i = 0; i < 4u; i++) {
        core.game.accounts.ranking.row[MODE_FESTIVAL][RANK_EVER][i].caught = 50;
        core.game.accounts.ranking.row[MODE_FESTIVAL][RANK_EVER][i].round_id = 900u + i;
    }
    play_alone(3);
    core_scene(&core, &scene);
    assert_int_equal(scene.player[0].place, 1);
    /* The round has rank 1 of the day and of the week. The scene must show the longer of these
     * periods. */
    assert_int_equal(scene.player[0].period, RANK_WEEK);
    begin_name_entry();
    press_key(NAME_DONE);
    core_scene(&core, &scene);
    assert_true(scene.leaderboard.shown);
    assert_int_equal(scene.leaderboard.period, RANK_WEEK);
    assert_true(scene.leaderboard.row[0].is_new);
    assert_int_equal(scene.leaderboard.row[0].caught, 3);
    assert_false(scene.leaderboard.row[1].is_new);
}

static void test_attract_cycles_through_the_leaderboards_with_scores(void **state)
{
    (void)state;
    uint32_t shown[MODE_COUNT][RANK_PERIOD_COUNT] = { 0 }, easy = 0;
    core.config.modes = 1u << MODE_FESTIVAL | 1u << MODE_PRACTICE;
    core.game.accounts.ranking.row[MODE_FESTIVAL][RANK_WEEK][0].caught = 4;
    core.game.accounts.ranking.row[MODE_FESTIVAL][RANK_EVER][0].caught = 4;
    /* The championship has a score, but the mode is not enabled, so its leaderboard is not
     * shown. */
    core.game.accounts.ranking.row[MODE_CHAMPIONSHIP][RANK_EVER][0].caught = 4;
    core.game.accounts.ranking.row[ranking_board(MODE_FESTIVAL, LEVEL_EASY)][RANK_DAY][0].caught =
        2;
    for (uint32_t i = 0; i < 6u * LEADERBOARD_EVERY_TICKS; i++) {
        core.game.tick++;
        core_scene(&core, &scene);
        const struct scene_leaderboard *board = &scene.leaderboard;
        easy += board->shown && board->level == LEVEL_EASY;
        shown[board->mode][board->period] += board->shown && board->level == LEVEL_MASTER;
    }
    assert_in_range(easy, 2u * LEADERBOARD_TICKS - 2u, 2u * LEADERBOARD_TICKS);
    assert_in_range(shown[MODE_FESTIVAL][RANK_WEEK], 2u * LEADERBOARD_TICKS - 2u,
                    2u * LEADERBOARD_TICKS);
    assert_in_range(shown[MODE_FESTIVAL][RANK_EVER], 2u * LEADERBOARD_TICKS - 2u,
                    2u * LEADERBOARD_TICKS);
    assert_int_equal(shown[MODE_FESTIVAL][RANK_DAY], 0);
    assert_int_equal(shown[MODE_CHAMPIONSHIP][RANK_EVER], 0);
}

static void test_an_empty_leaderboard_is_not_shown(void **state)
{
    (void)state;
    for (uint32_t i = 0; i < 2u * LEADERBOARD_EVERY_TICKS; i++) {
        core.game.tick++;
        core_scene(&core, &scene);
        assert_false(scene.leaderboard.shown);
    }
}

#define NAMED(test) cmocka_unit_test_setup(test, setup_names)

int main(void)
{
    const struct CMUnitTest tests[] = {
        NAMED(test_a_ranked_player_is_asked_after_the_result),
        NAMED(test_a_player_without_a_catch_is_not_asked),
        NAMED(test_no_player_is_asked_when_the_setting_is_off),
        NAMED(test_no_player_is_asked_without_a_store),
        NAMED(test_an_unranked_player_is_not_asked),
        NAMED(test_players_are_asked_once_each_with_the_best_first),
        NAMED(test_buttons_enter_a_name_for_every_leaderboard),
        NAMED(test_dips_enter_a_name),
        NAMED(test_a_poi_and_the_buttons_reach_every_cell_and_key),
        NAMED(test_another_players_poi_enters_nothing),
        NAMED(test_the_next_players_poi_highlights_its_key_at_once),
        NAMED(test_the_dip_that_ended_the_result_enters_nothing),
        NAMED(test_a_held_button_repeats_and_a_tap_does_not),
        NAMED(test_a_full_name_accepts_no_letter_and_selects_done),
        NAMED(test_erase_and_change_do_nothing_on_an_empty_name),
        NAMED(test_the_forms_of_a_letter_cycle),
        NAMED(test_a_rejected_name_can_be_replaced_once),
        NAMED(test_an_accepted_second_name_is_stored),
        NAMED(test_a_timeout_does_not_bypass_the_name_filter),
        NAMED(test_a_timeout_keeps_the_entered_letters),
        NAMED(test_the_name_entry_has_a_total_time_limit),
        NAMED(test_the_operators_button_keeps_the_entered_letters),
        NAMED(test_a_round_without_a_ledger_entry_gets_no_name),
        NAMED(test_the_name_entry_ends_with_any_input),
        NAMED(test_the_leaderboard_shows_the_best_rank_and_highlights_the_round),
        NAMED(test_attract_cycles_through_the_leaderboards_with_scores),
        NAMED(test_an_empty_leaderboard_is_not_shown),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
