/* test_players.c -- checks the game with up to four players at one tank. Each player has a bowl, a
 * poi, paper and a count of fish. A player's round may end earlier than the rounds of the
 * others. */
#include "tests/unit/support/core_fixture.h"

#include "core/poi/paper/paper_patch.h"
#include "tests/unit/support/newest_record.h"

#define ROUND_S 20u

static const vec3 places_m[POI_MAX] = {
    { 0.20f, ABOVE_M, 0.15f },
    { -0.20f, ABOVE_M, 0.15f },
    { 0.20f, ABOVE_M, -0.15f },
    { -0.20f, ABOVE_M, -0.15f },
};

/* Starts a round with `players` bowls. Bit i of `hands` is set if player i has a controller. */
static void play(uint8_t players, uint32_t hands)
{
    const struct core_config config = {
        .seed = 7, .fish_count = 12, .round_s = ROUND_S, .players = players
    };
    open_core(&config);
    for (uint32_t i = 0; i < POI_MAX; i++) {
        if (hands >> i & 1u) {
            hold(i, places_m[i]);
        }
    }
    press(INPUT_START);
    wait_for_phase(PHASE_ROUND, 4u * CORE_TICK_HZ);
    tick();
}

/* Drops fish number `which` into a player's bowl, as if it fell from that player's poi. */
static void drop_into_bowl(uint32_t player, uint32_t which)
{
    struct fish *fish = &core.world.tank.fish[which];
    struct poi *poi = &core.world.poi[player];
    fish->gait = GAIT_HELD;
    fish->holder = (uint8_t)player;
    fish->position_m = v3_add(core.world.bowl[player].position_m, v3(0.0f, 0.03f, 0.0f));
    poi->carried_fish[poi->carried_count++] = (struct carried_fish){
        .fish = (uint16_t)which,
        .state = CARRIED_FALLING,
        .clear_ticks = CARRIED_CLEAR_TICKS,
    };
    ticks(30);
}

static void test_there_are_as_many_bowls_and_pois_as_players(void **state)
{
    (void)state;
    for (uint8_t players = 1; players <= POI_MAX; players++) {
        play(players, 0xfu);
        look();
        for (uint32_t i = 0; i < POI_MAX; i++) {
            assert_int_equal(scene.bowl[i].present, i < players);
            assert_int_equal(scene.poi[i].present, i < players);
            assert_int_equal(scene.player[i].plays, i < players);
        }
    }
}

static void test_each_player_has_paper_of_its_own(void **state)
{
    (void)state;
    play(4, 0xfu);
    for (uint32_t i = 1; i < POI_MAX; i++) {
        assert_memory_not_equal(core.world.poi[i].sheet.strength, core.world.poi[0].sheet.strength,
                                sizeof core.world.poi[0].sheet.strength);
    }
    lead(2, v3(places_m[2].x, BELOW_M, places_m[2].z));
    ticks(120);
    assert_true(core.world.poi[2].sheet.touched);
    assert_false(core.world.poi[0].sheet.touched);
    assert_int_equal(core.world.poi[2].dips, 1);
    assert_int_equal(core.world.poi[3].dips, 0);
}

static void test_each_player_has_a_count_of_its_own(void **state)
{
    (void)state;
    play(4, 0xfu);
    drop_into_bowl(1, 0);
    drop_into_bowl(3, 1);
    drop_into_bowl(3, 2);
    static const uint32_t caught[POI_MAX] = { 0, 1, 0, 2 };
    assert_memory_equal(look()->caught, caught, sizeof caught);
    for (uint32_t i = 0; i < POI_MAX; i++) {
        assert_int_equal(scene.bowl[i].fish_count, caught[i]);
    }
}

