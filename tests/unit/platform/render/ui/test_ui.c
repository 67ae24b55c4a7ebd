/* The layout of every screen, measured from its vertices: nothing needs a display. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include <cmocka.h>

#include "core/game/accounting/credit.h"
#include "core/game/ranking/name_keyboard.h"
#include "core/game/ranking/ranking.h"
#include "platform/render/ui/ui_screens.h"
#include "tests/unit/support/glyphs.h"

#define ROUNDING_PX 0.6f
#define SETTLED_TICK 100000u

struct size {
    float width, height;
};

static const struct size sizes[] = {
    { 1280, 720 }, { 1920, 1080 }, { 3840, 2160 }, { 720, 1280 },  { 1080, 1920 }, { 640, 480 },
    { 1024, 768 }, { 3440, 1440 }, { 480, 800 },   { 1280, 1280 }, { 640, 360 },
};
#define SIZE_COUNT (sizeof sizes / sizeof *sizes)

static struct scene scene;
static struct ui_batch batch;
static struct ui_memory memory;

struct bounds {
    float left, top, right, bottom;
};

/* Where a quad lies. */
static struct bounds bounds_of(uint32_t quad)
{
    const struct ui_vertex *v = &batch.vertices[quad * 4u];
    struct bounds bounds = { v[0].x, v[0].y, v[0].x, v[0].y };
    for (uint32_t i = 1; i < 4u; i++) {
        bounds.left = v[i].x < bounds.left ? v[i].x : bounds.left;
        bounds.right = v[i].x > bounds.right ? v[i].x : bounds.right;
        bounds.top = v[i].y < bounds.top ? v[i].y : bounds.top;
        bounds.bottom = v[i].y > bounds.bottom ? v[i].y : bounds.bottom;
    }
    return bounds;
}

static void set_scene(uint8_t phase, uint8_t language, uint8_t hint, float phase_s)
{
    memset(&scene, 0, sizeof scene);
    scene.tick = SETTLED_TICK + (uint32_t)(phase_s * 120.0f);
    scene.phase = phase;
    scene.language = language;
    scene.hint = hint;
    scene.phase_s = phase_s;
    scene.seconds_left = phase == PHASE_READY ? 3.0f - phase_s : 600.0f - phase_s;
    scene.best_today = 9999;
    scene.modes = (1u << CHOICE_COUNT) - 1u;
    scene.grade = 7;
    for (uint32_t i = 0; i < MODE_COUNT; i++) {
        scene.offer[i] = (struct scene_offer){ .round_s = 90, .grade = 7 };
    }
    for (uint32_t i = 0; i < POI_MAX; i++) {
        scene.poi[i].present = scene.player[i].plays = 1;
        scene.poi[i].paper_left = 0.5f;
        scene.caught[i] = 1000u + i;
        scene.player[i].foul_s = 60.0f;
    }
    scene.call_s = 60.0f;
}

/* A mode, so many players, and what the umpire has to say to each. */
static void set_match(uint8_t mode, uint32_t players, uint8_t variant)
{
    scene.mode = mode;
    scene.call = variant % (CALL_TIME + 1u);
    scene.call_s = 0.15f * (float)(variant % 11u);
    scene.paused = variant % 5u == 4u;
    for (uint32_t i = 0; i < POI_MAX; i++) {
        scene.poi[i].present = scene.player[i].plays = i < players;
        scene.poi[i].shows_stress = mode == MODE_PRACTICE;
        scene.player[i].fouls = (uint8_t)((variant + i) % (FOUL_MAX + 1u));
        scene.player[i].foul = (uint8_t)((variant + i) % FOUL_COUNT);
        scene.player[i].foul_s = 0.3f * (float)(variant % 10u);
        scene.player[i].lost = (variant + i) % 3u == 0;
        scene.player[i].out = (variant + i) % 4u == 1;
    }
}

static void lay_out(struct size size)
{
    ui_screens(&batch, &memory, &scene, size.width, size.height);
    assert_int_equal(batch.unbaked_count, 0); /* Its font has every letter that it draws. */
}

/* The curtain is outside while it is raised or lowered; lights may spill over the edge. */
static int may_leave(uint32_t quad, const struct bounds *bounds)
{
    const int curtain =
        (scene.phase == PHASE_READY || scene.phase_s < 1.0f || scene.leaderboard.shown) &&
        bounds->top < 0.0f;
    return batch.kinds[quad] == UI_GLOW || curtain;
}

