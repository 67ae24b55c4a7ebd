/* lab_press.c -- handles the buttons of the growth lab, and drags knots. */
#include "core/game/lab/lab_press.h"

#include "core/base/mem.h"
#include "core/game/game.h"
#include "core/poi/world.h"
#include "core/config.h"
#include "core/game/phases.h"

static const struct species_card *edited_card(const struct lab *lab, const struct lab_book *book)
{
    return lab_book_card(book, lab->species);
}

/* ---- Species and their edits ---------------------------------------------------------------- */

void lab_take(struct lab *lab, const struct lab_book *book, uint32_t species)
{
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
    lab->asked_id = 0;
    lab->holds = HOLD_BUTTON; /* While the pointer stays pressed, it must not drag a knot of the
                                 previous graph. */
    lab->held_knot = LAB_NO_KNOT;
}

int lab_is_own(const struct lab *lab, const struct lab_book *book)
{
    struct lab_edit own;
    lab_edit_own(&own, edited_card(lab, book));
    return lab_edit_same(&lab->edit, &own);
}

int lab_is_kept(const struct lab *lab, const struct lab_book *book)
{
    return lab->has_edit[lab->species] ? lab_edit_same(&lab->edit, &lab->edits[lab->species])
                                       : lab_is_own(lab, book);
}

/* Requests saving of the current edit. If the edit equals the species' original curves, the saved
 * edit is deleted, and the next start loads no edit. */
static void save(struct lab *lab, const struct lab_book *book, struct output *output)
{
    const struct species_card *card = edited_card(lab, book);
    lab->edits[lab->species] = lab->edit;
    lab->has_edit[lab->species] = (uint8_t)!lab_is_own(lab, book);
    lab->asked_id = ++lab->save_id;
    output->edit = (struct graph_edit_record){ .id = lab->save_id,
                                               .is_own = (uint8_t)!lab->has_edit[lab->species],
                                               .key_count = card->key_count,
                                               .edit = lab->edit };
    memcpy(output->edit.species, card->id, sizeof output->edit.species);
}

static void reset(struct lab *lab, const struct lab_book *book)
{
    lab_edit_own(&lab->edit, edited_card(lab, book));
}

/* ---- Buttons -------------------------------------------------------------------------------- */

static void turn_page(struct lab *lab, const struct lab_book *book, uint32_t steps)
{
    const uint32_t count = lab_book_count(book);
    lab_take(lab, book, (lab->species + steps) % count);
}

static void add_knot(struct lab *lab, const struct lab_book *book)
{
    const struct species_card *card = edited_card(lab, book);
    struct lab_edit more = lab->edit;
    if (lab->layer == LAB_LAYER_SIZE) {
        lab_edit_size_add(&more, card, lab->progress);
    } else {
        lab_edit_add(&more, card->key_count, lab->progress);
    }
    if (lab_edit_is_valid(&more, card)) {
        lab->edit = more;
    }
}

/* Removes the nearest knot, unless the graph would be invalid without that knot. */
static void remove_knot(struct lab *lab, const struct lab_book *book)
{
    struct lab_edit less = lab->edit;
    if (lab->layer == LAB_LAYER_SIZE) {
        lab_edit_size_remove(&less, edited_card(lab, book), lab->progress);
    } else {
        lab_edit_remove(&less, lab->progress);
    }
    if (lab_edit_is_valid(&less, edited_card(lab, book))) {
        lab->edit = less;
    }
}

static void play_or_stop(struct lab *lab)
{
    lab->playing = !lab->playing;
    if (lab->playing && lab->progress >= 1.0f) {
        lab->progress = 0.0f;
        lab->rest_ticks = 0;
    }
}

/* Moves to the key's age and selects its curve for editing. */
static void go_to_key(struct lab *lab, const struct lab_book *book, uint32_t key)
{
    lab->layer = (uint8_t)key;
    lab->playing = 0;
    lab->rest_ticks = 0;
    lab->progress = (float)key / (float)(edited_card(lab, book)->key_count - 1u);
}

