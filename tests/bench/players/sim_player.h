/* sim_player.h -- a simulated player: chooses a fish on the screen, moves a poi (paper scoop) to
 * the fish, dips, follows the fish, lifts and carries the catch to the bowl.
 *
 * A simulated player differs from a bot (core/game/bot) in two ways. The player sees only the
 * scene, and acts through an input device (device.h) with the limits of that device. The habits of
 * a player are numbers (struct habits), and all players share one state machine.
 *
 * A player sees each frame late by the player's reaction time. A ring buffer of sights holds what
 * the screen showed meanwhile. Distances on the screen are pixels of a window of PLAYER_WIDTH_PX x
 * PLAYER_HEIGHT_PX, on which the poi has a diameter of about 160 pixels. */
#ifndef KINGYO_TESTS_BENCH_PLAYERS_SIM_PLAYER_H
#define KINGYO_TESTS_BENCH_PLAYERS_SIM_PLAYER_H

#include <stdbool.h>
#include <stdint.h>

#include "core/scene.h"

#define PLAYER_HZ 60u /* Frames per second: what the screen shows and what the device reports. */
#define PLAYER_WIDTH_PX 1920.0f
#define PLAYER_HEIGHT_PX 1080.0f

/* ---- Habits ---------------------------------------------------------------------------------- */

enum player_device {
    PLAYER_MOUSE = 0,
    PLAYER_FINGER,  /* Touch screen: one finger moves the ring, a second finger dips it. */
    PLAYER_GAMEPAD, /* The left stick moves the ring, button A dips it. */
    PLAYER_POI,     /* Kingyo's poi controller, which reports its pose. */
    PLAYER_BOT,     /* The expert bot of the core, which needs no device. */
};

struct habits {
    const char *name;
    uint8_t device; /* Input device (enum player_device). */

    float reaction_s; /* Delay between the screen and the player's action. */
    /* Prediction of the fish's motion, as a fraction [0, 1] of the reaction time. 1 aims at the
     * place where the fish is now. 0, the value of a beginner, aims at the place where the player
     * saw the fish. */
    float lead;
    /* Largest aiming error in pixels, to the left or right and up or down. Each attempt has a
     * random error. */
    float aim_px;

    float pause_s; /* Pause before the choice of a fish. */

    /* The player chooses the fish with the least cost. The cost is in pixels and is the sum of the
     * terms below. `cost_random_px` is the largest random term. */
    float cost_distance; /* Cost for each pixel of distance from the ring. */
    float cost_speed_s;  /* Cost of the fish's speed, in 1,000 pixels per m/s. */
    float cost_depth;    /* Cost of the fish's depth, in 1,000 pixels per metre. */
    float cost_length;   /* Cost of the fish's length, in 1,000 pixels per metre. */
    float cost_random_px;

    float arm_px_s;  /* Highest speed of the pointer above the water. */
    float beside_px; /* Distance from the fish at which the player dips. */
    /* The player dips when the ring is within this distance of its goal, in pixels. */
    float reach_px;
    float calm_m_s;   /* The player dips only if the fish is slower. 0 means no limit. */
    float patience_s; /* Longest time from the choice of a fish until the player dips anyway (no
                          `calm_m_s`) or chooses another fish. */

    float hold_min_s, hold_max_s; /* Time for which the player holds the ring still under water. */
    float until_px; /* A fish within this distance of the still ring ends the hold. 0 means that
                       no fish ends the hold. */
    float follow_min_s, follow_max_s; /* Longest time for which the ring follows the fish under
                                         water. 0 means that the player lifts at once. */
    float glide_px_s; /* Highest speed of the pointer while the ring is under water. */
    float over_px;    /* Distance between fish and ring at which the player lifts. 0: only the time
                         ends the pursuit. */
    /* If the fish is farther from the ring than this distance, the player follows the fish nearest
     * to the ring instead. 0 means never. */
    float lost_px;
    float rise_s; /* Time from the lift until the player looks whether a fish is on the paper. */
    float carry_px_s; /* Highest speed of the pointer on the way to the bowl. */

