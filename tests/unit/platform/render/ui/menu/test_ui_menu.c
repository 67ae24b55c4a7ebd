/* test_ui_menu.c -- Tests how the operator's menu is drawn in both languages. Each page must fit
 * every screen and be readable from one metre. */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>
#include <unistd.h>

#include <cmocka.h>

#include "core/game/menu/menu_pages.h"
#include "platform/render/ui/menu/ui_menu.h"
#include "platform/render/ui/ui_screens.h"
#include "tests/unit/support/glyphs.h"

#define ROUNDING_PX 0.6f

static const struct {
    float width, height;
} sizes[] = {
    { 1280, 720 }, { 1920, 1080 }, { 3840, 2160 }, { 720, 1280 },  { 1080, 1920 },
    { 1024, 768 }, { 640, 360 },   { 480, 800 },   { 3440, 1440 },
};
#define SIZE_COUNT (sizeof sizes / sizeof *sizes)

static struct scene scene;
static struct ui_batch batch;
static struct ui_memory memory;

/* Fills the data about devices with the longest names and the largest values that can occur. */
static void fill_devices(struct scene_devices *devices)
{
    memset(devices->about, 'W', sizeof devices->about);
    for (uint32_t i = 0; i < ABOUT_COUNT; i++) {
        devices->about[i][SCENE_LINE_SIZE - 1u] = 0;
    }
    for (uint32_t i = 0; i < POI_MAX; i++) {
        devices->axes[i] = (struct scene_axes){ POI_SOURCE_LIVE,
                                                { -99.0f, 99.0f, NAN },
                                                { 1000.0f, -1000.0f, INFINITY },
                                                4294967295u,
                                                INFINITY };
    }
    for (uint32_t i = 0; i < CONTROLLER_MAX; i++) {
        memset(devices->controller[i], 'W', SCENE_NAME_SIZE - 1u);
    }
    memset(devices->lines, 'm', SCENE_LINE_SIZE - 1u);
    memset(devices->controllers, 'm', SCENE_LINE_SIZE - 1u);
    devices->button_faults = 4294967295u;
    memset(devices->line, 0xff, sizeof devices->line);
    for (uint32_t i = 0; i < SCENE_FILE_MAX; i++) {
        devices->file[i].state = (uint8_t)(i % FILE_STATE_COUNT);
        memset(devices->file[i].name, 'W', SCENE_FILE_SIZE - 1u);
        memset(devices->file[i].words, 'W', SCENE_LINE_SIZE - 1u);
    }
}

/* Fills the scene of a menu page so that every optional element is visible and each text and number
 * has its greatest length. */
static void set_page(uint8_t page, uint16_t tags, uint8_t language, int upright)
{
    memset(&scene, 0, sizeof scene);
    scene.tick = 1000;
    scene.phase = PHASE_MENU;
    scene.phase_s = 3.0f;
    scene.language = language;
    struct scene_menu *menu = &scene.menu;
    *menu = (struct scene_menu){ .page = page,
                                 .tags = tags,
                                 .upright = (uint8_t)upright,
                                 .row = 1,
                                 .held = 0x155u,
                                 .test_coins = 9999,
                                 .coin_s = 0.1f,
                                 .has_pointer = 1,
                                 .presses = 1,
                                 .x = 400.0f,
                                 .y = 300.0f };
    settings_reset(&menu->settings);
    menu->fish_max = 2048u;
    menu->chosen = 0;
    menu->from = MENU_HOURS;
    menu->pin = 9999;
    menu->pin_count = MENU_PIN_DIGITS;
    menu->pin_wait_s = 160.0f;
    menu->boot = 9999u;
    menu->last_id = menu->saved_id = 999999u;
    for (uint32_t i = 0; i < SCENE_AUDIT_MAX; i++) {
        /* Nine years with thirty games a day give about 99999 games. */
        menu->audit[i] = 99999u;
    }
    scene.credit = (struct scene_credit){ .price = 20, .credits = 4294967295u, .coin_s = 0.1f };
    for (uint32_t i = 0; i < CONTROLLER_MAX; i++) {
        menu->controllers.state[i] = (uint8_t)(i % CONTROLLER_STATE_COUNT);
    }
    for (uint32_t i = 0; i < INPUT_BUTTON_COUNT; i++) {
        menu->pressed_count[i] = MENU_COUNT_MAX;
    }
    menu->controllers.file_count = UINT8_MAX;
    menu->file_first = 160;
    fill_devices(&scene.devices);
}

