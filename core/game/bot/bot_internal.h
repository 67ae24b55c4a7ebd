/* bot_internal.h -- internal interface of the bot*.c files: the stages of a scoop and their inputs.
 *
 * The bot has immediate access to its own arm position and to the time since an event. All other
 * data comes from the last usable snapshot. */
#ifndef KINGYO_CORE_GAME_BOT_BOT_INTERNAL_H
#define KINGYO_CORE_GAME_BOT_BOT_INTERNAL_H

#include "core/game/bot/bot.h"
#include "core/game/bot/targeting.h"

#define BOT_HOVER_Y_M 0.062f /* Hover height above the water while a fish is selected. */
#define BOT_THERE_M 0.012f   /* Distance from the goal within which the arm has arrived. */

/* ---- Queries -------------------------------------------------------------------------------- */

float bot_stage_s(const struct bot *bot, uint32_t tick); /* Returns the seconds since the stage
                                                            began. */
float bot_age_s(const struct bot *bot, uint32_t tick);   /* Returns the seconds since the snapshot
                                                            `known` was captured. */

/* Returns 1 if the snapshot `known` was captured at least `after_s` seconds after the start of the
 * stage, otherwise 0. A negative `after_s` also accepts a capture shortly before the start. */
int bot_saw_since(const struct bot *bot, float after_s);

int bot_plays(const struct bot *bot);      /* Returns 1 if a game runs and the bot has a poi,
                                              otherwise 0. */
int bot_prey_swims(const struct bot *bot); /* Returns 1 if the target fish is still in the tank,
                                              otherwise 0. */
vec3 bot_ground_m(const struct bot *bot);  /* Returns the place for wetting the paper and for
                                              searching for fish. */

/* Return the arm's position, its distance to the goal, and 1 if the wrist has reached its goal
 * angles (otherwise 0). */
vec3 bot_hand_m(const struct bot *bot);
float bot_way_left_m(const struct bot *bot);
int bot_wrist_is_there(const struct bot *bot);

/* Computes the path to the position that the target fish is predicted to have in `ahead_s` seconds.
 * Returns 1 if the path has enough room, otherwise 0, as targeting_approach() does. */
int bot_way_to_prey(const struct bot *bot, uint32_t tick, float ahead_s, struct approach_path *way);

/* ---- Actions -------------------------------------------------------------------------------- */

/* Starts a stage. Stages outside BOT_APPROACH .. BOT_GLIDE have no target fish. */
void bot_go(struct bot *bot, uint8_t stage, uint32_t tick);

/* Sets the goal of the arm, with the current handle yaw and the default acceleration time. */
void bot_want(struct bot *bot, vec3 position_m, float pitch_rad, float speed_m_s);

/* Stage functions, one for each enum bot_stage. The current stage's function is called once per
 * tick, sets the arm's goal and decides when to change the stage. */
void bot_rest(struct bot *bot, uint32_t tick); /* bot_wait.c contains the stages before a scoop. */
void bot_soak(struct bot *bot, uint32_t tick);
void bot_choose(struct bot *bot, uint32_t tick);
void bot_approach(struct bot *bot, uint32_t tick); /* bot_hunt.c contains the stages from the
                                                      approach of a fish to the position under the
                                                      fish. */
void bot_watch(struct bot *bot, uint32_t tick);
void bot_dip(struct bot *bot, uint32_t tick);
void bot_glide(struct bot *bot, uint32_t tick);
void bot_lift(struct bot *bot, uint32_t tick); /* bot_home.c contains the stages that bring the fish
                                                  to the bowl. */
void bot_carry(struct bot *bot, uint32_t tick);
void bot_tip(struct bot *bot, uint32_t tick);

#endif
