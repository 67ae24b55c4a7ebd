/* game.h -- the game: phases, players, and their results.
 *
 * The phases are attract, choose, ready, round, result, name, leaderboard and album, plus the
 * growth lab and the operator's menu. Each phase has its own file (phases.h). Further parts are the
 * umpire (fouls.h), time announcements (announcements.h), pauses for lost controllers (pause.h),
 * table setup (table_setup.h) and scoring (score.h). Differences between modes are data
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

/* Length of READY in the festival and in practice. */
#define GAME_READY_TICKS (RULES_READY_S * CORE_TICK_HZ)
#define GAME_RESULT_TICKS (12u * CORE_TICK_HZ) /* Time to read the result and to call a friend. */
/* Time to see the hole before the result covers it. */
#define GAME_GONE_TICKS (3u * CORE_TICK_HZ)
/* Time after the end of the round to carry the last fish to the bowl. */
#define GAME_CARRY_TICKS (3u * CORE_TICK_HZ)
/* Delay before START counts in the result, so that an earlier press is ignored. */
#define GAME_AGAIN_TICKS (3u * CORE_TICK_HZ / 2u)
/* Delay before a dip counts; longer, because a dip happens more easily by accident. */
#define GAME_AGAIN_DIP_TICKS (5u * CORE_TICK_HZ / 2u)
/* Time without input after which the selection returns to attract mode. */
#define GAME_MODE_SELECT_TICKS (15u * CORE_TICK_HZ)
/* Longest selection time; motion for that long comes from a poi swinging on its cord. */
#define GAME_MODE_SELECT_TICKS_MAX (120u * CORE_TICK_HZ)
/* Time to see the items before a press counts. */
#define GAME_MODE_SELECT_TICKS_MIN (CORE_TICK_HZ / 2u)
#define GAME_STALE_TICKS (115u * CORE_TICK_HZ) /* Time in attract mode for which the pump is off. */
/* Time in attract mode for which the pump bubbles, alternating with GAME_STALE_TICKS. */
#define GAME_AIR_TICKS (45u * CORE_TICK_HZ)
#define GAME_POI_GRADE 6u      /* Paper grade that real stalls use most; the default. */
#define GAME_DIP_Y_M (-0.010f) /* Height that a pose must cross downward to count as a dip. */

struct game {
    uint32_t tick;       /* Number of the current tick, from 0 at the start of the kiosk. */
    uint8_t phase;       /* enum scene_phase */
    uint8_t language;    /* enum language */
    uint8_t mode;        /* enum game_mode of this round, or the selected mode. */
    uint8_t lab_chosen;  /* In CHOOSE: 1 if the growth lab is selected. */
    uint8_t bot_played;  /* 1: the bot controlled a poi in this round. */
    uint8_t played;      /* 1: a player or the bot has had a poi in use in this round. */
    uint8_t paused;      /* 1: a controller is lost and the round waits. */
    uint8_t call;        /* enum time_call of the latest announcement in this round. */
    uint32_t call_tick;  /* Tick of the latest announcement. */
    uint32_t phase_tick; /* Tick at which the phase began; moved forward while the round's clock is
                            paused. */
    uint32_t round_tick; /* Tick at which the round began; never moved. */
    uint32_t paused_ticks;   /* Ticks for which the round's clock was paused, for any reason. */
    uint32_t point_tick;     /* In CHOOSE: tick of the last selection. */
    uint32_t lost_ticks;     /* Ticks for which the current pause without any active player has
                                lasted. */
    uint32_t waited_ticks;   /* Ticks of all pauses without any active player in this round. */
    uint32_t gone_tick;      /* Tick at which the last player was out; moved forward during
                                pauses; 0 while players are active. In attract mode: tick at
                                which the bot's paper was torn or its bowl was full. */
    uint32_t language_until; /* Tick at which attract mode ends a visitor's choice of language; 0:
                                no choice. */
    uint32_t turn_tick;      /* Tick at which a new session starts (session.h); 0: not requested. */
    uint32_t round_s;        /* Length of this round in seconds. */
    uint32_t round_count;    /* Number of started rounds; part of the seed of the next paper. */
    struct accounts accounts;
    struct settings_edit settings_edit;
    struct name name;
    struct player player[POI_MAX];
    uint8_t holder[POI_MAX];     /* enum poi_source of the last tick: the source that controlled
                                    the poi. */
    uint32_t grip_tick[POI_MAX]; /* Tick at which the current source took control of the poi. */
    struct poi_target hand_pose[POI_MAX]; /* Target pose of each poi in the last tick, after
                                             smoothing and failsafe. */
    float live_y_m[POI_MAX]; /* Height of the controller pose in the last tick; -1 if the input
                                was invalid. A dip is a downward crossing of GAME_DIP_Y_M. */
    struct input_validation validation[POI_MAX]; /* Input validation of each controller. */
    uint32_t return_ticks[POI_MAX];   /* Ticks since the poi began to return to the controller's
                                         pose; 0: the poi follows the controller. */
    uint8_t was_lost[POI_MAX];        /* 1 while the poi returns after an input loss. Damage is
                                         disabled until the poi arrives. */
    uint32_t immunity_ticks[POI_MAX]; /* Ticks of damage immunity used so far during returns;
                                         decreases while the player controls the poi. */
    uint32_t outlier_ticks[POI_MAX];  /* Ticks for which the reported pose has required a motion
                                         that no arm can make. */
    uint32_t rest_ticks[POI_MAX];     /* Ticks for which the player has not used the poi. */
    struct hints hints;
    struct bot bot[POI_MAX];
    struct health_log health_log;
    struct menu menu;
    struct album album;
    struct lab lab;
};

struct world;
struct core_config;

/* Fills `game` with the state at the start of a session, from `config`. */
void game_init(struct game *game, const struct core_config *config);

/* Runs the first step of a tick: phases, fresh paper and empty bowls at the start of a round. Fills
 * `targets` with the target pose of each poi (from the controller or the bot) and `live` with 1 for
 * each poi in use. */
void game_tick(struct game *game, struct world *world, struct core_config *config,
               const struct input *input, struct output *output, struct poi_target targets[POI_MAX],
               uint8_t live[POI_MAX]);

/* Returns 1 if player `index` may dip the poi. A dip is allowed in attract mode, and in a round
 * while the clock runs, time is left and the player is not out. Otherwise the poi is kept above the
 * water. */
int game_may_scoop(const struct game *game, uint32_t index);

/* Returns 1 if the tank's pump bubbles at `tick`. The pump is off during a round (a rule of the
 * federation). In attract mode the pump runs at intervals, so that visitors see the fish surface
 * for air and dive again. */
int game_pumps(const struct game *game, uint32_t tick);

/* Returns the seconds left in the round; in READY, until the round begins; in CHOOSE and NAME,
 * until the timeout; else 0. */
float game_seconds_left(const struct game *game, uint32_t tick);

uint64_t game_hash(uint64_t hash, const struct game *game);

#endif