static uint32_t longest; /* The most quads of any screen so far. */

static void check_inside(struct size size)
{
    longest = batch.quad_count > longest ? batch.quad_count : longest;
    assert_int_equal(batch.dropped_count, 0);
    assert_true(batch.quad_count > 0);
    for (uint32_t i = 0; i < batch.quad_count; i++) {
        const struct bounds bounds = bounds_of(i);
        if (may_leave(i, &bounds)) {
            continue;
        }
        if (bounds.left < -ROUNDING_PX || bounds.top < -ROUNDING_PX ||
            bounds.right > size.width + ROUNDING_PX || bounds.bottom > size.height + ROUNDING_PX) {
            fail_msg("phase %d language %d hint %d at %.2f s on %gx%g: quad %u of kind %d is at "
                     "%.1f,%.1f .. %.1f,%.1f",
                     scene.phase, scene.language, scene.hint, (double)scene.phase_s,
                     (double)size.width, (double)size.height, i, batch.kinds[i],
                     (double)bounds.left, (double)bounds.top, (double)bounds.right,
                     (double)bounds.bottom);
        }
    }
}

static void test_nothing_leaves_the_screen_in_any_phase_language_size_or_moment(void **state)
{
    (void)state;
    static const float moments_s[] = {
        0.0f, 0.1f, 0.5f, 0.9f, 1.3f, 1.7f, 2.6f, 2.99f, 8.0f, 55.0f
    };
    for (uint32_t k = 0; k < SIZE_COUNT * (PHASE_RESULT + 1u); k++) {
        const uint8_t phase = (uint8_t)(k / SIZE_COUNT);
        for (uint8_t language = 0; language < LANGUAGE_COUNT; language++) {
            for (uint8_t hint = 0; hint < HINT_COUNT; hint++) {
                for (size_t m = 0; m < sizeof moments_s / sizeof *moments_s; m++) {
                    set_scene(phase, language, hint, moments_s[m]);
                    memory = (struct ui_memory){ 0 };
                    lay_out(sizes[k % SIZE_COUNT]);
                    check_inside(sizes[k % SIZE_COUNT]);
                }
            }
        }
    }
}

static void test_every_mode_fits_with_one_to_four_players_and_all_that_is_called(void **state)
{
    (void)state;
    static const uint8_t phases[] = { PHASE_MODE_SELECT, PHASE_READY, PHASE_ROUND, PHASE_RESULT };
    static const float moments_s[] = { 0.4f, 2.0f, 597.3f };
    memory = (struct ui_memory){ 0 };
    for (uint32_t k = 0; k < SIZE_COUNT * 4u * MODE_COUNT * POI_MAX; k++) {
        const struct size size = sizes[k % SIZE_COUNT];
        const uint8_t phase = phases[k / SIZE_COUNT % 4u];
        const uint8_t mode = (uint8_t)(k / (SIZE_COUNT * 4u) % MODE_COUNT);
        for (uint8_t variant = 0; variant < 60u; variant++) {
            set_scene(phase, variant % LANGUAGE_COUNT, variant % HINT_COUNT,
                      moments_s[variant / 2u % 3u]);
            set_match(mode, (uint32_t)(k / (SIZE_COUNT * 4u * MODE_COUNT)) + 1u, variant);
            lay_out(size);
            check_inside(size);
        }
    }
}

static void test_every_count_of_fish_fits(void **state)
{
    (void)state;
    static const uint32_t counts[] = { 0, 1, 3, 6, 10, 15, 128, 4294967295u };
    for (size_t i = 0; i < sizeof counts / sizeof *counts; i++) {
        for (uint8_t language = 0; language < LANGUAGE_COUNT; language++) {
            for (uint8_t phase = PHASE_ATTRACT; phase <= PHASE_RESULT; phase++) {
                for (size_t s = 0; s < SIZE_COUNT; s++) {
                    set_scene(phase, language, HINT_START, 5.0f);
                    for (uint8_t players = 1; players <= POI_MAX; players++) {
                        set_match(MODE_CHAMPIONSHIP, players, 0);
                        scene.caught[0] = scene.best_today = counts[i];
                        lay_out(sizes[s]);
                        check_inside(sizes[s]);
                    }
                }
            }
        }
    }
}

