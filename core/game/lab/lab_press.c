/* lab_press.c -- handles the buttons of the growth lab, and drags the knots (control points) of the
 * curves. */
#include "core/game/lab/lab.h"

#include "core/base/mem.h"
#include "core/base/panic.h"

static const struct species_card *edited_card(const struct lab *lab, const struct lab_book *book)
{
    CORE_ASSERT(lab->species < SPECIES_MAX);
    return lab_book_card(book, lab->species);
}

/* ---- Display of a species and of its edits --------------------------------------------------- */

void lab_take(struct lab *lab, const struct lab_book *book, uint32_t species)
{
    CORE_ASSERT(species < lab_book_count(book));
    lab->species = (uint8_t)species;
    const struct species_card *card = edited_card(lab, book);
    if (lab->has_edit[species]) {
        lab->edit = lab->edits[species];
    } else {
        lab_edit_own(&lab->edit, card);
    }
    lab->layer = 0;
    lab->progress = 0.0f;
    lab->rest_ticks = 0;
    lab->playing = 1;
    lab->requested_id = 0;
    /* Treat the press as a press on a button, so that the pointer does not drag a knot of the
     * previous graph. */
    lab->holds = HOLD_BUTTON;
    lab->held_knot = LAB_NO_KNOT;
}

bool lab_is_own(const struct lab *lab, const struct lab_book *book)
{
    struct lab_edit own;
    lab_edit_own(&own, edited_card(lab, book));
    return lab_edit_same(&lab->edit, &own);
}

/* ---- Buttons on the page -------------------------------------------------------------------- */

/* Asks the store to save the displayed edit. If the edit equals the species' original curves, the
 * saved edit is deleted, and the next start loads no edit. */
static void save(struct lab *lab, const struct lab_book *book, struct output *output)
{
    CORE_ASSERT(lab->species < SPECIES_MAX);
    const struct species_card *card = edited_card(lab, book);
    lab->edits[lab->species] = lab->edit;
    lab->has_edit[lab->species] = (uint8_t)!lab_is_own(lab, book);
    lab->requested_id = ++lab->save_id;
    output->edit = (struct graph_edit_record){ .id = lab->save_id,
                                               .is_own = (uint8_t)!lab->has_edit[lab->species],
                                               .key_count = card->key_count,
                                               .edit = lab->edit };
    memcpy(output->edit.species, card->id, sizeof output->edit.species);
}

/* Adds a knot (control point) to the edited curve at the displayed progress if `adds` is true,
 * otherwise removes the nearest knot. A change that would make the graph invalid is discarded. */
static void change_knots(struct lab *lab, const struct lab_book *book, bool adds)
{
    CORE_ASSERT(lab->layer <= LAB_LAYER_SIZE);
    const struct species_card *card = edited_card(lab, book);
    struct lab_edit changed = lab->edit;
    if (lab->layer == LAB_LAYER_SIZE && adds) {
        lab_edit_size_add(&changed, card, lab->progress);
    } else if (lab->layer == LAB_LAYER_SIZE) {
        lab_edit_size_remove(&changed, card, lab->progress);
    } else if (adds) {
        lab_edit_add(&changed, card->key_count, lab->progress);
    } else {
        lab_edit_remove(&changed, lab->progress);
    }
    if (lab_edit_is_valid(&changed, card)) {
        lab->edit = changed;
    }
}

static void use_tool(struct lab *lab, const struct lab_book *book, enum lab_part part,
                     struct output *output)
{
    const uint32_t count = lab_book_count(book);
    switch (part) {
    case LAB_BACK:
        lab_take(lab, book, (lab->species + count - 1u) % count);
        break;
    case LAB_NEXT:
        lab_take(lab, book, (lab->species + 1u) % count);
        break;
    case LAB_PLAY:
        lab->playing = !lab->playing;
        if (lab->playing && lab->progress >= 1.0f) {
            lab->progress = 0.0f;
            lab->rest_ticks = 0;
        }
        break;
    case LAB_COMPARE:
        lab->compare = !lab->compare;
        break;
    case LAB_PATH:
        lab->path = !lab->path;
        break;
    case LAB_ADD:
    case LAB_REMOVE:
        change_knots(lab, book, part == LAB_ADD);
        break;
    case LAB_SIZE:
        lab->layer = lab->layer == LAB_LAYER_SIZE ? 0 : LAB_LAYER_SIZE;
        break;
    case LAB_SAVE:
        save(lab, book, output);
        break;
    case LAB_RESET:
        lab_edit_own(&lab->edit, edited_card(lab, book));
        break;
    default:
        break;
    }
}

