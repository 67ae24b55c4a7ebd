/* test_ui_messages.c -- Tests the messages on the screens: hints, warnings, credits, seals and
 * announcements. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "platform/render/ui/ui_screens.h"
#include "tests/unit/support/ui_fixture.h"

static void test_each_warning_is_one_line_and_free_play_shows_no_money(void **state)
{
    (void)state;
    uint32_t before = 0;
    for (uint32_t warned = 0; warned < 4u; warned++) {
        set_scene(PHASE_RESULT, LANGUAGE_EN, HINT_START, 6.0f);
        scene.credit.warnings = (uint8_t)((1u << warned) - 1u);
        lay_out(sizes[0]);
        assert_true(glyph_quads() > before);
        before = glyph_quads();
    }
    set_scene(PHASE_ATTRACT, LANGUAGE_EN, HINT_START, 6.0f);
    lay_out(sizes[0]);
    const uint32_t free_play = glyph_quads();
    scene.credit.price = 1;
    lay_out(sizes[0]);
    assert_true(glyph_quads() > free_play + 6u); /* The text "Credits 0" must be drawn in
                                                    addition. */
}

/* While the coin slot is locked, a warning is shown, and the hint to insert a coin must be hidden.
 * The hint to press START must stay, because a player who has a credit can start. */
static void test_no_hint_requests_a_coin_while_the_slot_is_locked(void **state)
{
    static const uint8_t why[] = { WARN_STORE, WARN_DOOR, WARN_TILT };
    static const uint8_t phases[] = { PHASE_ATTRACT, PHASE_RESULT, PHASE_ALBUM };
    (void)state;
    for (uint32_t k = 0; k < sizeof why * sizeof phases; k++) {
        uint32_t letters[2];
        for (uint8_t unpaid = 0; unpaid < 2u; unpaid++) {
            set_scene(phases[k % sizeof phases], LANGUAGE_EN, unpaid ? HINT_COIN : HINT_START,
                      6.0f);
            scene.credit.price = 1;
            scene.credit.unpaid = unpaid;
            scene.credit.request_s = 1e6f;
            scene.credit.warnings = why[k / sizeof phases];
            lay_out(sizes[0]);
            letters[unpaid] = glyph_quads();
        }
        assert_true(letters[1] + 10u < letters[0]);
    }
}

/* A credit can be played only after it is on disk. While the store fails, a player without a credit
 * on disk must not be invited to start. */
static void test_no_hint_invites_to_play_credits_that_the_store_cannot_write(void **state)
{
    (void)state;
    uint32_t letters[3];
    for (uint32_t written = 0; written < 3u; written++) {
        set_scene(PHASE_ATTRACT, LANGUAGE_EN, HINT_START, 6.0f);
        scene.credit.price = 1;
        scene.credit.coming = 1;
        scene.credit.credits = written == 1u;
        scene.credit.warnings = written == 2u ? 0u : WARN_STORE;
        lay_out(sizes[0]);
        letters[written] = glyph_quads();
    }
    assert_true(letters[0] + 30u < letters[1]);
    /* A coin that was just inserted is written soon. The invitation is then shown in place of the
     * warning, which has about as many letters. */
    assert_true(letters[2] + 30u > letters[0]);
}

/* Without a poi, the coin slot is locked and would return a coin. The result screen must therefore
 * not show the hint to insert a coin. */
static void test_no_hint_requests_a_coin_without_a_poi(void **state)
{
    static const uint8_t with[] = { 0, WARN_STORE, WARN_DOOR, WARN_TILT };
    (void)state;
    for (uint32_t k = 0; k < sizeof with; k++) {
        uint32_t letters[2];
        for (uint32_t asks = 0; asks < 2u; asks++) {
            set_scene(PHASE_RESULT, LANGUAGE_EN, asks ? HINT_COIN : HINT_NONE, 6.0f);
            scene.credit.price = 1;
            scene.credit.unpaid = 1;
            scene.credit.request_s = 1e6f;
            scene.credit.warnings = (uint8_t)(WARN_NO_POI | with[k]);
            lay_out(sizes[0]);
            scene.tick += CORE_TICK_HZ; /* A new hint fades in within one second. */
            lay_out(sizes[0]);
            letters[asks] = glyph_quads();
        }
        assert_int_equal(letters[1], letters[0]);
    }
}

