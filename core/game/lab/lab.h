/* lab.h -- the growth lab: a page that plays a species' life and edits its growth graph.
 *
 * A pose over the water points at the canvas (lab_layout.h) and presses while it is below the press
 * height. A mouse presses with its button. LEFT and RIGHT move through the life while they are
 * held. A short press of START plays the life; holding START leaves the lab. OK shows the next
 * species. The lab has no score. In the lab, a key is a modelled growth stage of the species (key
 * shape). */
#ifndef KINGYO_CORE_GAME_LAB_LAB_H
#define KINGYO_CORE_GAME_LAB_LAB_H

#include <stdint.h>

#include "core/game/lab/lab_state.h"
#include "core/output.h"

struct game;
struct world;
struct core_config;

/* Initializes `lab` with the saved edits in `config`. */
void lab_init(struct lab *lab, const struct core_config *config);

/* Opens the lab with the last shown species as a larva, and starts the playback. */
void lab_begin(struct game *game, struct world *world, const struct core_config *config,
               struct output *output);
void lab_tick(struct game *game, struct world *world, const struct core_config *config,
              const struct input *input, struct output *output);

/* Fills `out` with the visible state of the lab. */
void lab_show(const struct lab *lab, const struct lab_book *book, struct scene_lab *out);

uint64_t lab_hash_quick(uint64_t hash, const struct lab *lab); /* Returns `hash` continued over the
                                                                  lab without the saved edits. */
uint64_t lab_hash(uint64_t hash, const struct lab *lab);       /* Returns `hash` continued over the
                                                                  saved edits. */

/* ---- Pointer --------------------------------------------------------------------------------- */

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

/* ---- Album ----------------------------------------------------------------------------------- */

/* The album after a round: shows the growth of each caught fish from hatching to old age.
 *
 * Every goldfish of the tank has its own age and appearance. The album shows the fish's life
 * before and after the catch. START or a dip starts the next game; OK turns the page. */

/* Records that player `index` caught `count` fish, in the order of the catch. Fish beyond
 * ALBUM_FISH_MAX are counted but not stored. */
void album_note(struct album *album, const struct world *world, uint32_t index, uint32_t count);

/* Enters the album phase and returns 1. If the album is empty, changes nothing and returns 0. */
int album_begin(struct game *game);
void album_tick(struct game *game, struct world *world, const struct core_config *config,
                const struct input *input, struct output *output);

/* Returns the duration in ticks of a page with `fish_count` fish. */
uint32_t album_ticks(uint32_t fish_count);

/* Fills `out` with the visible state of the album. In other phases all fields of `out` are 0. */
void album_show(const struct game *game, struct scene_album *out);

uint64_t album_hash(uint64_t hash, const struct album *album);

#endif
