/* ui_menu_pin.c -- draws the PIN page: ten number keys, and a place for each digit. */
#include <math.h>

#include "platform/render/ui/menu/ui_menu.h"

static struct ui_box slot(const struct menu_view *view, uint32_t index)
{
    const int upright = view->menu->upright;
    const float size = upright ? 120.0f : 92.0f, gap = upright ? 36.0f : 28.0f;
    const float width = (float)MENU_PIN_DIGITS * (size + gap) - gap;
    const float left = 0.5f * (pointer_layout_size(upright).x - width);
    return menu_place(view, (struct layout_box){ left + (float)index * (size + gap),
                                                 upright ? 260.0f : 124.0f, size, size });
}

static char digit_at(const struct scene_menu *menu, uint32_t index)
{
    uint32_t pin = menu->pin;
    for (uint32_t i = index + 1u; i < menu->pin_count; i++) {
        pin /= 10u;
    }
    return (char)('0' + pin % 10u);
}

/* Draws one place for each digit. The digits of a new PIN are visible. When an existing PIN is
 * entered, a fish replaces each digit. */
static void slots(const struct menu_view *view)
{
    const struct scene_menu *menu = view->menu;
    const float u = view->frame.unit;
    const struct ui_text style = { .font = FONT_STALL, .size_px = 56.0f * u, .fill = UI_INK };
    for (uint32_t i = 0; i < MENU_PIN_DIGITS; i++) {
        const struct ui_box box = slot(view, i);
        const int is_typed = i < menu->pin_count;
        ui_shape(view->frame.batch,
                 &(struct ui_shape){ .box = box,
                                     .kind = UI_WASHI,
                                     .fill = is_typed ? UI_WASHI_WHITE : 0xfbf2dd60u,
                                     .line = 0xb5762fffu,
                                     .shape = { 0, 0, 10.0f * u, 2.0f * u } });
        if (is_typed && menu->page == MENU_NEW_PIN) {
            const char digit[2] = { digit_at(menu, i), 0 };
            ui_words_in(&view->frame, box, &style, digit);
        } else if (is_typed) {
            ui_fish_sign(&view->frame, box.x + 0.5f * box.width, box.y + 0.5f * box.height,
                         0.72f * box.width);
        }
    }
}

static void keys(const struct menu_view *view)
{
    const struct ui_text style = { .font = FONT_STALL,
                                   .size_px = 70.0f * view->frame.unit,
                                   .fill = MENU_INK };
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
    slots(view);
    keys(view);
    ui_words_in(&view->frame,
                menu_place(view, upright ? (struct layout_box){ 27.0f, 184.0f, 800.0f, 44.0f }
                                         : (struct layout_box){ 60.0f, 218.0f, 1160.0f, 38.0f }),
                &style, words);
}