static void use_tool(struct lab *lab, const struct lab_book *book, enum lab_part part,
                     struct output *output)
{
    switch (part) {
    case LAB_BACK:
        turn_page(lab, book, lab_book_count(book) - 1u);
        break;
    case LAB_NEXT:
        turn_page(lab, book, 1u);
        break;
    case LAB_PLAY:
        play_or_stop(lab);
        break;
    case LAB_COMPARE:
        lab->compare = !lab->compare;
        break;
    case LAB_PATH:
        lab->path = !lab->path;
        break;
    case LAB_ADD:
        add_knot(lab, book);
        break;
    case LAB_REMOVE:
        remove_knot(lab, book);
        break;
    case LAB_SIZE:
        lab->layer = lab->layer == LAB_LAYER_SIZE ? 0 : LAB_LAYER_SIZE;
        break;
    case LAB_SAVE:
        save(lab, book, output);
        break;
    case LAB_RESET:
        reset(lab, book);
        break;
    default:
        break;
    }
}

void lab_use(struct lab *lab, const struct lab_book *book, enum lab_part part,
             struct output *output)
{
    output_sound(output, SOUND_CHOOSE, 0.6f, 0.0f);
    if (part >= LAB_OWN && part <= LAB_SMOOTH) {
        lab_edit_template(&lab->edit, edited_card(lab, book),
                          (enum graph_template)((int)part - LAB_OWN + TEMPLATE_OWN));
    } else if (part >= LAB_KEY && part <= LAB_KEY_LAST) {
        go_to_key(lab, book, (uint32_t)part - LAB_KEY);
    } else {
        use_tool(lab, book, part, output);
    }
}

/* ---- Knots ---------------------------------------------------------------------------------- */

static struct layout_box plot_of(const struct lab *lab, const struct species_card *card)
{
    return lab_box(lab->upright, card->key_count, LAB_PLOT);
}

static float away2(const struct lab *lab, struct layout_box plot, float progress, float share)
{
    const float x = plot.x + progress * plot.width - lab->x;
    const float y = plot.y + (1.0f - share) * plot.height - lab->y;
    return x * x + y * y;
}

/* Returns the index of the scale knot under the pointer, or LAB_NO_KNOT. */
static uint32_t size_knot_at(const struct lab *lab, const struct species_card *card)
{
    const struct layout_box plot = plot_of(lab, card);
    struct scale_knot knots[GRAPH_KNOT_MAX];
    const uint32_t count = lab_edit_scale_knots(&lab->edit, card, knots);
    uint32_t found = LAB_NO_KNOT;
    float least = LAB_GRAB * LAB_GRAB;
    for (uint32_t i = 0; i < count; i++) {
        const float share = lab_length_share(card, knots[i].length_m);
        const float away = away2(lab, plot, knots[i].progress, share);
        if (away < least) {
            found = i;
            least = away;
        }
    }
    return found;
}

/* Returns the index of the weight knot under the pointer, or LAB_NO_KNOT. If knots of several keys
 * overlap, the knot of the selected key is preferred. */
static uint32_t weight_knot_at(const struct lab *lab, const struct species_card *card,
                               uint32_t *key)
{
    const struct layout_box plot = plot_of(lab, card);
    const struct graph *graph = &lab->edit.graph;
    uint32_t found = LAB_NO_KNOT;
    float least = LAB_GRAB * LAB_GRAB;
    for (uint32_t i = 0; i < graph->knot_count; i++) {
        for (uint32_t k = 0; k < card->key_count; k++) {
            const float ease = k == lab->layer ? 0.25f : 1.0f;
            const float away =
                ease * away2(lab, plot, graph->knots[i].progress, graph->knots[i].weight[k]);
            if (away < least) {
                found = i;
                *key = k;
                least = away;
            }
        }
    }
    return found;
}

