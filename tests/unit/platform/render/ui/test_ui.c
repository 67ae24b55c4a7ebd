/* test_ui.c -- Tests the layout of every screen without a display, by the vertices of the drawn
 * rectangles. */
#include <setjmp.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "platform/render/ui/ui_screens.h"
#include "platform/render/ui/ui_widgets.h"
#include "tests/unit/support/ui_fixture.h"

#define ROUNDING_PX 0.6f

/* Returns 1 if a quad may extend beyond the screen: a light, or the curtain while it moves. */
static bool may_leave(uint32_t quad, const struct bounds *bounds)
{
    const int curtain =
        (scene.phase == PHASE_READY || scene.phase_s < 1.0f || scene.leaderboard.shown) &&
        bounds->top < 0.0f;
    return batch.kinds[quad] == UI_GLOW || curtain;
}

static uint32_t longest; /* Number of quads of the screen that needed the most quads so far. */

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

static void test_every_screen_fits_in_any_phase_language_size_and_moment(void **state)
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
                    scene.text_size = (uint8_t)((m + hint) % 3u); /* Every value of SET_TEXT. */
                    memory = (struct ui_memory){ 0 };
                    lay_out(sizes[k % SIZE_COUNT]);
                    check_inside(sizes[k % SIZE_COUNT]);
                }
            }
        }
    }
}

static void test_every_mode_fits_with_one_to_four_players_and_every_announcement(void **state)
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

static void test_every_fish_count_fits(void **state)
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

static void test_credits_and_warnings_fit_in_every_phase(void **state)
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
            .request_s = 0.1f * (float)(k % 13u),
        };
        lay_out(size);
        check_inside(size);
    }
}

