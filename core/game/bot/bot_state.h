/* bot_state.h -- the state of the built-in bot: its snapshots, its arm and its present attempt to
 * catch a fish.
 *
 * A snapshot contains nearby fish with their speeds, the bot's paper, and its bowl. A snapshot is
 * outdated as soon as it is taken. A fish's velocity is its change of position between two
 * snapshots, divided by the time between the snapshots. A fish that is missing in the previous
 * snapshot gets velocity 0. */
#pragma once

#include <stdint.h>

#include "core/base/vec.h"
#include "core/game/bot/technique.h"
#include "core/input.h"
#include "core/scene.h"

struct vision_poi {
    uint8_t present;
    vec3 position_m;
    struct angles angles;
    float radius_m;
    float paper_left, water_m;
};

struct vision_bowl {
    uint8_t present;
    vec3 position_m;
    float radius_m;
};

#define SNAPSHOT_NO_FISH 0xffffu
/* Largest number of nearby fish in a snapshot, which is more than a person can watch. If more fish
 * are visible, the snapshot keeps the fish nearest to the point of attention. */
#define SNAPSHOT_NEAR_MAX 24u

struct snapshot_fish {
    uint16_t fish; /* Index of the fish in the tank; SNAPSHOT_NO_FISH means no fish. */
    uint8_t place; /* Place of the fish (enum scene_place). */
    uint8_t gulps;
    vec3 position_m, velocity_m_s;
    float heading_rad; /* Yaw of the direction in which the fish's head points. */
    float length_m;
};

/* State of the bot's own paper, computed from the visible picture of the paper. */
struct snapshot_paper {
    float wet;  /* Mean wetness of the remaining paper, [0, 1]. */
    float left; /* Remaining share of the paper, [0, 1]. */
    /* 1 if an undamaged patch of the paper is large enough for a fish, otherwise 0. */
    uint8_t holds;
    /* 1 if the undamaged patch for a fish is at or near the middle of the ring, otherwise 0. */
    uint8_t middle;
    /* Centre, in the poi's plane, of an undamaged patch on which a fish can lie; (0, 0) while the
     * paper is undamaged. */
    float x_m, z_m;
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
    uint32_t near_count;       /* Number of nearby fish in `near`, <= SNAPSHOT_NEAR_MAX. */
    struct snapshot_fish near[SNAPSHOT_NEAR_MAX];
};

#define BOT_HAND_M_S2_MAX 14.0f /* Highest acceleration of the bot's arm, in m/s2. */
#define BOT_WRIST_RAD_S_MAX 7.0f

struct bot_hand {
    struct poi_target pose; /* Current pose of the bot's arm, without tremor. */
    vec3 velocity_m_s;
    struct angles turning; /* Angular velocity of the wrist for each angle of the pose, in rad/s. */
};

enum bot_stage {
    BOT_REST = 0, /* Keeps the poi and its shadow away from the water while no game is played. */
    BOT_SOAK,     /* Wets the new paper in the tank. */
    BOT_CHOOSE,   /* Holds the poi above the water and selects a fish. */
    BOT_APPROACH, /* Moves the poi above the water to the start of the path to the fish. */
    /* Holds the poi above the start of the path until the fish is calm. A still shadow does not
     * startle fish. */
    BOT_WATCH,
    BOT_DIP,   /* Moves the poi down into the water. */
    BOT_GLIDE, /* Levels the poi and moves it under the fish. */
    BOT_LIFT,
    BOT_CARRY,
    BOT_TIP,
    BOT_STAGE_COUNT,
};

struct bot {
    struct technique technique;
    uint32_t seed;       /* Seed of the bot's random numbers. */
    uint8_t stage;       /* Current stage (enum bot_stage). */
    uint16_t prey;       /* Index of the target fish, or SNAPSHOT_NO_FISH. */
    uint32_t stage_tick; /* Tick at which the stage began. */
    /* Tick at which the bot may act on the snapshot `seen`, which is then copied to `known`. */
    uint32_t act_tick;
    uint32_t tries;         /* Number of attempts to catch a fish so far. */
    float yaw_rad;          /* Yaw of the poi's handle with which the bot scoops the target fish. */
    vec3 miss_m;            /* Random aiming error of the present attempt to catch a fish. */
    struct poi_target goal; /* Pose toward which the bot's arm moves. */
    float speed_m_s;        /* Maximum speed of the arm on its way to the pose `goal`. */
    float ease_s;           /* Time in seconds in which the arm accelerates to `speed_m_s`. */
    struct bot_hand hand;
    struct snapshot known; /* Snapshot on which the bot acts at present. */
    struct snapshot seen;  /* Newest snapshot; becomes `known` at `act_tick`. */
};
