/* ui_menu.c -- draws the operator's menu: wooden tags over the darkened tank. Also draws the
 * confirmation page and the PIN page. */
#include "platform/render/ui/menu/ui_menu.h"

#include <math.h>

#include "core/base/panic.h"

/* ---- Functions that all pages share: positions and texts ------------------------------------ */

struct ui_box menu_place(const struct menu_view *view, struct layout_box box)
{
    const float u = view->frame.unit;
    return (struct ui_box){ view->x + box.x * u, view->y + box.y * u, box.width * u,
                            box.height * u };
}

struct ui_box menu_tag_place(const struct menu_view *view, uint32_t tag)
{
    const struct scene_menu *menu = view->menu;
    return menu_place(view, menu_box(menu->upright, menu->page, menu->tags, tag));
}

const char *menu_text(const struct menu_view *view, enum text_key key)
{
    return text_words(view->frame.language, key);
}

struct ui_text menu_style(const struct menu_view *view, float size, uint32_t fill)
{
    return (struct ui_text){ .font = FONT_BODY, .size_px = size * view->frame.unit, .fill = fill };
}

struct ui_text menu_brush(const struct menu_view *view, float size, uint32_t fill)
{
    const int brush = view->frame.language == LANGUAGE_JA;
    return (struct ui_text){ .font = brush ? FONT_BRUSH : FONT_STALL,
                             .size_px = (brush ? size : 0.6f * size) * view->frame.unit,
                             .weight_em = brush ? 0.022f : 0.0f,
                             .spacing_em = brush ? -0.08f : 0.0f,
                             .fill = fill };
}

void menu_words_at(const struct menu_view *view, float x, float y, float room, float align,
                   const struct ui_text *style, const char *words)
{
    CORE_ASSERT(align >= 0.0f && align <= 1.0f);
    struct ui_text fitted = *style;
    fitted.fit_px = room;
    fitted.size_px = ui_text_size(&fitted, words);
    fitted.align = align;
    ui_text_at(&view->frame, &fitted, x, y, words);
}

/* ---- Wooden tags of the menu ---------------------------------------------------------------- */

struct ui_box menu_tag_board(const struct menu_view *view, uint32_t tag)
{
    const int is_pointed = view->menu->tag == tag;
    struct ui_box box = menu_tag_place(view, tag);
    if (is_pointed && view->menu->has_hand && view->menu->presses) {
        box.y += 3.0f * view->frame.unit;
    }
    ui_wooden_tag(&view->frame, box, is_pointed);
    return box;
}

/* Draws the sign in the upper corner of a tag. The sign is an exclamation mark on red for a page
 * that the operator should check, or the seal for a changed setting. */
static void draw_tag_corner_sign(const struct menu_view *view, struct ui_box box, uint8_t page)
{
    const float u = view->frame.unit, r = 17.0f * u;
    const float x = box.x + box.width - 26.0f * u, y = box.y + 26.0f * u;
    const struct ui_text sign = menu_style(view, 26.0f, MENU_CREAM);
    const struct scene_machine *machine = &view->devices->machine;
    if ((page == MENU_UPKEEP || page == MENU_FILES) &&
        (machine->aside > 0 || machine->missed > 0 || view->devices->files_refused > 0)) {
        ui_disc(&view->frame, x, y, r, 0.0f, 0xb3261effu, 0);
        menu_words_at(view, x, y, 2.0f * r, 0.5f, &sign, "!");
    } else if (page == MENU_NEW_PIN && view->menu->settings.value[SET_PIN] != 0) {
        menu_seal(view, x, y);
    }
}

static void hung_tag(const struct menu_view *view, uint32_t tag)
{
    const float u = view->frame.unit;
    const struct ui_text name = menu_brush(view, 88.0f, MENU_INK);
    const struct ui_text line = menu_style(view, 24.0f, MENU_INK_SOFT);
    struct ui_box box = menu_tag_place(view, tag);
    const uint8_t page = menu_page_at(view->menu->page, tag);
    const struct menu_words *words = menu_words_of(view->menu->page);
    const enum text_key name_key =
        page < MENU_PAGE_COUNT ? menu_words_of(page)->title : words->names[tag];
    const enum text_key line_key =
        page < MENU_PAGE_COUNT ? menu_words_of(page)->about : words->lines[tag];
    ui_cords(&view->frame, box, box.y - 40.0f * u);
    box = menu_tag_board(view, tag);
    const float x = box.x + 14.0f * u, width = box.width - 28.0f * u;
    ui_words_in(&view->frame, (struct ui_box){ x, box.y, width, 0.62f * box.height }, &name,
                menu_text(view, name_key));
    ui_words_in(&view->frame,
                (struct ui_box){ x, box.y + 0.64f * box.height, width, 0.28f * box.height }, &line,
                menu_text(view, line_key));
    draw_tag_corner_sign(view, box, page);
}

