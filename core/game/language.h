/* language.h -- the display language. The operator's setting is the default, and a visitor may
 * choose a different language for a limited time.
 *
 * A language chosen during a game lasts until attract mode begins. A language chosen in attract
 * mode lasts for LANGUAGE_TICKS after the last press. Under the rules of format 7 a choice does not
 * end. */
#ifndef KINGYO_CORE_GAME_LANGUAGE_H
#define KINGYO_CORE_GAME_LANGUAGE_H

#include <stdint.h>

#include "core/input.h"

/* Length of one loop of attract mode, equal to AUDIO_OUTPUT_SHOW_S. */
#define LANGUAGE_TICKS (60u * CORE_TICK_HZ)

/* Language chosen by a visitor, carried over to the next session. All fields are 0 if no visitor
 * chose a language. */
struct language_choice {
    uint32_t chosen;     /* Chosen language (enum language); 0 unless `until_tick` is set. */
    uint32_t until_tick; /* Tick in attract mode at which the choice ends; 0 means no choice. */
};

struct game;
struct core_config;

/* Changes to the next language when the LANGUAGE button is pressed. Ends a choice after
 * LANGUAGE_TICKS in attract mode. */
void language_tick(struct game *game, const struct core_config *config, const struct input *input);

/* Resets the display to the operator's language at the start of attract mode. */
void language_return(struct game *game, const struct core_config *config);

/* Returns the visitor's choice in `game`, for the next session. */
struct language_choice language_kept(const struct game *game);

/* Returns `hash` continued over `choice`. Without a choice `hash` is returned unchanged, so that
 * hashes of older recordings stay valid. */
uint64_t language_hash(uint64_t hash, const struct language_choice *choice);

#endif
