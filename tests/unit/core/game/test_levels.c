/* test_levels.c -- checks what the level of difficulty changes in a round: the size of the ring,
 * the paper, the motion of the poi in water, and how easily fish flee. */
#include "tests/unit/support/core_fixture.h"

#include "core/game/ranking/ranking.h"
#include "core/game/rules.h"
#include "core/poi/poi.h"

/* Opens a kiosk with one mode and starts a round. The poi is above the water. */
static void play_into_round(uint8_t mode, uint8_t level)
{
    open_core(&(struct core_config){ .seed = 7,
                                     .fish_count = mode == MODE_CHAMPIONSHIP ? 0u : 40u,
                                     .modes = (uint8_t)(1u << mode),
                                     .level = level });
    input.poi[0].link = POI_SOURCE_LIVE;
    input.poi[0].target.position_m = v3(0.0f, ABOVE_M, 0.0f);
    press(INPUT_START);
    for (uint32_t i = 0; i < 10u * CORE_TICK_HZ && core.game.phase != PHASE_ROUND; i++) {
        tick();
    }
    assert_int_equal(core.game.phase, PHASE_ROUND);
}

static void test_the_master_level_changes_nothing(void **state)
{
    (void)state;
    const struct level_rules *master = rules_of_level(LEVEL_MASTER);
    const struct temper none = { 0 };
    assert_float_equal(master->ring_radius_m, POI_RADIUS_M, 0.0f);
    assert_int_equal(master->grade_step, 0);
    assert_float_equal(master->stroke_s, 0.0f, 0.0f);
    assert_memory_equal(&master->temper, &none, sizeof none);
    play_into_round(MODE_FESTIVAL, LEVEL_MASTER);
    assert_float_equal(core.world.poi[0].sheet.radius_m, POI_RADIUS_M, 0.0f);
    assert_int_equal(core.world.poi[0].sheet.grade, GAME_POI_GRADE);
}

static void test_an_easier_level_has_a_larger_ring_stronger_paper_and_calmer_fish(void **state)
{
    (void)state;
    for (uint8_t level = LEVEL_NORMAL; level < LEVEL_COUNT; level++) {
        const struct level_rules *here = rules_of_level(level);
        const struct level_rules *harder = rules_of_level((uint8_t)(level - 1u));
        assert_true(here->ring_radius_m > harder->ring_radius_m);
        assert_true(here->ring_radius_m <= POI_RADIUS_MAX_M);
        assert_true(here->grade_step > harder->grade_step);
        assert_true(here->temper.threshold_gain > harder->temper.threshold_gain);
        assert_true(here->temper.latency_gain > harder->temper.latency_gain);
        assert_true(here->temper.reach_loss > harder->temper.reach_loss);
        assert_true(here->temper.calm_share > harder->temper.calm_share);
    }
}

static void test_a_round_uses_the_ring_the_paper_and_the_fish_of_its_level(void **state)
{
    (void)state;
    static const uint8_t modes[] = { MODE_FESTIVAL, MODE_PRACTICE };
    for (size_t i = 0; i < sizeof modes; i++) {
        const struct level_rules *easy = rules_of_level(LEVEL_EASY);
        play_into_round(modes[i], LEVEL_EASY);
        assert_int_equal(core.game.player[0].level, LEVEL_EASY);
        assert_float_equal(core.world.poi[0].sheet.radius_m, easy->ring_radius_m, 0.0f);
        assert_int_equal(core.world.poi[0].sheet.grade, GAME_POI_GRADE - easy->grade_step);
        assert_memory_equal(&core.world.tank.temper, &easy->temper, sizeof easy->temper);
        core_scene(&core, &scene);
        assert_float_equal(scene.poi[0].ring_radius_m, easy->ring_radius_m, 0.0f);
        assert_int_equal(scene.grade, GAME_POI_GRADE - easy->grade_step);
    }
}

static void test_the_championship_is_always_played_at_the_master_level(void **state)
{
    (void)state;
    const struct temper none = { 0 };
    play_into_round(MODE_CHAMPIONSHIP, LEVEL_EASY);
    assert_int_equal(core.game.player[0].level, LEVEL_MASTER);
    assert_float_equal(core.world.poi[0].sheet.radius_m, POI_RADIUS_M, 0.0f);
    assert_memory_equal(&core.world.tank.temper, &none, sizeof none);
}

/* Moves the controller by 5 cm in one tick under water. Returns the greatest distance by which the
 * poi's target then moves in one tick. */