void lab_use(struct lab *lab, const struct lab_book *book, enum lab_part part,
             struct output *output)
{
    CORE_ASSERT(part < LAB_PRESSED_COUNT && part != LAB_LEAVE);
    output_sound(output, SOUND_CHOOSE, 0.6f, 0.0f);
    if (part >= LAB_OWN && part <= LAB_SMOOTH) {
        lab_edit_template(&lab->edit, edited_card(lab, book),
                          (enum graph_template)((int)part - LAB_OWN + TEMPLATE_OWN));
    } else if (part >= LAB_KEY && part <= LAB_KEY_LAST) {
        /* A press on the picture of a key shape moves to the key's age and selects its curve for
         * editing. */
        const uint32_t key = (uint32_t)part - LAB_KEY;
        lab->layer = (uint8_t)key;
        lab->playing = 0;
        lab->rest_ticks = 0;
        lab->progress = (float)key / (float)(edited_card(lab, book)->key_count - 1u);
    } else {
        use_tool(lab, book, part, output);
    }
}

/* ---- Grabbing of knots by the pointer -------------------------------------------------------- */

/* Returns the squared distance on the canvas from the pointer to a knot in the plot. */
static float away2(const struct lab *lab, struct layout_box plot, float progress, float share)
{
    const float x = plot.x + progress * plot.width - lab->x;
    const float y = plot.y + (1.0f - share) * plot.height - lab->y;
    return x * x + y * y;
}

/* Grabs the knot under the pointer. If weight knots of several keys overlap, the knot of the
 * selected key is preferred. */
static void grab_in_plot(struct lab *lab, const struct species_card *card)
{
    CORE_ASSERT(lab->layer <= LAB_LAYER_SIZE);
    const struct layout_box plot = lab_box(lab->upright, card->key_count, LAB_PLOT);
    const struct graph *graph = &lab->edit.graph;
    float least = LAB_GRAB * LAB_GRAB;
    lab->held_knot = LAB_NO_KNOT;
    lab->holds = HOLD_PLOT;
    if (lab->layer == LAB_LAYER_SIZE) {
        struct scale_knot knots[GRAPH_KNOT_MAX];
        const uint32_t count = lab_edit_scale_knots(&lab->edit, card, knots);
        for (uint32_t i = 0; i < count; i++) {
            const float share = lab_length_share(card, knots[i].length_m);
            const float away = away2(lab, plot, knots[i].progress, share);
            if (away < least) {
                lab->held_knot = (uint8_t)i;
                lab->holds = HOLD_SIZE;
                least = away;
            }
        }
        return;
    }
    const uint8_t selected = lab->layer;
    for (uint32_t i = 0; i < graph->knot_count; i++) {
        for (uint32_t k = 0; k < card->key_count; k++) {
            const float ease = k == selected ? 0.25f : 1.0f;
            const float away =
                ease * away2(lab, plot, graph->knots[i].progress, graph->knots[i].weight[k]);
            if (away < least) {
                lab->held_knot = (uint8_t)i;
                lab->holds = HOLD_WEIGHT;
                lab->layer = (uint8_t)k;
                least = away;
            }
        }
    }
}

/* ---- Drags, presses and releases of the pointer --------------------------------------------- */

static void scrub_to(struct lab *lab, float progress)
{
    CORE_ASSERT(f_is_finite(progress));
    lab->progress = f_clamp(progress, 0.0f, 1.0f);
    lab->rest_ticks = 0;
    lab->playing = 0;
}

/* Returns the pointer position in a field, as fractions of its width and height. The origin is the
 * field's lower left corner. */