static void test_no_hint_requests_a_dip_or_a_mouse_without_a_poi(void **state)
{
    (void)state;
    for (uint8_t unpaid = 0; unpaid < 2u; unpaid++) {
        set_scene(PHASE_ATTRACT, LANGUAGE_EN, HINT_START, 6.0f);
        scene.credit.unpaid = unpaid;
        scene.credit.request_s = 1e6f;
        scene.credit.warnings = WARN_DOOR;
        lay_out(sizes[0]);
        const uint32_t with = glyph_quads();
        scene.credit.warnings = WARN_NO_POI;
        lay_out(sizes[0]);
        assert_true(glyph_quads() + 40u < with); /* Without a poi, the long hint for the mouse is
                                                    hidden, so fewer letters are drawn. */
    }
    static struct ui_vertex paid[sizeof batch.vertices / sizeof *batch.vertices];
    lay_out(sizes[0]);
    const uint32_t quads = batch.quad_count;
    memcpy(paid, batch.vertices, sizeof paid);
    /* Without a poi, the screen must not request a coin. Whether the credit is unpaid must
     * therefore make no difference to the picture. */
    scene.credit.unpaid = 0;
    lay_out(sizes[0]);
    assert_int_equal(batch.quad_count, quads);
    assert_memory_equal(batch.vertices, paid, 4u * quads * sizeof *paid);
}

static void test_a_partly_paid_credit_is_shown_beside_whole_credits(void **state)
{
    (void)state;
    for (uint8_t language = 0; language < LANGUAGE_COUNT; language++) {
        set_scene(PHASE_ATTRACT, language, HINT_START, 6.0f);
        scene.credit = (struct scene_credit){ .price = 3, .credits = 1, .coin_s = 6.0f };
        lay_out(sizes[0]);
        const uint32_t whole = glyph_quads();
        scene.credit.units = 2;
        lay_out(sizes[0]);
        assert_int_equal(glyph_quads(), whole + 4u); /* The text "+ 2/3" has four letters. */
        /* Three coins normally become a credit, but here the number of credits is already at its
         * maximum. The three coins stay units, and a fraction of 3/3 must not be shown. */
        scene.credit.units = 3;
        lay_out(sizes[0]);
        assert_int_equal(glyph_quads(), whole);
    }
}

/* After a refund, the result card shows no count, praise, rank or seal. The picture must therefore
 * be the same for any number of caught fish. */
static void test_a_refunded_round_is_shown_without_a_count(void **state)
{
    (void)state;
    static struct ui_vertex none_caught[sizeof batch.vertices / sizeof *batch.vertices];
    for (uint8_t players = 1; players <= POI_MAX; players++) {
        for (uint32_t caught = 0; caught < 60u; caught += 47u) {
            set_scene(PHASE_RESULT, LANGUAGE_EN, HINT_PAID_BACK, 6.0f);
            set_match(MODE_CHAMPIONSHIP, players, 0);
            scene.credit.came_back = 1;
            for (uint32_t i = 0; i < POI_MAX; i++) {
                scene.caught[i] = caught;
            }
            lay_out(sizes[0]);
            if (caught == 0) {
                memcpy(none_caught, batch.vertices, sizeof none_caught);
            }
            assert_memory_equal(batch.vertices, none_caught,
                                4u * batch.quad_count * sizeof *none_caught);
        }
    }
}

static void test_without_a_hint_no_ribbon_is_drawn(void **state)
{
    (void)state;
    set_scene(PHASE_ROUND, LANGUAGE_EN, HINT_LOST_POI, 20.0f);
    memory = (struct ui_memory){ .hint = HINT_LOST_POI };
    lay_out(sizes[0]);
    const uint32_t with = glyph_quads();
    set_scene(PHASE_ROUND, LANGUAGE_EN, HINT_NONE, 20.0f);
    lay_out(sizes[0]);
    assert_true(glyph_quads() < with);
    /* HINT_COUNT is not a hint, so no text may be drawn for it. */
    set_scene(PHASE_ROUND, LANGUAGE_EN, HINT_COUNT, 20.0f);
    lay_out(sizes[0]);
    assert_true(glyph_quads() < with);
}

static uint8_t last_opacity(void)
{
    return batch.vertices[(batch.quad_count - 1u) * 4u].fill[3];
}

static void test_a_new_hint_fades_in(void **state)
{
    (void)state;
    memory = (struct ui_memory){ 0 };
    set_scene(PHASE_ROUND, LANGUAGE_EN, HINT_LOST_POI, 20.0f);
    lay_out(sizes[0]);
    scene.tick += 12; /* 12 ticks are 0.1 s, so the message has just begun to fade in. */
    lay_out(sizes[0]);
    const uint8_t early = last_opacity();
    scene.tick += 120;
    lay_out(sizes[0]);
    assert_true(early > 0);
    assert_true(last_opacity() > early);
    assert_int_equal(last_opacity(), 255);
}

static uint32_t seals(void)
{
    uint32_t count = 0;
    for (uint32_t i = 0; i < batch.quad_count; i++) {
        count += batch.kinds[i] == UI_WASHI;
    }
    return count;
}

static void test_a_ranked_player_gets_the_seal(void **state)
{
    (void)state;
    for (uint8_t place = 0; place <= 10; place++) {
        for (uint8_t period = 0; period < RANK_PERIOD_COUNT; period++) {
            set_scene(PHASE_RESULT, LANGUAGE_EN, HINT_NONE, 4.0f);
            set_match(MODE_FESTIVAL, 1, 0);
            scene.player[0].place = place;
            scene.player[0].period = period;
            lay_out(sizes[0]);
            assert_int_equal(seals(), place > 0 ? 2 : 1); /* The result card always has one seal.
                                                             The rank of a player gives a second
                                                             seal. */
        }
    }
}

