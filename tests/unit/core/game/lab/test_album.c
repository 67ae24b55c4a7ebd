/* test_album.c -- checks the album. Each caught fish must be recorded, and the page of the album
 * must show how the fish grows up. */
#include "tests/unit/support/game_fixture.h"

#include "core/game/lab/lab.h"
#include "core/game/phases.h"
#include "core/morph/morph.h"

/* Simulates that the fish with the number `fish` lands in the player's bowl in this tick. */
static void land(uint32_t fish, uint32_t player)
{
    struct catch_result caught[POI_MAX] = { 0 };
    core.world.tank.fish[fish].gait = GAIT_BOWL;
    core.world.tank.fish[fish].holder = (uint8_t)player;
    caught[player].bowled = caught[player].landed = 1;
    game_score(core.game.player, &core.game.album, &core.game, &core.world, caught, false, &output);
}

static const struct scene_album *page(void)
{
    static struct scene scene;
    core_scene(&core, &scene);
    return &scene.album;
}

static void catch_and_end(uint32_t count)
{
    play_into_round();
    for (uint32_t i = 0; i < count; i++) {
        land(11u - i, 0);
    }
    steps(ROUND_S * CORE_TICK_HZ);
    assert_int_equal(core.game.phase, PHASE_RESULT);
    steps(GAME_RESULT_TICKS);
}

/* ---- Presents -------------------------------------------------------------------------------- */

static void test_a_player_without_a_catch_gets_the_nearest_fish_as_a_present(void **state)
{
    (void)state;
    core.config.ticket_fish = 1;
    play_into_round();
    const vec3 bowl_m = core.world.bowl[0].position_m;
    core.world.tank.fish[5].position_m = v3(bowl_m.x + 0.1f, -0.05f, bowl_m.z);
    core.world.tank.fish[4].position_m = v3(bowl_m.x + 0.09f, -0.05f, bowl_m.z);
    core.world.tank.fish[4].gait = GAIT_HELD; /* Makes the fish held, because a held fish cannot
                                                 become the present. */
    steps(ROUND_S * CORE_TICK_HZ);
    assert_int_equal(core.game.phase, PHASE_RESULT);
    assert_int_equal(core.world.tank.fish[5].gait, GAIT_BOWL);
    assert_int_equal(core.world.tank.fish[5].holder, 0);
    assert_int_equal(core.world.bowl[0].fish_count, 1);
    static struct scene scene;
    core_scene(&core, &scene);
    assert_int_equal(scene.player[0].has_present, 1);
    assert_int_equal(scene.player[1].has_present, 0);
    /* The present must give neither a score nor a ticket. */
    assert_int_equal(scene.caught[0], 0);
    assert_int_equal(game_record(&core.game, &core.world, &core.config).caught, 0);
    assert_int_equal(output.tickets, 0);
    steps(GAME_RESULT_TICKS);
    assert_int_equal(core.game.phase, PHASE_ALBUM);
    assert_int_equal(page()->fish_count, 1);
    assert_int_equal(page()->caught, 0);
    assert_int_equal(page()->fish[0].is_present, 1);
    assert_int_equal(page()->fish[0].look, core.world.tank.fish[5].look);
    steps(album_ticks(1) - 1u);
    assert_float_equal(page()->fish[0].progress, 1.0f, 0.0f);
}

static void test_only_a_player_without_a_catch_gets_a_present(void **state)
{
    (void)state;
    play_into_round();
    bowl_init(&core.world.bowl[1], v3(0.0f, 0.02f, 0.0f));
    core.game.player[1].plays = core.game.player[1].out = 1;
    /* Player 2 is out of the round too, but has no bowl and therefore gets no present. */
    core.game.player[2].plays = core.game.player[2].out = 1;
    for (uint32_t i = 0; i < ALBUM_FISH_MAX; i++) {
        land(i, 0);
    }
    steps(ROUND_S * CORE_TICK_HZ);
    assert_int_equal(core.game.phase, PHASE_RESULT);
    /* The album page is full, so the present has replaced the last fish on the page. */
    assert_int_equal(core.game.album.fish_count, ALBUM_FISH_MAX);
    assert_int_equal(core.game.album.fish[ALBUM_FISH_MAX - 1u].owner, 1);
    assert_false(album_has_present(&core.game, 0));
    assert_true(album_has_present(&core.game, 1));
    assert_false(album_has_present(&core.game, 2));
    /* land() simulates a catch, but puts no fish into the bowl. Only the present is in a bowl. */
    assert_int_equal(core.world.bowl[0].fish_count, 0);
    assert_int_equal(core.world.bowl[1].fish_count, 1);
}

static void test_older_recordings_refunds_and_empty_tanks_have_no_present(void **state)
{
    for (uint32_t i = 0; i < 4u; i++) {
        setup(state);
        core.config.rules = i == 0 ? 8 : 0;
        play_into_round();
        core.game.accounts.credit.came_back = i == 1u;
        for (uint32_t k = 0; k < core.world.tank.fish_count && i == 2u; k++) {
            core.world.tank.fish[k].gait = GAIT_BOWL;
        }
        if (i == 3u) {
            round_result_skip(&core.game, &core.world, &core.config, &output);
        } else {
            steps(ROUND_S * CORE_TICK_HZ);
            assert_int_equal(core.game.phase, PHASE_RESULT);
            steps(GAME_RESULT_TICKS);
            assert_int_equal(core.game.phase, PHASE_ATTRACT);
        }
        assert_int_equal(core.game.album.fish_count, 0);
    }
}

