/* ui_menu.c -- draws the operator's menu: wooden tags over the darkened tank. Also draws the
 * confirmation page and the PIN page. */
#include "platform/render/ui/menu/ui_menu.h"

#include <math.h>

/* ---- Functions that all pages share --------------------------------------------------------- */

struct ui_box menu_tag_place(const struct ui_frame *frame, uint32_t tag)
{
    const struct scene_menu *const menu = &frame->scene->menu;
    return ui_place(frame, menu_box(menu->upright, menu->page, menu->rules, menu->tags, tag));
}

void menu_paper(const struct ui_frame *frame, struct ui_box box)
{
    ui_panel(frame, UI_WASHI, box, 10.0f * frame->unit, 2.0f * frame->unit, UI_WASHI_WHITE,
             0xb5762fffu);
}

void menu_note(const struct ui_frame *frame, struct layout_box wide, struct layout_box upright,
               struct ui_text style, const char *words)
{
    ui_words_in(frame, ui_place_either(frame, wide, upright), style, words);
}

struct ui_text menu_brush(const struct ui_frame *frame, float size, uint32_t fill)
{
    return ui_brush(frame, size, 0.6f * size, -0.08f, fill);
}

/* ---- Wooden tags of the menu ---------------------------------------------------------------- */

struct ui_box menu_tag_board(const struct ui_frame *frame, uint32_t tag)
{
    const struct scene_menu *const menu = &frame->scene->menu;
    const bool is_pointed = menu->tag == tag;
    struct ui_box box = menu_tag_place(frame, tag);
    if (is_pointed && menu->has_pointer && menu->presses) {
        box.y += 3.0f * frame->unit;
    }
    ui_wooden_tag(frame, box, is_pointed);
    return box;
}

static void hung_tag(const struct ui_frame *frame, uint32_t tag)
{
    const float u = frame->unit;
    const struct scene *const scene = frame->scene;
    const uint8_t page = menu_page_at(scene->menu.page, scene->menu.rules, tag);
    const struct menu_words *const words = menu_words_of(scene->menu.page);
    const bool is_page = page < MENU_PAGE_COUNT;
    struct ui_box box = menu_tag_place(frame, tag);
    ui_cords(frame, box, box.y - 40.0f * u);
    box = menu_tag_board(frame, tag);
    const float x = box.x + 14.0f * u, width = box.width - 28.0f * u;
    ui_words_in(frame, (struct ui_box){ x, box.y, width, 0.62f * box.height },
                menu_brush(frame, 88.0f, MENU_INK),
                ui_words(frame, is_page ? menu_words_of(page)->title : words->names[tag]));
    ui_label_in(frame, (struct ui_box){ x, box.y + 0.64f * box.height, width, 0.28f * box.height },
                24.0f, MENU_INK_SOFT, is_page ? menu_words_of(page)->about : words->lines[tag]);
    /* A tag may have a sign in its upper corner. The sign is an exclamation mark on red if the
     * operator should check the tag's page, or a seal if the tag leads to a changed setting. */
    const float sign_x = box.x + box.width - 26.0f * u, sign_y = box.y + 26.0f * u, r = 17.0f * u;
    const struct scene_machine *const machine = &scene->devices.machine;
    if ((page == MENU_UPKEEP || page == MENU_FILES) &&
        (machine->quarantined > 0 || machine->missed > 0 || scene->devices.files_refused > 0)) {
        ui_disc(frame, sign_x, sign_y, r, 0.0f, MENU_BAD, 0);
        ui_words_at(frame, sign_x, sign_y, 2.0f * r, 0.5f, ui_body(frame, 26.0f, UI_CREAM), "!");
    } else if (page == MENU_NEW_PIN && scene->menu.settings.value[SET_PIN] != 0) {
        menu_seal(frame, sign_x, sign_y);
    }
}

/* Draws a pole over each row of hanging tags. A new row begins at each tag that is lower than the
 * tag before it. */
static void poles(const struct ui_frame *frame, uint32_t body_count)
{
    const float u = frame->unit;
    float row_y = -1.0f, from = 0.0f, to = 0.0f;
    for (uint32_t tag = 0; tag <= body_count; tag++) {
        const bool is_last = tag == body_count;
        const bool is_tag = !is_last && (frame->scene->menu.tags >> tag & 1u);
        const struct ui_box box = is_tag ? menu_tag_place(frame, tag) : (struct ui_box){ 0 };
        if (row_y >= 0.0f && (is_last || (is_tag && box.y > row_y))) {
            ui_pole(frame, 0.5f * (from + to), row_y - 40.0f * u, to - from + 60.0f * u);
        }
        if (is_tag) {
            from = box.y > row_y ? box.x : from;
            to = box.x + box.width;
            row_y = box.y;
        }
    }
}