static void lay_out(uint32_t size)
{
    memory = (struct ui_memory){ 0 };
    ui_screens(&batch, &memory, &scene, sizes[size].width, sizes[size].height);
    assert_int_equal(batch.dropped_count, 0);
    assert_int_equal(batch.unbaked_count, 0);
    assert_true(batch.quad_count > 0);
}

static void expect_inside(uint32_t size)
{
    for (uint32_t i = 0; i < batch.quad_count * 4u; i++) {
        const struct ui_vertex *v = &batch.vertices[i];
        if (batch.kinds[i / 4u] != UI_GLOW &&
            (v->x < -ROUNDING_PX || v->y < -ROUNDING_PX || v->x > sizes[size].width + ROUNDING_PX ||
             v->y > sizes[size].height + ROUNDING_PX)) {
            fail_msg("page %d step %d language %d on %gx%g: quad %u of kind %d reaches %.1f,%.1f",
                     scene.menu.page, scene.menu.controllers.learn_step, scene.language,
                     (double)sizes[size].width, (double)sizes[size].height, i / 4u,
                     batch.kinds[i / 4u], (double)v->x, (double)v->y);
        }
    }
}

static bool is_upright(uint32_t size)
{
    return sizes[size].width < POINTER_UPRIGHT_ASPECT * sizes[size].height;
}

static void test_every_menu_page_fits_the_screen(void **state)
{
    (void)state;
    for (uint32_t k = 0; k < SIZE_COUNT * MENU_PAGE_COUNT * LANGUAGE_COUNT; k++) {
        const uint32_t size = k % SIZE_COUNT;
        const uint8_t page = (uint8_t)(k / SIZE_COUNT % MENU_PAGE_COUNT);
        const uint32_t all = (1u << menu_tag_count(page, false)) - 1u;
        const uint32_t last = (all + 1u) / 2u;
        for (uint8_t step = 0; step < LEARN_STEP_COUNT; step++) {
            for (uint32_t bare = 0; bare < 2u; bare++) {
                set_page(page, (uint16_t)(bare ? last : all),
                         (uint8_t)(k / (SIZE_COUNT * MENU_PAGE_COUNT)), is_upright(size));
                scene.menu.controllers.learn_step = step;
                memset(scene.menu.audit, 0xff, sizeof scene.menu.audit);
                scene.tick += 37u * step; /* Each step is drawn at another moment of the
                                             animations. */
                lay_out(size);
                expect_inside(size);
            }
        }
    }
}

/* Every text has its greatest length, and each counter the value of nine years. */
static void test_no_letter_of_the_menu_lies_on_another(void **state)
{
    (void)state;
    for (uint32_t k = 0; k < SIZE_COUNT * MENU_PAGE_COUNT * LANGUAGE_COUNT; k++) {
        const uint32_t size = k % SIZE_COUNT;
        const uint8_t page = (uint8_t)(k / SIZE_COUNT % MENU_PAGE_COUNT);
        const uint32_t all = (1u << menu_tag_count(page, false)) - 1u;
        float share = 0.0f, box[4];
        set_page(page, (uint16_t)all, (uint8_t)(k / (SIZE_COUNT * MENU_PAGE_COUNT)),
                 is_upright(size));
        lay_out(size);
        const uint32_t quad = glyph_find_covered(&batch, &share);
        if (quad < batch.quad_count) {
            glyph_box(&batch, quad, box);
            fail_msg("page %d language %d on %gx%g: the letter at %.0f,%.0f is covered to %.2f",
                     page, scene.language, (double)sizes[size].width, (double)sizes[size].height,
                     (double)box[0], (double)box[1], (double)share);
        }
    }
}

/* A 24-inch screen is 30 cm high, so a letter of 2.4 % of this height is 7 mm high, which is 25 arc
 * minutes seen from 1 m. The device name is short, because long names are drawn smaller. The
 * letters on the test card are not text. */
