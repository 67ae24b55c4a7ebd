/* ui_name.c -- draws the name entry: the line for the name, the letter keys and four function keys.
 * Coordinates are on the core's canvas, the layout area that is scaled to the screen. */
#include <math.h>

#include "core/game/ranking/name_keyboard.h"
#include "platform/render/ui/ui_widgets.h"

_Static_assert(SCENE_NAME_LETTERS == NAME_LETTERS_MAX, "every letter can be shown");

#define KEY_PAPER 0xfbf2ddffu
#define KEY_PAPER_LIT 0xffd978ffu
#define WARN_PAPER 0xb8301ee8u
#define LETTER_INK 0x2a160cffu
/* Remaining seconds below which the countdown is shown. A longer countdown would make players
 * nervous. */
#define COUNTDOWN_S 15.0f

/* Returns the colour of the player who enters a name. */
static uint32_t colour_of(const struct scene_name *name)
{
    return ui_player_colours[name->slot < POI_MAX ? name->slot : 0];
}

/* ---- Player, leaderboard place and remaining time ------------------------------------------- */

static void draw_name_title(const struct ui_frame *frame)
{
    const struct scene *const scene = frame->scene;
    const struct scene_player *const player = &scene->player[scene->name.slot];
    const float u = frame->unit;
    const struct ui_box line =
        ui_place_either(frame, canvas_box(300, 62, 680, 44), canvas_box(60, 150, 734, 70));
    char where[TEXT_LINE_MAX];
    text_number(where, sizeof where, ui_words(frame, ui_leaderboard_period(player->period)->place),
                player->place);
    ui_words_in(frame,
                ui_place_either(frame, canvas_box(300, 12, 680, 52), canvas_box(150, 70, 554, 70)),
                ui_style(frame, FONT_STALL, 44.0f, 0.0f, UI_GOLD, 0.0f), where);
    if (scene->name.was_refused) {
        ui_ribbon_at(frame, (struct ui_ribbon){ FONT_STALL, WARN_PAPER, UI_GOLD, 0 },
                     line.x + 0.5f * line.width, line.y + 0.5f * line.height, 27.0f * u, line.width,
                     ui_words(frame, TEXT_NAME_REFUSED));
    } else {
        ui_words_in(frame, line, ui_style(frame, FONT_STALL, 34.0f, 0.0f, UI_CREAM, 0.0f),
                    ui_words(frame, TEXT_NAME_TITLE));
    }
    if (ui_player_count(scene) > 1u) {
        const struct ui_box mark =
            ui_place_either(frame, canvas_box(250, 58, 0, 0), canvas_box(90, 105, 0, 0));
        ui_player_mark(frame, mark.x, mark.y, 30.0f * u, scene->name.slot);
    }
    if (scene->seconds_left <= COUNTDOWN_S) {
        const struct ui_box at =
            ui_place_either(frame, canvas_box(1210, 62, 0, 0), canvas_box(764, 105, 0, 0));
        ui_ring(frame, at.x, at.y, 34.0f * u, 6.0f * u, scene->seconds_left / COUNTDOWN_S,
                UI_VERMILION, 0xffffff26u);
        ui_number_at(frame, ui_style(frame, FONT_STALL, 30.0f, 0.5f, 0xfff8eaffu, 0.0f), at.x, at.y,
                     (uint32_t)ceilf(scene->seconds_left));
    }
}

/* ---- Line with the letters of the name ------------------------------------------------------ */

static void one_letter(const struct ui_frame *frame, struct ui_box box, uint16_t letter, float size,
                       uint32_t ink)
{
    char words[LEDGER_NAME_SIZE];
    name_spell(&letter, 1u, words);
    ui_words_in(frame, box, ui_style(frame, FONT_STALL, size, 0.0f, ink, 0.0f), words);
}

/* Draws the eight places for the letters of the name. The place for the next letter has the
 * player's colour. */
