/* ui_menu_confirm.c -- draws the confirmation page: a question on paper, and the consequences of
 * answering yes. */
#include "platform/render/ui/menu/ui_menu.h"

static enum text_key question(uint8_t page)
{
    return page == MENU_RESET     ? TEXT_SURE_RESET
           : page == MENU_RESTART ? TEXT_SURE_RESTART
                                  : TEXT_SURE_FACTORY;
}

static enum text_key cost(uint8_t page)
{
    return page == MENU_RESET     ? TEXT_SURE_RESET_WORDS
           : page == MENU_RESTART ? TEXT_SURE_RESTART_WORDS
                                  : TEXT_SURE_FACTORY_WORDS;
}

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
    ui_shape(view->frame.batch, &(struct ui_shape){ .box = box,
                                                    .kind = UI_WASHI,
                                                    .fill = UI_WASHI_WHITE,
                                                    .line = 0xb5762fffu,
                                                    .shape = { 0, 0, 12.0f * u, 2.0f * u } });
    const float x = box.x + 24.0f * u, width = box.width - 48.0f * u;
    if (menu->page == MENU_RESET) {
        /* The page also shows the name of the account book that would be reset. */
        ui_words_in(&view->frame,
                    (struct ui_box){ x, box.y + 0.06f * box.height, width, 0.2f * box.height },
                    &about, menu_text(view, menu_words_of(menu->from)->title));
    }
    ui_words_in(&view->frame,
                (struct ui_box){ x, box.y + 0.26f * box.height, width, 0.32f * box.height }, &asks,
                menu_text(view, question(menu->page)));
    ui_words_in(&view->frame,
                (struct ui_box){ x, box.y + 0.64f * box.height, width, 0.2f * box.height }, &costs,
                menu_text(view, cost(menu->page)));
}