static void grab_in_plot(struct lab *lab, const struct species_card *card)
{
    uint32_t key = 0;
    const int of_size = lab->layer == LAB_LAYER_SIZE;
    const uint32_t knot = of_size ? size_knot_at(lab, card) : weight_knot_at(lab, card, &key);
    lab->held_knot = (uint8_t)knot;
    lab->holds = HOLD_PLOT;
    if (knot != LAB_NO_KNOT) {
        lab->holds = of_size ? HOLD_SIZE : HOLD_WEIGHT;
        lab->layer = of_size ? lab->layer : (uint8_t)key;
    }
}

/* ---- The pointer ---------------------------------------------------------------------------- */

static void scrub_to(struct lab *lab, float progress)
{
    lab->progress = f_clamp(progress, 0.0f, 1.0f);
    lab->rest_ticks = 0;
    lab->playing = 0;
}

/* Drags a knot of a weight curve. If the new position would make the graph invalid, the knot keeps
 * its last valid position. */
static void drag_weight(struct lab *lab, const struct species_card *card, struct layout_point at)
{
    const uint32_t knot = lab->held_knot;
    struct lab_edit moved = lab->edit;
    lab_edit_move(&moved, knot, at.x);
    lab_edit_weigh(&moved, card->key_count, knot, lab->layer, at.y);
    if (lab_edit_is_valid(&moved, card)) {
        lab->edit = moved;
    }
    scrub_to(lab, lab->edit.graph.knots[knot].progress);
}

static void drag_size(struct lab *lab, const struct species_card *card, struct layout_point at)
{
    const uint32_t knot = lab->held_knot;
    lab_edit_size_move(&lab->edit, card, knot, at.x);
    lab_edit_size(&lab->edit, card, knot, lab_length_of_share(card, f_clamp(at.y, 0.0f, 1.0f)));
    scrub_to(lab, lab->edit.scale_knots[knot].progress);
}

/* Returns the pointer position in a field, as shares of its width and height. The origin is the
 * field's lower left corner. */
static struct layout_point pointer_share_of(const struct lab *lab, struct layout_box field)
{
    return (struct layout_point){ (lab->x - field.x) / field.width,
                                  1.0f - (lab->y - field.y) / field.height };
}

/* Returns the progress at the pointer on the growth curve. The horizontal axis is the age, from
 * hatching to the age of the last key. */
static float charted_progress(const struct lab *lab, const struct species_card *card)
{
    const struct layout_box chart = lab_box(lab->upright, card->key_count, LAB_CHART);
    const float share = f_clamp(pointer_share_of(lab, chart).x, 0.0f, 1.0f);
    return life_progress(card, share * card->key_age_days[card->key_count - 1u]);
}

void lab_drag(struct lab *lab, const struct lab_book *book)
{
    const struct species_card *card = edited_card(lab, book);
    const struct layout_point at = pointer_share_of(lab, plot_of(lab, card));
    switch (lab->holds) {
    case HOLD_AGE:
        scrub_to(lab, lab_age_progress(lab->upright, card->key_count, lab->x));
        break;
    case HOLD_CHART:
        scrub_to(lab, charted_progress(lab, card));
        break;
    case HOLD_PLOT:
        scrub_to(lab, at.x);
        break;
    case HOLD_WEIGHT:
        drag_weight(lab, card, at);
        break;
    case HOLD_SIZE:
        drag_size(lab, card, at);
        break;
    default:
        break;
    }
}

static void point(struct lab *lab, const struct species_card *card)
{
    const struct layout_point at = { lab->x, lab->y };
    lab->points = (uint8_t)lab_part_at(lab->upright, card->key_count, at);
}

void lab_press(struct lab *lab, const struct lab_book *book, uint32_t tick, struct output *output)
{
    const struct species_card *card = edited_card(lab, book);
    point(lab, card);
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

void lab_release(struct game *game, struct world *world, const struct core_config *config)
{
    struct lab *lab = &game->lab;
    const int leaves = lab->holds == HOLD_LEAVE && lab->has_hand;
    lab->holds = HOLD_NOTHING;
    lab->held_knot = LAB_NO_KNOT;
    if (lab->has_hand) {
        point(lab, edited_card(&game->lab, &config->book));
    } else {
        lab->points = LAB_NOTHING;
    }
    if (leaves) {
        attract_begin(game, world, config);
    }
}
