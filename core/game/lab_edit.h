/* lab_edit.h -- a deformation graph under somebody's hands: knots are dragged, added, taken away.
 *
 * Whatever is done, the graph stays one: knots from progress 0 to 1, rising; at each the weights
 * are >= 0 and sum to 1 (2005 thesis, eq. 3.2 and figure 3.7). Pure. */
#ifndef KINGYO_CORE_GAME_LAB_EDIT_H
#define KINGYO_CORE_GAME_LAB_EDIT_H

#include "core/edit.h"
#include "core/morph/morph.h"

#define LAB_KNOT_GAP 0.02f /* Knots keep so far apart: a fiftieth of a life. */
#define LAB_NO_KNOT 255u

/* The species' own. */
void lab_edit_own(struct lab_edit *edit, const struct species_card *card);

/* Another template's graph; size stays as it is. */
void lab_edit_template(struct lab_edit *edit, const struct species_card *card,
                       enum graph_template template);

/* The species as edited: what is blended and measured from then on. `out` may not be `card`. */
void lab_edit_apply(const struct lab_edit *edit, const struct species_card *card,
                    struct species_card *out);

/* Whether it is one of `card`: its graph is good and its scale knots rise from 0 to 1, each length
 * within LAB_LENGTH_MIN_M .. _MAX_M. */
bool lab_edit_is_good(const struct lab_edit *edit, const struct species_card *card);

/* Whether two blend and measure alike. */
bool lab_edit_same(const struct lab_edit *a, const struct lab_edit *b);

#define LAB_LENGTH_MIN_M 0.0002f /* No fish hatches smaller, ... */
#define LAB_LENGTH_MAX_M 20.0f   /* ... and none grows longer: a whale shark. */

/* ---- Weights ---- */

/* Gives `key` that weight, clamped to [0, 1], at `knot`; the others share the rest in proportion,
 * or its neighbours halve it where the others had nothing. */
void lab_edit_weigh(struct lab_edit *edit, uint32_t key_count, uint32_t knot, uint32_t key,
                    float weight);

/* Moves an inner knot along the life, between its neighbours; the first and the last stay. */
void lab_edit_move(struct lab_edit *edit, uint32_t knot, float progress);

/* A new knot on the curve as it runs: nothing moves yet where lines are straight. Returns its
 * index, or LAB_NO_KNOT when there is no room, in the table or between two knots. */
uint32_t lab_edit_add(struct lab_edit *edit, uint32_t key_count, float progress);

/* Takes away the inner knot nearest to `progress`. Returns whether there was one. */
bool lab_edit_remove(struct lab_edit *edit, float progress);

/* ---- Scale ---- */

/* The scale knots as shown: those drawn by hand, or one a key on the growth curve and,
 * between two keys where it turns round (a conger's least length), one at each of its measured
 * points and between those far apart. Returns how many. */
uint32_t lab_edit_scale_knots(const struct lab_edit *edit, const struct species_card *card,
                              struct scale_knot out[GRAPH_KNOT_MAX]);

/* As lab_edit_weigh, lab_edit_move, .._add and .._remove, of the scale. The first touch draws the
 * growth curve's own knots by hand; `card` is the species' own. */
void lab_edit_size(struct lab_edit *edit, const struct species_card *card, uint32_t knot,
                   float length_m);
void lab_edit_size_move(struct lab_edit *edit, const struct species_card *card, uint32_t knot,
                        float progress);
uint32_t lab_edit_size_add(struct lab_edit *edit, const struct species_card *card, float progress);
bool lab_edit_size_remove(struct lab_edit *edit, const struct species_card *card, float progress);

/* A graph's right-hand axis: lengths by their logarithm, from half of the smallest key's to twice
 * the greatest's. The share of the axis of a length, unclamped; and back. */
float lab_length_share(const struct species_card *card, float length_m);
float lab_length_of_share(const struct species_card *card, float share);

#endif