static void test_only_the_ranked_player_of_several_gets_the_seal(void **state)
{
    (void)state;
    set_scene(PHASE_RESULT, LANGUAGE_JA, HINT_NONE, 4.0f);
    set_match(MODE_FESTIVAL, 2, 0);
    scene.player[1].place = 3;
    lay_out(sizes[0]);
    assert_int_equal(seals(), 2);
    scene.player[1].place = 0;
    lay_out(sizes[0]);
    assert_int_equal(seals(), 1);
}

static uint32_t vermilion_lamps(void)
{
    uint32_t count = 0;
    for (uint32_t i = 0; i < batch.quad_count; i++) {
        const uint8_t *fill = batch.vertices[i * 4u].fill;
        count += batch.kinds[i] == UI_PANEL && fill[0] == 0xff && fill[1] == 0x52;
    }
    return count;
}

static void test_each_foul_lights_a_lamp_in_modes_with_fouls(void **state)
{
    (void)state;
    for (uint8_t mode = 0; mode < MODE_COUNT; mode++) {
        for (uint8_t fouls = 0; fouls <= FOUL_MAX; fouls++) {
            for (uint32_t players = 1; players <= 2u; players++) {
                set_scene(PHASE_ROUND, LANGUAGE_JA, HINT_NONE, 20.0f);
                set_match(mode, players, 0);
                scene.player[0].fouls = fouls;
                scene.player[0].lost = scene.player[1].lost = 0;
                scene.player[1].fouls = 0;
                scene.player[0].foul_s = 60.0f;
                scene.player[1].foul_s = 60.0f;
                lay_out(sizes[0]);
                assert_int_equal(vermilion_lamps(), mode == MODE_CHAMPIONSHIP ? fouls : 0);
            }
        }
    }
}

static void test_an_announcement_is_shown_once_and_does_not_cover_the_water(void **state)
{
    (void)state;
    for (uint8_t call = CALL_ONE_MINUTE; call <= CALL_TIME; call++) {
        set_scene(PHASE_ROUND, LANGUAGE_JA, HINT_NONE, 20.0f);
        set_match(MODE_CHAMPIONSHIP, 1, 0);
        scene.seconds_left = call == CALL_COUNTDOWN ? 3.5f : 60.0f;
        scene.player[0].foul_s = 60.0f;
        lay_out(sizes[0]);
        const uint32_t without = glyph_quads();
        scene.call = call;
        scene.call_s = 0.5f;
        lay_out(sizes[0]);
        assert_true(glyph_quads() > without);
        scene.call_s = 3.0f;
        /* Each digit of the countdown must have disappeared before the next one appears. */
        scene.seconds_left -= call == CALL_COUNTDOWN ? 0.48f : 0.0f;
        lay_out(sizes[0]);
        assert_int_equal(glyph_quads(), without);
    }
}

static void test_a_pause_is_shown_over_the_water(void **state)
{
    (void)state;
    set_scene(PHASE_ROUND, LANGUAGE_EN, HINT_NONE, 20.0f);
    set_match(MODE_CHAMPIONSHIP, 1, 0);
    scene.player[0].foul_s = 60.0f;
    lay_out(sizes[0]);
    const uint32_t without = glyph_quads();
    scene.paused = scene.player[0].lost = 1;
    lay_out(sizes[0]);
    assert_true(glyph_quads() > without + 20u);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_a_refunded_round_is_shown_without_a_count),
        cmocka_unit_test(test_no_hint_requests_a_coin_while_the_slot_is_locked),
        cmocka_unit_test(test_no_hint_invites_to_play_credits_that_the_store_cannot_write),
        cmocka_unit_test(test_no_hint_requests_a_coin_without_a_poi),
        cmocka_unit_test(test_no_hint_requests_a_dip_or_a_mouse_without_a_poi),
        cmocka_unit_test(test_a_partly_paid_credit_is_shown_beside_whole_credits),
        cmocka_unit_test(test_each_warning_is_one_line_and_free_play_shows_no_money),
        cmocka_unit_test(test_without_a_hint_no_ribbon_is_drawn),
        cmocka_unit_test(test_a_new_hint_fades_in),
        cmocka_unit_test(test_a_ranked_player_gets_the_seal),
        cmocka_unit_test(test_only_the_ranked_player_of_several_gets_the_seal),
        cmocka_unit_test(test_each_foul_lights_a_lamp_in_modes_with_fouls),
        cmocka_unit_test(test_an_announcement_is_shown_once_and_does_not_cover_the_water),
        cmocka_unit_test(test_a_pause_is_shown_over_the_water),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
