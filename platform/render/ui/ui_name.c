/* ui_name.c -- draws the name entry: the line for the name, the letter keys and four function keys.
 * Coordinates are on the core's canvas, the layout area that is scaled to the screen. */
#include <math.h>

#include "core/game/ranking/name_keyboard.h"
#include "platform/render/ui/ui_widgets.h"

_Static_assert(SCENE_NAME_LETTERS == NAME_LETTERS_MAX, "every letter can be shown");

#define KEY_PAPER 0xfbf2ddffu
#define KEY_PAPER_LIT 0xffd978ffu
#define WARN_PAPER 0xb8301ee8u

/* Drawing context of the name entry: position and scale of the canvas on the screen, and the name
 * that the player enters. */
struct slate {
    struct ui_frame frame; /* Drawing context of the user interface. Its `unit` is the size of one
                              canvas unit in pixels. */
    const struct scene_name *name;
    float x, y; /* Position of the upper left corner of the canvas on the screen, in pixels. */
    uint32_t colour;
};

static struct ui_box slate_box(const struct slate *slate, struct layout_box box)
{
    const float u = slate->frame.unit;
    return (struct ui_box){ slate->x + box.x * u, slate->y + box.y * u, box.width * u,
                            box.height * u };
}

/* ---- Player, leaderboard place and remaining time ------------------------------------------- */

static void draw_name_title(const struct slate *slate, const struct scene *scene)
{
    const int upright = slate->name->upright;
    const float u = slate->frame.unit;
    const struct ui_box box =
        slate_box(slate, upright ? (struct layout_box){ 150.0f, 70.0f, 554.0f, 70.0f }
                                 : (struct layout_box){ 300.0f, 12.0f, 680.0f, 52.0f });
    const struct ui_box line =
        slate_box(slate, upright ? (struct layout_box){ 60.0f, 150.0f, 734.0f, 70.0f }
                                 : (struct layout_box){ 300.0f, 62.0f, 680.0f, 44.0f });
    const struct ui_text proud = ui_style(&slate->frame, FONT_STALL, 44.0f, 0.0f, UI_GOLD, 0.0f);
    const struct ui_text words =
        ui_style(&slate->frame, FONT_STALL, 34.0f, 0.0f, 0xfff6e2ffu, 0.0f);
    char where[TEXT_LINE_MAX];
    const struct scene_player *player = &scene->player[slate->name->seat];
    text_number(where, sizeof where, ui_words(&slate->frame, ui_place_key(player->period)),
                player->place);
    ui_words_in(&slate->frame, box, &proud, where);
    if (slate->name->was_refused) {
        const struct ui_ribbon ribbon = { .x = line.x + 0.5f * line.width,
                                          .y = line.y + 0.5f * line.height,
                                          .size_px = 27.0f * u,
                                          .font = FONT_STALL,
                                          .fill = WARN_PAPER,
                                          .line = UI_GOLD,
                                          .room_px = line.width };
        ui_ribbon(&slate->frame, &ribbon, ui_words(&slate->frame, TEXT_NAME_REFUSED));
    } else {
        ui_words_in(&slate->frame, line, &words, ui_words(&slate->frame, TEXT_NAME_TITLE));
    }
    if (ui_player_count(scene) > 1u) {
        const struct ui_box mark =
            slate_box(slate, upright ? (struct layout_box){ 90.0f, 105.0f, 0.0f, 0.0f }
                                     : (struct layout_box){ 250.0f, 58.0f, 0.0f, 0.0f });
        ui_player_mark(&slate->frame, mark.x, mark.y, 30.0f * u, slate->name->seat);
    }
}

/* Draws the remaining seconds. Only the last few seconds are shown, because a longer countdown
 * makes players nervous. */
static void draw_name_countdown(const struct slate *slate, const struct scene *scene)
{
    const float u = slate->frame.unit, radius = 34.0f * u;
    const struct ui_box at =
        slate_box(slate, slate->name->upright ? (struct layout_box){ 764.0f, 105.0f, 0.0f, 0.0f }
                                              : (struct layout_box){ 1210.0f, 62.0f, 0.0f, 0.0f });
    const float whole = ceilf(scene->seconds_left);
    char number[12];
    if (scene->seconds_left > 15.0f) {
        return;
    }
    text_number(number, sizeof number, "{}", (uint32_t)whole);
    ui_ring(&slate->frame, at.x, at.y, radius, 6.0f * u, scene->seconds_left / 15.0f, UI_VERMILION,
            0xffffff26u);
    const struct ui_text digits =
        ui_style(&slate->frame, FONT_STALL, 30.0f, 0.5f, 0xfff8eaffu, 0.0f);
    ui_text_at(&slate->frame, &digits, at.x, at.y, number);
}

/* ---- Line with the letters of the name ------------------------------------------------------ */

static void one_letter(const struct slate *slate, struct ui_box box, uint16_t letter, float size,
                       uint32_t ink)
{
    char words[LEDGER_NAME_SIZE];
    const struct ui_text style = ui_style(&slate->frame, FONT_STALL, size, 0.0f, ink, 0.0f);
    name_spell(&letter, 1u, words);
    ui_words_in(&slate->frame, box, &style, words);
}

