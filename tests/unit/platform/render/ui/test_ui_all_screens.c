/* test_ui_all_screens.c -- Tests the texts of every screen that the gallery draws: each screen for
 * players, each page of the operator's menu, the growth lab and the album (tests/golden/screens.h).
 * Each screen is laid out in both languages, in the four sizes of the gallery and with each value
 * of SET_TEXT. */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "core/game/menu/menu_pages.h"
#include "platform/render/ui/ui_screens.h"
#include "tests/golden/screens.h"
#include "tests/unit/support/glyphs.h"

#define TEXT_SIZES 3u /* Number of values of SET_TEXT. */

/* Size of a screen in pixels. `far_arcmin` is the smallest angle in arc minutes of the capitals of
 * a text for players, seen from 3 m on a screen of 32 inches (assets/ACCESSIBILITY.md). */
static const struct size {
    float width, height, far_arcmin;
} sizes[] = { { 1280, 720, 9.8f }, { 1920, 1080, 9.8f }, { 720, 1280, 8.2f }, { 1024, 768, 9.0f } };
#define SIZE_COUNT ((uint32_t)(sizeof sizes / sizeof *sizes))

static struct scene scene;
static struct ui_batch batch;
static struct ui_memory memory;

/* A screen that was laid out, with what a message needs to name the screen. */
struct laid_out {
    struct screen screen;
    const struct size *size;
    uint32_t text_size;
};

typedef void check_screen(const struct laid_out *at);

/* Lays out the filled scene in every size of one orientation and with each value of SET_TEXT. */
static void check_sizes(check_screen *check, struct screen screen, bool upright)
{
    const struct ui_memory before = memory;
    for (uint32_t k = 0; k < SIZE_COUNT * TEXT_SIZES; k++) {
        const struct laid_out at = { screen, &sizes[k % SIZE_COUNT], k / SIZE_COUNT };
        if (upright == (at.size->height > at.size->width)) {
            memory = before;
            scene.text_size = (uint8_t)at.text_size;
            ui_screens(&batch, &memory, &scene, at.size->width, at.size->height);
            check(&at);
        }
    }
}

static void check_every_screen(check_screen *check)
{
    for (uint32_t i = 0; i < screens_count(); i++) {
        for (uint32_t k = 0; k < 2u * LANGUAGE_COUNT; k++) {
            const uint8_t language = (uint8_t)(k / 2u);
            const bool upright = k % 2u != 0;
            check_sizes(check, screens_fill(i, language, upright, &scene, &memory), upright);
        }
    }
}

static void fail_at(const struct laid_out *at, uint32_t quad, const char *what, float value)
{
    float box[4];
    glyph_box(&batch, quad, box);
    fail_msg("%s, language %d, %gx%g, text %u: the letter at %.0f,%.0f %s %.2f", at->screen.name,
             scene.language, (double)at->size->width, (double)at->size->height, at->text_size,
             (double)box[0], (double)box[1], what, (double)value);
}

/* ---- Completeness ---------------------------------------------------------------------------- */

static uint32_t phases, pages, playbacks; /* Bit masks of the drawn screens. */

static void note_screen(const struct laid_out *at)
{
    (void)at;
    phases |= 1u << scene.phase;
    pages |= scene.phase == PHASE_MENU ? 1u << scene.menu.page : 0u;
    playbacks |= 1u << scene.playback;
    assert_int_equal(batch.unbaked_count, 0);
    assert_int_equal(batch.dropped_count, 0);
}

static void test_the_list_has_every_phase_and_page_and_no_letter_is_missing(void **state)
{
    (void)state;
    check_every_screen(note_screen);
    /* A wordless screen draws nothing. The test card has no text. */
    const uint32_t all_phases = (1u << (PHASE_LEADERBOARD + 1u)) - 1u;
    assert_int_equal(phases, all_phases & ~(1u << PHASE_WORDLESS));
    assert_int_equal(pages, ((1u << MENU_PAGE_COUNT) - 1u) & ~(1u << MENU_CARD));
    assert_int_equal(playbacks, (1u << PLAYBACK_COUNT) - 1u);
}

/* ---- Size of letters ------------------------------------------------------------------------- */

