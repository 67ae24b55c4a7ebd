/* lab_press.h -- handles a press, a drag and a release of the pointer in the growth lab. Internal
 * to core/game. */
#ifndef KINGYO_CORE_GAME_LAB_LAB_PRESS_H
#define KINGYO_CORE_GAME_LAB_LAB_PRESS_H

#include "core/game/lab/lab_layout.h"
#include "core/output.h"

struct game;
struct lab;
struct world;
struct core_config;
struct lab_book;

/* Shows a species as a larva and starts the playback of its life. Uses the saved edit if one
 * exists. */
void lab_take(struct lab *lab, const struct lab_book *book, uint32_t species);

/* Activates `part` as if it was pressed. `part` must not be LAB_LEAVE. */
void lab_use(struct lab *lab, const struct lab_book *book, enum lab_part part,
             struct output *output);

/* Handle the pointer's press (lab_press), its motion while pressed (lab_drag), and its release
 * (lab_release). LAB_LEAVE acts on the release, because a pose that still moves down would count as
 * a dip and open the lab again. */
void lab_press(struct lab *lab, const struct lab_book *book, uint32_t tick, struct output *output);
void lab_drag(struct lab *lab, const struct lab_book *book);
void lab_release(struct game *game, struct world *world, const struct core_config *config);

/* lab_is_own() returns 1 if the current edit equals the species' original curves, otherwise 0.
 * lab_is_kept() returns 1 if the current edit equals the saved edit, otherwise 0. */
int lab_is_own(const struct lab *lab, const struct lab_book *book);
int lab_is_kept(const struct lab *lab, const struct lab_book *book);

#endif
