/* bot.h -- the built-in bot: an artificial player with human reaction times and arm motion.
 *
 * The bot perceives the game only through snapshots (snapshot.c), one every 150 to 250 ms. A
 * snapshot becomes usable when the next snapshot is taken, so the bot always acts on the past. The
 * bot's poi moves like a poi in a human hand. */
#pragma once

#include <stdbool.h>
#include <stdint.h>

#include "core/game/bot/vision.h"

/* Initializes `bot` with a copy of `technique`. The arm starts above the middle of the tank. */
void bot_init(struct bot *bot, const struct technique *technique, uint32_t seed);

/* Advances the bot by one tick, before the core's tick. `vision->player` is the player that the bot
 * controls. Returns the pose of the arm, including the wrist angles. */
struct poi_target bot_tick(struct bot *bot, const struct vision *vision);

/* ---- Stages of an attempt to catch a fish ---------------------------------------------------- */

#define BOT_HOVER_Y_M 0.062f /* Hover height above the water while a fish is selected. */

/* Runs the function of the bot's current stage, which sets the arm's goal and decides when to
 * change the stage. */
void bot_decide(struct bot *bot, uint32_t tick);

/* Returns the bot's point of attention. The next snapshot contains the fish near this point. */
vec3 bot_attention_m(const struct bot *bot);

/* ---- Snapshots of the visible game ----------------------------------------------------------- */

/* Takes a snapshot of the game. The snapshot contains the target fish `prey`, unless `prey` is
 * SNAPSHOT_NO_FISH, and the fish that are near `attention_m` and near the water surface. `before`
 * is the previous snapshot; all its fields are 0 if the bot has not taken a snapshot before. */
void snapshot_take(struct snapshot *snapshot, const struct snapshot *before,
                   const struct vision *vision, uint16_t prey, vec3 attention_m);

/* Returns the predicted position of a fish `age_s` seconds after the snapshot, at constant
 * velocity. The prediction time is limited to SNAPSHOT_PREDICT_S. */
#define SNAPSHOT_PREDICT_S 0.6f
vec3 snapshot_predict(const struct snapshot_fish *seen, float age_s);

/* ---- Selection of the target fish and of the path to the fish -------------------------------- */

/* Functions that select the bot's target fish and the path of the poi to this fish, from a
 * snapshot.
 *
 * A path goes from a point above the water down to a stop point beside and below the fish. From the
 * stop point the path is level until the fish is over its intended place on the paper. */

#define TARGETING_RING_M 0.0465f /* Outer radius of the poi, which every player can see. */
/* Vertical distance from the fish's centre down to the ring while the poi moves under the fish. */
#define TARGETING_UNDER_M 0.020f

struct approach_path {
    float yaw_rad;
    vec3 entry_m; /* Point above the water at which the path starts. */
    vec3 stop_m;  /* Stop point of the path: a point under water, beside the fish. */
    /* Position of the ring's centre at which the fish is over its intended place on the paper. */
    vec3 under_m;
};

/* Returns the horizontal unit vector toward the far edge of a poi with handle yaw `yaw_rad`. */
vec3 targeting_forward(float yaw_rad);

/* Computes the path to a fish of length `length_m` at `fish_m` for handle yaw `yaw_rad`, and writes
 * the path to `way`. Returns true if the walls, the floor and the bot's own bowl leave room for the
 * path. */
bool targeting_approach(const struct technique *technique, const struct snapshot *snapshot,
                        vec3 fish_m, float length_m, float yaw_rad, struct approach_path *way);

/* Selects the target fish: returns the nearby fish of the snapshot with the lowest cost for a poi
 * at `hand_m`, or NULL if no fish can be reached. A cost is a time in seconds. Writes the best
 * handle yaw to `*yaw_rad`. `age_s` is the age of the snapshot. */
const struct snapshot_fish *targeting_choose(const struct technique *technique,
                                             const struct snapshot *snapshot, vec3 hand_m,
                                             float age_s, float *yaw_rad);

/* Returns the handle yaw with which the ring moves under the fish from the end that the technique
 * prefers: from the head or from the tail. Returns `yaw_rad` if the technique prefers no end, or if
 * the wrist cannot turn that far. */
float targeting_yaw(const struct technique *technique, const struct snapshot_fish *fish,
                    float yaw_rad);

/* Returns the fish nearest to an underwater ring at `ring_m` in horizontal distance, or NULL. Only
 * fish above the ring and within `reach_m` are considered. */
const struct snapshot_fish *targeting_nearest(const struct snapshot *snapshot, vec3 ring_m,
                                              float reach_m);
