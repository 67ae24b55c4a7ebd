/* game.h -- the game: phases, players, and their results.
 *
 * The phases are attract, mode selection, ready, round, result, name, leaderboard and album, plus
 * the growth lab and the operator's menu. Each phase has its own file (phases.h). Further parts are
 * the umpire (fouls.h), time announcements (announcements.h), pauses for lost controllers
 * (pause.h), table setup (table_setup.h) and scoring (score.h). Differences between modes are data
 * (rules.h). */
#ifndef KINGYO_CORE_GAME_GAME_H
#define KINGYO_CORE_GAME_GAME_H

#include <stdint.h>

#include "core/game/accounting/accounts.h"
#include "core/game/bot/bot.h"
#include "core/game/control/input_validation.h"
#include "core/game/health_log.h"
#include "core/game/hints.h"
#include "core/game/lab/album.h"
#include "core/game/lab/lab.h"
#include "core/game/language.h"
#include "core/game/menu/menu.h"
#include "core/game/menu/settings_edit.h"
#include "core/game/pause.h"
#include "core/game/player.h"
#include "core/game/ranking/name.h"
#include "core/game/rules.h"
#include "core/game/score.h"
#include "core/game/table_setup.h"
#include "core/input.h"
#include "core/output.h"
#include "core/poi/catch/catch.h"
#include "core/scene.h"

/* Length of READY in the festival mode and in the practice mode. */
#define GAME_READY_TICKS (RULES_READY_S * CORE_TICK_HZ)
/* Duration of the result screen, long enough to read the result and to call a friend. */
#define GAME_RESULT_TICKS (12u * CORE_TICK_HZ)
/* Time between the last player's end and the result, so that the player sees the hole in the
 * paper. */
#define GAME_GONE_TICKS (3u * CORE_TICK_HZ)
/* Time after the end of the round in which the last fish can be carried to the bowl. */
#define GAME_CARRY_TICKS (3u * CORE_TICK_HZ)
/* Time in the result screen before a START press starts the next game, so that an earlier press is
 * ignored. */
#define GAME_AGAIN_TICKS (3u * CORE_TICK_HZ / 2u)
/* Time in the result screen before a dip starts the next game. The time is longer than for START,
 * because a dip happens more easily by accident. */
#define GAME_AGAIN_DIP_TICKS (5u * CORE_TICK_HZ / 2u)
/* Time without input after which the mode selection returns to attract mode. */
#define GAME_MODE_SELECT_TICKS (15u * CORE_TICK_HZ)
/* Longest duration of the mode selection. Motion that lasts longer comes from a poi that swings on
 * its cord. */
#define GAME_MODE_SELECT_TICKS_MAX (120u * CORE_TICK_HZ)
/* Time in the mode selection before a press counts, so that the player sees the items first. */
#define GAME_MODE_SELECT_TICKS_MIN (CORE_TICK_HZ / 2u)
#define GAME_STALE_TICKS (115u * CORE_TICK_HZ) /* Time in attract mode for which the pump is off. */
/* Time in attract mode for which the pump bubbles, alternating with GAME_STALE_TICKS. */
#define GAME_AIR_TICKS (45u * CORE_TICK_HZ)
#define GAME_POI_GRADE 6u      /* Default paper grade, which real stalls use most. */
#define GAME_DIP_Y_M (-0.010f) /* Height that a pose must cross downward to count as a dip. */