static void test_a_player_without_paper_is_out_and_the_others_continue(void **state)
{
    (void)state;
    play(3, 0x7u);
    tear_all(0);
    ticks(GAME_GONE_TICKS + 10u);
    assert_int_equal(core.game.phase, PHASE_ROUND);
    assert_true(look()->player[0].out);
    assert_false(scene.player[1].out);
    assert_int_equal(scene.lesson[0].hint, HINT_TORN);
    tear_all(1);
    ticks(GAME_GONE_TICKS + 10u);
    assert_int_equal(core.game.phase, PHASE_ROUND);
    tear_all(2);
    ticks(GAME_GONE_TICKS);
    /* After the last paper tore, the round continues for GAME_GONE_TICKS, so that the players see
     * the hole. */
    assert_int_equal(core.game.phase, PHASE_ROUND);
    ticks(2);
    assert_int_equal(core.game.phase, PHASE_RESULT);
    assert_int_equal(sounds[SOUND_GONE], 3);
}

static void test_a_player_who_is_out_cannot_dip(void **state)
{
    (void)state;
    play(2, 0x3u);
    tear_all(0);
    tick();
    lead(0, v3(places_m[0].x, BELOW_M, places_m[0].z));
    lead(1, v3(places_m[1].x, BELOW_M, places_m[1].z));
    ticks(120);
    assert_true(core.world.poi[0].immersed <= 0.0f);
    assert_true(core.world.poi[1].immersed > 0.9f);
}

static void test_a_torn_poi_may_be_used_while_it_can_hold_a_fish(void **state)
{
    (void)state;
    play(1, 0x1u);
    struct sheet *sheet = &core.world.poi[0].sheet;
    /* Turns the first ten rows of cells into holes. These rows are the third of the paper that is
     * farthest from the player. */
    for (uint32_t i = 0; i < 10u * SHEET_SIDE; i++) {
        if (sheet->state[i] == CELL_PAPER) {
            sheet->state[i] = CELL_HOLE;
            sheet->paper_cells--;
        }
    }
    assert_true(paper_can_hold(sheet));
    ticks(GAME_GONE_TICKS + 10u);
    assert_int_equal(core.game.phase, PHASE_ROUND);
    assert_false(look()->player[0].out);
    drop_into_bowl(0, 0);
    assert_int_equal(look()->caught[0], 1);
}

static void test_the_record_lists_the_players_and_their_results(void **state)
{
    (void)state;
    /* Bits 0 and 2 are set, so the first and the third player take part. */
    play(4, 0x5u);
    lead(2, v3(places_m[2].x, BELOW_M, places_m[2].z));
    lead(2, places_m[2]);
    drop_into_bowl(0, 0);
    drop_into_bowl(2, 1);
    drop_into_bowl(2, 2);
    tear_all(0);
    tick();
    const uint32_t torn_tick = core.game.tick - 1u;
    tear_all(2);
    wait_for_phase(PHASE_RESULT, GAME_GONE_TICKS + 2u);
    const struct round_record *record = newest_record(&output);
    assert_int_equal(record->mode, MODE_FESTIVAL);
    assert_int_equal(record->grade, 6);
    assert_int_equal(record->players, 0x5u);
    assert_int_equal(record->caught, 3);
    assert_int_equal(record->player[0].caught, 1);
    assert_int_equal(record->player[0].scoops, 0);
    assert_int_equal(record->player[0].torn_tick, torn_tick);
    assert_int_equal(record->player[2].caught, 2);
    assert_int_equal(record->player[2].scoops, 1);
    /* The hole is the whole paper, a disc of 80 mm diameter, whose area is 5,027 mm^2. */
    assert_int_equal(record->player[2].hole_area_mm2, 5027);
    assert_int_equal(record->player[2].sheets, 1);
    assert_int_equal(record->player[1].caught, 0);
    assert_int_equal(record->by_bot, 0);
}

static void test_the_best_score_is_that_of_one_player(void **state)
{
    (void)state;
    play(2, 0x3u);
    drop_into_bowl(0, 0);
    drop_into_bowl(1, 1);
    drop_into_bowl(1, 2);
    wait_for_phase(PHASE_RESULT, (ROUND_S + 4u) * CORE_TICK_HZ);
    assert_int_equal(newest_record(&output)->caught, 3);
    assert_int_equal(core.game.accounts.ranking.row[MODE_FESTIVAL][RANK_DAY][0].caught, 2);
}