/* Draws eight places for letters. The place of the next letter has the player's colour. */
static void draw_letter_places(const struct slate *slate)
{
    const int upright = slate->name->upright;
    const float u = slate->frame.unit;
    const float width = upright ? 88.0f : 78.0f, height = upright ? 110.0f : 78.0f;
    const float pitch = upright ? 98.0f : 88.0f, y = upright ? 280.0f : 110.0f;
    const float row = pitch * (float)NAME_LETTERS_MAX - (pitch - width);
    const float left = 0.5f * (pointer_layout_size(upright).x - row);
    for (uint32_t i = 0; i < NAME_LETTERS_MAX; i++) {
        const struct ui_box box =
            slate_box(slate, (struct layout_box){ left + pitch * (float)i, y, width, height });
        const int is_next = i == slate->name->letter_count;
        const float pulse = 0.45f + 0.55f * ui_pulse(slate->frame.time_s, 1.0f);
        ui_panel(&slate->frame, UI_WASHI, box, 8.0f * u, (is_next ? 5.0f : 1.5f) * u,
                 is_next ? KEY_PAPER : 0xe6dcc4ffu,
                 is_next ? ui_fade(slate->colour, pulse) : 0x6a5238ffu);
        if (i < slate->name->letter_count) {
            one_letter(slate, box, slate->name->letter[i], 58.0f, UI_INK);
        }
    }
}

/* ---- Keyboard ------------------------------------------------------------------------------- */

/* Returns the box of a key. The box is slightly lower while the key is pressed. */
static struct ui_box key_paper(const struct slate *slate, uint32_t key)
{
    const struct scene_name *name = slate->name;
    const float u = slate->frame.unit;
    const int is_lit = name->key == key;
    struct ui_box box = slate_box(slate, name_box(name->upright, name->alphabet, key));
    box.y += is_lit && name->presses ? 3.0f * u : 0.0f;
    ui_shape(slate->frame.batch,
             &(struct ui_shape){ .box = box,
                                 .kind = is_lit ? UI_PANEL : UI_WOOD,
                                 .fill = is_lit ? KEY_PAPER_LIT : 0xd9a667ffu,
                                 .line = is_lit ? slate->colour : 0x5a3a20ffu,
                                 .shape = { 0, 0, 8.0f * u, (is_lit ? 5.0f : 2.0f) * u } });
    return box;
}

static enum text_key key_words(const struct scene_name *name, uint32_t key)
{
    static const enum text_key next[ALPHABET_COUNT] = {
        [ALPHABET_HIRAGANA] = TEXT_NAME_KATAKANA,
        [ALPHABET_KATAKANA] = TEXT_NAME_LATIN,
        [ALPHABET_LATIN] = TEXT_NAME_HIRAGANA,
    };
    switch (key) {
    case NAME_ALPHABET:
        return next[name->alphabet < ALPHABET_COUNT ? name->alphabet : 0];
    case NAME_CHANGE:
        return name->alphabet == ALPHABET_LATIN ? TEXT_NAME_CASE : TEXT_NAME_VOICE;
    case NAME_ERASE:
        return TEXT_NAME_ERASE;
    default:
        return TEXT_NAME_DONE;
    }
}

static void draw_name_keys(const struct slate *slate)
{
    const struct scene_name *name = slate->name;
    const float u = slate->frame.unit;
    for (uint32_t cell = 0; cell < NAME_CELLS; cell++) {
        const uint16_t letter = name_letter(name->alphabet, cell);
        if (letter != 0) {
            one_letter(slate, key_paper(slate, cell), letter, 46.0f, 0x2a160cffu);
        }
    }
    const struct ui_text style =
        ui_style(&slate->frame, FONT_STALL, 36.0f, 0.0f, 0x2a160cffu, 0.0f);
    for (uint32_t key = NAME_CELLS; key < NAME_KEY_COUNT; key++) {
        const struct ui_box box = key_paper(slate, key);
        ui_words_in(&slate->frame,
                    (struct ui_box){ box.x + 10.0f * u, box.y, box.width - 20.0f * u, box.height },
                    &style, ui_words(&slate->frame, key_words(name, key)));
    }
}

void ui_name(const struct ui_frame *frame, const struct scene *scene)
{
    const struct layout_point canvas = pointer_layout_size(scene->name.upright);
    struct slate slate = { .frame = *frame, .name = &scene->name };
    slate.frame.unit = scene->name.upright
                           ? frame->width / canvas.x
                           : fminf(frame->width / canvas.x, frame->height / canvas.y);
    slate.x = 0.5f * (frame->width - canvas.x * slate.frame.unit);
    slate.y = 0.5f * (frame->height - canvas.y * slate.frame.unit);
    slate.colour = ui_player_colours[scene->name.seat < POI_MAX ? scene->name.seat : 0];
    frame->batch->opacity = ui_smooth(0.0f, 0.25f, scene->phase_s);
    /* A veil darkens the tank, so that the letters are readable over the bright lights of the
     * tank. */
    const struct ui_box box = { 0.0f, 0.0f, slate.frame.width, slate.frame.height };
    ui_panel(&slate.frame, UI_PANEL, box, 0.0f, 0.0f, 0x090d24b4u, 0);
    draw_name_title(&slate, scene);
    draw_name_countdown(&slate, scene);
    draw_letter_places(&slate);
    draw_name_keys(&slate);
    const int upright = slate.name->upright;
    const struct ui_text style = ui_style(&slate.frame, FONT_BODY, 24.0f, 0.0f, 0xc9d2eeffu, 0.0f);
    ui_words_in(&slate.frame,
                slate_box(&slate, upright ? (struct layout_box){ 27.0f, 1190.0f, 800.0f, 40.0f }
                                          : (struct layout_box){ 60.0f, 678.0f, 1160.0f, 34.0f }),
                &style, ui_words(&slate.frame, TEXT_NAME_KEYS));
    const struct scene_name *name = slate.name;
    const float u = slate.frame.unit;
    if (name->has_hand) {
        ui_poi_sign(&slate.frame, slate.x + name->x * u, slate.y + name->y * u,
                    (name->presses ? 15.0f : 20.0f) * u, 1.0f, slate.colour);
    }
    frame->batch->opacity = 1.0f;
}
