/* bot_mind.h -- inside the bot: the stages of a scoop, and what they go by. For bot*.c alone.
 *
 * What the hand feels it knows at once: that it has arrived, and how long ago something began. All
 * else it has seen, a moment ago. */
#ifndef KINGYO_CORE_GAME_BOT_MIND_H
#define KINGYO_CORE_GAME_BOT_MIND_H

#include "core/game/aim.h"
#include "core/game/bot.h"

#define BOT_HOVER_Y_M 0.062f /* Over the water while it chooses. */
#define BOT_THERE_M 0.012f   /* Near enough, for a hand on its way. */

/* ---- What it has ---------------------------------------------------------------------------- */

float bot_stage_s(const struct bot *bot, uint32_t tick); /* Since the stage began, ... */
float bot_age_s(const struct bot *bot, uint32_t tick);   /* ... and since what it knows was seen. */

/* Whether that was seen in this stage, at least `after_s` after it began (< 0: before it). */
int bot_saw_since(const struct bot *bot, float after_s);

int bot_plays(const struct bot *bot);      /* There is something to play, and a poi to play with. */
int bot_prey_swims(const struct bot *bot); /* It is after a fish that is still in the tank. */
vec3 bot_ground_m(const struct bot *bot);  /* Where it soaks its paper and looks for fish. */

/* The hand: where it is, what is left of its way, and whether it is turned as it wants. */
vec3 bot_hand_m(const struct bot *bot);
float bot_way_left_m(const struct bot *bot);
int bot_wrist_is_there(const struct bot *bot);

/* The way to where the prey will be `ahead_s` from now, as aim_way_to(). */
int bot_way_to_prey(const struct bot *bot, uint32_t tick, float ahead_s, struct aim_way *way);

/* ---- What it does --------------------------------------------------------------------------- */

/* Enters a stage. Who begins to lift looks at no one fish any more. */
void bot_go(struct bot *bot, uint8_t stage, uint32_t tick);

/* Wants its hand there, the handle as it holds it, in no hurry to get up that speed. */
void bot_want(struct bot *bot, vec3 position_m, float pitch_rad, float speed_m_s);

/* One tick of each stage (enum bot_stage), with what it knows: what to want, when to go on. */
void bot_rest(struct bot *bot, uint32_t tick); /* bot_wait.c: before a scoop */
void bot_soak(struct bot *bot, uint32_t tick);
void bot_choose(struct bot *bot, uint32_t tick);
void bot_approach(struct bot *bot, uint32_t tick); /* bot_hunt.c: to a fish and under it */
void bot_watch(struct bot *bot, uint32_t tick);
void bot_dip(struct bot *bot, uint32_t tick);
void bot_glide(struct bot *bot, uint32_t tick);
void bot_lift(struct bot *bot, uint32_t tick); /* bot_home.c: home with it */
void bot_carry(struct bot *bot, uint32_t tick);
void bot_tip(struct bot *bot, uint32_t tick);

#endif
