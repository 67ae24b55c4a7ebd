/* ui_lab.c -- draws the screen of the growth lab, in which players watch a fish grow: an aquarium
 * at night beside a sheet of paper with graphs. */
#include "platform/render/ui/lab/ui_lab.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "core/base/panic.h"
#include "core/game/lab/lab.h"
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

/* ---- Coordinates and texts ------------------------------------------------------------------ */

float lab_px_x(const struct lab_page *page, float x)
{
    return page->x + x * page->frame.unit;
}

float lab_px_y(const struct lab_page *page, float y)
{
    return page->y + y * page->frame.unit;
}

struct ui_box lab_place(const struct lab_page *page, enum lab_part part)
{
    const struct layout_box box = lab_box(page->lab->upright, page->lab->card.key_count, part);
    const float u = page->frame.unit;
    return (struct ui_box){ lab_px_x(page, box.x), lab_px_y(page, box.y), box.width * u,
                            box.height * u };
}

uint32_t lab_key_colour(uint32_t key_count, uint32_t key)
{
    CORE_ASSERT(key < key_count && key_count <= MORPH_KEY_MAX);
    return key_colour(key_count, key) << 8 | 0xffu;
}

int lab_is_pointed(const struct lab_page *page, enum lab_part part)
{
    return page->lab->has_hand && page->lab->points == part;
}

struct ui_text lab_text(const struct lab_page *page, float size, uint32_t fill)
{
    return (struct ui_text){ .font = FONT_BODY, .size_px = size * page->frame.unit, .fill = fill };
}

/* ---- Buttons -------------------------------------------------------------------------------- */

struct button {
    enum lab_part part;
    const char *words;
    int is_on, is_idle; /* `is_on` is 1 if the button is selected, otherwise 0. `is_idle` is 1 if
                           the button currently has no effect, otherwise 0. */
};

/* Returns the box of a button. The box is slightly lower while the button is pressed. */
static struct ui_box draw_lab_tag(const struct lab_page *page, const struct button *button)
{
    const float u = page->frame.unit;
    struct ui_box box = lab_place(page, button->part);
    const int pointed = lab_is_pointed(page, button->part) && !button->is_idle;
    if (pointed && page->lab->presses) {
        box.y += 2.0f * u;
    }
    ui_panel(&page->frame, UI_PANEL, box, 10.0f * u, (pointed ? 2.5f : 1.5f) * u,
             button->is_on ? BUTTON_ON
             : pointed     ? BUTTON_LIT
                           : BUTTON,
             pointed ? UI_GOLD : UI_GOLD_DIM);
    return box;
}

static void word_button(const struct lab_page *page, const struct button *button)
{
    const float u = page->frame.unit;
    const int is_small = button->part >= LAB_OWN && button->part <= LAB_SMOOTH;
    const struct ui_box box = draw_lab_tag(page, button);
    const struct ui_text style = lab_text(
        page, is_small ? 20.0f : 23.0f, button->is_idle ? ui_fade(BUTTON_INK, 0.45f) : BUTTON_INK);
    const float margin = (is_small ? 3.0f : 10.0f) * u;
    ui_words_in(&page->frame,
                (struct ui_box){ box.x + margin, box.y, box.width - 2.0f * margin, box.height },
                &style, button->words);
}

static void draw_lab_sign(const struct lab_page *page, struct ui_box box, enum text_key key)
{
    const struct ui_text style = lab_text(page, 30.0f, BUTTON_INK);
    ui_words_in(&page->frame, box, &style, ui_words(&page->frame, key));
}

static void arrow_button(const struct lab_page *page, enum lab_part part, enum text_key key)
{
    draw_lab_sign(page, draw_lab_tag(page, &(struct button){ .part = part }), key);
}

