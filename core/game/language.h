/* language.h -- the display language: the operator's setting is the default, and a visitor may
 * choose a different language for a while.
 *
 * A chosen language lasts until attract mode begins. A choice during attract mode lasts for
 * LANGUAGE_TICKS after the last press. Under the rules of format 7 a choice has no end. */
#ifndef KINGYO_CORE_GAME_LANGUAGE_H
#define KINGYO_CORE_GAME_LANGUAGE_H

#include <stdint.h>

#include "core/input.h"

/* Length of a cycle of attract mode, equal to AUDIO_OUTPUT_SHOW_S. */
#define LANGUAGE_TICKS (60u * CORE_TICK_HZ)

/* A visitor's choice, carried over to the next session. All zero: no choice. */
struct language_choice {
    uint32_t chosen;     /* enum language; 0 unless `until_tick` is set. */
    uint32_t until_tick; /* Tick in attract mode at which the choice ends; 0: no choice. */
};

struct game;
struct core_config;

/* Changes to the next language when the button is pressed. Ends a choice that has lasted for a
 * cycle of attract mode. */
void language_tick(struct game *game, const struct core_config *config, const struct input *input);

/* Returns to the operator's language at the start of attract mode. */
void language_return(struct game *game, const struct core_config *config);

/* Returns the visitor's choice in `core`, for the next session. */
struct language_choice language_kept(const struct game *game);

/* Returns `hash` continued over a choice; `hash` unchanged without a choice, as before the field
 * existed. */
uint64_t language_hash(uint64_t hash, const struct language_choice *choice);

#endif
