/* targeting.h -- selects the bot's target fish and the path of the poi, from a visual snapshot.
 *
 * A path goes from a point above the water down to a stop point beside and below the fish. From the
 * stop point the path is level until the fish is over its intended place on the paper. */
#ifndef KINGYO_CORE_GAME_BOT_TARGETING_H
#define KINGYO_CORE_GAME_BOT_TARGETING_H

#include <stdint.h>

#include "core/game/bot/snapshot.h"
#include "core/game/bot/technique.h"

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