/* Draws a pole over each row of hanging tags. A new row begins at each tag that is lower than the
 * tag before it. */
static void poles(const struct menu_view *view, uint32_t body_count)
{
    const float u = view->frame.unit;
    float row_y = -1.0f, from = 0.0f, to = 0.0f;
    for (uint32_t tag = 0; tag <= body_count; tag++) {
        const int is_tag = tag < body_count && (view->menu->tags >> tag & 1u);
        const struct ui_box box = is_tag ? menu_tag_place(view, tag) : (struct ui_box){ 0 };
        const int is_last = tag == body_count;
        if (row_y >= 0.0f && (is_last || (is_tag && box.y > row_y))) {
            ui_pole(&view->frame, 0.5f * (from + to), row_y - 40.0f * u, to - from + 60.0f * u);
        }
        if (is_tag) {
            from = box.y > row_y ? box.x : from;
            to = box.x + box.width;
            row_y = box.y;
        }
    }
}

static void foot_tag(const struct menu_view *view, uint32_t tag, enum text_key key)
{
    const float u = view->frame.unit;
    const struct ui_box box = menu_tag_board(view, tag);
    const struct ui_text name = ui_style(&view->frame, FONT_STALL, 34.0f, 0.0f, MENU_INK, 0.0f);
    const int turns_down = key == TEXT_FOOT_UP && view->menu->turns_down;
    ui_words_in(&view->frame,
                (struct ui_box){ box.x + 12.0f * u, box.y, box.width - 24.0f * u, box.height },
                &name, menu_text(view, turns_down ? TEXT_FOOT_DOWN : key));
}

static void draw_menu_tags(const struct menu_view *view)
{
    const uint8_t page = view->menu->page, body = menu_page_desc_of(page)->body;
    const int is_hung = body == MENU_BODY_TILES || body == MENU_BODY_PAGES;
    const uint32_t body_count = menu_body_count(page);
    if (is_hung) {
        poles(view, body_count);
    }
    for (uint32_t tag = is_hung ? 0u : body_count; tag < menu_tag_count(page); tag++) {
        if (!(view->menu->tags >> tag & 1u)) {
            continue;
        }
        if (tag >= body_count) {
            foot_tag(view, tag, menu_words_of(page)->foot[tag - body_count]);
        } else {
            hung_tag(view, tag);
        }
    }
}

/* ---- Whole page of the menu ------------------------------------------------------------------ */

static void draw_menu_title(const struct menu_view *view)
{
    const int upright = view->menu->upright;
    const struct ui_box box =
        menu_place(view, upright ? (struct layout_box){ 40.0f, 40.0f, 774.0f, 110.0f }
                                 : (struct layout_box){ 320.0f, 18.0f, 640.0f, 96.0f });
    struct ui_text style = menu_brush(view, 92.0f, MENU_CREAM);
    style.outline_em = 0.03f;
    style.soft_em = 0.1f;
    style.line = 0x0a0c24e0u;
    ui_words_in(&view->frame, box, &style, menu_text(view, menu_words_of(view->menu->page)->title));
}

/* Returns the view with the largest scale at which the whole canvas fits on the screen. On an
 * upright screen, the scale equals the camera's scale, because the pointer also uses the camera's
 * scale. */
static struct menu_view open_view(const struct ui_frame *frame, const struct scene *scene)
{
    const struct layout_point canvas = pointer_layout_size(scene->menu.upright);
    struct menu_view view = {
        .frame = *frame, .scene = scene, .menu = &scene->menu, .devices = &scene->devices
    };
    view.frame.unit = scene->menu.upright
                          ? frame->width / canvas.x
                          : fminf(frame->width / canvas.x, frame->height / canvas.y);
    view.x = 0.5f * (frame->width - canvas.x * view.frame.unit);
    view.y = 0.5f * (frame->height - canvas.y * view.frame.unit);
    return view;
}