static void test_what_is_paid_and_what_is_wrong_fits_in_every_phase(void **state)
{
    (void)state;
    static const uint8_t phases[] = { PHASE_ATTRACT, PHASE_MODE_SELECT, PHASE_READY,
                                      PHASE_ROUND,   PHASE_RESULT,      PHASE_ALBUM };
    static const uint32_t counts[] = { 0, 1, 99, 4294967295u };
    for (uint32_t k = 0; k < SIZE_COUNT * 6u * 4u * 8u * LANGUAGE_COUNT; k++) {
        const struct size size = sizes[k % SIZE_COUNT];
        const uint32_t count = counts[k / (SIZE_COUNT * 6u) % 4u];
        set_scene(phases[k / SIZE_COUNT % 6u], (uint8_t)(k % LANGUAGE_COUNT), HINT_COIN, 6.0f);
        scene.credit = (struct scene_credit){
            .price = 20,
            .unpaid = count == 0,
            .warnings = (uint8_t)(k / (SIZE_COUNT * 24u) % 8u),
            .came_back = (uint8_t)(k / 5u % 2u),
            .units = k % 20u,
            .coming = count / 2u,
            .credits = count,
            .coin_s = 0.1f * (float)(k % 7u),
            .asked_s = 0.1f * (float)(k % 13u),
        };
        lay_out(size);
        check_inside(size);
    }
}

static uint32_t glyph_quads(void);

static void test_each_warning_is_a_line_and_nothing_of_money_is_said_in_free_play(void **state)
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
    assert_true(glyph_quads() > free_play + 6u); /* "Credits 0" */
}

/* Over "coins are not taken just now" no ribbon calls for one; whoever has paid may still begin. */
static void test_while_coins_come_back_none_is_asked_for(void **state)
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
            scene.credit.asked_s = 1e6f;
            scene.credit.warnings = why[k / sizeof phases];
            lay_out(sizes[0]);
            letters[unpaid] = glyph_quads();
        }
        assert_true(letters[1] + 10u < letters[0]);
    }
}

/* Without a poi the slot is shut as well: a result's foot does not ask for what comes back. */
static void test_without_a_poi_no_hint_calls_for_a_coin(void **state)
{
    static const uint8_t with[] = { 0, WARN_STORE, WARN_DOOR, WARN_TILT };
    (void)state;
    for (uint32_t k = 0; k < sizeof with; k++) {
        uint32_t letters[2];
        for (uint32_t asks = 0; asks < 2u; asks++) {
            set_scene(PHASE_RESULT, LANGUAGE_EN, asks ? HINT_COIN : HINT_NONE, 6.0f);
            scene.credit.price = 1;
            scene.credit.unpaid = 1;
            scene.credit.asked_s = 1e6f;
            scene.credit.warnings = (uint8_t)(WARN_NO_POI | with[k]);
            lay_out(sizes[0]);
            scene.tick += CORE_TICK_HZ; /* A new hint fades in. */
            lay_out(sizes[0]);
            letters[asks] = glyph_quads();
        }
        assert_int_equal(letters[1], letters[0]);
    }
}

static void test_without_a_poi_nobody_is_told_to_dip_one_or_to_move_a_mouse(void **state)
{
    (void)state;
    for (uint8_t unpaid = 0; unpaid < 2u; unpaid++) {
        set_scene(PHASE_ATTRACT, LANGUAGE_EN, HINT_START, 6.0f);
        scene.credit.unpaid = unpaid;
        scene.credit.asked_s = 1e6f;
        scene.credit.warnings = WARN_DOOR;
        lay_out(sizes[0]);
        const uint32_t with = glyph_quads();
        scene.credit.warnings = WARN_NO_POI;
        lay_out(sizes[0]);
        assert_true(glyph_quads() + 40u < with); /* The mouse's line has more. */
    }
    static struct ui_vertex paid[sizeof batch.vertices / sizeof *batch.vertices];
    lay_out(sizes[0]);
    const uint32_t quads = batch.quad_count;
    memcpy(paid, batch.vertices, sizeof paid);
    scene.credit.unpaid = 0; /* Whoever paid or not: the slot is locked, no coin is asked for. */
    lay_out(sizes[0]);
    assert_int_equal(batch.quad_count, quads);
    assert_memory_equal(batch.vertices, paid, 4u * quads * sizeof *paid);
}