/* ---- Caught fish ----------------------------------------------------------------------------- */

static void test_the_album_shows_the_first_catches_and_counts_the_rest(void **state)
{
    (void)state;
    catch_and_end(8);
    assert_int_equal(core.game.phase, PHASE_ALBUM);
    assert_int_equal(page()->fish_count, ALBUM_FISH_MAX);
    assert_int_equal(page()->caught, 8);
    for (uint32_t i = 0; i < ALBUM_FISH_MAX; i++) {
        assert_int_equal(core.game.album.fish[i].fish, 11u - i);
        assert_int_equal(page()->fish[i].look, core.world.tank.fish[11u - i].look);
    }
}

static void test_the_album_stores_the_player_of_each_fish(void **state)
{
    (void)state;
    play_into_round();
    land(3, 2);
    land(4, 0);
    assert_int_equal(core.game.album.fish[0].owner, 2);
    assert_int_equal(core.game.album.fish[1].owner, 0);
}

/* The album must keep the state that a fish had when it was first caught. */
static void test_a_fish_is_recorded_once_in_its_caught_state(void **state)
{
    (void)state;
    play_into_round();
    const float age_days = core.world.tank.fish[5].age_days;
    land(5, 0);
    /* The fish is poured back and caught again at another age. The album must not change. */
    core.world.tank.fish[5].gait = GAIT_SWIM;
    core.world.tank.fish[5].age_days = 9999.0f;
    land(5, 0);
    assert_int_equal(core.game.album.fish_count, 1);
    assert_int_equal(core.game.album.caught, 2);
    assert_float_equal(core.game.album.fish[0].age_days, age_days, 0.0f);
}

static void test_each_life_runs_from_hatching_to_the_last_key(void **state)
{
    (void)state;
    const struct species_card *card = &species_wakin.card;
    catch_and_end(2);
    const struct scene_grown hatched = page()->fish[0];
    assert_float_equal(hatched.progress, 0.0f, 1e-4f);
    assert_float_equal(hatched.length_m, card->key_length_m[0], 1e-5f);
    assert_int_equal(hatched.is_caught, 0);
    float before = 0.0f;
    int met = 0;
    for (uint32_t i = 0; i < ALBUM_LIFE_TICKS; i++) {
        step();
        const struct scene_grown now = page()->fish[0];
        assert_true(now.progress >= before);
        before = now.progress;
        /* `is_caught` must become 1 when the animated fish reaches the length that it had when it
         * was caught. */
        if (now.is_caught && !met) {
            assert_float_equal(now.length_m, now.caught_length_m, 0.03f * now.caught_length_m);
            met = 1;
        }
    }
    assert_true(met);
    assert_float_equal(page()->fish[0].progress, 1.0f, 1e-3f);
    /* The smaller fish begins to grow later on this page, so its animation is not complete yet. */
    assert_true(page()->fish[1].progress < 1.0f);
}

static void test_a_small_fish_stays_small(void **state)
{
    (void)state;
    play_into_round();
    core.world.tank.fish[0].length_m *= 0.8f;
    land(0, 0);
    land(1, 0);
    core.game.phase = PHASE_ALBUM;
    core.game.phase_tick = core.game.tick - album_ticks(2);
    const float ratio = page()->fish[0].length_m / page()->fish[1].length_m;
    assert_float_equal(ratio, 0.8f, 0.02f);
}

static void test_the_album_ends_after_its_time_and_ok_turns_the_page_sooner(void **state)
{
    (void)state;
    catch_and_end(3);
    steps(album_ticks(3) - 2u);
    assert_int_equal(core.game.phase, PHASE_ALBUM);
    steps(3);
    assert_int_equal(core.game.phase, PHASE_ATTRACT);
    setup(state);
    catch_and_end(3);
    steps(10);
    press(INPUT_OK);
    assert_int_equal(core.game.phase, PHASE_ATTRACT);
}

static void test_start_and_a_dip_begin_another_round(void **state)
{
    for (uint32_t i = 0; i < 2; i++) {
        setup(state);
        catch_and_end(1);
        steps(10);
        if (i == 0) {
            press(INPUT_START);
        } else {
            dip();
        }
        /* This kiosk has only one mode, so the mode selection is skipped. */
        assert_int_equal(core.game.phase, PHASE_READY);
        assert_int_equal(core.game.album.fish_count, 0);
    }
}

int main(void)
{
#define TEST(name) cmocka_unit_test_setup(name, setup)
    const struct CMUnitTest tests[] = {
        TEST(test_a_player_without_a_catch_gets_the_nearest_fish_as_a_present),
        TEST(test_only_a_player_without_a_catch_gets_a_present),
        TEST(test_older_recordings_refunds_and_empty_tanks_have_no_present),
        TEST(test_the_album_shows_the_first_catches_and_counts_the_rest),
        TEST(test_the_album_stores_the_player_of_each_fish),
        TEST(test_a_fish_is_recorded_once_in_its_caught_state),
        TEST(test_each_life_runs_from_hatching_to_the_last_key),
        TEST(test_a_small_fish_stays_small),
        TEST(test_the_album_ends_after_its_time_and_ok_turns_the_page_sooner),
        TEST(test_start_and_a_dip_begin_another_round),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