static void test_every_menu_word_is_readable_from_one_metre(void **state)
{
    (void)state;
    for (uint32_t k = 0; k < MENU_PAGE_COUNT * LANGUAGE_COUNT * LEARN_STEP_COUNT; k++) {
        const uint8_t page = (uint8_t)(k % MENU_PAGE_COUNT);
        const uint32_t all = (1u << menu_tag_count(page, false)) - 1u;
        set_page(page, (uint16_t)all, (uint8_t)(k / MENU_PAGE_COUNT % LANGUAGE_COUNT), 0);
        scene.menu.controllers.learn_step = (uint8_t)(k / (MENU_PAGE_COUNT * LANGUAGE_COUNT));
        memset(&scene.devices, 0, sizeof scene.devices);
        snprintf(scene.devices.controller[1], SCENE_NAME_SIZE, "054c:09cc Wireless Controller");
        lay_out(0);
        for (uint32_t i = 0; i < batch.quad_count && page != MENU_CARD; i++) {
            if (batch.kinds[i] == UI_GLYPH && glyph_em_px(&batch, i) < 0.024f * 720.0f) {
                fail_msg("page %d step %d language %d: letter %u is %.1f px", page,
                         scene.menu.controllers.learn_step, scene.language, i,
                         (double)glyph_em_px(&batch, i));
            }
        }
    }
}

/* Draws the update page with each step, each fault and the longest name of a version. */
static void test_every_line_of_the_update_page_fits_and_is_readable(void **state)
{
    (void)state;
    for (uint32_t k = 0; k < SIZE_COUNT * LANGUAGE_COUNT * UPDATE_STEP_COUNT; k++) {
        const uint32_t size = k % SIZE_COUNT;
        for (uint8_t fault = 0; fault < UPDATE_FAULT_COUNT; fault++) {
            set_page(MENU_UPDATE, 3, (uint8_t)(k / SIZE_COUNT % LANGUAGE_COUNT), is_upright(size));
            struct scene_update *update = &scene.devices.update;
            *update = (struct scene_update){ .step = (uint8_t)(k / (SIZE_COUNT * LANGUAGE_COUNT)),
                                             .percent = fault == 0 ? 100 : fault,
                                             .fault = fault };
            memset(update->name, 'W', sizeof update->name - 1u);
            lay_out(size);
            expect_inside(size);
            snprintf(update->name, sizeof update->name, "Kingyo 0.2.0 (2026-12-01)");
            lay_out(size);
            for (uint32_t i = 0; i < batch.quad_count && size == 0; i++) {
                assert_true(batch.kinds[i] != UI_GLYPH ||
                            glyph_em_px(&batch, i) >= 0.024f * 720.0f);
            }
        }
    }
}

static uint32_t count_kind(enum ui_kind kind)
{
    uint32_t count = 0;
    for (uint32_t i = 0; i < batch.quad_count; i++) {
        count += batch.kinds[i] == kind;
    }
    return count;
}

static void test_a_board_is_drawn_for_each_present_controller(void **state)
{
    (void)state;
    uint32_t before = 0;
    for (uint32_t there = 0; there <= CONTROLLER_MAX; there++) {
        set_page(MENU_CONTROLLERS, (uint16_t)(1u << ROWS_BACK | ((1u << there) - 1u)), 0, 0);
        lay_out(0);
        const uint32_t boards = count_kind(UI_WOOD);
        /* A board is drawn behind each menu item. The additional board belongs to the item that
         * returns to the previous page. */
        assert_int_equal(boards, there + 1u);
        assert_true(there == 0 || boards > before);
        before = boards;
    }
}

static void test_the_reason_is_shown_if_no_controller_is_plugged_in(void **state)
{
    (void)state;
    set_page(MENU_CONTROLLERS, 1u << ROWS_BACK, LANGUAGE_EN, 0);
    scene.devices.controllers[0] = 0;
    lay_out(0);
    const uint32_t without = count_kind(UI_GLYPH);
    snprintf(scene.devices.controllers, SCENE_LINE_SIZE, "no libusb in this build");
    lay_out(0);
    /* The text has 19 letters. Spaces are not drawn. */
    assert_int_equal(count_kind(UI_GLYPH), without + 19u);
}

/* Sets the longest reason that a rejected file can have, with letters and spaces as in normal text.
 * Returns the number of letters. */
static uint32_t set_reason(const char *name)
{
    static const char words[] = "curve 2: knot 5: its weights sum to 1.250000; ";
    char *out = scene.devices.file[0].words;
    uint32_t letters = 0;
    for (uint32_t i = 0; i < SCENE_LINE_SIZE - 1u; i++) {
        out[i] = words[i % (sizeof words - 1u)];
        letters += out[i] != ' ';
    }
    snprintf(scene.devices.file[0].name, SCENE_FILE_SIZE, "%s", name);
    scene.devices.file[0].state = FILE_REFUSED;
    return letters;
}