static void test_a_credit_that_is_paid_in_part_is_seen_beside_those_that_are_whole(void **state)
{
    (void)state;
    for (uint8_t language = 0; language < LANGUAGE_COUNT; language++) {
        set_scene(PHASE_ATTRACT, language, HINT_START, 6.0f);
        scene.credit = (struct scene_credit){ .price = 3, .credits = 1, .coin_s = 6.0f };
        lay_out(sizes[0]);
        const uint32_t whole = glyph_quads();
        scene.credit.units = 2;
        lay_out(sizes[0]);
        assert_int_equal(glyph_quads(), whole + 4u); /* "+ 2/3" */
        scene.credit.units = 3; /* They wait: there are as many credits as there may be. */
        lay_out(sizes[0]);
        assert_int_equal(glyph_quads(), whole);
    }
}

/* Neither figure, nor praise, nor place, nor seal: the card is the same whatever was caught. */
static void test_a_round_that_was_given_back_is_told_without_a_count(void **state)
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

static void test_the_tanks_middle_is_free_while_a_round_is_played(void **state)
{
    (void)state;
    for (size_t s = 0; s < SIZE_COUNT; s++) {
        for (uint8_t hint = 0; hint < HINT_COUNT; hint++) {
            set_scene(PHASE_ROUND, hint % LANGUAGE_COUNT, hint, 20.0f);
            lay_out(sizes[s]);
            for (uint32_t i = 0; i < batch.quad_count; i++) {
                const struct bounds bounds = bounds_of(i);
                const int apart =
                    bounds.right < 0.22f * sizes[s].width || bounds.left > 0.78f * sizes[s].width ||
                    bounds.bottom < 0.20f * sizes[s].height || bounds.top > 0.84f * sizes[s].height;
                assert_true(apart);
            }
        }
    }
}

/* A letter of 3 % of a 40 cm high screen is 12 mm: 20 minutes of arc from 2 m. */
static void test_what_a_player_must_read_is_readable_from_two_metres(void **state)
{
    (void)state;
    static const uint8_t phases[] = { PHASE_MODE_SELECT, PHASE_READY, PHASE_ROUND, PHASE_RESULT };
    for (uint32_t k = 0; k < 4u * MODE_COUNT * POI_MAX; k++) {
        for (uint8_t hint = 0; hint < HINT_COUNT * LANGUAGE_COUNT; hint++) {
            set_scene(phases[k % 4u], hint % LANGUAGE_COUNT, hint / LANGUAGE_COUNT, 2.0f);
            set_match((uint8_t)(k / 4u % MODE_COUNT), k / (4u * MODE_COUNT) + 1u, hint);
            scene.caught[0] = 12;
            memory = (struct ui_memory){ .hint = scene.hint };
            lay_out((struct size){ 1280, 720 });
            for (uint32_t i = 0; i < batch.quad_count; i++) {
                if (batch.kinds[i] == UI_GLYPH && glyph_em_px(&batch, i) < 0.03f * 720.0f) {
                    fail_msg("phase %d mode %d language %d hint %d: letter %u is %.1f px",
                             scene.phase, scene.mode, scene.language, scene.hint, i,
                             (double)glyph_em_px(&batch, i));
                }
            }
        }
    }
}

static uint32_t glyph_quads(void)
{
    uint32_t count = 0;
    for (uint32_t i = 0; i < batch.quad_count; i++) {
        count += batch.kinds[i] == UI_GLYPH;
    }
    return count;
}