static void draw_menu_body(const struct menu_view *view)
{
    const uint8_t kind = menu_page_desc_of(view->menu->page)->body;
    if (kind == MENU_BODY_SETTINGS) {
        menu_settings(view);
    } else if (kind == MENU_BODY_BITS) {
        menu_bits(view);
    }
    if (menu_words_of(view->menu->page)->draw) {
        menu_words_of(view->menu->page)->draw(view);
    }
}

static void draw_menu_page(const struct menu_view *view)
{
    /* A veil darkens the tank, so that the menu's text is readable over the bright lights of the
     * tank. */
    const struct ui_box box = { 0.0f, 0.0f, view->frame.width, view->frame.height };
    ui_panel(&view->frame, UI_PANEL, box, 0.0f, 0.0f, 0x090d24dcu, 0);
    draw_menu_title(view);
    draw_menu_tags(view);
    draw_menu_body(view);
    const int upright = view->menu->upright;
    const struct menu_page_desc *sheet = menu_page_desc_of(view->menu->page);
    const enum text_key key = view->menu->page == MENU_SELF_TEST  ? TEXT_CHECK_KEYS
                              : sheet->watches                    ? TEXT_MENU_WATCH_KEYS
                              : sheet->body == MENU_BODY_SETTINGS ? TEXT_MENU_TURN_KEYS
                                                                  : TEXT_MENU_KEYS;
    const struct ui_text style = menu_style(view, 22.0f, 0xc9d2eeffu);
    ui_words_in(&view->frame,
                menu_place(view, upright ? (struct layout_box){ 27.0f, 1366.0f, 800.0f, 34.0f }
                                         : (struct layout_box){ 60.0f, 684.0f, 1160.0f, 32.0f }),
                &style, menu_text(view, key));
}

void ui_menu(const struct ui_frame *frame, const struct scene *scene)
{
    const struct menu_view view = open_view(frame, scene);
    frame->batch->opacity = ui_smooth(0.0f, 0.25f, scene->phase_s);
    if (menu_words_of(scene->menu.page)->is_whole) {
        draw_menu_body(&view);
        draw_menu_tags(&view);
    } else {
        draw_menu_page(&view);
    }
    const struct scene_menu *menu = view.menu;
    const float u = view.frame.unit;
    if (menu->has_hand) {
        ui_poi_sign(&view.frame, view.x + menu->x * u, view.y + menu->y * u,
                    (menu->presses ? 15.0f : 20.0f) * u, 1.0f, ui_player_colours[0]);
    }
    frame->batch->opacity = 1.0f;
}

/* ---- Confirmation page ----------------------------------------------------------------------- */

void menu_confirm(const struct menu_view *view)
{
    const struct scene_menu *menu = view->menu;
    const int upright = menu->upright;
    const float u = view->frame.unit;
    const struct ui_box box =
        menu_place(view, upright ? (struct layout_box){ 27.0f, 480.0f, 800.0f, 300.0f }
                                 : (struct layout_box){ 140.0f, 210.0f, 1000.0f, 250.0f });
    const struct ui_text asks = menu_style(view, 38.0f, UI_INK);
    const struct ui_text costs = menu_style(view, 24.0f, UI_INK_SOFT);
    const struct ui_text about = menu_style(view, 26.0f, 0xc23a22ffu);
    ui_panel(&view->frame, UI_WASHI, box, 12.0f * u, 2.0f * u, UI_WASHI_WHITE, 0xb5762fffu);
    const float x = box.x + 24.0f * u, width = box.width - 48.0f * u;
    if (menu->page == MENU_RESET) {
        /* The page also shows the name of the account book that would be reset. */
        ui_words_in(&view->frame,
                    (struct ui_box){ x, box.y + 0.06f * box.height, width, 0.2f * box.height },
                    &about, menu_text(view, menu_words_of(menu->from)->title));
    }
    ui_words_in(&view->frame,
                (struct ui_box){ x, box.y + 0.26f * box.height, width, 0.32f * box.height }, &asks,
                menu_text(view, menu->page == MENU_RESET     ? TEXT_SURE_RESET
                                : menu->page == MENU_RESTART ? TEXT_SURE_RESTART
                                                             : TEXT_SURE_FACTORY));
    ui_words_in(&view->frame,
                (struct ui_box){ x, box.y + 0.64f * box.height, width, 0.2f * box.height }, &costs,
                menu_text(view, menu->page == MENU_RESET     ? TEXT_SURE_RESET_WORDS
                                : menu->page == MENU_RESTART ? TEXT_SURE_RESTART_WORDS
                                                             : TEXT_SURE_FACTORY_WORDS));
}