static void test_the_longest_reason_is_complete_in_portrait_and_landscape(void **state)
{
    (void)state;
    for (uint32_t size = 0; size < SIZE_COUNT; size++) {
        const int upright = is_upright(size);
        const float unit = upright
                               ? sizes[size].width / 854.0f
                               : fminf(sizes[size].width / 1280.0f, sizes[size].height / 720.0f);
        set_page(MENU_FILES, 1u << FILES_BACK, LANGUAGE_EN, upright);
        memset(&scene.devices, 0, sizeof scene.devices);
        scene.menu.controllers.file_count = 2;
        scene.menu.file_first = 1;
        snprintf(scene.devices.file[0].name, SCENE_FILE_SIZE, "x");
        scene.devices.file[0].state = FILE_REFUSED;
        lay_out(size);
        const uint32_t without = count_kind(UI_GLYPH);
        const uint32_t letters = set_reason("x");
        lay_out(size);
        assert_int_equal(count_kind(UI_GLYPH), without + letters);
        expect_inside(size);
        for (uint32_t i = 0; i < batch.quad_count; i++) {
            if (batch.kinds[i] == UI_GLYPH && glyph_em_px(&batch, i) < 21.9f * unit) {
                fail_msg("on %gx%g letter %u shrank to %.1f units", (double)sizes[size].width,
                         (double)sizes[size].height, i, (double)(glyph_em_px(&batch, i) / unit));
            }
        }
    }
}

static void test_a_slip_is_drawn_for_each_existing_row(void **state)
{
    (void)state;
    for (uint32_t count = 0; count <= 2u * SCENE_FILE_MAX; count++) {
        for (int upright = 0; upright < 2; upright++) {
            const uint32_t shown = menu_files_shown(upright);
            set_page(MENU_FILES, 1u << FILES_BACK, LANGUAGE_JA, upright);
            scene.menu.controllers.file_count = (uint8_t)count;
            scene.menu.file_first = (uint8_t)(count > shown ? shown : 0u);
            const uint32_t left = count - scene.menu.file_first;
            lay_out(upright ? 4 : 0);
            assert_int_equal(count_kind(UI_WASHI), left < shown ? left : shown);
        }
    }
}

/* Returns the number of lit lamps. Each lamp shows a button or the coin slot. */
static uint32_t lit_lamps(void)
{
    uint32_t lit = 0;
    for (uint32_t i = 0; i < batch.quad_count; i++) {
        const struct ui_vertex *v = &batch.vertices[i * 4u];
        lit += batch.kinds[i] == UI_PANEL && v->fill[0] == 0xff && v->fill[1] == 0xd0;
    }
    return lit;
}

static void test_a_lamp_is_lit_for_each_pressed_button(void **state)
{
    (void)state;
    uint32_t held = 0;
    for (uint32_t i = 0; i <= INPUT_BUTTON_COUNT; i++) {
        set_page(MENU_LINES, 1u, LANGUAGE_JA, 0);
        scene.menu.coin_s = 60.0f;
        scene.menu.held = held;
        lay_out(0);
        assert_int_equal(lit_lamps(), i);
        held = held << 1 | 1u;
    }
    scene.menu.coin_s = 0.0f; /* A coin has just been inserted, so the lamp of the coin slot is lit
                                 too. */
    lay_out(0);
    assert_int_equal(lit_lamps(), INPUT_BUTTON_COUNT + 1u);
}

static uint32_t count_fill(uint8_t red, uint8_t green)
{
    uint32_t count = 0;
    for (uint32_t i = 0; i < batch.quad_count; i++) {
        const struct ui_vertex *v = &batch.vertices[i * 4u];
        count += batch.kinds[i] == UI_PANEL && v->fill[0] == red && v->fill[1] == green;
    }
    return count;
}