static void test_no_hint_means_no_ribbon(void **state)
{
    (void)state;
    set_scene(PHASE_ROUND, LANGUAGE_EN, HINT_DIP, 20.0f);
    memory = (struct ui_memory){ .hint = HINT_DIP };
    lay_out(sizes[0]);
    const uint32_t with = glyph_quads();
    set_scene(PHASE_ROUND, LANGUAGE_EN, HINT_NONE, 20.0f);
    lay_out(sizes[0]);
    assert_true(glyph_quads() < with);
    set_scene(PHASE_ROUND, LANGUAGE_EN, HINT_COUNT, 20.0f); /* Newer core, older words. */
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
    set_scene(PHASE_ROUND, LANGUAGE_EN, HINT_DIP, 20.0f);
    lay_out(sizes[0]);
    scene.tick += 12; /* 0.1 s */
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

static void test_whoever_is_ranked_earns_the_seal(void **state)
{
    (void)state;
    for (uint8_t place = 0; place <= 10; place++) {
        for (uint8_t period = 0; period < RANK_PERIOD_COUNT; period++) {
            set_scene(PHASE_RESULT, LANGUAGE_EN, HINT_NONE, 4.0f);
            set_match(MODE_FESTIVAL, 1, 0);
            scene.player[0].place = place;
            scene.player[0].period = period;
            lay_out(sizes[0]);
            assert_int_equal(seals(), place > 0 ? 2 : 1); /* The card is one. */
        }
    }
}

static void test_the_one_of_several_who_is_ranked_earns_the_seal(void **state)
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

static uint32_t quads_of(enum ui_kind kind)
{
    uint32_t count = 0;
    for (uint32_t i = 0; i < batch.quad_count; i++) {
        count += batch.kinds[i] == kind;
    }
    return count;
}

static void test_a_tag_hangs_for_each_mode_offered_and_the_one_pointed_at_hangs_higher(void **state)
{
    (void)state;
    for (uint8_t modes = 1; modes < 1u << CHOICE_COUNT; modes++) {
        set_scene(PHASE_MODE_SELECT, LANGUAGE_JA, HINT_CHOOSE, 3.0f);
        scene.modes = modes;
        scene.choice = 0;
        while ((modes >> scene.choice & 1u) == 0) {
            scene.choice++;
        }
        scene.mode = scene.choice < MODE_COUNT ? scene.choice : MODE_FESTIVAL;
        lay_out(sizes[0]);
        scene.tick += 60; /* It is drawn up meanwhile. */
        lay_out(sizes[0]);
        const uint32_t offered =
            (modes & 1u) + (modes >> 1 & 1u) + (modes >> 2 & 1u) + (modes >> 3);
        assert_int_equal(quads_of(UI_WOOD), offered);
        float first_top = 0.0f, other_top = 1e9f;
        for (uint32_t i = 0; i < batch.quad_count; i++) {
            const float top = bounds_of(i).top;
            if (batch.kinds[i] == UI_WOOD && first_top == 0.0f) {
                first_top = top; /* The lowest mode that is offered: the one pointed at. */
            } else if (batch.kinds[i] == UI_WOOD) {
                other_top = top < other_top ? top : other_top;
            }
        }
        assert_true(first_top < other_top - 10.0f);
    }
}

static int overlap(const struct bounds *a, const struct bounds *b)
{
    return a->left < b->right && b->left < a->right && a->top < b->bottom && b->top < a->bottom;
}

static void test_no_plate_lies_on_another_while_a_round_is_played(void **state)
{
    (void)state;
    for (uint32_t k = 0; k < SIZE_COUNT * MODE_COUNT * POI_MAX * LANGUAGE_COUNT; k++) {
        const struct size size = sizes[k % SIZE_COUNT];
        set_scene(PHASE_ROUND, k / SIZE_COUNT % LANGUAGE_COUNT, HINT_NONE, 20.0f);
        set_match((uint8_t)(k / (SIZE_COUNT * LANGUAGE_COUNT) % MODE_COUNT),
                  (uint32_t)(k / (SIZE_COUNT * LANGUAGE_COUNT * MODE_COUNT)) + 1u, 0);
        lay_out(size);
        for (uint32_t i = 0; i < batch.quad_count; i++) {
            for (uint32_t j = 0; j < i && batch.kinds[i] == UI_WAVES; j++) {
                const struct bounds a = bounds_of(i), b = bounds_of(j);
                assert_false(batch.kinds[j] == UI_WAVES && overlap(&a, &b));
            }
        }
    }
}

/* The top of the `nth` wooden tag. */
static float tag_top(uint32_t nth)
{
    for (uint32_t i = 0; i < batch.quad_count; i++) {
        if (batch.kinds[i] == UI_WOOD && nth-- == 0) {
            return bounds_of(i).top;
        }
    }
    fail_msg("no such tag");
    return 0.0f;
}

static void test_as_one_tag_rises_the_last_one_sinks(void **state)
{
    (void)state;
    set_scene(PHASE_MODE_SELECT, LANGUAGE_JA, HINT_CHOOSE, 3.0f);
    memory = (struct ui_memory){ 0 };
    lay_out(sizes[0]);
    const float high = tag_top(0), low = tag_top(1);
    assert_true(high < low - 10.0f);
    scene.mode = scene.choice = MODE_CHAMPIONSHIP;
    lay_out(sizes[0]);
    assert_float_equal(tag_top(0), high, 0.1f); /* No jump. */
    scene.tick += 10;
    lay_out(sizes[0]);
    assert_true(tag_top(0) > high + 1.0f && tag_top(0) < low - 1.0f);
    assert_true(tag_top(1) > high + 1.0f && tag_top(1) < low - 1.0f);
    scene.tick += 30;
    lay_out(sizes[0]);
    assert_float_equal(tag_top(0), low, 0.1f);
    assert_float_equal(tag_top(1), high, 0.1f);
}

#define LINES_MAX 128u

/* A line of letters: those that follow one another in the batch, in one size, to the right. */
struct line {
    struct bounds bounds;
    float size;
};

static uint32_t gather_lines(struct line lines[LINES_MAX])
{
    uint32_t count = 0;
    for (uint32_t i = 0; i < batch.quad_count; i++) {
        if (batch.kinds[i] != UI_GLYPH) {
            continue;
        }
        const struct bounds next = bounds_of(i);
        const float size = batch.vertices[i * 4u].shape[3];
        struct line *last = count > 0 ? &lines[count - 1u] : NULL;
        const float middle = 0.5f * (next.top + next.bottom);
        if (last != NULL && batch.kinds[i - 1u] == UI_GLYPH && last->size == size &&
            next.right > last->bounds.right && middle > last->bounds.top - 4.0f &&
            middle < last->bounds.bottom + 4.0f) {
            last->bounds.right = next.right;
            last->bounds.top = next.top < last->bounds.top ? next.top : last->bounds.top;
            last->bounds.bottom =
                next.bottom > last->bounds.bottom ? next.bottom : last->bounds.bottom;
        } else {
            assert_true(count < LINES_MAX);
            lines[count++] = (struct line){ next, size };
        }
    }
    return count;
}

static float area(const struct bounds *bounds)
{
    const float width = bounds->right - bounds->left, height = bounds->bottom - bounds->top;
    return width > 0.0f && height > 0.0f ? width * height : 0.0f;
}

/* What two lines share, of the smaller one; 0 for a line and its own outline. */
static float shared(const struct line *a, const struct line *b)
{
    const struct bounds both = {
        a->bounds.left > b->bounds.left ? a->bounds.left : b->bounds.left,
        a->bounds.top > b->bounds.top ? a->bounds.top : b->bounds.top,
        a->bounds.right < b->bounds.right ? a->bounds.right : b->bounds.right,
        a->bounds.bottom < b->bounds.bottom ? a->bounds.bottom : b->bounds.bottom,
    };
    const float area_a = area(&a->bounds), area_b = area(&b->bounds);
    const float smaller = area_a < area_b ? area_a : area_b;
    const float larger = area_a < area_b ? area_b : area_a;
    const int same = a->size == b->size && area(&both) > 0.98f * smaller && larger < 3.0f * smaller;
    return same || smaller <= 0.0f ? 0.0f : area(&both) / smaller;
}

static void check_no_line_on_another(struct size size)
{
    static struct line lines[LINES_MAX];
    const uint32_t count = gather_lines(lines);
    for (uint32_t i = 0; i < count; i++) {
        for (uint32_t j = 0; j < i; j++) {
            if (shared(&lines[i], &lines[j]) > 0.10f) {
                fail_msg("phase %d mode %d language %d on %gx%g: letters at %.0f,%.0f .. %.0f,%.0f "
                         "lie on those at %.0f,%.0f .. %.0f,%.0f",
                         scene.phase, scene.mode, scene.language, (double)size.width,
                         (double)size.height, (double)lines[i].bounds.left,
                         (double)lines[i].bounds.top, (double)lines[i].bounds.right,
                         (double)lines[i].bounds.bottom, (double)lines[j].bounds.left,
                         (double)lines[j].bounds.top, (double)lines[j].bounds.right,
                         (double)lines[j].bounds.bottom);
            }
        }
    }
}

static void test_no_words_lie_on_others_on_any_screen_at_rest(void **state)
{
    (void)state;
    static const uint8_t phases[] = { PHASE_ATTRACT, PHASE_MODE_SELECT, PHASE_READY, PHASE_ROUND,
                                      PHASE_RESULT };
    for (uint32_t k = 0; k < SIZE_COUNT * 5u * MODE_COUNT * POI_MAX * LANGUAGE_COUNT; k++) {
        const struct size size = sizes[k % SIZE_COUNT];
        uint32_t rest = (uint32_t)(k / SIZE_COUNT);
        const uint8_t phase = phases[rest % 5u];
        rest /= 5u;
        set_scene(phase, (uint8_t)(rest % LANGUAGE_COUNT), HINT_START,
                  phase == PHASE_READY ? 1.3f : 8.0f);
        rest /= LANGUAGE_COUNT;
        set_match((uint8_t)(rest % MODE_COUNT), rest / MODE_COUNT + 1u, 0);
        for (uint32_t i = 0; i < POI_MAX; i++) {
            scene.caught[i] = 107u - i; /* The record. */
            scene.player[i].foul_s = 60.0f;
        }
        scene.player[0].place = 1;
        memory = (struct ui_memory){ 0 };
        lay_out(size);
        check_no_line_on_another(size);
    }
}

/* The longest name, the largest catch, and a place in every row. */
static void hang_board(uint8_t period, uint32_t rows, float shown_s, float left_s)
{
    scene.leaderboard = (struct scene_leaderboard){ .shown = 1,
                                                    .mode = MODE_CHAMPIONSHIP,
                                                    .period = period,
                                                    .shown_s = shown_s,
                                                    .left_s = left_s };
    for (uint32_t i = 0; i < rows; i++) {
        struct scene_row *row = &scene.leaderboard.row[i];
        row->caught = 9999;
        row->seat = (uint8_t)(i % POI_MAX);
        row->is_new = i % 2u == 0;
        row->is_sealed = i % 3u == 0;
        memcpy(row->name, "ゑゑゑゑゑゑゑゑゑゑ", 30);
    }
}

static void test_no_board_leaves_the_screen(void **state)
{
    (void)state;
    static const float moments_s[] = { 0.0f, 0.1f, 0.4f, 0.9f, 4.0f, 8.7f, 9.0f };
    for (uint32_t k = 0; k < SIZE_COUNT * LANGUAGE_COUNT * RANK_PERIOD_COUNT * 7u * 3u; k++) {
        uint32_t rest = (uint32_t)(k / SIZE_COUNT);
        const uint8_t language = (uint8_t)(rest % LANGUAGE_COUNT);
        rest /= LANGUAGE_COUNT;
        const uint8_t period = (uint8_t)(rest % RANK_PERIOD_COUNT);
        rest /= RANK_PERIOD_COUNT;
        const float moment_s = moments_s[rest % 7u];
        set_scene(rest / 7u == 0 ? PHASE_LEADERBOARD : PHASE_ATTRACT, language, HINT_START, 20.0f);
        scene.credit = (struct scene_credit){ .price = 3, .credits = 99, .units = 1 };
        hang_board(period, rest / 7u == 1u ? 1u : SCENE_LEADERBOARD_ROWS, moment_s,
                   9.0f - moment_s);
        memory = (struct ui_memory){ 0 };
        lay_out(sizes[k % SIZE_COUNT]);
        if (moment_s > 0.2f && moment_s < 8.7f) { /* The curtain is under way before and after. */
            check_inside(sizes[k % SIZE_COUNT]);
        }
        assert_int_equal(batch.dropped_count, 0);
    }
}

static void set_name(uint8_t alphabet, uint8_t key, uint8_t letter_count, int upright)
{
    scene.player[0].place = 10;
    scene.player[0].period = RANK_EVER;
    scene.name = (struct scene_name){ .alphabet = alphabet,
                                      .key = key,
                                      .has_hand = 1,
                                      .letter_count = letter_count,
                                      .x = 60.0f,
                                      .y = 60.0f,
                                      .was_refused = letter_count == 3u,
                                      .upright = (uint8_t)upright,
                                      .presses = key % 2u };
    for (uint32_t i = 0; i < letter_count; i++) {
        scene.name.letter[i] = 0x3091;
    }
}

static void test_writing_a_name_leaves_no_screen(void **state)
{
    (void)state;
    for (uint32_t k = 0; k < SIZE_COUNT * LANGUAGE_COUNT * ALPHABET_COUNT * NAME_KEY_COUNT; k++) {
        const struct size size = sizes[k % SIZE_COUNT];
        uint32_t rest = (uint32_t)(k / SIZE_COUNT);
        set_scene(PHASE_NAME, (uint8_t)(rest % LANGUAGE_COUNT), HINT_NONE, 4.0f);
        rest /= LANGUAGE_COUNT;
        scene.seconds_left = (float)(rest % 60u);
        set_name((uint8_t)(rest % ALPHABET_COUNT), (uint8_t)(rest / ALPHABET_COUNT),
                 (uint8_t)(rest % (NAME_LETTERS_MAX + 1u)),
                 size.width / size.height < POINTER_UPRIGHT_ASPECT);
        memory = (struct ui_memory){ 0 };
        lay_out(size);
        check_inside(size);
    }
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

static void test_each_foul_lights_a_lamp_where_fouls_are_called(void **state)
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

static void test_a_call_is_seen_once_and_leaves_the_water_free(void **state)
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
        scene.seconds_left -= call == CALL_COUNTDOWN ? 0.48f : 0.0f; /* Each digit goes, too. */
        lay_out(sizes[0]);
        assert_int_equal(glyph_quads(), without);
    }
}