static void draw_menu_tags(const struct ui_frame *frame)
{
    const struct scene_menu *const menu = &frame->scene->menu;
    const uint8_t body = menu_page_desc_of(menu->page)->body;
    const bool is_hung = body == MENU_BODY_TILES || body == MENU_BODY_PAGES;
    const uint32_t body_count = menu_body_count(menu->page, menu->rules);
    if (is_hung) {
        poles(frame, body_count);
    }
    for (uint32_t tag = is_hung ? 0u : body_count; tag < menu_tag_count(menu->page, menu->rules);
         tag++) {
        if (!(menu->tags >> tag & 1u)) {
            continue;
        }
        if (tag < body_count) {
            hung_tag(frame, tag);
        } else {
            const enum text_key key = menu_words_of(menu->page)->foot[tag - body_count];
            const bool turns_down = key == TEXT_FOOT_UP && menu->turns_down;
            ui_words_in(frame, ui_inset(menu_tag_board(frame, tag), 12.0f * frame->unit),
                        ui_style(frame, FONT_STALL, 34.0f, 0.0f, MENU_INK, 0.0f),
                        ui_words(frame, turns_down ? TEXT_FOOT_DOWN : key));
        }
    }
}

/* ---- Whole page of the menu ------------------------------------------------------------------ */

static void draw_menu_body(const struct ui_frame *frame)
{
    const uint8_t page = frame->scene->menu.page, kind = menu_page_desc_of(page)->body;
    if (kind == MENU_BODY_SETTINGS) {
        menu_settings(frame);
    } else if (kind == MENU_BODY_BITS) {
        menu_bits(frame);
    }
    if (menu_words_of(page)->draw) {
        menu_words_of(page)->draw(frame);
    }
}

void ui_menu(const struct ui_frame *frame)
{
    const struct scene_menu *const menu = &frame->scene->menu;
    const struct menu_page_desc *const desc = menu_page_desc_of(menu->page);
    const struct menu_words *const words = menu_words_of(menu->page);
    const struct ui_frame canvas = ui_canvas(frame, menu->upright);
    frame->batch->opacity = f_smoothstep(0.0f, 0.25f, frame->scene->phase_s);
    if (words->is_whole) {
        draw_menu_body(&canvas);
        draw_menu_tags(&canvas);
    } else {
        const enum text_key keys = menu->page == MENU_SELF_TEST       ? TEXT_CHECK_KEYS
                                   : desc->shows_presses              ? TEXT_MENU_WATCH_KEYS
                                   : desc->body == MENU_BODY_SETTINGS ? TEXT_MENU_TURN_KEYS
                                                                      : TEXT_MENU_KEYS;
        ui_veil(frame, 0x090d24dcu);
        menu_note(&canvas, canvas_box(320, 18, 640, 96), canvas_box(40, 40, 774, 110),
                  ui_outlined(menu_brush(&canvas, 92.0f, UI_CREAM), 0.03f, 0.1f, 0x0a0c24e0u),
                  ui_words(frame, words->title));
        draw_menu_tags(&canvas);
        draw_menu_body(&canvas);
        menu_note(&canvas, canvas_box(60, 684, 1160, 32), canvas_box(27, 1366, 800, 34),
                  ui_body(&canvas, 22.0f, MENU_NOTE), ui_words(&canvas, keys));
    }
    if (menu->has_pointer) {
        ui_pointer(&canvas, menu->x, menu->y, menu->presses != 0, ui_player_colours[0]);
    }
    frame->batch->opacity = 1.0f;
}

/* ---- Confirmation page ----------------------------------------------------------------------- */