static void test_a_missing_gpio_line_has_a_red_slip_and_no_lamp(void **state)
{
    (void)state;
    for (uint32_t i = 0; i <= INPUT_BUTTON_COUNT; i++) {
        for (uint8_t language = 0; language < LANGUAGE_COUNT; language++) {
            set_page(MENU_LINES, 1u, language, i & 1u);
            lay_out(i & 1u ? 4 : 0);
            assert_int_equal(count_fill(0xb3, 0x26), 0);
            const uint32_t lamps = lit_lamps() + count_fill(0x3a, 0x2a);
            scene.devices.buttons_missing = 1u << i;
            lay_out(i & 1u ? 4 : 0);
            assert_int_equal(count_fill(0xb3, 0x26), 1);
            assert_int_equal(lit_lamps() + count_fill(0x3a, 0x2a), lamps - 1u);
        }
    }
}

static void test_the_state_of_the_lines_is_complete_and_readable_from_one_metre(void **state)
{
    (void)state;
    for (int upright = 0; upright < 2; upright++) {
        const float unit = upright ? 1080.0f / 854.0f : 1.0f;
        set_page(MENU_LINES, 1u, LANGUAGE_EN, upright);
        scene.devices.lines[0] = 0;
        scene.devices.button_faults = 12;
        lay_out(upright ? 4 : 0);
        const uint32_t without = count_kind(UI_GLYPH);
        snprintf(scene.devices.lines, SCENE_LINE_SIZE,
                 "libgpiod 1.6.3: 0 of 3 lines; no start, coin, start-lamp (BTN_START: there is no "
                 "GPIO chip in /dev)");
        lay_out(upright ? 4 : 0);
        /* The text has 82 letters. Spaces are not drawn. */
        assert_int_equal(count_kind(UI_GLYPH), without + 82u);
        for (uint32_t i = 0; i < batch.quad_count; i++) {
            if (batch.kinds[i] == UI_GLYPH && glyph_em_px(&batch, i) < 21.0f * unit) {
                fail_msg("letter %u is %.1f units", i, (double)(glyph_em_px(&batch, i) / unit));
            }
        }
    }
}

/* A window manager may ignore the minimum size of the window, so each page must be laid out at any
 * window size. */
static void test_every_page_is_laid_out_in_a_window_of_any_size(void **state)
{
    (void)state;
    static const float sides[] = { 1.0f, 2.0f, 8.0f, 17.0f, 240.0f, 8192.0f };
    const uint32_t count = sizeof sides / sizeof sides[0];
    alarm(30); /* Ends the test if the layout runs in an endless loop. */
    for (uint32_t k = 0; k < count * count * MENU_PAGE_COUNT; k++) {
        const float width = sides[k % count], height = sides[k / count % count];
        set_page((uint8_t)(k / (count * count)), 0xffffu, LANGUAGE_EN, width < height);
        ui_screens(&batch, &memory, &scene, width, height);
        assert_int_equal(batch.dropped_count, 0);
    }
    for (uint8_t phase = 0; phase <= PHASE_LEADERBOARD; phase++) {
        /* The page of the lab is left out, because it needs a fish and this scene has none. */
        for (uint32_t k = 0; k < count * count && phase != PHASE_LAB; k++) {
            scene.phase = phase;
            ui_screens(&batch, &memory, &scene, sides[k % count], sides[k / count]);
            assert_int_equal(batch.dropped_count, 0);
        }
    }
    alarm(0);
}

static void test_the_quit_confirmation_is_readable_over_the_tank(void **state)
{
    (void)state;
    memset(&scene, 0, sizeof scene);
    scene.phase = PHASE_ROUND;
    scene.phase_s = 20.0f;
    scene.seconds_left = 30.0f;
    lay_out(0);
    const uint32_t without = count_kind(UI_GLYPH);
    scene.is_confirming_menu = scene.is_confirming_quit = 1;
    for (uint32_t size = 0; size < SIZE_COUNT; size++) {
        lay_out(size);
        expect_inside(size);
    }
    lay_out(0);
    assert_true(count_kind(UI_GLYPH) > without + 15u);
}

/* During practice, a legend of the paper colours is shown at the right edge. The legend is 256
 * units wide, 18 units from the edge, and ends 204 units below the top. No letter of the
 * confirmation may overlap it. */