static void test_a_pause_is_told_over_the_water(void **state)
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

/* After the tests that lay out everything there is. */
static void test_the_longest_screen_leaves_room_for_a_language_with_longer_words(void **state)
{
    (void)state;
    print_message("the longest screen has %u quads of %u\n", longest, UI_QUADS_MAX);
    assert_in_range(longest, 200, UI_QUADS_MAX * 2u / 3u);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_nothing_leaves_the_screen_in_any_phase_language_size_or_moment),
        cmocka_unit_test(test_every_mode_fits_with_one_to_four_players_and_all_that_is_called),
        cmocka_unit_test(test_every_count_of_fish_fits),
        cmocka_unit_test(test_what_is_paid_and_what_is_wrong_fits_in_every_phase),
        cmocka_unit_test(test_a_round_that_was_given_back_is_told_without_a_count),
        cmocka_unit_test(test_while_coins_come_back_none_is_asked_for),
        cmocka_unit_test(test_without_a_poi_no_hint_calls_for_a_coin),
        cmocka_unit_test(test_without_a_poi_nobody_is_told_to_dip_one_or_to_move_a_mouse),
        cmocka_unit_test(test_a_credit_that_is_paid_in_part_is_seen_beside_those_that_are_whole),
        cmocka_unit_test(test_each_warning_is_a_line_and_nothing_of_money_is_said_in_free_play),
        cmocka_unit_test(test_the_tanks_middle_is_free_while_a_round_is_played),
        cmocka_unit_test(test_what_a_player_must_read_is_readable_from_two_metres),
        cmocka_unit_test(test_no_hint_means_no_ribbon),
        cmocka_unit_test(test_a_new_hint_fades_in),
        cmocka_unit_test(test_no_board_leaves_the_screen),
        cmocka_unit_test(test_writing_a_name_leaves_no_screen),
        cmocka_unit_test(test_whoever_is_ranked_earns_the_seal),
        cmocka_unit_test(test_the_one_of_several_who_is_ranked_earns_the_seal),
        cmocka_unit_test(
            test_a_tag_hangs_for_each_mode_offered_and_the_one_pointed_at_hangs_higher),
        cmocka_unit_test(test_as_one_tag_rises_the_last_one_sinks),
        cmocka_unit_test(test_no_plate_lies_on_another_while_a_round_is_played),
        cmocka_unit_test(test_no_words_lie_on_others_on_any_screen_at_rest),
        cmocka_unit_test(test_each_foul_lights_a_lamp_where_fouls_are_called),
        cmocka_unit_test(test_a_call_is_seen_once_and_leaves_the_water_free),
        cmocka_unit_test(test_a_pause_is_told_over_the_water),
        cmocka_unit_test(test_the_longest_screen_leaves_room_for_a_language_with_longer_words),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