static struct layout_point pointer_share_of(const struct lab *lab, struct layout_box field)
{
    return (struct layout_point){ (lab->x - field.x) / field.width,
                                  1.0f - (lab->y - field.y) / field.height };
}

/* Moves the grabbed knot to the pointer's place `at` in the plot. If the new place would make the
 * graph of the weights invalid, the knot keeps its last valid place. */
static void drag_knot(struct lab *lab, const struct species_card *card, struct layout_point at)
{
    const uint32_t knot = lab->held_knot;
    struct lab_edit *edit = &lab->edit;
    CORE_ASSERT(lab->holds == HOLD_SIZE || lab->holds == HOLD_WEIGHT);
    if (lab->holds == HOLD_SIZE) {
        lab_edit_size_move(edit, card, knot, at.x);
        lab_edit_size(edit, card, knot, lab_length_of_share(card, f_clamp(at.y, 0.0f, 1.0f)));
        scrub_to(lab, edit->scale_knots[knot].progress);
        return;
    }
    struct lab_edit moved = *edit;
    lab_edit_move(&moved, knot, at.x);
    lab_edit_weigh(&moved, card->key_count, knot, lab->layer, at.y);
    if (lab_edit_is_valid(&moved, card)) {
        *edit = moved;
    }
    scrub_to(lab, edit->graph.knots[knot].progress);
}

void lab_drag(struct lab *lab, const struct lab_book *book)
{
    const struct species_card *card = edited_card(lab, book);
    const uint32_t key_count = card->key_count;
    const struct layout_point at =
        pointer_share_of(lab, lab_box(lab->upright, key_count, LAB_PLOT));
    switch (lab->holds) {
    case HOLD_AGE:
        scrub_to(lab, lab_age_progress(lab->upright, key_count, lab->x));
        break;
    case HOLD_CHART: { /* The horizontal axis of the growth chart is the age, from hatching to
                          the age of the last key. */
        const struct layout_box chart = lab_box(lab->upright, key_count, LAB_CHART);
        const float share = f_clamp(pointer_share_of(lab, chart).x, 0.0f, 1.0f);
        scrub_to(lab, life_progress(card, share * card->key_age_days[key_count - 1u]));
        break;
    }
    case HOLD_PLOT:
        scrub_to(lab, at.x);
        break;
    case HOLD_WEIGHT:
    case HOLD_SIZE:
        drag_knot(lab, card, at);
        break;
    default:
        break;
    }
}

static void point_at_lab_part(struct lab *lab, const struct species_card *card)
{
    const struct layout_point at = { lab->x, lab->y };
    lab->points = (uint8_t)lab_part_at(lab->upright, card->key_count, at);
}

void lab_press(struct lab *lab, const struct lab_book *book, uint32_t tick, struct output *output)
{
    CORE_ASSERT(lab->has_pointer);
    const struct species_card *card = edited_card(lab, book);
    point_at_lab_part(lab, card);
    lab->act_tick = lab->stir_tick = tick;
    lab->holds = HOLD_BUTTON;
    switch (lab->points) {
    case LAB_AGE:
        lab->holds = HOLD_AGE;
        break;
    case LAB_CHART:
        lab->holds = HOLD_CHART;
        break;
    case LAB_PLOT:
        grab_in_plot(lab, card);
        break;
    case LAB_NOTHING:
        break;
    case LAB_LEAVE:
        lab->holds = HOLD_LEAVE;
        output_sound(output, SOUND_CHOOSE, 0.6f, 0.0f);
        break;
    default:
        lab_use(lab, book, (enum lab_part)lab->points, output);
        return;
    }
    lab_drag(lab, book);
}

bool lab_release(struct lab *lab, const struct lab_book *book)
{
    const bool leaves = lab->holds == HOLD_LEAVE && lab->has_pointer;
    lab->holds = HOLD_NOTHING;
    lab->held_knot = LAB_NO_KNOT;
    if (lab->has_pointer) {
        point_at_lab_part(lab, edited_card(lab, book));
    } else {
        lab->points = LAB_NOTHING;
    }
    return leaves;
}