static void test_the_quit_confirmation_does_not_overlap_the_practice_plates(void **state)
{
    (void)state;
    for (uint32_t k = 0; k < SIZE_COUNT * LANGUAGE_COUNT; k++) {
        const uint32_t size = k % SIZE_COUNT;
        const float width = sizes[size].width;
        const float unit = fminf(sizes[size].height / 720.0f, width / 860.0f);
        const float left = width - 274.0f * unit, y = 0.215f * sizes[size].height;
        if (y > 240.0f * unit) {
            continue; /* On a portrait screen, the confirmation lies below the legend. */
        }
        memset(&scene, 0, sizeof scene);
        scene.phase = PHASE_ROUND;
        scene.phase_s = 20.0f;
        scene.language = (uint8_t)(k / SIZE_COUNT);
        scene.is_confirming_menu = 1;
        lay_out(size);
        for (uint32_t i = 0; i < batch.quad_count * 4u; i++) {
            const struct ui_vertex *v = &batch.vertices[i];
            if (batch.kinds[i / 4u] == UI_GLYPH && fabsf(v->y - y) < 20.0f * unit && v->x > left) {
                fail_msg("language %d on %gx%g: a letter at %.1f of %.1f", scene.language,
                         (double)width, (double)sizes[size].height, (double)v->x, (double)left);
            }
        }
    }
}

static void expect_range(uint32_t id, const char *expected)
{
    char words[TEXT_LINE_MAX];
    const struct ui_frame frame = { .language = LANGUAGE_EN, .scene = &scene };
    menu_range_words(&frame, id, words, sizeof words);
    assert_string_equal(words, expected);
}

static void test_a_setting_shows_its_range_and_unit(void **state)
{
    (void)state;
    set_page(MENU_MONEY, 0x7ffu, LANGUAGE_EN, 0);
    expect_range(SET_PLAY, "free / paid / event   default free");
    expect_range(SET_CREDIT_EXPIRY_MIN, "5 - 240 min   default never");
    expect_range(SET_NIGHT_TO_MIN, "00:00 - 23:45   default 00:00");
    expect_range(SET_GRADE, "No. 4 - 7   default the mode's own");
    expect_range(SET_OVERSCAN_X, "0.0 - 10.0 %   default 0.0 %");
    expect_range(SET_ATTRACT_SOUND, "silent / 1 - 10   default every loop");
}

static uint32_t quads_of(uint8_t page)
{
    scene.menu.page = page;
    scene.menu.tags = (uint16_t)((1u << menu_tag_count(page, false)) - 1u);
    lay_out(0);
    expect_inside(0);
    return batch.quad_count;
}

/* Each page on the path to the page of the warning shows a mark, so that the operator finds the
 * warning. */
/* Every letter of the menu must lie inside its board, slip or plate, in every size and language. */
static void test_no_text_of_the_menu_overflows_its_box(void **state)
{
    (void)state;
    for (uint32_t k = 0; k < MENU_PAGE_COUNT * LANGUAGE_COUNT * SIZE_COUNT; k++) {
        const uint8_t page = (uint8_t)(k % MENU_PAGE_COUNT);
        const uint32_t size = k / (MENU_PAGE_COUNT * LANGUAGE_COUNT);
        const uint32_t all = (1u << menu_tag_count(page, false)) - 1u;
        set_page(page, (uint16_t)all, (uint8_t)(k / MENU_PAGE_COUNT % LANGUAGE_COUNT),
                 sizes[size].width < sizes[size].height);
        lay_out(size);
        for (uint32_t i = 0; i < batch.quad_count && page != MENU_CARD; i++) {
            const float over = batch.kinds[i] == UI_GLYPH ? glyph_overflow_px(&batch, i) : 0.0f;
            if (over > 1.0f + 0.002f * sizes[size].height) {
                fail_msg("page %d language %d %gx%g: a letter at %.0f,%.0f overflows by %.1f px",
                         page, scene.language, (double)sizes[size].width,
                         (double)sizes[size].height, (double)batch.vertices[i * 4u].x,
                         (double)batch.vertices[i * 4u].y, (double)over);
            }
        }
    }
}

/* Returns the relative luminance [0, 1] of the colour 0xRRGGBBAA (WCAG 2.1). */
static double luminance(uint32_t colour)
{
    static const double weights[3] = { 0.2126, 0.7152, 0.0722 };
    double sum = 0.0;
    for (uint32_t i = 0; i < 3u; i++) {
        const double part = (double)(colour >> (24u - 8u * i) & 0xffu) / 255.0;
        sum += weights[i] * (part <= 0.04045 ? part / 12.92 : pow((part + 0.055) / 1.055, 2.4));
    }
    return sum;
}

/* Returns the contrast ratio of two colours (WCAG 2.1), from 1 to 21. */
static double contrast(uint32_t a, uint32_t b)
{
    const double x = luminance(a) + 0.05, y = luminance(b) + 0.05;
    return x > y ? x / y : y / x;
}