static void draw_lab_buttons(const struct lab_page *page)
{
    static const enum text_key templates[] = { TEXT_LAB_OWN, TEXT_LAB_ORDINARY, TEXT_LAB_PAIRWISE,
                                               TEXT_LAB_SIMULTANEOUS, TEXT_LAB_SMOOTH };
    const struct scene_lab *lab = page->lab;
    const uint8_t language = page->frame.language;
    const struct button words[] = {
        { LAB_LEAVE, text_words(language, TEXT_LAB_LEAVE), 0, 0 },
        { LAB_COMPARE, text_words(language, TEXT_LAB_COMPARE), lab->compare, 0 },
        { LAB_PATH, text_words(language, TEXT_LAB_PATH), lab->path, 0 },
        { LAB_RESET, text_words(language, TEXT_LAB_RESET), 0, lab->is_own },
    };
    for (size_t i = 0; i < sizeof words / sizeof *words; i++) {
        word_button(page, &words[i]);
    }
    for (uint32_t i = 0; i < TEMPLATE_COUNT; i++) {
        word_button(page, &(struct button){ .part = (enum lab_part)(LAB_OWN + i),
                                            .words = text_words(language, templates[i]),
                                            .is_on = lab->template_id == i });
    }
    const float u = page->frame.unit;
    const int plays = lab->playing;
    const struct ui_box box =
        draw_lab_tag(page, &(struct button){ .part = LAB_PLAY, .is_on = plays });
    const float x = box.x + 40.0f * u, y = box.y + 0.5f * box.height;
    if (plays) {
        for (uint32_t i = 0; i < 2u; i++) {
            const float at = x + ((float)i - 0.5f) * 14.0f * u;
            const float from[2] = { at, y - 9.0f * u }, to[2] = { at, y + 9.0f * u };
            ui_segment(page->frame.batch, from, to, 6.0f * u, BUTTON_INK);
        }
    } else {
        const struct ui_box place = { x - 20.0f * u, box.y, 40.0f * u, box.height };
        draw_lab_sign(page, place, TEXT_SIGN_ON);
    }
    const struct ui_text style = lab_text(page, 23.0f, BUTTON_INK);
    const struct ui_box room = { box.x + 64.0f * u, box.y, box.width - 76.0f * u, box.height };
    ui_words_in(&page->frame, room, &style,
                ui_words(&page->frame, plays ? TEXT_LAB_STOP : TEXT_LAB_PLAY));
    const enum text_key save_words = !lab->is_kept                 ? TEXT_LAB_SAVE
                                     : lab->keeping == LAB_SAVED   ? TEXT_LAB_SAVED
                                     : lab->keeping == LAB_SAVING  ? TEXT_LAB_SAVING
                                     : lab->keeping == LAB_UNSAVED ? TEXT_LAB_UNSAVED
                                                                   : TEXT_LAB_SAVE;
    word_button(page, &(struct button){ .part = LAB_SAVE,
                                        .words = text_words(language, save_words),
                                        .is_idle = lab->is_kept && lab->keeping != LAB_UNSAVED });
}

/* ---- Title and help line -------------------------------------------------------------------- */

static void name_plate(const struct lab_page *page)
{
    const float u = page->frame.unit;
    const struct scene_lab *lab = page->lab;
    const struct ui_box box = lab_place(page, LAB_NAME);
    const uint8_t language = page->frame.language;
    char of[24];
    snprintf(of, sizeof of, "%u / %u", lab->species + 1u, lab->species_count);
    ui_panel(&page->frame, UI_WASHI, box, 10.0f * u, 2.0f * u, LAB_PAPER, LAB_PAPER_LINE);
    const struct ui_text name = ui_style(&page->frame, FONT_STALL, 34.0f, 0.0f, LAB_INK, 0.0f);
    struct ui_text small = lab_text(page, 20.0f, LAB_INK_SOFT);
    const struct ui_box room = { box.x + 16.0f * u, box.y, box.width - 120.0f * u, box.height };
    ui_words_in(&page->frame, room, &name, lab_name(language, lab->card.id));
    small.align = 1.0f;
    ui_text_at(&page->frame, &small, box.x + box.width - 18.0f * u, box.y + 0.5f * box.height, of);
}

/* Returns the box of the help line. The box is beside the species' name, or above the name on a
 * tall upright screen. */
static struct ui_box line_room(const struct lab_page *page)
{
    const float u = page->frame.unit;
    const struct ui_box next = lab_place(page, LAB_NEXT), leave = lab_place(page, LAB_LEAVE);
    if (page->lab->upright) {
        const float high = page->y > 40.0f * u ? 32.0f * u : 0.0f;
        return (struct ui_box){ lab_px_x(page, 24.0f), page->y - 0.6f * high, 806.0f * u, high };
    }
    const float left = next.x + next.width + 18.0f * u;
    return (struct ui_box){ left, next.y, leave.x - left - 18.0f * u, next.height };
}

/* Draws the help line. Messages for the operator replace the help line in turn: the number of
 * rejected makers' files, then the reason for each rejected file. */
