/* lab_edit.h -- edits a deformation graph: drags, adds and removes knots.
 *
 * A knot is a value of progress, which is a position in the fish's growth from 0 to 1, and the
 * weight of each key shape at this progress. Every function keeps the graph valid: the progress
 * rises from 0 at the first knot to 1 at the last knot, and at each knot the weights are >= 0 and
 * sum to 1 (2005 thesis, eq. 3.2 and figure 3.7). The functions have no side effects outside their
 * arguments. */
#pragma once

#include <stdbool.h>
#include <stdint.h>

#include "core/output.h"
#include "core/morph/morph.h"

/* Smallest difference in progress between two neighbouring knots: a fiftieth of the whole
 * growth. */
#define LAB_KNOT_GAP 0.02f
#define LAB_NO_KNOT 255u

/* Resets `edit` to the original, unedited curves of the species `card`. */
void lab_edit_own(struct lab_edit *edit, const struct species_card *card);

/* Replaces the graph of `edit` with the graph of a template. The scale curve stays unchanged. */
void lab_edit_template(struct lab_edit *edit, const struct species_card *card,
                       enum graph_template template_id);

/* Writes a copy of `card` with the edited curves to `out`. The copy gives the edited shape and
 * length of the fish at each age. `out` must not be `card`. */
void lab_edit_apply(const struct lab_edit *edit, const struct species_card *card,
                    struct species_card *out);

/* Returns true if `edit` is valid for `card`, otherwise false. The graph of `edit` must be valid,
 * the progress of its scale knots must rise from 0 to 1, and each length must be within
 * LAB_LENGTH_MIN_M .. LAB_LENGTH_MAX_M. */
bool lab_edit_is_valid(const struct lab_edit *edit, const struct species_card *card);

/* Returns true if both edits give the same shapes and lengths. */
bool lab_edit_same(const struct lab_edit *a, const struct lab_edit *b);

/* Shortest allowed length of a fish, shorter than any fish at hatching. */
#define LAB_LENGTH_MIN_M 0.0002f
/* Longest allowed length of a fish, longer than the longest fish (a whale shark). */
#define LAB_LENGTH_MAX_M 20.0f

/* ---- Weights of the key shapes ---- */

/* Sets the weight of the key shape `key` at the knot `knot`, clamped to [0, 1]. The other keys
 * receive the remaining weight in proportion to their present weights. If their present weights are
 * all 0, each neighbour of `key` receives half of the remaining weight. */
void lab_edit_weigh(struct lab_edit *edit, uint32_t key_count, uint32_t knot, uint32_t key,
                    float weight);

/* Moves an inner knot to `progress`, but not past its neighbouring knots. The first and the last
 * knot do not move. */
void lab_edit_move(struct lab_edit *edit, uint32_t knot, float progress);

/* Adds a knot at `progress` with the graph's weights at this progress. The new knot does not change
 * a graph that is linear between its knots (GRAPH_STRAIGHT). Returns the index of the knot, or
 * LAB_NO_KNOT if the table is full or a neighbouring knot is nearer than LAB_KNOT_GAP. */
uint32_t lab_edit_add(struct lab_edit *edit, uint32_t key_count, float progress);

/* Removes the inner knot nearest to `progress`. Returns false if no inner knot exists. */
bool lab_edit_remove(struct lab_edit *edit, float progress);

/* ---- Scale curve, which gives the fish's length ---- */

/* Writes the displayed knots of the scale curve to `out` and returns their number. If the scale
 * curve was edited, the displayed knots are the knots in `edit`. Otherwise the function computes
 * the knots from the growth curve, with one knot for each key. More knots are added between two
 * keys if the fish both grows and shrinks there, as a conger does. More knots are also added
 * between distant knots. */
uint32_t lab_edit_scale_knots(const struct lab_edit *edit, const struct species_card *card,
                              struct scale_knot out[GRAPH_KNOT_MAX]);

/* These four functions edit the knots of the scale curve in the same way as lab_edit_weigh(),
 * lab_edit_move(), lab_edit_add() and lab_edit_remove() edit the knots of the graph. The first
 * change copies the displayed scale knots to `edit`. `card` is the unedited species. */
void lab_edit_size(struct lab_edit *edit, const struct species_card *card, uint32_t knot,
                   float length_m);
void lab_edit_size_move(struct lab_edit *edit, const struct species_card *card, uint32_t knot,
                        float progress);
uint32_t lab_edit_size_add(struct lab_edit *edit, const struct species_card *card, float progress);
bool lab_edit_size_remove(struct lab_edit *edit, const struct species_card *card, float progress);

/* lab_length_share() converts a length to its position on the graph's right axis, where 0 is the
 * lower end and 1 the upper end. lab_length_of_share() converts a position to a length. The axis is
 * logarithmic, from half of the smallest key length to twice the largest. The position is not
 * clamped. */
float lab_length_share(const struct species_card *card, float length_m);
float lab_length_of_share(const struct species_card *card, float share);

/* ---- Lab book: species and saved edits ------------------------------------------------------- */

/* The lab book: the species data of a kiosk, consisting of custom species and of the graphs saved
 * in the growth lab. The lab book is plain data, loaded from the data folder at startup. */

struct lab_book {
    /* Number of custom species. The custom species have the indices after the built-in species. */
    uint8_t card_count;
    /* Number of species files that were rejected, displayed to the operator. */
    uint8_t refused;
    /* 1 for each species for which an edited graph was saved, otherwise 0. The built-in species
     * come first, then the custom species. */
    uint8_t has_edit[SPECIES_MAX];
    struct species_card cards[SPECIES_EXTRA_MAX];
    struct lab_edit edits[SPECIES_MAX];
};

/* lab_book_count() returns the number of species. lab_book_card() returns the card of species
 * `species`, which must be below that number. */
uint32_t lab_book_count(const struct lab_book *book);
const struct species_card *lab_book_card(const struct lab_book *book, uint32_t species);

/* Returns true if all data is valid (lab_book.c). Each number of a custom card must be in the
 * range that packed species files permit. Each saved graph must match its species. */
bool lab_book_is_valid(const struct lab_book *book);
