/* ui_lab.c -- draws the screen of the growth lab, in which players watch a fish grow: an aquarium
 * at night beside a sheet of paper with graphs. */
#include "platform/render/ui/lab/ui_lab.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "core/base/panic.h"
#include "platform/key_colour.h"
#include "platform/render/ui/ui_widgets.h"

#define CLOTH 0x141a3cffu
#define CLOTH_EDGE 0x171d42ffu
#define BUTTON 0x232c5affu
#define BUTTON_LIT 0x34407cffu
#define BUTTON_ON 0xc8341fffu
#define BUTTON_INK 0xfff4deffu
#define REFUSED 0xf0c089ffu
/* Time in seconds for which one help line is shown before the next line replaces it. */
#define TURN_S 4.0f

/* ---- Coordinates and colours ---------------------------------------------------------------- */

struct ui_box lab_place(const struct ui_frame *frame, enum lab_part part)
{
    const uint32_t key_count = frame->scene->lab.card.key_count;
    return ui_place(frame, lab_box(frame->is_upright, key_count, part));
}

uint32_t lab_key_colour(uint32_t key_count, uint32_t key)
{
    CORE_ASSERT(key < key_count && key_count <= MORPH_KEY_MAX);
    return key_colour(key_count, key) << 8 | 0xffu;
}

bool lab_is_pointed(const struct ui_frame *frame, enum lab_part part)
{
    return frame->scene->lab.has_pointer && frame->scene->lab.points == part;
}

/* ---- Buttons -------------------------------------------------------------------------------- */

/* Draws a button without text and returns its box. The box is slightly lower while the button is
 * pressed. `is_on` is true if the button is selected, and `is_idle` is true if the button currently
 * has no effect. */
static struct ui_box draw_lab_tag(const struct ui_frame *frame, enum lab_part part, bool is_on,
                                  bool is_idle)
{
    const float u = frame->unit;
    struct ui_box box = lab_place(frame, part);
    const bool is_pointed = lab_is_pointed(frame, part) && !is_idle;
    if (is_pointed && frame->scene->lab.presses) {
        box.y += 2.0f * u;
    }
    ui_panel(frame, UI_PANEL, box, 10.0f * u, (is_pointed ? 2.5f : 1.5f) * u,
             is_on        ? BUTTON_ON
             : is_pointed ? BUTTON_LIT
                          : BUTTON,
             is_pointed ? UI_GOLD : UI_GOLD_DIM);
    return box;
}

static void word_button(const struct ui_frame *frame, enum lab_part part, enum text_key key,
                        bool is_on, bool is_idle)
{
    const bool is_small = part >= LAB_OWN && part <= LAB_SMOOTH;
    const struct ui_box box = draw_lab_tag(frame, part, is_on, is_idle);
    ui_label_in(frame, ui_inset(box, (is_small ? 3.0f : 10.0f) * frame->unit),
                is_small ? 20.0f : 23.0f, is_idle ? ui_fade(BUTTON_INK, 0.45f) : BUTTON_INK, key);
}

static void draw_lab_sign(const struct ui_frame *frame, struct ui_box box, enum text_key key)
{
    ui_label_in(frame, box, 30.0f, BUTTON_INK, key);
}

static void draw_lab_buttons(const struct ui_frame *frame)
{
    static const enum text_key templates[] = { TEXT_LAB_OWN, TEXT_LAB_ORDINARY, TEXT_LAB_PAIRWISE,
                                               TEXT_LAB_SIMULTANEOUS, TEXT_LAB_SMOOTH };
    static const enum text_key saves[] = { [LAB_NOT_SAVED] = TEXT_LAB_SAVE,
                                           [LAB_SAVING] = TEXT_LAB_SAVING,
                                           [LAB_SAVED] = TEXT_LAB_SAVED,
                                           [LAB_UNSAVED] = TEXT_LAB_UNSAVED };
    const struct scene_lab *const lab = &frame->scene->lab;
    word_button(frame, LAB_LEAVE, TEXT_LAB_LEAVE, false, false);
    word_button(frame, LAB_COMPARE, TEXT_LAB_COMPARE, lab->compare, false);
    word_button(frame, LAB_PATH, TEXT_LAB_PATH, lab->path, false);
    word_button(frame, LAB_RESET, TEXT_LAB_RESET, false, lab->is_own);
    for (uint32_t i = 0; i < TEMPLATE_COUNT; i++) {
        word_button(frame, (enum lab_part)(LAB_OWN + i), templates[i], lab->template_id == i,
                    false);
    }
    const float u = frame->unit;
    const struct ui_box box = draw_lab_tag(frame, LAB_PLAY, lab->playing, false);
    const float x = box.x + 40.0f * u, y = box.y + 0.5f * box.height;
    if (lab->playing) {
        for (uint32_t i = 0; i < 2u; i++) {
            const float at = x + ((float)i - 0.5f) * 14.0f * u;
            const float from[2] = { at, y - 9.0f * u }, to[2] = { at, y + 9.0f * u };
            ui_segment(frame->batch, from, to, 6.0f * u, BUTTON_INK);
        }
    } else {
        draw_lab_sign(frame, (struct ui_box){ x - 20.0f * u, box.y, 40.0f * u, box.height },
                      TEXT_SIGN_ON);
    }
    ui_label_in(frame,
                (struct ui_box){ box.x + 64.0f * u, box.y, box.width - 76.0f * u, box.height },
                23.0f, BUTTON_INK, lab->playing ? TEXT_LAB_STOP : TEXT_LAB_PLAY);
    word_button(frame, LAB_SAVE, lab->is_kept ? saves[lab->keeping & 3u] : TEXT_LAB_SAVE, false,
                lab->is_kept && lab->keeping != LAB_UNSAVED);
}

