/* bot.h -- the built-in bot: an artificial player with human reaction times and arm motion.
 *
 * The bot perceives the game only through snapshots (snapshot.c), one every 150 to 250 ms. A
 * snapshot becomes usable when the next snapshot is taken, so the bot always acts on the past. The
 * bot's poi moves like a poi in a human hand. */
#ifndef KINGYO_CORE_GAME_BOT_BOT_H
#define KINGYO_CORE_GAME_BOT_BOT_H

#include <stdint.h>

#include "core/game/bot/vision.h"

/* Initializes `bot` with a copy of `technique`. The arm starts above the middle of the tank. */
void bot_init(struct bot *bot, const struct technique *technique, uint32_t seed);

/* Advances the bot by one tick, before the core's tick. `vision->player` is the player that the bot
 * controls. Returns the pose of the arm, including the wrist angles. */
struct poi_target bot_tick(struct bot *bot, const struct vision *vision);

uint64_t bot_hash(uint64_t hash, const struct bot *bot);

/* ---- Stages ---------------------------------------------------------------------------------- */

#define BOT_HOVER_Y_M 0.062f /* Hover height above the water while a fish is selected. */

/* Runs the function of the bot's current stage, which sets the arm's goal and decides when to
 * change the stage. */
void bot_decide(struct bot *bot, uint32_t tick);

/* Returns the point around which the bot's next snapshot contains the nearby fish. */
vec3 bot_attention_m(const struct bot *bot);

/* ---- Snapshots ------------------------------------------------------------------------------- */

/* Takes a snapshot with the fish `prey` (or SNAPSHOT_NO_FISH) and the shallow fish around
 * `attention_m`. `before` is the previous snapshot; all its fields are 0 if none was taken. */
void snapshot_take(struct snapshot *snapshot, const struct snapshot *before,
                   const struct vision *vision, uint16_t prey, vec3 attention_m);

/* Returns the predicted position of a fish `age_s` seconds after the snapshot, at constant
 * velocity. The prediction time is limited to SNAPSHOT_PREDICT_S. */
#define SNAPSHOT_PREDICT_S 0.6f
vec3 snapshot_predict(const struct snapshot_fish *seen, float age_s);

uint64_t snapshot_hash(uint64_t hash, const struct snapshot *snapshot);

/* ---- Targeting ------------------------------------------------------------------------------- */

/* Selects the bot's target fish and the path of the poi, from a visual snapshot.
 *
 * A path goes from a point above the water down to a stop point beside and below the fish. From
 * the stop point the path is level until the fish is over its intended place on the paper. */

#define TARGETING_RING_M 0.0465f /* Outer radius of the poi, which every player can see. */
#define TARGETING_UNDER_M 0.020f /* Depth of the ring below the fish's centre. */

struct approach_path {
    float yaw_rad;
    vec3 entry_m; /* Point above the water where the path starts. */
    vec3 stop_m;  /* Stop point under water, beside the fish. */
    vec3 under_m; /* Position of the ring's centre at which the fish is over its intended place on
                     the paper. */
};

/* Returns the horizontal unit vector toward the far edge of a poi with handle yaw `yaw_rad`. */
vec3 targeting_forward(float yaw_rad);

/* Computes the path to a fish at `fish_m` for handle yaw `yaw_rad`. Returns 1 if the walls, the
 * floor and the bot's own bowl leave room for the path, otherwise 0. */
int targeting_approach(const struct technique *technique, const struct snapshot *snapshot,
                       vec3 fish_m, float length_m, float yaw_rad, struct approach_path *way);

/* Returns the nearby fish of the snapshot with the lowest cost for a poi at `hand_m`, or NULL if no
 * fish can be reached. A cost is a time in seconds. Writes the best handle yaw to `*yaw_rad`.
 * `age_s` is the age of the snapshot. */
const struct snapshot_fish *targeting_choose(const struct technique *technique,
                                             const struct snapshot *snapshot, vec3 hand_m,
                                             float age_s, float *yaw_rad);

/* Returns the handle yaw at which the ring first passes under the end of the fish that the
 * technique prefers (head or tail). Returns `yaw_rad` if the technique has no preference or the
 * wrist cannot turn that far. */
float targeting_yaw(const struct technique *technique, const struct snapshot_fish *fish,
                    float yaw_rad);

/* Returns the fish nearest to an underwater ring at `ring_m` in horizontal distance, or NULL. Only
 * fish above the ring and within `reach_m` are considered. */
const struct snapshot_fish *targeting_nearest(const struct snapshot *snapshot, vec3 ring_m,
                                              float reach_m);

#endif
