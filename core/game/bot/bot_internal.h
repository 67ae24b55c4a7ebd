/* bot_internal.h -- internal interface of bot*.c: the stages of a scoop and their inputs.
 *
 * The bot has immediate access to its own arm position and to the time since an event. All other
 * data comes from the last usable snapshot. */
#ifndef KINGYO_CORE_GAME_BOT_BOT_INTERNAL_H
#define KINGYO_CORE_GAME_BOT_BOT_INTERNAL_H

#include "core/game/bot/bot.h"
#include "core/game/bot/targeting.h"

#define BOT_HOVER_Y_M 0.062f /* Hover height above the water while a fish is selected. */
#define BOT_THERE_M 0.012f   /* Distance that counts as arrived. */

/* ---- Queries -------------------------------------------------------------------------------- */

float bot_stage_s(const struct bot *bot, uint32_t tick); /* Seconds since the stage began. */
float bot_age_s(const struct bot *bot, uint32_t tick);   /* Seconds since `known` was captured. */

/* Returns 1 if `known` was captured at least `after_s` seconds after the start of the stage. A
 * negative `after_s` allows a capture before the start. */
int bot_saw_since(const struct bot *bot, float after_s);

int bot_plays(const struct bot *bot);      /* 1 if a game runs and the bot has a poi. */
int bot_prey_swims(const struct bot *bot); /* 1 if the target fish is still in the tank. */
vec3 bot_ground_m(const struct bot *bot);  /* Place for wetting the paper and searching for fish. */

/* Arm state: position, distance to the goal, and whether the wrist has reached its angles. */
vec3 bot_hand_m(const struct bot *bot);
float bot_way_left_m(const struct bot *bot);
int bot_wrist_is_there(const struct bot *bot);

/* Computes the path to the predicted position of the target fish in `ahead_s` seconds, as
 * targeting_approach(). */
int bot_way_to_prey(const struct bot *bot, uint32_t tick, float ahead_s, struct approach_path *way);

/* ---- Actions -------------------------------------------------------------------------------- */

/* Enters a stage. Stages outside BOT_APPROACH .. BOT_GLIDE have no target fish. */
void bot_go(struct bot *bot, uint8_t stage, uint32_t tick);

/* Sets the arm's goal with the current handle yaw and the default acceleration time. */
void bot_want(struct bot *bot, vec3 position_m, float pitch_rad, float speed_m_s);

/* Stage functions (enum bot_stage), one call per tick: each sets the arm's goal and decides when to
 * change the stage. */
void bot_rest(struct bot *bot, uint32_t tick); /* bot_wait.c: before a scoop. */
void bot_soak(struct bot *bot, uint32_t tick);
void bot_choose(struct bot *bot, uint32_t tick);
void bot_approach(struct bot *bot, uint32_t tick); /* bot_hunt.c: toward and under a fish. */
void bot_watch(struct bot *bot, uint32_t tick);
void bot_dip(struct bot *bot, uint32_t tick);
void bot_glide(struct bot *bot, uint32_t tick);
void bot_lift(struct bot *bot, uint32_t tick); /* bot_home.c: to the bowl with the fish. */
void bot_carry(struct bot *bot, uint32_t tick);
void bot_tip(struct bot *bot, uint32_t tick);

#endif