static void draw_letter_places(const struct ui_frame *frame)
{
    const struct scene_name *const name = &frame->scene->name;
    const bool is_upright = frame->is_upright;
    const float u = frame->unit, pulse = 0.45f + 0.55f * ui_pulse(frame->time_s, 1.0f);
    const float width = is_upright ? 88.0f : 78.0f, height = is_upright ? 110.0f : 78.0f;
    const float pitch = is_upright ? 98.0f : 88.0f, y = is_upright ? 280.0f : 110.0f;
    const float row = pitch * (float)NAME_LETTERS_MAX - (pitch - width);
    const float left = 0.5f * (pointer_layout_size(is_upright).x - row);
    for (uint32_t i = 0; i < NAME_LETTERS_MAX; i++) {
        const struct ui_box box =
            ui_place(frame, canvas_box(left + pitch * (float)i, y, width, height));
        const bool is_next = i == name->letter_count;
        ui_panel(frame, UI_WASHI, box, 8.0f * u, (is_next ? 5.0f : 1.5f) * u,
                 is_next ? KEY_PAPER : 0xe6dcc4ffu,
                 is_next ? ui_fade(colour_of(name), pulse) : 0x6a5238ffu);
        if (i < name->letter_count) {
            one_letter(frame, box, name->letter[i], 58.0f, UI_INK);
        }
    }
}

/* ---- Keyboard ------------------------------------------------------------------------------- */

/* Returns the box of a key. The box is slightly lower while the key is pressed. */
static struct ui_box key_paper(const struct ui_frame *frame, uint32_t key)
{
    const struct scene_name *const name = &frame->scene->name;
    const float u = frame->unit;
    const bool is_lit = name->key == key;
    struct ui_box box = ui_place(frame, name_box(name->upright, name->alphabet, key));
    box.y += is_lit && name->presses ? 3.0f * u : 0.0f;
    ui_panel(frame, is_lit ? UI_PANEL : UI_WOOD, box, 8.0f * u, (is_lit ? 5.0f : 2.0f) * u,
             is_lit ? KEY_PAPER_LIT : UI_CEDAR, is_lit ? colour_of(name) : 0x5a3a20ffu);
    return box;
}

static void draw_name_keys(const struct ui_frame *frame)
{
    static const enum text_key next_alphabet[ALPHABET_COUNT] = {
        [ALPHABET_HIRAGANA] = TEXT_NAME_KATAKANA,
        [ALPHABET_KATAKANA] = TEXT_NAME_LATIN,
        [ALPHABET_LATIN] = TEXT_NAME_HIRAGANA,
    };
    const struct scene_name *const name = &frame->scene->name;
    for (uint32_t cell = 0; cell < NAME_CELLS; cell++) {
        const uint16_t letter = name_letter(name->alphabet, cell);
        if (letter != 0) {
            one_letter(frame, key_paper(frame, cell), letter, 46.0f, LETTER_INK);
        }
    }
    for (uint32_t key = NAME_CELLS; key < NAME_KEY_COUNT; key++) {
        enum text_key words = key == NAME_ERASE ? TEXT_NAME_ERASE : TEXT_NAME_DONE;
        if (key == NAME_ALPHABET) {
            words = next_alphabet[name->alphabet < ALPHABET_COUNT ? name->alphabet : 0];
        } else if (key == NAME_CHANGE) {
            words = name->alphabet == ALPHABET_LATIN ? TEXT_NAME_CASE : TEXT_NAME_VOICE;
        }
        ui_words_in(frame, ui_inset(key_paper(frame, key), 10.0f * frame->unit),
                    ui_style(frame, FONT_STALL, 36.0f, 0.0f, LETTER_INK, 0.0f),
                    ui_words(frame, words));
    }
}

void ui_name(const struct ui_frame *frame)
{
    const struct scene_name *const name = &frame->scene->name;
    const struct ui_frame canvas = ui_canvas(frame, name->upright);
    frame->batch->opacity = f_smoothstep(0.0f, 0.25f, frame->scene->phase_s);
    ui_veil(frame, 0x090d24b4u);
    draw_name_title(&canvas);
    draw_letter_places(&canvas);
    draw_name_keys(&canvas);
    ui_label_in(
        &canvas,
        ui_place_either(&canvas, canvas_box(60, 678, 1160, 34), canvas_box(27, 1190, 800, 40)),
        24.0f, 0xc9d2eeffu, TEXT_NAME_KEYS);
    if (name->has_pointer) {
        ui_pointer(&canvas, name->x, name->y, name->presses != 0, colour_of(name));
    }
    frame->batch->opacity = 1.0f;
}