/* ---- Title and help line -------------------------------------------------------------------- */

static void name_plate(const struct ui_frame *frame)
{
    const float u = frame->unit;
    const struct scene_lab *const lab = &frame->scene->lab;
    const struct ui_box box = lab_place(frame, LAB_NAME);
    char of[24];
    snprintf(of, sizeof of, "%u / %u", lab->species + 1u, lab->species_count);
    ui_panel(frame, UI_WASHI, box, 10.0f * u, 2.0f * u, LAB_PAPER, LAB_PAPER_LINE);
    ui_words_in(frame,
                (struct ui_box){ box.x + 16.0f * u, box.y, box.width - 120.0f * u, box.height },
                ui_style(frame, FONT_STALL, 34.0f, 0.0f, LAB_INK, 0.0f),
                lab_name(frame->language, lab->card.id));
    ui_text_at(frame, ui_style(frame, FONT_BODY, 20.0f, 1.0f, LAB_INK_SOFT, 0.0f),
               box.x + box.width - 18.0f * u, box.y + 0.5f * box.height, of);
}

/* Draws the help line beside the species' name, or above the name on a tall upright screen. From
 * time to time, messages for the operator replace the help line: first the number of rejected
 * species files, then the reason for each rejected file. */
static void help_line(const struct ui_frame *frame)
{
    const float u = frame->unit;
    const struct library *const library = frame->memory->library;
    const struct ui_box next = lab_place(frame, LAB_NEXT), leave = lab_place(frame, LAB_LEAVE);
    const float left = next.x + next.width + 18.0f * u;
    const float high = frame->y > 40.0f * u ? 32.0f * u : 0.0f;
    const struct ui_box room =
        frame->is_upright
            ? (struct ui_box){ frame->x + 24.0f * u, frame->y - 0.6f * high, 806.0f * u, high }
            : (struct ui_box){ left, next.y, leave.x - left - 18.0f * u, next.height };
    const uint32_t refused = frame->scene->lab.refused, counted = refused > 0;
    const uint32_t faults = library != NULL ? library_fault_count(library) : 0u;
    const uint32_t turn = (uint32_t)(frame->time_s / TURN_S) % (1u + counted + faults);
    if (room.height <= 0.0f) {
        return;
    }
    if (turn == 0) {
        ui_label_in(frame, room, 20.0f, 0xc9d2eeffu, TEXT_LAB_HELP);
    } else if (turn <= counted) {
        char words[TEXT_LINE_MAX];
        text_number(words, sizeof words, ui_words(frame, TEXT_LAB_REFUSED), refused);
        ui_words_in(frame, room, ui_body(frame, 20.0f, REFUSED), words);
    } else {
        const struct library_line fault = library_fault(library, turn - 1u - counted);
        /* The reason for a rejected file is written below the name of the file. */
        const float half = 0.5f * room.height;
        struct ui_text style = ui_body(frame, 18.0f, REFUSED);
        style.size_px = fminf(style.size_px, 0.9f * half);
        ui_words_in(frame, (struct ui_box){ room.x, room.y, room.width, half }, style, fault.file);
        ui_words_in(frame, (struct ui_box){ room.x, room.y + half, room.width, half }, style,
                    fault.why);
    }
}

/* ---- Whole page of the growth lab ----------------------------------------------------------- */

void ui_lab(const struct ui_frame *frame)
{
    /* A recording may show a species that a user drew and that exists only on another kiosk. In
     * this case the graphs are drawn without a fish. */
    struct ui_memory *const memory = frame->memory;
    const struct scene_lab *const lab = &frame->scene->lab;
    const struct species *found = NULL;
    if (lab->species < species_table_count) {
        found = species_table[lab->species];
    } else if (memory->library != NULL && lab->species < library_count(memory->library)) {
        found = library_species(memory->library, lab->species);
    }
    memory->bench.is_shown = found != NULL && found->card.key_count == lab->card.key_count &&
                             strcmp(found->card.id, lab->card.id) == 0;
    if (memory->bench.is_shown) {
        ui_lab_preview_set(&memory->bench, found, &lab->card);
    }
    const struct ui_frame canvas = ui_canvas(frame, lab->upright);
    const float u = canvas.unit;
    ui_veil(frame, CLOTH_EDGE);
    ui_panel(frame, UI_WAVES, (struct ui_box){ 0.0f, 0.0f, frame->width, frame->height }, 36.0f * u,
             0.0f, CLOTH, 0);
    lab_stage(&canvas);
    lab_keys(&canvas);
    lab_graph(&canvas);
    lab_chart(&canvas);
    name_plate(&canvas);
    draw_lab_sign(&canvas, draw_lab_tag(&canvas, LAB_BACK, false, false), TEXT_SIGN_BACK);
    draw_lab_sign(&canvas, draw_lab_tag(&canvas, LAB_NEXT, false, false), TEXT_SIGN_ON);
    help_line(&canvas);
    draw_lab_buttons(&canvas);
    if (lab->has_pointer) {
        ui_pointer(&canvas, lab->x, lab->y, lab->presses != 0, ui_player_colours[0]);
    }
}
