/* chapter.h -- sessions: the periods into which the running time is divided, one recording each.
 *
 * A new session begins at each start of attract mode, and after every ten minutes of it. The core
 * then restarts from its configuration.
 *
 * A session starts with the state that core_init() creates from the configuration in the core. The
 * tank and the seed are fresh; money, ledger, audits, leaderboard, saved graphs and the tick
 * continue. The configuration and the inputs since then reproduce any round of the session. A round
 * starts at most ten minutes plus its own waiting time after the session's start. The player sees a
 * short fade to dark. */
#ifndef KINGYO_CORE_GAME_CHAPTER_H
#define KINGYO_CORE_GAME_CHAPTER_H

#include <stdint.h>

#include "core/game/adjust.h"
#include "core/game/credit.h"
#include "core/game/language.h"
#include "core/game/ledger.h"
#include "core/game/upkeep.h"
#include "core/input.h"

#define CHAPTER_TICKS_MAX (600u * CORE_TICK_HZ)  /* Longest attract time of a session; a running
                                                    game is never interrupted. */
#define CHAPTER_FADE_TICKS (CORE_TICK_HZ / 2u)   /* Duration of the fade before the restart, and of
                                                    the fade after it. */

/* State carried over from the previous session. All zero: the kiosk has just started. */
struct chapter {
    uint32_t tick;  /* First tick of this session; 0 at the kiosk's start. */
    uint32_t order_count, edit_save_id, edit_saved_id; /* Command and edit ids, as in struct menu
                                                          and struct lab. */
    struct ledger ledger;
    struct credit credit;
    struct upkeep upkeep;
    struct adjust adjust;
    struct language_choice language;
};

struct core;
struct game;

/* Requests a new session. The session starts when the picture is dark, if attract mode is still
 * active then. */
void chapter_ask(struct core *core);

/* Returns 1 if the finished tick was the last one of the session. */
int chapter_is_over(const struct core *core);

/* Writes the configuration of the next session to core->config. The caller then rebuilds the rest
 * of `core` as core_init() does. */
void chapter_turn(struct core *core);

/* Copies the carried-over state to a fresh game. Does nothing at the kiosk's start. */
void chapter_go_on(struct game *game, const struct chapter *chapter);

/* Returns the darkness of the picture, [0, 1]; 1 at the restart. */
float chapter_veil(const struct core *core);

uint64_t chapter_hash(uint64_t hash, const struct chapter *chapter, int rules_7);

#endif
