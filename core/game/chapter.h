/* chapter.h -- the evening in chapters: when attract begins, and every ten minutes of it, the stall
 * begins anew, so that what follows is a recording of its own.
 *
 * A chapter begins with the very state that core_init() makes of the configuration which the core
 * holds from then on: a fresh tank under a fresh seed, and all that goes on (money, ledger, audits,
 * ranking, saved graphs, the tick). Whoever keeps that configuration and the inputs since can play
 * any round again, at most ten minutes and its own time after its chapter's beginning. What is
 * seen of it is a short dip to dark. */
#ifndef KINGYO_CORE_GAME_CHAPTER_H
#define KINGYO_CORE_GAME_CHAPTER_H

#include <stdint.h>

#include "core/game/adjust.h"
#include "core/game/credit.h"
#include "core/game/language.h"
#include "core/game/ledger.h"
#include "core/game/upkeep.h"
#include "core/input.h"

#define CHAPTER_TICKS_MAX (600u * CORE_TICK_HZ)  /* Of attract; a game that runs is not cut. */
#define CHAPTER_FADE_TICKS (CORE_TICK_HZ / 2u)   /* Before the cut, and after it. */

/* What goes on from the chapter before. Zero: there was none, the kiosk begins. */
struct chapter {
    uint32_t tick;  /* The first of this one; 0 at the start. */
    uint32_t order_count, edit_save_id, edit_saved_id; /* As in struct menu and struct lab. */
    struct ledger ledger;
    struct credit credit;
    struct upkeep upkeep;
    struct adjust adjust;
    struct language_choice language;
};

struct core;
struct game;

/* A chapter will begin when the picture is dark, if it is still attract then. */
void chapter_ask(struct core *core);

/* Whether the tick that is over was the chapter's last. */
int chapter_is_over(const struct core *core);

/* Writes into core->config what the next chapter begins with; the rest of `core` is to be made of
 * it, by core_init()'s own way. */
void chapter_turn(struct core *core);

/* Puts what goes on into a fresh game; where the kiosk begins, nothing does. */
void chapter_go_on(struct game *game, const struct chapter *chapter);

/* How dark it is, [0, 1]: 1 at the cut. */
float chapter_veil(const struct core *core);

uint64_t chapter_hash(uint64_t hash, const struct chapter *chapter, int rules_7);

#endif