void menu_confirm(const struct ui_frame *frame)
{
    const struct scene_menu *const menu = &frame->scene->menu;
    const bool is_reset = menu->page == MENU_RESET, is_restart = menu->page == MENU_RESTART;
    const float u = frame->unit;
    const struct ui_box box =
        ui_place_either(frame, canvas_box(140, 210, 1000, 250), canvas_box(27, 480, 800, 300));
    ui_panel(frame, UI_WASHI, box, 12.0f * u, 2.0f * u, UI_WASHI_WHITE, 0xb5762fffu);
    struct ui_box line = ui_inset(box, 24.0f * u);
    if (is_reset) {
        /* The page also shows the name of the account book that would be reset. */
        line.y = box.y + 0.06f * box.height;
        line.height = 0.2f * box.height;
        ui_label_in(frame, line, 26.0f, 0xc23a22ffu, menu_words_of(menu->from)->title);
    }
    line.y = box.y + 0.26f * box.height;
    line.height = 0.32f * box.height;
    ui_label_in(frame, line, 38.0f, UI_INK,
                is_reset     ? TEXT_SURE_RESET
                : is_restart ? TEXT_SURE_RESTART
                             : TEXT_SURE_FACTORY);
    line.y = box.y + 0.64f * box.height;
    line.height = 0.2f * box.height;
    ui_label_in(frame, line, 24.0f, UI_INK_SOFT,
                is_reset     ? TEXT_SURE_RESET_WORDS
                : is_restart ? TEXT_SURE_RESTART_WORDS
                             : TEXT_SURE_FACTORY_WORDS);
}

/* ---- PIN page: ten number keys, and a place for each digit ----------------------------------- */

void menu_pin(const struct ui_frame *frame)
{
    const struct scene_menu *const menu = &frame->scene->menu;
    const bool waits = menu->page == MENU_PIN && menu->pin_wait_s > 0.0f;
    const bool has_pin = menu->settings.value[SET_PIN] != 0;
    const enum text_key key = waits                        ? TEXT_PIN_WAIT
                              : menu->page != MENU_NEW_PIN ? TEXT_PIN_ASK
                              : has_pin                    ? TEXT_PIN_CHANGE
                                                           : TEXT_PIN_NEW;
    char words[TEXT_LINE_MAX];
    text_number(words, sizeof words, ui_words(frame, key), (uint32_t)ceilf(menu->pin_wait_s));
    /* Draws one place for each digit. A new PIN is shown as digits, and an existing PIN is shown as
     * fish while the operator enters it. */
    const bool is_upright = frame->is_upright;
    const float u = frame->unit, y = is_upright ? 260.0f : 124.0f;
    const float size = is_upright ? 120.0f : 92.0f, pitch = size + (is_upright ? 36.0f : 28.0f);
    const float width = (float)(MENU_PIN_DIGITS - 1u) * pitch + size;
    const float left = 0.5f * (pointer_layout_size(is_upright).x - width);
    /* Place value of the drawn digit: 1, 10, 100 and so on, from the last digit to the first. */
    uint32_t unit = 1;
    for (uint32_t k = 1; k < menu->pin_count; k++) {
        unit *= 10u;
    }
    for (uint32_t i = 0; i < MENU_PIN_DIGITS; i++, unit /= 10u) {
        const bool is_typed = i < menu->pin_count;
        const struct ui_box box =
            ui_place(frame, canvas_box(left + (float)i * pitch, y, size, size));
        ui_panel(frame, UI_WASHI, box, 10.0f * u, 2.0f * u, is_typed ? UI_WASHI_WHITE : 0xfbf2dd60u,
                 0xb5762fffu);
        if (is_typed && menu->page == MENU_NEW_PIN) {
            const char digit[2] = { (char)('0' + menu->pin / unit % 10u), 0 };
            ui_words_in(frame, box, ui_style(frame, FONT_STALL, 56.0f, 0.0f, UI_INK, 0.0f), digit);
        } else if (is_typed) {
            ui_fish_sign(frame, box.x + 0.5f * box.width, box.y + 0.5f * box.height,
                         0.72f * box.width);
        }
    }
    for (uint32_t tag = 0; tag < PIN_ERASE; tag++) {
        if (menu->tags >> tag & 1u) {
            const char digit[2] = { (char)('0' + (tag + 1u) % 10u), 0 };
            ui_words_in(frame, menu_tag_board(frame, tag),
                        ui_style(frame, FONT_STALL, 70.0f, 0.0f, MENU_INK, 0.0f), digit);
        }
    }
    menu_note(frame, canvas_box(60, 218, 1160, 38), canvas_box(27, 184, 800, 44),
              ui_body(frame, 26.0f, waits ? 0xff9c86ffu : UI_CREAM), words);
}