static float step_in_water_m(uint8_t level)
{
    play_into_round(MODE_FESTIVAL, level);
    for (uint32_t i = 0; i < 3u * CORE_TICK_HZ; i++) {
        input.poi[0].target.position_m.y = f_max(BELOW_M, ABOVE_M - 0.001f * (float)i);
        tick();
    }
    const vec3 from_m = core.game.control[0].target_pose.position_m;
    float most_m = 0.0f, last_m = 0.0f;
    for (uint32_t i = 0; i < CORE_TICK_HZ; i++) {
        input.poi[0].target.position_m.x = f_min(0.05f, 0.01f * (float)i);
        tick();
        const float way_m = v3_length(v3_sub(core.game.control[0].target_pose.position_m, from_m));
        most_m = f_max(most_m, way_m - last_m);
        last_m = way_m;
    }
    assert_float_equal(last_m, 0.05f, 0.001f);
    return most_m;
}

static void test_the_easy_level_limits_the_speed_of_a_poi_in_water(void **state)
{
    (void)state;
    const float most_m = rules_of_level(LEVEL_EASY)->stroke_m_s * CORE_TICK_S;
    assert_true(step_in_water_m(LEVEL_MASTER) > most_m);
    assert_true(step_in_water_m(LEVEL_EASY) <= 1.01f * most_m);
}

/* Two players dip, one at the easy level and one at the master level. Each poi follows the level of
 * its own player. The record and the leaderboards have the easiest level. */
static void test_players_at_two_levels_share_a_round_and_its_leaderboard(void **state)
{
    (void)state;
    static const uint8_t levels[] = { LEVEL_EASY, LEVEL_MASTER };
    const struct level_rules *easy = rules_of_level(LEVEL_EASY);
    open_core(&(struct core_config){ .seed = 7, .fish_count = 40, .players = 2 });
    hold(0, v3(-0.2f, ABOVE_M, 0.0f));
    hold(1, v3(0.2f, ABOVE_M, 0.0f));
    press(INPUT_START);
    wait_for_phase(PHASE_READY, 600);
    for (uint32_t i = 0; i < 2u; i++) {
        core.game.player[i].level = levels[i];
    }
    assert_int_equal(look()->grade, 0); /* The players have different papers. */
    wait_for_phase(PHASE_ROUND, 1200);
    lead(0, v3(-0.2f, BELOW_M, 0.0f));
    lead(1, v3(0.2f, BELOW_M, 0.0f));
    ticks(60);
    assert_int_equal(look()->grade, 0);
    float most_m[2] = { 0.0f, 0.0f };
    vec3 before[2] = { core.game.control[0].target_pose.position_m,
                       core.game.control[1].target_pose.position_m };
    for (uint32_t k = 0; k < 10u; k++) {
        for (uint32_t i = 0; i < 2u; i++) {
            input.poi[i].target.position_m.z += k < 5u ? 0.01f : 0.0f;
        }
        tick();
        for (uint32_t i = 0; i < 2u; i++) {
            const vec3 at_m = core.game.control[i].target_pose.position_m;
            most_m[i] = f_max(most_m[i], v3_length(v3_sub(at_m, before[i])));
            before[i] = at_m;
        }
    }
    assert_true(most_m[0] <= 1.01f * easy->stroke_m_s * CORE_TICK_S);
    assert_true(most_m[1] > 1.2f * most_m[0]);
    core.game.player[0].caught = 1;
    core.game.player[1].caught = 2;
    assert_int_equal(core_round_record(&core).level, LEVEL_EASY);
    wait_for_phase(PHASE_RESULT, core.game.round_s * CORE_TICK_HZ + 600u);
    const struct ranking *ranking = &core.game.accounts.ranking;
    const uint32_t at_easy = ranking_board(MODE_FESTIVAL, LEVEL_EASY);
    const uint32_t at_master = ranking_board(MODE_FESTIVAL, LEVEL_MASTER);
    assert_int_equal(ranking->row[at_easy][RANK_DAY][0].caught, 2);
    assert_int_equal(ranking->row[at_easy][RANK_DAY][1].caught, 1);
    assert_int_equal(ranking->row[at_master][RANK_DAY][0].caught, 0);
}

static void test_a_level_out_of_range_is_refused(void **state)
{
    (void)state;
    const struct core_config config = { .level = LEVEL_COUNT };
    assert_int_equal(core_init(&core, &config), CORE_ERR_RANGE);
}

static void test_the_record_and_the_scene_have_the_easiest_level_of_the_players(void **state)
{
    (void)state;
    play_into_round(MODE_FESTIVAL, LEVEL_NORMAL);
    assert_int_equal(core_round_record(&core).level, LEVEL_NORMAL);
    core.game.player[0].level = LEVEL_MASTER;
    core.game.player[1].level = LEVEL_EASY;
    assert_int_equal(core_round_record(&core).level, LEVEL_MASTER);
    /* The level of the second player counts only from now on, because this player takes part
     * now. */
    core.game.player[1].plays = 1;
    assert_int_equal(core_round_record(&core).level, LEVEL_EASY);
    core_scene(&core, &scene);
    assert_int_equal(scene.level, LEVEL_EASY);
    assert_int_equal(scene.player[0].level, LEVEL_MASTER);
    assert_int_equal(scene.player[1].level, LEVEL_EASY);
    play_into_round(MODE_CHAMPIONSHIP, LEVEL_EASY);
    assert_int_equal(core_round_record(&core).level, LEVEL_MASTER);
}