static void help_line(const struct lab_page *page)
{
    const struct ui_box room = line_room(page);
    const uint32_t counted = page->lab->refused > 0;
    const uint32_t faults = page->library != NULL ? library_fault_count(page->library) : 0u;
    const uint32_t turn = (uint32_t)(page->frame.time_s / TURN_S) % (1u + counted + faults);
    if (room.height <= 0.0f) {
        return;
    }
    if (turn == 0) {
        const struct ui_text style = lab_text(page, 20.0f, 0xc9d2eeffu);
        ui_words_in(&page->frame, room, &style, ui_words(&page->frame, TEXT_LAB_HELP));
    } else if (turn <= counted) {
        char words[TEXT_LINE_MAX];
        const struct ui_text refused_style = lab_text(page, 20.0f, REFUSED);
        text_number(words, sizeof words, ui_words(&page->frame, TEXT_LAB_REFUSED),
                    page->lab->refused);
        ui_words_in(&page->frame, room, &refused_style, words);
    } else {
        const struct library_line fault = library_fault(page->library, turn - 1u - counted);
        /* The reason for a rejected file is written below the name of the file. */
        const float half = 0.5f * room.height;
        const struct ui_box upper = { room.x, room.y, room.width, half };
        const struct ui_box lower = { room.x, room.y + half, room.width, half };
        struct ui_text fault_style = lab_text(page, 18.0f, REFUSED);
        fault_style.size_px = fminf(fault_style.size_px, 0.9f * half);
        ui_words_in(&page->frame, upper, &fault_style, fault.file);
        ui_words_in(&page->frame, lower, &fault_style, fault.why);
    }
}

/* ---- Whole page of the growth lab ----------------------------------------------------------- */

void ui_lab(const struct ui_frame *frame, const struct scene *scene, struct ui_memory *memory)
{
    /* A recording may show a maker's species that exists only on another kiosk. In this case
     * `species` is null, and the graphs are drawn without a fish. */
    const uint32_t index = scene->lab.species;
    const struct species *found = NULL;
    if (index < species_table_count) {
        found = species_table[index];
    } else if (memory->library != NULL && index < library_count(memory->library)) {
        found = library_species(memory->library, index);
    }
    const int fits = found != NULL && found->card.key_count == scene->lab.card.key_count &&
                     strcmp(found->card.id, scene->lab.card.id) == 0;
    const struct species *species = fits ? found : NULL;
    if (species != NULL) {
        ui_lab_preview_set(&memory->bench, species, &scene->lab.card);
    }
    const struct layout_point canvas = pointer_layout_size(scene->lab.upright);
    struct lab_page page = { .frame = *frame,
                             .lab = &scene->lab,
                             .bench = species != NULL ? &memory->bench : NULL,
                             .library = memory->library };
    /* On an upright screen, the scale of the canvas equals the camera's scale. */
    page.frame.unit = scene->lab.upright ? frame->width / canvas.x
                                         : fminf(frame->width / canvas.x, frame->height / canvas.y);
    page.x = 0.5f * (frame->width - canvas.x * page.frame.unit);
    page.y = 0.5f * (frame->height - canvas.y * page.frame.unit);
    const struct ui_box cloth = { 0.0f, 0.0f, frame->width, frame->height };
    ui_panel(frame, UI_PANEL, cloth, 0.0f, 0.0f, CLOTH_EDGE, 0);
    ui_panel(frame, UI_WAVES, cloth, 36.0f * page.frame.unit, 0.0f, CLOTH, 0);
    lab_stage(&page);
    lab_keys(&page);
    lab_graph(&page);
    lab_chart(&page);
    name_plate(&page);
    arrow_button(&page, LAB_BACK, TEXT_SIGN_BACK);
    arrow_button(&page, LAB_NEXT, TEXT_SIGN_ON);
    help_line(&page);
    draw_lab_buttons(&page);
    const struct scene_lab *lab = page.lab;
    const float u = page.frame.unit;
    if (!lab->has_hand) {
        return;
    }
    const float x = lab_px_x(&page, lab->x), y = lab_px_y(&page, lab->y);
    const float radius = (lab->presses ? 12.0f : 16.0f) * u;
    const struct ui_box glow = { x - 2.2f * radius, y - 2.2f * radius, 4.4f * radius,
                                 4.4f * radius };
    ui_glow(&page.frame, glow, lab->presses ? 0xff9a50a0u : 0xffffff38u);
    ui_poi_sign(&page.frame, x, y, radius, 0.0f, ui_player_colours[0]);
}