/* ---- PIN page: ten number keys, and a place for each digit ----------------------------------- */

/* Draws one place for each digit. The digits of a new PIN are visible. When an existing PIN is
 * entered, a fish replaces each digit. */
static void pin_slots(const struct menu_view *view)
{
    const struct scene_menu *menu = view->menu;
    const float u = view->frame.unit;
    const int upright = menu->upright;
    const float size = upright ? 120.0f : 92.0f, gap = upright ? 36.0f : 28.0f, pitch = size + gap;
    const float width = (float)MENU_PIN_DIGITS * pitch - gap;
    const float left = 0.5f * (pointer_layout_size(upright).x - width);
    const struct ui_text style = ui_style(&view->frame, FONT_STALL, 56.0f, 0.0f, UI_INK, 0.0f);
    for (uint32_t i = 0; i < MENU_PIN_DIGITS; i++) {
        const int is_typed = i < menu->pin_count;
        const struct ui_box box =
            menu_place(view, (struct layout_box){ left + (float)i * pitch,
                                                  upright ? 260.0f : 124.0f, size, size });
        ui_panel(&view->frame, UI_WASHI, box, 10.0f * u, 2.0f * u,
                 is_typed ? UI_WASHI_WHITE : 0xfbf2dd60u, 0xb5762fffu);
        if (is_typed && menu->page == MENU_NEW_PIN) {
            uint32_t pin = menu->pin;
            for (uint32_t k = i + 1u; k < menu->pin_count; k++) {
                pin /= 10u;
            }
            const char digit[2] = { (char)('0' + pin % 10u), 0 };
            ui_words_in(&view->frame, box, &style, digit);
        } else if (is_typed) {
            ui_fish_sign(&view->frame, box.x + 0.5f * box.width, box.y + 0.5f * box.height,
                         0.72f * box.width);
        }
    }
}

static void pin_keys(const struct menu_view *view)
{
    const struct ui_text style = ui_style(&view->frame, FONT_STALL, 70.0f, 0.0f, MENU_INK, 0.0f);
    for (uint32_t tag = 0; tag < PIN_ERASE; tag++) {
        if (view->menu->tags >> tag & 1u) {
            const struct ui_box box = menu_tag_board(view, tag);
            const char digit[2] = { (char)('0' + (tag + 1u) % 10u), 0 };
            ui_words_in(&view->frame, box, &style, digit);
        }
    }
}

void menu_pin(const struct menu_view *view)
{
    const struct scene_menu *menu = view->menu;
    const int upright = menu->upright, waits = menu->page == MENU_PIN && menu->pin_wait_s > 0.0f;
    const struct ui_text style = menu_style(view, 26.0f, waits ? 0xff9c86ffu : MENU_CREAM);
    const enum text_key new_pin =
        menu->settings.value[SET_PIN] != 0 ? TEXT_PIN_CHANGE : TEXT_PIN_NEW;
    char words[TEXT_LINE_MAX];
    text_number(words, sizeof words,
                menu_text(view, waits                        ? TEXT_PIN_WAIT
                                : menu->page == MENU_NEW_PIN ? new_pin
                                                             : TEXT_PIN_ASK),
                (uint32_t)ceilf(menu->pin_wait_s));
    pin_slots(view);
    pin_keys(view);
    ui_words_in(&view->frame,
                menu_place(view, upright ? (struct layout_box){ 27.0f, 184.0f, 800.0f, 44.0f }
                                         : (struct layout_box){ 60.0f, 218.0f, 1160.0f, 38.0f }),
                &style, words);
}