struct game {
    uint32_t tick;       /* Number of the current tick, counted from 0 at the start of the kiosk. */
    uint8_t phase;       /* Current phase (enum scene_phase). */
    uint8_t language;    /* Display language (enum language). */
    uint8_t mode;        /* Mode of this round, or the selected mode (enum game_mode). */
    uint8_t lab_chosen;  /* 1 if the growth lab is selected in the mode selection, otherwise 0. */
    uint8_t bot_played;  /* 1 if the bot controlled a poi in this round, otherwise 0. */
    uint8_t played;      /* 1 if a player or the bot has had a poi in use in this round, otherwise
                            0. */
    uint8_t paused;      /* 1 if the round is paused because a controller is lost, otherwise 0. */
    uint8_t call;        /* Latest time announcement in this round (enum time_call). */
    uint32_t call_tick;  /* Tick of the latest time announcement. */
    uint32_t phase_tick; /* Tick at which the phase began. While the round's clock is paused,
                            `phase_tick` rises by one per tick. */
    uint32_t round_tick; /* Tick at which the round began; not changed by pauses. */
    uint32_t paused_ticks;   /* Ticks for which the round's clock was paused, for any reason. */
    uint32_t point_tick;     /* Tick of the last selection in the mode selection. */
    uint32_t lost_ticks;     /* Duration in ticks of the current pause without any active player. */
    uint32_t waited_ticks;   /* Total duration in ticks of all pauses without any active player in
                                this round. */
    uint32_t gone_tick;      /* Tick at which the last player was out, or 0 while players are
                                active; rises by one per tick during pauses. In attract mode: tick
                                at which the bot's paper was torn or its bowl was full. */
    uint32_t language_until; /* Tick at which a visitor's choice of language in attract mode ends; 0
                                means no choice. */
    uint32_t turn_tick;      /* Tick at which a new session starts (session.h); 0 means that no
                                session was requested. */
    uint32_t round_s;        /* Length of this round in seconds. */
    uint32_t round_count;    /* Number of started rounds; part of the seed of the next paper. */
    struct accounts accounts;
    struct settings_edit settings_edit;
    struct name name;
    struct player player[POI_MAX];
    uint8_t holder[POI_MAX];     /* Source that controlled each poi in the last tick (enum
                                    poi_source). */
    uint32_t grip_tick[POI_MAX]; /* Tick at which the current source took control of each poi. */
    struct poi_target hand_pose[POI_MAX]; /* Target pose of each poi in the last tick, after
                                             smoothing and failsafe. */
    float live_y_m[POI_MAX]; /* Height of each controller's pose in the last tick, or -1 if the
                                input was invalid. A dip is a downward crossing of GAME_DIP_Y_M. */
    struct input_validation validation[POI_MAX]; /* State of the input validation of each
                                                    controller. */
    uint32_t return_ticks[POI_MAX];   /* Ticks since each poi began to return to its controller's
                                         pose; 0 means that the poi follows the controller. */
    uint8_t was_lost[POI_MAX];        /* 1 while the poi returns after an input loss, otherwise 0.
                                         The paper cannot be damaged until the poi arrives. */
    uint32_t immunity_ticks[POI_MAX]; /* Ticks of damage immunity that each poi has used during
                                         returns. The number decreases while the player controls the
                                         poi. */
    uint32_t outlier_ticks[POI_MAX];  /* Ticks for which the reported pose has required a motion
                                         that no arm can make. */
    uint32_t rest_ticks[POI_MAX];     /* Number of ticks in a row in which the player has not used
                                         the poi. */
    struct hints hints;
    struct bot bot[POI_MAX];
    struct health_log health_log;
    struct menu menu;
    struct album album;
    struct lab lab;
};

struct world;
struct core_config;

/* Initializes `game` from `config` with the state at the start of a session. */
void game_init(struct game *game, const struct core_config *config);

/* Runs the first step of a tick: updates the phase, and supplies fresh paper and empty bowls at the
 * start of a round. Fills `targets` with the target pose of each poi, from the controller or the
 * bot. Fills `live` with 1 for each poi in use, otherwise 0. */
void game_tick(struct game *game, struct world *world, struct core_config *config,
               const struct input *input, struct output *output, struct poi_target targets[POI_MAX],
               uint8_t live[POI_MAX]);

/* Returns 1 if player `index` may dip the poi. Dips are allowed in attract mode. In a round, dips
 * are allowed while the clock runs, time is left and the player is not out. Otherwise the poi stays
 * above the water. */
int game_may_scoop(const struct game *game, uint32_t index);

/* Returns 1 if the tank's pump bubbles at `tick`, otherwise 0. The pump is off during a round, as
 * the rules of the federation require. In attract mode the pump runs at intervals. Visitors
 * therefore see the fish surface for air and dive again. */
int game_pumps(const struct game *game, uint32_t tick);

/* Returns the seconds left in the round. In READY: seconds until the round begins. In mode
 * selection and name entry: seconds until the timeout. In other phases 0. */
float game_seconds_left(const struct game *game, uint32_t tick);

uint64_t game_hash(uint64_t hash, const struct game *game);

#endif
