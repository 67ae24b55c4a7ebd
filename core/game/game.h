/* game.h -- what the stall does: attract, choose, ready, round, result, name, board, album; the
 * growth lab; who plays, and how well.
 *
 * Phases are files of their own (phases.h), so are the umpire (fouls.h), the keeper's calls
 * (calls.h), waiting for lost hands (pause.h), tanks and paper (keeper.h) and counting (score.h).
 * What differs between modes is data (rules.h). */
#ifndef KINGYO_CORE_GAME_GAME_H
#define KINGYO_CORE_GAME_GAME_H

#include <stdint.h>

#include "core/game/adjust.h"
#include "core/game/album.h"
#include "core/game/audits.h"
#include "core/game/bot.h"
#include "core/game/credit.h"
#include "core/game/hints.h"
#include "core/game/keeper.h"
#include "core/game/lab.h"
#include "core/game/language.h"
#include "core/game/ledger.h"
#include "core/game/menu.h"
#include "core/game/name.h"
#include "core/game/pause.h"
#include "core/game/player.h"
#include "core/game/ranking.h"
#include "core/game/rules.h"
#include "core/game/score.h"
#include "core/game/trust.h"
#include "core/game/upkeep.h"
#include "core/input.h"
#include "core/output.h"
#include "core/poi/catch.h"
#include "core/scene.h"

#define GAME_READY_TICKS (RULES_READY_S * CORE_TICK_HZ) /* In the festival and in practice. */
#define GAME_RESULT_TICKS (12u * CORE_TICK_HZ)  /* To read the result and call a friend. */
#define GAME_GONE_TICKS (3u * CORE_TICK_HZ)     /* To see the hole before the result covers it. */
#define GAME_CARRY_TICKS (3u * CORE_TICK_HZ)    /* After the call, to bring the last fish home. */
#define GAME_AGAIN_TICKS (3u * CORE_TICK_HZ / 2u)     /* START in the result: not the last press. */
#define GAME_AGAIN_DIP_TICKS (5u * CORE_TICK_HZ / 2u) /* A dip is easier to do by accident. */
#define GAME_CHOOSE_TICKS (15u * CORE_TICK_HZ)  /* Nobody points any more: back to attract. */
#define GAME_CHOOSE_TICKS_MAX (120u * CORE_TICK_HZ) /* Nor does who points so long choose: it is a
                                                       poi that swings on its cord. */
#define GAME_CHOOSE_TICKS_MIN (CORE_TICK_HZ / 2u) /* To see what there is; then a press counts. */
#define GAME_STALE_TICKS (115u * CORE_TICK_HZ) /* In attract the pump rests so long ... */
#define GAME_AIR_TICKS (45u * CORE_TICK_HZ)    /* ... and then bubbles so long, by turns. */
#define GAME_POI_GRADE 6u      /* What stalls hand out most. */
#define GAME_DIP_Y_M (-0.010f) /* A hand that goes below this from above dips. */

struct game {
    uint8_t phase;       /* enum scene_phase */
    uint8_t language;    /* enum language */
    uint8_t mode;        /* enum game_mode of this round, or the one pointed at. */
    uint8_t lab_chosen;  /* In CHOOSE: the growth lab is pointed at. */
    uint8_t bot_played;  /* Some poi of this round was the bot's. */
    uint8_t played;      /* Somebody has held a poi in this round. */
    uint8_t paused;      /* A hand is lost: the round waits for it. */
    uint8_t call;        /* enum time_call: the latest of this round, ... */
    uint32_t call_tick;  /* ... and when. */
    uint32_t phase_tick; /* When the phase began; shifted while the round's clock waits ... */
    uint32_t round_tick; /* When the round began, never shifted. */
    uint32_t paused_ticks; /* How long its clock has waited, for whatever reason. */
    uint32_t point_tick; /* In CHOOSE: when somebody last pointed at a mode. */
    uint32_t lost_ticks; /* How long the clock has waited for anybody, without a break, ... */
    uint32_t waited_ticks; /* ... and in all of this round. */
    uint32_t gone_tick;  /* ... as is when the last one who played was out; 0 while some are not.
                            In attract: since when the bot's paper is gone or its bowl full. */
    uint32_t language_until; /* Tick at which attract ends a visitor's choice of language; 0: there
                                is no choice. */
    uint32_t turn_tick;   /* When the stall begins anew (chapter.h); 0: nobody asked for it. */
    uint32_t round_s;     /* Of this round. */
    uint32_t round_count; /* Rounds begun; seeds the next poi's paper. */
    struct ledger ledger;
    struct audits audits;
    struct ranking ranking;
    struct adjust adjust;
    struct name name;
    struct player player[POI_MAX];
    uint8_t holder[POI_MAX];         /* enum poi_link: who held the poi in the last tick. */
    uint32_t grip_tick[POI_MAX];     /* When that holder took it. */
    struct poi_target hand[POI_MAX]; /* Where the poi's hand was in the last tick. */
    float live_y_m[POI_MAX];         /* Of the last live target; the dip is its way down. */
    struct trust trust[POI_MAX];     /* What is thought of each controller. */
    uint32_t back_ticks[POI_MAX];    /* How long a poi is on its way back to its hand; 0: it is
                                        there. */
    uint8_t was_lost[POI_MAX];       /* It goes that way because it was lost: it is spared. */
    uint32_t spared_ticks[POI_MAX];  /* What its paper was spared on such ways, less what being led
                                        since has given back. */
    uint32_t doubt_ticks[POI_MAX];   /* How long it is said to be where no arm could be so soon. */
    uint32_t rest_ticks[POI_MAX];    /* How long its player has had nothing to do with it. */
    struct hints hints;
    struct bot bot[POI_MAX];
    struct credit credit;
    struct upkeep upkeep;
    struct menu menu;
    struct album album;
    struct lab lab;
};

struct core;
struct core_config;

void game_init(struct game *game, const struct core_config *config);

/* The first step of a tick: phases, fresh poi and empty bowls at the start of a round. Fills
 * `targets` with what each hand wants (the controller's, or the bot's) and `live` with which poi
 * take part. */
void game_tick(struct core *core, const struct input *input, struct output *output,
               struct poi_target targets[POI_MAX], uint8_t live[POI_MAX]);

/* Whether player `index` may dip its poi: in attract, and in the round while the clock runs, time
 * is left and it is not out. Else its hand is kept above the water. */
int game_may_scoop(const struct core *core, uint32_t index);

/* Whether the keeper lets the stall's pump bubble: not while somebody plays (the federation's rule:
 * the pump is stopped), and by turns while nobody does, so that who looks on sees the fish come up
 * for air and go down again. */
int game_pumps(const struct game *game, uint32_t tick);

/* Seconds of the round that are left; in READY, until it begins; in CHOOSE, until the stall waits
 * no longer, likewise in NAME; else 0. */
float game_seconds_left(const struct game *game, uint32_t tick);

uint64_t game_hash(uint64_t hash, const struct game *game);

#endif
