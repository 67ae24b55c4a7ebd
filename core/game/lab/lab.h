/* lab.h -- the growth lab: a page that plays the growth of a species and edits its growth graph.
 *
 * A controller moves a pointer over the page (pointer_mapping.h). The pointer is pressed while the
 * controller's pose is below POINTER_PRESS_Y_M, which a mouse reaches by its button.
 *
 * LEFT and RIGHT change the displayed progress of the growth while they are held. A press of START
 * starts or stops the playback of the growth. If START is held for LAB_END_TICKS, the kiosk leaves
 * the lab. OK shows the next species.
 *
 * The lab has no score. In the lab, a key is a modelled growth stage of the species (key shape). */
#pragma once

#include <stdbool.h>
#include <stdint.h>

#include "core/game/game.h"
#include "core/output.h"

/* Opens the growth lab. The page shows the species that was displayed last, as a larva, and starts
 * the playback of its growth. */
void lab_begin(struct game *game, struct world *world, const struct core_config *config,
               struct output *output);
game_phase_tick lab_tick;

/* Fills `out` with the visible state of the lab. */
void lab_show(const struct lab *lab, const struct lab_book *book, struct scene_lab *out);

/* ---- Species, buttons and pointer ------------------------------------------------------------ */

/* Shows a species as a larva and starts the playback of its growth. Uses the saved edit if one
 * exists. */
void lab_take(struct lab *lab, const struct lab_book *book, uint32_t species);

/* Runs the action of the button or picture `part`, as if the player had pressed it. `part` must not
 * be LAB_LEAVE. */
void lab_use(struct lab *lab, const struct lab_book *book, enum lab_part part,
             struct output *output);

/* Handle the press of the pointer on a part of the page (lab_press), its motion while pressed
 * (lab_drag), and its release (lab_release). The button LAB_LEAVE acts when it is released, because
 * a pose that still moves down would count as a dip and open the lab again. lab_release() returns
 * true if the player leaves the lab. */
void lab_press(struct lab *lab, const struct lab_book *book, uint32_t tick, struct output *output);
void lab_drag(struct lab *lab, const struct lab_book *book);
bool lab_release(struct lab *lab, const struct lab_book *book);

/* Returns true if the displayed curves equal the species' original curves, which means that nothing
 * was edited. */
bool lab_is_own(const struct lab *lab, const struct lab_book *book);

/* ---- Album of the caught fish ---------------------------------------------------------------- */

/* The album after a round: shows the growth of each caught fish from hatching to old age.
 *
 * Every goldfish of the tank has its own age and appearance. The album shows the fish's life
 * before and after the catch. START or a dip starts the next game; OK turns the page. */

/* Adds the `count` fish that player `index` caught in this tick to the album. Fish beyond
 * ALBUM_FISH_MAX are counted but not stored. */
void album_note(struct album *album, const struct world *world, uint32_t index, uint32_t count);

/* Gives a fish as a present to each player whose round ends without a catch: the swimming fish that
 * is nearest to the player's bowl. The fish moves into the bowl and to the page of the album. If
 * the page is full, the present replaces the last fish that was caught. A present changes neither
 * the score nor the tickets. Does nothing in the replay of a recording older than format 9. */
void album_give_presents(struct album *album, const struct player player[POI_MAX],
                         struct world *world, const struct core_config *config);

/* Returns true if player `index` has a present in the album. */
bool album_has_present(const struct game *game, uint32_t index);

/* Enters the album phase and returns true. If the album is empty, changes nothing and returns
 * false. */
bool album_begin(struct game *game);
game_phase_tick album_tick;

/* Returns the number of ticks for which the album shows a page with `fish_count` fish. */
uint32_t album_ticks(uint32_t fish_count);

/* Fills `out` with the visible state of the album. Outside the album phase all fields of `out` are
 * 0. */
void album_show(const struct game *game, struct scene_album *out);
