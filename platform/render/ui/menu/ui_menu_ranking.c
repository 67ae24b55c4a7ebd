/* ui_menu_ranking.c -- draws the operator's leaderboard page, with a wooden board for each score,
 * and the page of one score. */
#include "core/game/ranking/ranking.h"
#include "platform/render/ui/menu/ui_menu.h"
#include "platform/render/ui/ui_leaderboard.h"

/* Draws the name of the shown leaderboard beside the title. On an upright screen the name is below
 * the title. */
static void board_words(const struct menu_view *view)
{
    const int upright = view->menu->upright;
    const struct scene_leaderboard *board = &view->scene->leaderboard;
    const struct ui_text mode = { .font = FONT_STALL,
                                  .size_px = 27.0f * view->frame.unit,
                                  .fill = UI_GOLD };
    const struct ui_text period = { .font = FONT_STALL,
                                    .size_px = 31.0f * view->frame.unit,
                                    .fill = MENU_CREAM };
    ui_words_in(&view->frame,
                menu_place(view, upright ? (struct layout_box){ 127.0f, 152.0f, 250.0f, 44.0f }
                                         : (struct layout_box){ 60.0f, 30.0f, 250.0f, 36.0f }),
                &mode, ui_mode_name(view->frame.language, board->mode));
    ui_words_in(&view->frame,
                menu_place(view, upright ? (struct layout_box){ 397.0f, 152.0f, 330.0f, 44.0f }
                                         : (struct layout_box){ 60.0f, 68.0f, 250.0f, 40.0f }),
                &period, menu_text(view, ui_leaderboard_key(board->period)));
}

/* Draws a score such as "3.  きんぎょ  12 fish" on a wooden board. */
static void score_words(const struct menu_view *view, uint32_t index, struct ui_box box)
{
    const struct scene_row *row = &view->scene->leaderboard.row[index];
    const float u = view->frame.unit, y = box.y + 0.5f * box.height;
    const struct ui_text place = {
        .font = FONT_STALL, .size_px = 28.0f * u, .align = 1.0f, .fill = MENU_INK_SOFT
    };
    const struct ui_text name = {
        .font = FONT_STALL, .size_px = 32.0f * u, .fill = MENU_INK, .fit_px = box.width - 320.0f * u
    };
    const struct ui_text count = {
        .font = FONT_STALL, .size_px = 32.0f * u, .align = 1.0f, .fill = MENU_INK
    };
    const struct ui_text unit = {
        .font = FONT_STALL, .size_px = 22.0f * u, .align = 1.0f, .fill = MENU_INK_SOFT
    };
    char number[12];
    text_number(number, sizeof number, "{}", index + 1u);
    ui_text(view->frame.batch, &place, box.x + 70.0f * u, ui_text_middle(&place, y), number);
    ui_text(view->frame.batch, &name, box.x + 100.0f * u, ui_text_middle(&name, y),
            row->name[0] ? row->name : "---");
    const float right = box.x + box.width - 24.0f * u, baseline = ui_text_middle(&count, y);
    const char *fish = menu_text(view, TEXT_UNIT);
    text_number(number, sizeof number, "{}", row->caught);
    ui_text(view->frame.batch, &unit, right, baseline, fish);
    ui_text(view->frame.batch, &count, right - ui_text_width(&unit, fish) - 10.0f * u, baseline,
            number);
    if (row->is_sealed) {
        ui_genuine_seal(&view->frame, box.x + box.width - 190.0f * u, y, 30.0f * u);
    }
}

static void nobody(const struct menu_view *view)
{
    const int upright = view->menu->upright;
    const struct ui_text style = menu_style(view, 30.0f, 0xc9d2eeffu);
    ui_words_in(&view->frame,
                menu_place(view, upright ? (struct layout_box){ 60.0f, 600.0f, 734.0f, 60.0f }
                                         : (struct layout_box){ 160.0f, 320.0f, 960.0f, 60.0f }),
                &style, menu_text(view, TEXT_RANKING_NOBODY));
}

void menu_ranking(const struct menu_view *view)
{
    board_words(view);
    for (uint32_t row = 0; row < SCENE_LEADERBOARD_ROWS; row++) {
        if (view->menu->tags >> row & 1u) {
            score_words(view, row, menu_tag_board(view, row));
        }
    }
    if (!(view->menu->tags & 1u)) {
        nobody(view);
    }
}

/* Draws the page of one score. The tags below the score are the operator's actions. */
void menu_score(const struct menu_view *view)
{
    const int upright = view->menu->upright;
    const float u = view->frame.unit;
    const struct ui_box box =
        menu_place(view, upright ? (struct layout_box){ 27.0f, 260.0f, 800.0f, 110.0f }
                                 : (struct layout_box){ 190.0f, 134.0f, 900.0f, 72.0f });
    board_words(view);
    ui_shape(view->frame.batch, &(struct ui_shape){ .box = box,
                                                    .kind = UI_WASHI,
                                                    .fill = UI_WASHI_WHITE,
                                                    .line = 0xb5762fffu,
                                                    .shape = { 0, 0, 8.0f * u, 1.5f * u } });
    score_words(view, view->menu->score, box);
}