#define DIAGONAL_M 0.8128f /* Diagonal of a screen of 32 inches. */
#define CAPITAL_EM 0.71f   /* Height of a capital letter in ems. */
#define FAR_M 3.0f         /* Distance of players. */
#define NEAR_M 1.0f        /* Distance of a person who operates the growth lab or the menu. */
#define NEAR_ARCMIN 16.5f  /* Smallest angle of capitals of the growth lab and the menu. */

static float smallest_arcmin[SIZE_COUNT][2]; /* Of the texts for players and of the other texts. */

static void check_size_of_letters(const struct laid_out *at)
{
    const struct size *const size = at->size;
    const bool is_near = at->screen.kind == SCREEN_LAB || at->screen.kind == SCREEN_MENU;
    const float metres_per_px = DIAGONAL_M / hypotf(size->width, size->height);
    const float least = is_near ? NEAR_ARCMIN : size->far_arcmin;
    float *const smallest = &smallest_arcmin[size - sizes][is_near];
    for (uint32_t i = 0; i < batch.quad_count; i++) {
        /* The two lowest lines of attract mode describe the keys of a desktop computer, whose
         * player sits at the screen. */
        const bool is_desktop_line =
            scene.phase == PHASE_ATTRACT && batch.vertices[i * 4u].y > 0.9f * size->height;
        if (batch.kinds[i] != UI_GLYPH || is_desktop_line) {
            continue;
        }
        const float capital_m = CAPITAL_EM * glyph_em_px(&batch, i) * metres_per_px;
        const float arcmin = capital_m / (is_near ? NEAR_M : FAR_M) * 60.0f * 57.29578f;
        *smallest = *smallest == 0.0f ? arcmin : fminf(*smallest, arcmin);
        if (arcmin < least) {
            fail_at(at, i, "has an angle in arc minutes of", arcmin);
        }
    }
}

static void test_every_text_is_readable_from_its_distance(void **state)
{
    (void)state;
    check_every_screen(check_size_of_letters);
    for (uint32_t i = 0; i < SIZE_COUNT; i++) {
        print_message(
            "%gx%g: the smallest capitals are %.1f arc minutes from 3 m, and %.1f from 1 m "
            "in the menu and the growth lab\n",
            (double)sizes[i].width, (double)sizes[i].height, (double)smallest_arcmin[i][0],
            (double)smallest_arcmin[i][1]);
    }
}

/* ---- Overlap and overflow -------------------------------------------------------------------- */

static void check_no_letter_on_another(const struct laid_out *at)
{
    float share = 0.0f;
    const uint32_t quad = glyph_find_covered(&batch, &share);
    if (quad < batch.quad_count) {
        fail_at(at, quad, "is covered by another letter to a share of", share);
    }
}

static void test_no_letter_lies_on_another(void **state)
{
    (void)state;
    check_every_screen(check_no_letter_on_another);
}

/* Two texts may meet at letters that were drawn one after the other. */
static void test_a_letter_on_the_one_before_it_is_found(void **state)
{
    (void)state;
    float share = 0.0f;
    uint32_t quad = 1;
    screens_fill(0, LANGUAGE_EN, false, &scene, &memory);
    ui_screens(&batch, &memory, &scene, 1280.0f, 720.0f);
    while (quad < batch.quad_count &&
           !(glyph_is_filled(&batch, quad - 1u) && glyph_is_filled(&batch, quad))) {
        quad++;
    }
    assert_true(quad < batch.quad_count);
    memcpy(&batch.vertices[quad * 4u], &batch.vertices[(quad - 1u) * 4u],
           4u * sizeof *batch.vertices);
    assert_int_equal(glyph_find_covered(&batch, &share), quad);
}

static void check_no_letter_overflows(const struct laid_out *at)
{
    for (uint32_t i = 0; i < batch.quad_count; i++) {
        const float over = batch.kinds[i] == UI_GLYPH ? glyph_overflow_px(&batch, i) : 0.0f;
        if (over > 1.0f) {
            fail_at(at, i, "overflows its box by px:", over);
        }
    }
}

static void test_no_letter_overflows_its_box(void **state)
{
    (void)state;
    check_every_screen(check_no_letter_overflows);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_the_list_has_every_phase_and_page_and_no_letter_is_missing),
        cmocka_unit_test(test_every_text_is_readable_from_its_distance),
        cmocka_unit_test(test_no_letter_lies_on_another),
        cmocka_unit_test(test_a_letter_on_the_one_before_it_is_found),
        cmocka_unit_test(test_no_letter_overflows_its_box),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