/* WCAG 2.1 demands a contrast ratio of 4.5 for small text (level AA). */
static void test_ink_has_contrast_to_the_wood_of_the_boards(void **state)
{
    (void)state;
    static const uint32_t inks[] = { MENU_INK, MENU_INK_SOFT, MENU_INK_CHANGED, MENU_INK_ON };
    for (uint32_t i = 0; i < sizeof inks / sizeof *inks; i++) {
        assert_true(contrast(inks[i], UI_CEDAR_DIM) >= 4.5);
        assert_true(contrast(inks[i], UI_CEDAR) >= 4.5);
    }
    assert_true(contrast(0x000000ff, 0xffffffff) > 20.9);
}

/* A pointer with paper would hide the number below the pointer. */
static void test_the_pointer_is_a_ring_without_paper(void **state)
{
    (void)state;
    uint32_t rings = 0;
    set_page(MENU_MONEY, 0x3ffu, LANGUAGE_EN, 0);
    lay_out(0);
    for (uint32_t i = 0; i < batch.quad_count; i++) {
        const struct ui_vertex *v = &batch.vertices[i * 4u];
        const float x = 0.5f * (v[0].x + v[3].x), y = 0.5f * (v[0].y + v[3].y);
        if (batch.kinds[i] == UI_POI && fabsf(x - 400.0f) < 1.0f && fabsf(y - 300.0f) < 1.0f) {
            assert_true(v->shape[1] == 0.0f);
            rings++;
        }
    }
    assert_int_equal(rings, 1);
}

static void test_an_open_warning_marks_the_path_to_its_page(void **state)
{
    static const uint8_t pages[] = { MENU_TOP, MENU_UPKEEP };
    (void)state;
    for (size_t i = 0; i < sizeof pages; i++) {
        set_page(pages[i], 0, LANGUAGE_EN, 0);
        const uint32_t bare = quads_of(pages[i]);
        scene.devices.files_refused = 1;
        /* The mark of a warning has two quads: a disc and an exclamation mark. */
        assert_int_equal(quads_of(pages[i]), bare + 2u);
        scene.devices.files_refused = 0;
        scene.devices.machine.quarantined = 1;
        assert_int_equal(quads_of(pages[i]), bare + 2u);
        scene.devices.machine.quarantined = 0;
        scene.devices.machine.missed = 1;
        assert_int_equal(quads_of(pages[i]), bare + 2u);
    }
}

/* The page of the data files must report how many scores have lost their replay. */
static void test_unstored_replays_are_shown_on_the_slip_of_the_store(void **state)
{
    (void)state;
    for (uint8_t language = 0; language < LANGUAGE_COUNT; language++) {
        set_page(MENU_FILES, 0, language, 0);
        memset(scene.devices.file, 0, sizeof scene.devices.file);
        scene.menu.controllers.file_count = 1;
        scene.menu.file_first = 0;
        snprintf(scene.devices.file[0].words, SCENE_LINE_SIZE, "/data/kingyo.db");
        const uint32_t bare = quads_of(MENU_FILES);
        scene.devices.machine.missed = 3;
        assert_in_range(quads_of(MENU_FILES) - bare, 15, 60);
    }
}

static void test_a_changed_setting_has_a_seal_on_its_own_page_too(void **state)
{
    (void)state;
    set_page(MENU_MODES, 0, LANGUAGE_JA, 0);
    const int32_t standard = settings_entry(SET_MODES)->standard;
    const uint32_t bare = quads_of(MENU_MODES);
    scene.menu.settings.value[SET_MODES] = standard ^ 1;
    /* The changed row has a seal, and its new value 出さない has two letters more than its default
     * 出す. */
    assert_int_equal(standard & 1, 1);
    assert_int_equal(quads_of(MENU_MODES), bare + 1u + 2u);
    set_page(MENU_UPKEEP, 0, LANGUAGE_EN, 0);
    const uint32_t without = quads_of(MENU_UPKEEP);
    scene.menu.settings.value[SET_PIN] = 407;
    assert_int_equal(quads_of(MENU_UPKEEP), without + 1u);
}

/* The opening checklist shows the state of the machine before the stall opens. Each of its rows
 * must fit in every state, with the largest values, on every screen. */
