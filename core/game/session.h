/* session.h -- sessions: the periods into which the running time is divided. Each session has one
 * recording.
 *
 * A new session begins at each start of attract mode, and after every ten minutes in attract mode.
 * At the start of a session the core restarts from its configuration, with the state that
 * core_init() creates. The tank and the seed are new. Money, ledger, audits, leaderboards, saved
 * graphs and the tick number continue.
 *
 * The configuration and the inputs since the session's start reproduce any round of the session. A
 * round starts at most ten minutes plus its own waiting time after the session's start. The player
 * sees a short fade to dark when a session starts. */
#ifndef KINGYO_CORE_GAME_SESSION_H
#define KINGYO_CORE_GAME_SESSION_H

#include <stdint.h>

#include "core/game/accounting/credit.h"
#include "core/game/accounting/ledger_writer.h"
#include "core/game/health_log.h"
#include "core/game/language.h"
#include "core/game/menu/settings_edit.h"
#include "core/input.h"

/* Longest time in attract mode before a new session starts. A running game is never interrupted. */
#define SESSION_TICKS_MAX (600u * CORE_TICK_HZ)
/* Duration of the fade to dark before a session starts, and of the fade back after the start. */
#define SESSION_FADE_TICKS (CORE_TICK_HZ / 2u)

/* State carried over from the previous session. All fields are 0 if the kiosk has just started. */
struct game_session {
    uint32_t tick; /* First tick of this session; 0 at the kiosk's start. */
    uint32_t command_count, edit_save_id, edit_saved_id; /* Number of commands and ids of graph
                                                            edits, as in struct menu and struct
                                                            lab. */
    struct ledger ledger;
    struct credit credit;
    struct health_log health_log;
    struct settings_edit settings_edit;
    struct language_choice language;
};

struct core_config;
struct game;

/* Requests a new session. The session starts when the picture is dark, if attract mode is still
 * active at that time. */
void session_request(struct game *game);

/* Returns 1 if the finished tick was the last tick of the session, otherwise 0. */
int session_is_over(const struct game *game);

/* Writes the configuration of the next session to `config`. The caller then initializes the game
 * and the world from `config`, as core_init() does. */
void session_restart(const struct game *game, struct core_config *config);

/* Copies the state in `session` to a newly initialized game. Does nothing at the kiosk's start. */
void session_restore(struct game *game, const struct game_session *session);

/* Returns the darkness of the picture, [0, 1]; 1 at the start of a session. */
float session_fade(const struct game *game, const struct core_config *config);

uint64_t session_hash(uint64_t hash, const struct game_session *session, int rules_7);

#endif