static void test_only_the_bot_is_present_in_attract(void **state)
{
    (void)state;
    const struct core_config config = { .fish_count = 12, .players = 4 };
    open_core(&config);
    for (uint32_t i = 0; i < POI_MAX; i++) {
        hold(i, places_m[i]);
    }
    ticks(10);
    look();
    for (uint32_t i = 0; i < POI_MAX; i++) {
        assert_int_equal(scene.poi[i].present, i == 0);
        assert_true(scene.bowl[i].present);
    }
}

static void test_any_player_can_start_by_a_dip(void **state)
{
    (void)state;
    const struct core_config config = { .fish_count = 12, .players = 3 };
    open_core(&config);
    dip(2, 0.1f, 0.0f);
    assert_int_equal(core.game.phase, PHASE_READY);
    open_core(&config);
    /* The kiosk is set to three players, so a dip of the fourth poi starts no round. */
    dip(3, 0.1f, 0.0f);
    assert_int_equal(core.game.phase, PHASE_ATTRACT);
}

/* A player whose controller appears during a round takes part from that moment. */
static void test_a_late_player_joins_the_round(void **state)
{
    (void)state;
    play(2, 0x1u);
    assert_false(look()->player[1].plays);
    hold(1, places_m[1]);
    ticks(60);
    assert_true(look()->player[1].plays);
    assert_false(scene.paused);
    tear_all(0);
    ticks(GAME_GONE_TICKS + 10u);
    assert_int_equal(core.game.phase, PHASE_ROUND);
}

/* The ring was not above the water (`clear_ticks` is 0). This would be a foul in a championship. In
 * a festival the fish counts for player 1, who owns the bowl. */
static void test_a_fish_counts_for_the_bowl_it_lies_in_in_a_festival(void **state)
{
    (void)state;
    play(2, 0x3u);
    struct fish *fish = &core.world.tank.fish[0];
    struct poi *poi = &core.world.poi[0];
    fish->gait = GAIT_HELD;
    fish->holder = 0;
    fish->position_m = v3_add(core.world.bowl[1].position_m, v3(0.0f, 0.03f, 0.0f));
    poi->carried_fish[poi->carried_count++] =
        (struct carried_fish){ .fish = 0, .state = CARRIED_FALLING };
    ticks(30);
    assert_int_equal(core.world.bowl[1].fish_count, 1);
    assert_int_equal(look()->caught[1], 1);
    assert_int_equal(scene.caught[0], 0);
}

static void test_a_scoop_counts_only_while_a_player_controls_the_poi(void **state)
{
    (void)state;
    play(1, 0x1u);
    lead(0, v3(0.0f, BELOW_M, 0.0f));
    ticks(60);
    assert_int_equal(core.world.poi[0].dips, 1);
    /* The poi is under water while its controller is lost and found three times. This must not
     * count as dips. */
    for (uint32_t i = 0; i < 3; i++) {
        input.poi[0].link = POI_SOURCE_LOST;
        ticks(4u * CORE_TICK_HZ);
        assert_true(core.world.poi[0].immersed <= 0.0f);
        input.poi[0].link = POI_SOURCE_LIVE;
        ticks(4u * CORE_TICK_HZ);
        assert_true(core.world.poi[0].immersed > 0.5f);
    }
    assert_int_equal(core.world.poi[0].dips, 1);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_there_are_as_many_bowls_and_pois_as_players),
        cmocka_unit_test(test_each_player_has_paper_of_its_own),
        cmocka_unit_test(test_each_player_has_a_count_of_its_own),
        cmocka_unit_test(test_a_player_without_paper_is_out_and_the_others_continue),
        cmocka_unit_test(test_a_player_who_is_out_cannot_dip),
        cmocka_unit_test(test_a_torn_poi_may_be_used_while_it_can_hold_a_fish),
        cmocka_unit_test(test_the_record_lists_the_players_and_their_results),
        cmocka_unit_test(test_the_best_score_is_that_of_one_player),
        cmocka_unit_test(test_only_the_bot_is_present_in_attract),
        cmocka_unit_test(test_any_player_can_start_by_a_dip),
        cmocka_unit_test(test_a_late_player_joins_the_round),
        cmocka_unit_test(test_a_fish_counts_for_the_bowl_it_lies_in_in_a_festival),
        cmocka_unit_test(test_a_scoop_counts_only_while_a_player_controls_the_poi),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