static void test_the_middle_of_the_tank_is_uncovered_during_a_round(void **state)
{
    (void)state;
    for (size_t s = 0; s < SIZE_COUNT; s++) {
        for (uint8_t hint = 0; hint < HINT_COUNT; hint++) {
            set_scene(PHASE_ROUND, hint % LANGUAGE_COUNT, hint, 20.0f);
            for (uint32_t i = 0; i < POI_MAX; i++) { /* The numbers follow the pois, which are
                                                        outside the middle here. */
                scene.poi[i].position_m.x = i % 2u == 0 ? -3.0f : 3.0f;
            }
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

/* Smallest em of a text for players, as a fraction of the height of a wide screen. Capitals are
 * 0.71 em high. On a screen of 32 inches, which is 40 cm high, they are 8.7 mm high, which is 10
 * arc minutes seen from 3 m. Letters of this size test an acuity of 6/12
 * (assets/ACCESSIBILITY.md). */
#define READABLE_EM (22.0f / 720.0f)

/* The two lowest lines of attract mode describe the keys of a desktop computer, whose player sits
 * at the screen. */
static bool is_desktop_line(uint32_t quad)
{
    return scene.phase == PHASE_ATTRACT && bounds_of(quad).top > 0.9f * 720.0f;
}

static void test_text_for_players_is_readable_from_three_metres(void **state)
{
    (void)state;
    static const uint8_t phases[] = { PHASE_ATTRACT, PHASE_MODE_SELECT, PHASE_READY, PHASE_ROUND,
                                      PHASE_RESULT };
    for (uint32_t k = 0; k < 5u * MODE_COUNT * POI_MAX; k++) {
        for (uint8_t hint = 0; hint < HINT_COUNT * LANGUAGE_COUNT; hint++) {
            set_scene(phases[k % 5u], hint % LANGUAGE_COUNT, hint / LANGUAGE_COUNT, 2.0f);
            set_match((uint8_t)(k / 5u % MODE_COUNT), k / (5u * MODE_COUNT) + 1u, hint);
            scene.caught[0] = 12;
            memory = (struct ui_memory){ .hint = scene.hint };
            lay_out((struct size){ 1280, 720 });
            for (uint32_t i = 0; i < batch.quad_count; i++) {
                if (batch.kinds[i] == UI_GLYPH && !is_desktop_line(i) &&
                    glyph_em_px(&batch, i) < READABLE_EM * 720.0f - 0.01f) {
                    fail_msg("phase %d mode %d language %d hint %d: letter %u is %.1f px",
                             scene.phase, scene.mode, scene.language, scene.hint, i,
                             (double)glyph_em_px(&batch, i));
                }
            }
        }
    }
}

static uint32_t quads_of(enum ui_kind kind)
{
    uint32_t count = 0;
    for (uint32_t i = 0; i < batch.quad_count; i++) {
        count += batch.kinds[i] == kind;
    }
    return count;
}

static void test_each_offered_mode_has_a_tag_and_the_selected_tag_is_raised(void **state)
{
    (void)state;
    for (uint8_t modes = 1; modes < 1u << CHOICE_COUNT; modes++) {
        set_scene(PHASE_MODE_SELECT, LANGUAGE_JA, HINT_CHOOSE, 3.0f);
        scene.modes = modes;
        scene.tags = (uint8_t)mode_tags_offered(modes, true);
        scene.pointed_tags = (uint8_t)(scene.tags & (0u - scene.tags)); /* The lowest set bit, which
                                                                           is the first tag. */
        scene.choice = 0;
        while ((modes >> scene.choice & 1u) == 0) {
            scene.choice++;
        }
        scene.mode = scene.choice < MODE_COUNT ? scene.choice : MODE_FESTIVAL;
        lay_out(sizes[0]);
        scene.tick += 60; /* After 60 ticks the curtain has risen. */
        lay_out(sizes[0]);
        const uint32_t offered =
            (modes & 1u) * MODE_TAG_LEVELS + (modes >> 1 & 1u) + (modes >> 2 & 1u) + (modes >> 3);
        assert_int_equal(quads_of(UI_WOOD), offered);
        float first_top = 0.0f, other_top = 1e9f;
        for (uint32_t i = 0; i < batch.quad_count; i++) {
            const float top = bounds_of(i).top;
            if (batch.kinds[i] == UI_WOOD && first_top == 0.0f) {
                first_top = top; /* The first wooden tag is that of the selected game mode. */
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

static void test_no_plates_overlap_during_a_round(void **state)
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

/* Returns the y coordinate of the top of the wooden tag with index `nth`. */
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

static void test_a_rising_tag_and_a_sinking_tag_move_together(void **state)
{
    (void)state;
    set_scene(PHASE_MODE_SELECT, LANGUAGE_JA, HINT_CHOOSE, 3.0f);
    memory = (struct ui_memory){ .pointed = 1u }; /* The first tag is selected and has already
                                                     risen. */
    lay_out(sizes[0]);
    const float high = tag_top(0), low = tag_top(1);
    assert_true(high < low - 10.0f);
    scene.pointed_tags = 2u;
    lay_out(sizes[0]);
    /* The tag of the mode that was selected before must begin to sink without a jump. */
    assert_float_equal(tag_top(0), high, 0.1f);
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

/* A line of text: consecutive glyph quads of one size, from left to right. */
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

/* Returns the overlap of two lines as a share of the smaller line. A text and its outline are two
 * lines with the same bounds, which do not count as an overlap. */
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
                fail_msg("phase %d mode %d language %d text %d on %gx%g: letters at %.0f,%.0f .. "
                         "%.0f,%.0f lie on those at %.0f,%.0f .. %.0f,%.0f",
                         scene.phase, scene.mode, scene.language, scene.text_size,
                         (double)size.width, (double)size.height, (double)lines[i].bounds.left,
                         (double)lines[i].bounds.top, (double)lines[i].bounds.right,
                         (double)lines[i].bounds.bottom, (double)lines[j].bounds.left,
                         (double)lines[j].bounds.top, (double)lines[j].bounds.right,
                         (double)lines[j].bounds.bottom);
            }
        }
    }
}

static void test_no_texts_overlap_on_any_screen_at_rest(void **state)
{
    (void)state;
    static const uint8_t phases[] = { PHASE_ATTRACT, PHASE_MODE_SELECT, PHASE_READY, PHASE_ROUND,
                                      PHASE_RESULT };
    for (uint32_t k = 0; k < SIZE_COUNT * 5u * MODE_COUNT * POI_MAX * LANGUAGE_COUNT * 3u; k++) {
        const struct size size = sizes[k % SIZE_COUNT];
        uint32_t rest = (uint32_t)(k / SIZE_COUNT);
        const uint8_t phase = phases[rest % 5u];
        rest /= 5u;
        set_scene(phase, (uint8_t)(rest % LANGUAGE_COUNT), HINT_START,
                  phase == PHASE_READY ? 1.3f : 8.0f);
        rest /= LANGUAGE_COUNT;
        set_match((uint8_t)(rest % MODE_COUNT), rest / MODE_COUNT % POI_MAX + 1u, 0);
        scene.text_size = (uint8_t)(rest / (MODE_COUNT * POI_MAX)); /* Every value of SET_TEXT. */
        for (uint32_t i = 0; i < POI_MAX; i++) {
            scene.caught[i] = 107u - i; /* The largest catch on record is 107. */
            scene.player[i].foul_s = 60.0f;
        }
        scene.player[0].place = 1;
        memory = (struct ui_memory){ 0 };
        lay_out(size);
        check_no_line_on_another(size);
    }
}

/* Sets up a leaderboard with `rows` entries, each with the longest name and the largest catch. */
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
        row->slot = (uint8_t)(i % POI_MAX);
        row->is_new = i % 2u == 0;
        row->is_sealed = i % 3u == 0;
        memcpy(row->name, "ゑゑゑゑゑゑゑゑゑゑ", 30);
    }
}

/* Returns true if a strip of the shop curtain contains the ink of the letter `quad`, or if the
 * letter is not on the curtain. */
static bool is_on_one_strip(uint32_t quad)
{
    float letter[4];
    glyph_box(&batch, quad, letter);
    const float middle = 0.5f * (letter[1] + letter[3]);
    bool is_on_curtain = false, is_on_strip = false;
    for (uint32_t i = 0; i < batch.quad_count; i++) {
        const struct bounds strip = bounds_of(i);
        if (batch.kinds[i] != UI_WAVES || middle < strip.top || middle > strip.bottom) {
            continue;
        }
        is_on_curtain |= letter[2] > strip.left && letter[0] < strip.right;
        is_on_strip |= letter[0] >= strip.left && letter[2] <= strip.right;
    }
    return !is_on_curtain || is_on_strip;
}

static void test_no_letter_of_the_title_crosses_a_slit_of_the_curtain(void **state)
{
    (void)state;
    for (size_t s = 0; s < SIZE_COUNT; s++) {
        for (uint8_t language = 0; language < LANGUAGE_COUNT; language++) {
            uint32_t strips = 0;
            set_scene(PHASE_ATTRACT, language, HINT_NONE, 5.0f);
            scene.leaderboard.shown = 0;
            lay_out(sizes[s]);
            for (uint32_t i = 0; i < batch.quad_count; i++) {
                strips += batch.kinds[i] == UI_WAVES;
                assert_true(batch.kinds[i] != UI_GLYPH || is_on_one_strip(i));
            }
            assert_true(strips >= 2u);
        }
    }
}

/* Lays out the scene, and fails if a letter extends beyond its plate, tag, paper or ribbon. */
static void check_no_letter_overflows(struct size size, const char *page, uint32_t number)
{
    memory = (struct ui_memory){ 0 };
    memcpy(memory.caught, scene.caught, sizeof memory.caught);
    lay_out(size);
    for (uint32_t i = 0; i < batch.quad_count; i++) {
        const float over = batch.kinds[i] == UI_GLYPH ? glyph_overflow_px(&batch, i) : 0.0f;
        if (over > 1.0f) {
            const struct bounds at = bounds_of(i);
            fail_msg("%s %u, language %d, %.0fx%.0f, text %d: a letter at %.0f,%.0f overflows its "
                     "box by %.1f px",
                     page, number, scene.language, (double)size.width, (double)size.height,
                     scene.text_size, (double)at.left, (double)at.top, (double)over);
        }
    }
}

static const struct size overflow_sizes[] = {
    { 1280, 720 }, { 720, 1280 }, { 1024, 768 }, { 1200, 1920 }
};

/* Letters that fly, pop or cross a plate while they move are not drawn in the still moments of
 * these tests. */
static void test_no_text_overflows_its_box(void **state)
{
    (void)state;
    static const uint8_t phases[] = { PHASE_ATTRACT, PHASE_MODE_SELECT, PHASE_READY, PHASE_ROUND,
                                      PHASE_RESULT };
    for (uint32_t k = 0; k < 5u * MODE_COUNT * POI_MAX * 4u; k++) {
        const uint8_t phase = phases[k % 5u], mode = (uint8_t)(k / 5u % MODE_COUNT);
        const uint32_t players = k / (5u * MODE_COUNT) % POI_MAX + 1u;
        for (uint8_t language = 0; language < LANGUAGE_COUNT; language++) {
            set_scene(phase, language, HINT_NONE, phase == PHASE_READY ? 1.5f : 20.0f);
            set_match(mode, players, 0);
            scene.text_size = (uint8_t)(k % 3u);
            check_no_letter_overflows(overflow_sizes[k / (5u * MODE_COUNT * POI_MAX)], "phase",
                                      phase);
        }
    }
}

static void test_no_hint_and_no_warning_overflows_its_box(void **state)
{
    (void)state;
    static const uint8_t phases[] = { PHASE_ATTRACT, PHASE_MODE_SELECT, PHASE_ROUND,
                                      PHASE_RESULT,  PHASE_NAME,        PHASE_ALBUM };
    for (uint32_t k = 0; k < 6u * 4u * LANGUAGE_COUNT * HINT_COUNT; k++) {
        const uint8_t hint = (uint8_t)(k / (6u * 4u * LANGUAGE_COUNT));
        set_scene(phases[k % 6u], (uint8_t)(k / 24u % LANGUAGE_COUNT), hint, 20.0f);
        scene.text_size = (uint8_t)(hint % 3u);
        scene.credit.price = hint % 2u;
        scene.credit.credits = 88;
        scene.credit.coming = 88;
        scene.credit.request_s = 1e6f;
        scene.credit.warnings = (uint8_t)(1u << hint % 4u);
        check_no_letter_overflows(overflow_sizes[k / 6u % 4u], "100 times the hint, plus phase",
                                  100u * hint + phases[k % 6u]);
    }
}

static void test_every_leaderboard_fits_the_screen(void **state)
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
        /* Before 0.2 s and after 8.7 s, the curtain moves and may extend beyond the screen. */
        if (moment_s > 0.2f && moment_s < 8.7f) {
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
                                      .has_pointer = 1,
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

static void test_the_name_entry_fits_every_screen(void **state)
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

/* Adds a torn paper with all its cells for each of the first `players` players. */
static void set_tears(uint32_t players, uint8_t cause, vec3 velocity_m_s)
{
    for (uint32_t i = 0; i < players; i++) {
        scene.tear[i] = (struct scene_tear){ .cause = cause,
                                             .time_s = 0.1f,
                                             .position_m = { 0.4f, -0.05f * (float)i, 0.2f },
                                             .velocity_m_s = velocity_m_s,
                                             .angles = { 0.8f * (float)i, 0.5f, -0.3f } };
        memset(scene.tear[i].load, 200, sizeof scene.tear[i].load);
    }
}

static void test_every_cause_of_a_tear_fits_the_result(void **state)
{
    (void)state;
    for (uint32_t k = 0; k < SIZE_COUNT * TEAR_CAUSE_COUNT * POI_MAX * LANGUAGE_COUNT; k++) {
        const uint8_t cause = (uint8_t)(k / SIZE_COUNT % TEAR_CAUSE_COUNT);
        const uint32_t players = (uint32_t)(k / (SIZE_COUNT * TEAR_CAUSE_COUNT)) % POI_MAX + 1u;
        set_scene(PHASE_RESULT, (uint8_t)(k % LANGUAGE_COUNT), HINT_START, (float)(k % 12u));
        set_match((uint8_t)(k % MODE_COUNT), players, 0);
        scene.caught[0] = 13;
        set_tears(players, cause, v3(0.5f * (float)(k % 3u), -0.5f, 2.0f * (float)(k % 2u)));
        lay_out(sizes[k % SIZE_COUNT]);
        check_inside(sizes[k % SIZE_COUNT]);
    }
}

/* Returns the number of quads of a result screen whose paper was torn by `cause`. */
static uint32_t result_quads(uint8_t cause, uint8_t language)
{
    set_scene(PHASE_RESULT, language, HINT_NONE, 4.0f);
    set_match(MODE_FESTIVAL, 1, 0);
    set_tears(1, cause, v3(0.0f, 0.0f, 0.0f));
    lay_out(sizes[0]);
    return batch.quad_count;
}

static void test_a_tear_adds_its_load_its_picture_and_its_words(void **state)
{
    (void)state;
    for (uint8_t language = 0; language < LANGUAGE_COUNT; language++) {
        const uint32_t whole = result_quads(TEAR_NONE, language), letters = glyph_quads();
        for (uint8_t cause = TEAR_FAST; cause < TEAR_CAUSE_COUNT; cause++) {
            assert_true(result_quads(cause, language) > whole + TEAR_CELL_COUNT);
            assert_true(glyph_quads() > letters + 10u);
        }
        /* The round was refunded, so its result must not show the tear. */
        result_quads(TEAR_SLAP, language);
        scene.credit.came_back = 1;
        lay_out(sizes[0]);
        assert_true(batch.quad_count < TEAR_CELL_COUNT);
    }
}

/* Returns the luminance, [0, 255], of the cells of a tear whose cells all have the load `load`. */
static float load_luminance(uint8_t load)
{
    set_scene(PHASE_RESULT, LANGUAGE_EN, HINT_NONE, 4.0f);
    set_match(MODE_FESTIVAL, 1, 0);
    set_tears(1, TEAR_FAST, v3(0.0f, 0.0f, 0.0f));
    memset(scene.tear[0].load, 0, sizeof scene.tear[0].load);
    lay_out(sizes[0]);
    const uint32_t before = batch.quad_count;
    memset(scene.tear[0].load, load, sizeof scene.tear[0].load);
    lay_out(sizes[0]);
    assert_int_equal(batch.quad_count, before + TEAR_CELL_COUNT);
    for (uint32_t i = 1; i < batch.quad_count; i++) {
        /* The cells are the longest run of quads with equal colours. */
        const uint8_t *fill = batch.vertices[i * 4u].fill;
        if (i + TEAR_CELL_COUNT <= batch.quad_count &&
            memcmp(fill, batch.vertices[(i + TEAR_CELL_COUNT - 1u) * 4u].fill, 4) == 0 &&
            memcmp(fill, batch.vertices[(i + TEAR_CELL_COUNT / 2u) * 4u].fill, 4) == 0) {
            return 0.2126f * fill[0] + 0.7152f * fill[1] + 0.0722f * fill[2];
        }
    }
    fail_msg("the cells of the paper were not found");
    return 0.0f;
}

/* A viewer who does not see red and green as different reads the load by its brightness. */
static void test_a_higher_load_of_the_paper_is_darker(void **state)
{
    (void)state;
    for (uint32_t load = 17; load + 34u <= 255; load += 34) {
        assert_true(load_luminance((uint8_t)(load + 34u)) < load_luminance((uint8_t)load) - 1.0f);
    }
}

static void test_a_present_swims_into_a_bowl_on_the_result(void **state)
{
    (void)state;
    for (uint32_t k = 0; k < SIZE_COUNT * POI_MAX * LANGUAGE_COUNT; k++) {
        const uint32_t players = (uint32_t)(k / SIZE_COUNT) % POI_MAX + 1u;
        for (uint32_t halves = 1; halves < 8u; halves++) {
            const float phase_s = 0.5f * (float)halves;
            uint32_t fish[2] = { 0 }, bowls = 0;
            for (uint8_t with = 0; with < 2u; with++) {
                set_scene(PHASE_RESULT, (uint8_t)(k % LANGUAGE_COUNT), HINT_START, phase_s);
                set_match(MODE_FESTIVAL, players, 0);
                scene.caught[0] = 0;
                scene.player[0].has_present = with;
                lay_out(sizes[k % SIZE_COUNT]);
                check_inside(sizes[k % SIZE_COUNT]);
                for (uint32_t i = 0; i < batch.quad_count; i++) {
                    fish[with] += batch.kinds[i] == UI_FISH;
                    bowls += with && batch.kinds[i] == UI_WATER;
                }
            }
            assert_int_equal(bowls, 1);
            assert_int_equal(fish[1] - fish[0], phase_s > 1.3f);
        }
    }
}

static void test_the_tears_of_several_players_are_shown_in_turn(void **state)
{
    (void)state;
    set_scene(PHASE_RESULT, LANGUAGE_EN, HINT_NONE, 0.0f);
    set_match(MODE_FESTIVAL, 3, 0);
    assert_int_equal(ui_torn_player(&scene), POI_MAX);
    scene.tear[0].cause = scene.tear[2].cause = TEAR_FLAT;
    scene.tear[3].cause = TEAR_FLAT; /* Player 4 does not play, so the result must not show this
                                        tear. */
    static const uint32_t shown[] = { 0, 2, 0, 2 };
    for (uint32_t i = 0; i < 4u; i++) {
        scene.phase_s = 1.0f + 3.0f * (float)i;
        assert_int_equal(ui_torn_player(&scene), shown[i]);
    }
}

/* Returns true if a quad is a paper tag whose border has the colour of player 0. */
static bool is_tag(uint32_t quad)
{
    const uint8_t *const line = batch.vertices[quad * 4u].line;
    return batch.kinds[quad] == UI_WASHI && line[0] == ui_player_colours[0] >> 24 &&
           line[1] == ((ui_player_colours[0] >> 16) & 255u) &&
           line[2] == ((ui_player_colours[0] >> 8) & 255u);
}

/* Lays out a round of `players` players in which player 0 catches a fish, and checks that no plate
 * covers the tag of the fish. */
static void check_flight(uint8_t mode, uint32_t players)
{
    bool flies = false;
    memory = (struct ui_memory){ 0 };
    for (uint32_t caught = 0; caught < 2u; caught++) {
        set_scene(PHASE_ROUND, LANGUAGE_EN, HINT_NONE, 20.0f);
        set_match(mode, players, 1);
        scene.tick += 30u * caught;
        memset(scene.caught, 0, sizeof scene.caught);
        scene.caught[0] = caught;
        lay_out(sizes[0]);
    }
    for (uint32_t i = 0; i < batch.quad_count; i++) {
        flies |= is_tag(i);
        assert_false(flies && batch.kinds[i] == UI_WAVES);
    }
    assert_true(flies);
}

static void test_tags_fly_in_front_of_all_plates(void **state)
{
    (void)state;
    check_flight(MODE_FESTIVAL, 3);
    check_flight(MODE_CHAMPIONSHIP, 1);
}

/* Lays out a round at `elapsed_ticks` after its first scene, with `caught` fish of player 0.
 * Returns the number of paper tags that fly, and writes the number that the counter shows to
 * `shown`. */
static uint32_t tags_in_round(uint32_t elapsed_ticks, uint32_t caught, uint32_t *shown)
{
    set_scene(PHASE_ROUND, LANGUAGE_EN, HINT_NONE, 20.0f);
    set_match(MODE_FESTIVAL, 1, 1);
    scene.tick += elapsed_ticks;
    scene.caught[0] = caught;
    scene.bowl[0].position_m = v3(0.3f, 0.0f, 0.1f);
    lay_out(sizes[0]);
    check_inside(sizes[0]);
    const struct ui_frame frame = { .batch = &batch, .scene = &scene, .memory = &memory };
    *shown = ui_catch_shown(&frame, 0);
    uint32_t tags = 0;
    for (uint32_t i = 0; i < batch.quad_count; i++) {
        tags += is_tag(i);
    }
    return tags;
}

static void test_tags_fly_to_the_counter_and_count_there(void **state)
{
    (void)state;
    uint32_t shown;
    memory = (struct ui_memory){ 0 };
    assert_int_equal(tags_in_round(0, 3, &shown), 0); /* No tag of the first scene flies. */
    assert_int_equal(shown, 3);
    assert_int_equal(tags_in_round(4, 5, &shown), 1);
    assert_int_equal(shown, 3);
    assert_int_equal(tags_in_round(4 + 30, 5, &shown), 2); /* The second tag follows the first. */
    assert_int_equal(tags_in_round(4 + 59, 5, &shown), 2);
    assert_int_equal(shown, 3);
    assert_int_equal(tags_in_round(4 + 60, 5, &shown), 1);
    assert_int_equal(shown, 4);
    assert_int_equal(tags_in_round(4 + 75, 5, &shown), 0);
    assert_int_equal(shown, 5);
    tags_in_round(100, 105, &shown); /* The tags of the last eight fish fly. */
    assert_int_equal(shown, 97);
    assert_int_equal(tags_in_round(20, 2, &shown), 0); /* Another round, at an earlier tick. */
    assert_int_equal(shown, 2);
}

static void test_each_handle_has_the_number_of_its_player(void **state)
{
    (void)state;
    uint32_t letters[3];
    for (uint32_t shown = 0; shown < 3u; shown++) {
        set_scene(PHASE_ROUND, LANGUAGE_EN, HINT_NONE, 20.0f);
        set_match(MODE_FESTIVAL, 3, 1);
        scene.poi[1].present = shown > 0;
        scene.poi[2].present = shown > 1;
        lay_out(sizes[0]);
        letters[shown] = glyph_quads();
    }
    assert_int_equal(letters[1] - letters[0], 1);
    assert_int_equal(letters[2] - letters[1], 1);
}

static void test_a_near_miss_is_named_beside_its_poi_for_a_moment(void **state)
{
    (void)state;
    static const float moments_s[] = { 0.0f, 0.5f, 1.39f, 1.5f };
    uint32_t letters[4];
    for (uint32_t i = 0; i < 4u; i++) {
        set_scene(PHASE_ROUND, LANGUAGE_EN, HINT_NONE, 20.0f);
        set_match(MODE_FESTIVAL, 2, 1);
        scene.player[1].miss_s = moments_s[i];
        lay_out(sizes[0]);
        check_inside(sizes[0]);
        letters[i] = glyph_quads();
    }
    /* "So close!" has eight letters, each with an outline. */
    assert_int_equal(letters[1] - letters[0], 16);
    assert_int_equal(letters[2], letters[1]);
    assert_int_equal(letters[3], letters[0]);
}

/* This test must be the last one, because `longest` is the maximum of all tests before it. */
static void test_the_largest_screen_leaves_quads_for_longer_languages(void **state)
{
    (void)state;
    print_message("the longest screen has %u quads of %u\n", longest, UI_QUADS_MAX);
    assert_in_range(longest, 200, UI_QUADS_MAX * 2u / 3u);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_every_screen_fits_in_any_phase_language_size_and_moment),
        cmocka_unit_test(test_every_mode_fits_with_one_to_four_players_and_every_announcement),
        cmocka_unit_test(test_every_fish_count_fits),
        cmocka_unit_test(test_credits_and_warnings_fit_in_every_phase),
        cmocka_unit_test(test_the_middle_of_the_tank_is_uncovered_during_a_round),
        cmocka_unit_test(test_text_for_players_is_readable_from_three_metres),
        cmocka_unit_test(test_no_letter_of_the_title_crosses_a_slit_of_the_curtain),
        cmocka_unit_test(test_no_text_overflows_its_box),
        cmocka_unit_test(test_no_hint_and_no_warning_overflows_its_box),
        cmocka_unit_test(test_every_leaderboard_fits_the_screen),
        cmocka_unit_test(test_the_name_entry_fits_every_screen),
        cmocka_unit_test(test_each_offered_mode_has_a_tag_and_the_selected_tag_is_raised),
        cmocka_unit_test(test_a_rising_tag_and_a_sinking_tag_move_together),
        cmocka_unit_test(test_no_plates_overlap_during_a_round),
        cmocka_unit_test(test_no_texts_overlap_on_any_screen_at_rest),
        cmocka_unit_test(test_every_cause_of_a_tear_fits_the_result),
        cmocka_unit_test(test_a_tear_adds_its_load_its_picture_and_its_words),
        cmocka_unit_test(test_a_higher_load_of_the_paper_is_darker),
        cmocka_unit_test(test_a_present_swims_into_a_bowl_on_the_result),
        cmocka_unit_test(test_the_tears_of_several_players_are_shown_in_turn),
        cmocka_unit_test(test_tags_fly_to_the_counter_and_count_there),
        cmocka_unit_test(test_tags_fly_in_front_of_all_plates),
        cmocka_unit_test(test_each_handle_has_the_number_of_its_player),
        cmocka_unit_test(test_a_near_miss_is_named_beside_its_poi_for_a_moment),
        cmocka_unit_test(test_the_largest_screen_leaves_quads_for_longer_languages),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