    float tilt_notches; /* Wheel notches by which the player tilts the ring before the dip. Negative
                           values lower the far edge. */
    bool levels;        /* True if the player levels the ring under water. False if the ring stays
                           tilted until the lift. */

    /* Only for PLAYER_POI: */
    float dip_m_s, lift_m_s; /* Vertical speed of the ring. */
    float entry_rad;         /* Tilt of the ring while it goes down. */
    float tremor_m;          /* Amplitude of the tremor of the player's hand. */
};

/* Rows of the table of players, in the order of the report (habits.c). */
extern const struct habits sim_player_table[];
extern const uint32_t sim_player_table_count;

/* ---- Player ---------------------------------------------------------------------------------- */

enum player_state {
    PLAYER_CHOOSE = 0, /* Chooses a fish. */
    PLAYER_REACH,      /* Moves the ring above the water to the place of the dip. */
    PLAYER_STILL,      /* Dips, and holds the ring still. */
    PLAYER_FOLLOW,     /* Follows the fish under water. */
    PLAYER_RISE,       /* Lifts the ring. */
    PLAYER_CARRY,      /* Carries the catch to the bowl. */
    PLAYER_STATE_COUNT,
};

#define PLAYER_NO_FISH 0xffffu
#define PLAYER_FISH_MAX 512u
/* Capacity of the ring buffer of pictures, in frames. It covers the longest reaction time plus
 * SPEED_FRAMES. */
#define PLAYER_SIGHT_MAX 48u

struct sight_fish {
    vec3 position_m;
    float length_m;
    bool swims; /* True while the fish is in the water of the tank. */
};

/* What the screen shows in one frame. */
struct sight {
    bool in_round;  /* True while the round runs. */
    bool has_catch; /* True while a fish lies on the paper. */
    vec3 ring_m, bowl_m;
    float bowl_radius_m;
    vec3 tank_m; /* Inner size of the tank. */
    uint32_t fish_count;
    struct sight_fish fish[PLAYER_FISH_MAX];
};

/* Command of a player to its input device in one frame. */
struct player_command {
    float x_px, y_px;   /* Place on the screen where the ring should be. */
    float speed_px_s;   /* Highest speed on the way there. */
    bool dips;          /* True while the ring should be under water. */
    bool tips;          /* True while the catch should slide from the paper into the bowl. */
    float tilt_notches; /* Tilt of the ring in notches of a wheel. */
    float ring_x_px, ring_y_px; /* Place on the screen where the player sees the ring. */
};

struct sim_player {
    const struct habits *habits;
    struct view view;
    uint32_t seed;
    uint32_t frame;       /* Number of frames seen. */
    uint8_t state;        /* Present state (enum player_state). */
    uint32_t state_frame; /* Frame in which the state began. */
    uint32_t tries;       /* Number of fish chosen so far. */
    uint16_t prey;        /* Chosen fish, or PLAYER_NO_FISH. */
    float side;           /* Side of the fish at which the player dips: -1 is left, 1 is right. */
    float error_x_px, error_y_px; /* Aiming error of the present attempt. */
    /* Random durations of the present attempt, s: how long the player holds the ring still, and how
     * long it follows the fish. */
    float hold_s, follow_s;
    struct player_command command;
    struct sight sights[PLAYER_SIGHT_MAX];
};

/* Initializes a player whose random numbers depend only on `seed`. `habits` is kept. */
void sim_player_init(struct sim_player *player, const struct habits *habits,
                     const struct view *view, uint32_t seed);

/* Copies what a person sees in `scene` to `sight`. */
void sim_player_see(const struct scene *scene, struct sight *sight);

/* Advances the player by one frame, with the picture that the screen shows now. Returns what the
 * player does. */
struct player_command sim_player_frame(struct sim_player *player, const struct sight *now);

/* Writes the place of `point_m` on the screen to `x_px` and `y_px`. */
void sim_player_to_screen(const struct view *view, vec3 point_m, float *x_px, float *y_px);

#endif