static void test_the_opening_checklist_fits_its_page_in_every_state(void **state)
{
    /* clang-format off */
    static const struct scene_machine machines[] = {
        { 0 },
        { .is_checked = 1, .keeps = KEEPS_PROVEN, .watch = WATCH_OK, .has_backup = 1,
          .backup_min = 179, .room_mib = 4294967295u, .has_heat = 1, .heat_margin_c = 2147483647 },
        { .is_checked = 1, .keeps = KEEPS_FOLDER, .watch = WATCH_NO_LIMIT, .has_backup = 1,
          .backup_min = 4294967295u, .room_mib = 63, .has_heat = 1, .heat_margin_c = 9,
          .quarantined = 4294967295u },
        { .is_checked = 1, .keeps = KEEPS_MEMORY, .watch = WATCH_FAIL, .room_mib = 7,
          .has_heat = 1, .heat_margin_c = -2147483647, .is_clock_back = 1 },
        { .is_checked = 1, .keeps = KEEPS_NOT }, { .is_checked = 1, .keeps = KEEPS_NOWHERE },
        { .is_checked = 255, .keeps = 255, .watch = 255 },
    };
    /* clang-format on */
    const uint32_t count = sizeof machines / sizeof machines[0];
    (void)state;
    for (uint32_t k = 0; k < SIZE_COUNT * LANGUAGE_COUNT * count * 4u; k++) {
        const uint32_t size = k % SIZE_COUNT, way = k / (SIZE_COUNT * LANGUAGE_COUNT * count);
        set_page(MENU_SELF_TEST, (1u << SELF_TAGS) - 1u, (uint8_t)(k / SIZE_COUNT % LANGUAGE_COUNT),
                 is_upright(size));
        scene.devices.machine = machines[k / (SIZE_COUNT * LANGUAGE_COUNT) % count];
        scene.devices.frames_a_second = way & 1u ? 4294967295u : 0u;
        scene.devices.files_refused = way & 1u;
        scene.menu.self = (struct scene_self_test){
            .sound_answer = (uint8_t)(way % 3u),
            .lamp_answer = (uint8_t)(way % 3u),
            .players = 4,
            .store = (uint8_t)(way % SELF_STATES),
            .clock = way & 1u ? SELF_GOOD : SELF_WARN,
            .seconds_left = way & 2u ? 20u : 0u,
            .day = 65535u,
            .minute = 1439u,
        };
        lay_out(size);
        expect_inside(size);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_no_text_of_the_menu_overflows_its_box),
        cmocka_unit_test(test_ink_has_contrast_to_the_wood_of_the_boards),
        cmocka_unit_test(test_the_pointer_is_a_ring_without_paper),
        cmocka_unit_test(test_an_open_warning_marks_the_path_to_its_page),
        cmocka_unit_test(test_unstored_replays_are_shown_on_the_slip_of_the_store),
        cmocka_unit_test(test_a_changed_setting_has_a_seal_on_its_own_page_too),
        cmocka_unit_test(test_the_opening_checklist_fits_its_page_in_every_state),
        cmocka_unit_test(test_every_menu_page_fits_the_screen),
        cmocka_unit_test(test_no_letter_of_the_menu_lies_on_another),
        cmocka_unit_test(test_every_line_of_the_update_page_fits_and_is_readable),
        cmocka_unit_test(test_every_menu_word_is_readable_from_one_metre),
        cmocka_unit_test(test_a_setting_shows_its_range_and_unit),
        cmocka_unit_test(test_a_board_is_drawn_for_each_present_controller),
        cmocka_unit_test(test_the_reason_is_shown_if_no_controller_is_plugged_in),
        cmocka_unit_test(test_the_longest_reason_is_complete_in_portrait_and_landscape),
        cmocka_unit_test(test_a_slip_is_drawn_for_each_existing_row),
        cmocka_unit_test(test_a_lamp_is_lit_for_each_pressed_button),
        cmocka_unit_test(test_a_missing_gpio_line_has_a_red_slip_and_no_lamp),
        cmocka_unit_test(test_the_state_of_the_lines_is_complete_and_readable_from_one_metre),
        cmocka_unit_test(test_the_quit_confirmation_does_not_overlap_the_practice_plates),
        cmocka_unit_test(test_every_page_is_laid_out_in_a_window_of_any_size),
        cmocka_unit_test(test_the_quit_confirmation_is_readable_over_the_tank),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
