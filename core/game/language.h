/* language.h -- the language of the stall: the operator's setting is the default, and a visitor
 * chooses another one for a while.
 *
 * A chosen language lasts until attract begins. A choice in attract itself lasts for
 * LANGUAGE_TICKS after the last press. Under the rules of format 7 a choice has no end. */
#ifndef KINGYO_CORE_GAME_LANGUAGE_H
#define KINGYO_CORE_GAME_LANGUAGE_H

#include <stdint.h>

#include "core/input.h"

#define LANGUAGE_TICKS (60u * CORE_TICK_HZ) /* One cycle of attract, as VOICE_SHOW_S counts them. */

/* A visitor's choice, as the next chapter takes it over. Zero: none. */
struct language_choice {
    uint32_t chosen;     /* enum language; 0 unless `until_tick` is set. */
    uint32_t until_tick; /* In attract, the tick at which the choice ends; 0: there is no choice. */
};

struct core;

/* Changes to the next language when the button is pressed, and ends a choice that lasted for a
 * cycle of attract. */
void language_tick(struct core *core, const struct input *input);

/* Returns to the operator's language, because attract begins. */
void language_return(struct core *core);

/* Returns the visitor's choice of `core`, for the next chapter. */
struct language_choice language_kept(const struct core *core);

/* Mixes a choice into `hash`; nothing where there is none, as before choices ended. */
uint64_t language_hash(uint64_t hash, const struct language_choice *choice);

#endif
