/* snapshot.h -- a visual snapshot for the bot: nearby fish with their speeds, the bot's paper, and
 * its bowl.
 *
 * A snapshot is outdated as soon as it is taken. A fish's velocity is its change of position
 * between two snapshots, divided by the time between the snapshots. A fish that is missing in the
 * previous snapshot gets velocity 0. */
#ifndef KINGYO_CORE_GAME_BOT_SNAPSHOT_H
#define KINGYO_CORE_GAME_BOT_SNAPSHOT_H

#include <stdint.h>

#include "core/game/bot/vision.h"

#define SNAPSHOT_NO_FISH 0xffffu
/* Largest number of nearby fish, more than a person can watch. If more fish are visible, the
 * snapshot keeps the fish nearest to the point of attention. */
#define SNAPSHOT_NEAR_MAX 24u

struct snapshot_fish {
    uint16_t fish; /* Index of the fish; SNAPSHOT_NO_FISH means no fish. */
    uint8_t place; /* Place of the fish (enum scene_place). */
    uint8_t gulps;
    vec3 position_m, velocity_m_s;
    float heading_rad; /* Yaw of the direction in which the fish's head points. */
    float length_m;
};

/* State of the bot's own paper, from its picture. */
struct snapshot_paper {
    float wet;      /* Mean wetness of the remaining paper, [0, 1]. */
    float left;     /* Remaining share of the paper, [0, 1]. */
    uint8_t holds;  /* 1 if some patch of the paper is large enough for a fish, otherwise 0. */
    uint8_t middle; /* 1 if the patch for a fish is at or near the middle of the ring, otherwise
                       0. */
    float x_m, z_m; /* Centre of the patch for a fish in the poi's plane; (0, 0) while the paper is
                       undamaged. */
};

struct snapshot {
    uint32_t tick;
    uint8_t phase, mode;
    float seconds_left;
    vec3 tank_m;
    struct vision_poi poi;
    struct vision_bowl bowl;
    struct snapshot_paper paper;
    uint32_t rival_count; /* Number of other players' pois. */
    vec3 rival_m[POI_MAX];
    uint32_t carried_count;    /* Number of fish on the bot's paper. */
    uint32_t over;             /* Number of fish in the water above the bot's paper. */
    struct snapshot_fish prey; /* Target fish of the bot. */
    uint32_t near_count;       /* Number of nearby fish, <= SNAPSHOT_NEAR_MAX. */
    struct snapshot_fish near[SNAPSHOT_NEAR_MAX];
};

/* Takes a snapshot with the fish `prey` (or SNAPSHOT_NO_FISH) and the shallow fish around
 * `attention_m`. `before` is the previous snapshot; all its fields are 0 if none was taken. */
void snapshot_take(struct snapshot *snapshot, const struct snapshot *before,
                   const struct vision *vision, uint16_t prey, vec3 attention_m);

/* Returns the predicted position of a fish `age_s` seconds after the snapshot, at constant
 * velocity. The prediction time is limited to SNAPSHOT_PREDICT_S. */
#define SNAPSHOT_PREDICT_S 0.6f
vec3 snapshot_predict(const struct snapshot_fish *seen, float age_s);

uint64_t snapshot_hash(uint64_t hash, const struct snapshot *snapshot);

#endif