/* Returns the newest entry of the kind `kind` in the output's ring buffer of ledger entries. */
static const struct ledger_entry *newest(uint8_t kind)
{
    uint32_t id = output.entry_id;
    while (output.entries[id % LEDGER_RING].kind != kind) {
        assert_true(--id > 0);
    }
    return &output.entries[id % LEDGER_RING];
}

static void test_a_round_that_a_power_cut_ends_keeps_its_level(void **state)
{
    (void)state;
    play_into_round(MODE_FESTIVAL, LEVEL_EASY);
    /* If the kiosk gives tickets, the state of a running round is written to the ledger. */
    core.config.ticket_fish = 1;
    ticks(core.game.round_s * CORE_TICK_HZ * 5u / 6u);
    assert_int_equal(core.game.phase, PHASE_ROUND);
    const struct ledger_entry *last = newest(LEDGER_STAND);
    struct core_config config = { .seed = 7, .fish_count = 40, .level = LEVEL_NORMAL };
    config.persistent.ledger = (struct ledger_start){
        .last_id = last->id,
        .boots = 2,
        .balance = last->balance,
        .stand = round_standing_after((struct ledger_stand){ 0 }, last),
    };
    open_core(&config);
    tick();
    const struct ledger_entry *round = newest(LEDGER_ROUND);
    assert_int_equal(round->detail, ROUND_CUT_OFF);
    assert_int_equal(round->round.level, LEVEL_EASY);
    /* Sets the level of the stored round to 3, which does not exist. */
    config.persistent.ledger.stand.value |= 3 << 21;
    assert_int_equal(core_init(&core, &config), CORE_ERR_RANGE);
}

static void test_finished_rounds_are_counted_at_their_level(void **state)
{
    (void)state;
    /* Simulates four rounds that were counted by an older version, which had no levels. */
    struct audits audits = { .count[AUDIT_ROUNDS] = 4 };
    struct ledger_entry entry = { .kind = LEDGER_ROUND, .id = 1, .round.players = 1 };
    static const uint8_t levels[] = { LEVEL_EASY, LEVEL_NORMAL, LEVEL_EASY, LEVEL_MASTER };
    for (size_t i = 0; i < sizeof levels; i++) {
        entry.round.level = levels[i];
        audits_note(&audits, &entry);
    }
    entry.round.by_bot = 1;
    audits_note(&audits, &entry);
    assert_int_equal(audits.count[AUDIT_ROUNDS], 8);
    assert_int_equal(audits_rounds_at(audits.count, LEVEL_MASTER), 5);
    assert_int_equal(audits_rounds_at(audits.count, LEVEL_NORMAL), 1);
    assert_int_equal(audits_rounds_at(audits.count, LEVEL_EASY), 2);
    entry.round.by_bot = 0;
    entry.round.level = LEVEL_COUNT; /* No such level exists, and it has no counter. */
    audits_note(&audits, &entry);
    assert_int_equal(audits.count[AUDIT_ROUNDS], 9);
    assert_int_equal(audits_rounds_at(audits.count, LEVEL_MASTER), 6);
    entry = (struct ledger_entry){ .kind = LEDGER_RESET, .detail = AUDIT_GROUP_PLAY };
    audits_note(&audits, &entry);
    for (uint8_t level = 0; level < LEVEL_COUNT; level++) {
        assert_int_equal(audits_rounds_at(audits.count, level), 0);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_the_master_level_changes_nothing),
        cmocka_unit_test(test_an_easier_level_has_a_larger_ring_stronger_paper_and_calmer_fish),
        cmocka_unit_test(test_a_round_uses_the_ring_the_paper_and_the_fish_of_its_level),
        cmocka_unit_test(test_the_championship_is_always_played_at_the_master_level),
        cmocka_unit_test(test_the_easy_level_limits_the_speed_of_a_poi_in_water),
        cmocka_unit_test(test_players_at_two_levels_share_a_round_and_its_leaderboard),
        cmocka_unit_test(test_a_level_out_of_range_is_refused),
        cmocka_unit_test(test_the_record_and_the_scene_have_the_easiest_level_of_the_players),
        cmocka_unit_test(test_a_round_that_a_power_cut_ends_keeps_its_level),
        cmocka_unit_test(test_finished_rounds_are_counted_at_their_level),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
