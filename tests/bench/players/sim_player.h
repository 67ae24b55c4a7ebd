/* sim_player.h -- a simulated player. The player chooses a fish on the screen, moves a poi (paper
 * scoop) to the fish, dips, follows the fish, lifts, and carries the catch to the bowl.
 *
 * A bot (core/game/bot) reads the state of the game. A simulated player sees only the scene, and
 * acts through an input device (device.h) with the limits of that device. The habits of a player
 * are numbers (struct habits), and all players use the same state machine.
 *
 * A player sees each frame after a delay, the reaction time. A ring buffer keeps the pictures of
 * this time. Distances on the screen are pixels of a window of PLAYER_WIDTH_PX x PLAYER_HEIGHT_PX,
 * in which the poi has a diameter of about 160 pixels. */
#ifndef KINGYO_TESTS_BENCH_PLAYERS_SIM_PLAYER_H
#define KINGYO_TESTS_BENCH_PLAYERS_SIM_PLAYER_H

#include <stdbool.h>
#include <stdint.h>

#include "core/scene.h"

#define PLAYER_HZ 60u /* Frames per second of the screen and of the input device. */
#define PLAYER_WIDTH_PX 1920.0f
#define PLAYER_HEIGHT_PX 1080.0f

/* ---- Habits ---------------------------------------------------------------------------------- */

/* Signs on the screen that a player may follow: the hints beside the poi (enum scene_hint), and the
 * other aids of the lessons. */
enum player_sign {
    SIGN_ARROW = HINT_COUNT, /* The arrow to the bowl. */
    SIGN_RING,               /* The ring around a fish that is easy to catch. */
    /* The ghost: a translucent poi on the screen that shows how to scoop a fish. */
    SIGN_GHOST,
};

enum player_device {
    PLAYER_MOUSE = 0,
    /* Touch screen: one finger moves the ring, and a second finger dips the ring. */
    PLAYER_FINGER,
    /* Gamepad: the left stick moves the ring, and button A dips the ring. */
    PLAYER_GAMEPAD,
    PLAYER_POI, /* Kingyo's poi controller, which reports its pose. */
    PLAYER_BOT, /* The expert bot of the core, which needs no device. */
};

struct habits {
    const char *name;
    uint8_t device; /* Input device (enum player_device). */

    /* Sign (enum scene_hint or enum player_sign) after which the player has the habits `cured`; 0
     * means that the player follows no sign. */
    uint8_t sign;
    const struct habits *cured;

    /* Time of the round before which the player does not choose a fish, or does not dip. */
    float start_s, dip_start_s;
    bool takes_marked; /* True if the player chooses the fish with the ring, if there is one. */
    bool keeps;        /* True if the player does not carry the catch to the bowl. */

    float reaction_s; /* Seconds from the display of a picture to the player's reaction to it. */
    /* Fraction [0, 1] of the reaction time for which the player predicts the motion of a fish. With
     * 1, the player aims at the current position of the fish. With 0, the player aims at the
     * position in the delayed picture, as a beginner does. */
    float lead;
    /* Largest random aiming error of an attempt in each direction, in pixels. */
    float aim_px;

    float pause_s; /* Time that the player waits before choosing a fish. */

    /* The player chooses the fish with the lowest cost. The cost is the sum of the following terms
     * in pixels and of a random term between 0 and `cost_random_px`. */
    float cost_distance; /* Pixels of cost for each pixel of distance between fish and ring. */
    /* Cost of the fish's speed, in 1,000 pixels of cost per m/s. */
    float cost_speed_s;
    /* Cost of the fish's depth, in 1,000 pixels of cost per metre. */
    float cost_depth;
    /* Cost of the fish's length, in 1,000 pixels of cost per metre. */
    float cost_length;
    float cost_random_px;

    float arm_px_s; /* Highest speed of the pointer while the ring is above the water. */
    /* Distance beside the fish, in pixels, of the place where the player dips. */
    float beside_px;
    /* When the ring is within this distance of the goal, in pixels, the player dips. */
    float reach_px;
    /* Highest speed of a fish beside which the player dips; 0 means no limit. */
    float calm_m_s;
    /* Longest time from the choice of a fish to the dip. After this time the player dips in any
     * case. If `calm_m_s` is set, the player chooses another fish instead. */
    float patience_s;

    /* Shortest and longest time for which the player holds the ring still under water. */
    float hold_min_s, hold_max_s;
    /* The hold ends when a fish above the ring is within this distance of the ring, in pixels. 0
     * means that the hold always lasts for its full time. */
    float until_px;
    /* Shortest and longest time for which the player follows the fish under water; 0 means that the
     * player lifts at once. */
    float follow_min_s, follow_max_s;
    float glide_px_s; /* Highest speed of the pointer while the ring is under water. */
    /* When fish and ring are within this distance in pixels, the player lifts. 0 means that only
     * the time limit ends the pursuit. */
    float over_px;
    /* If the chosen fish is farther than this distance from the ring, in pixels, the player follows
     * the nearest fish above the ring instead. 0 means that the player always follows the chosen
     * fish. */
    float lost_px;
    /* Seconds from the lift until the player checks whether a fish is on the paper. */
    float rise_s;
    float carry_px_s; /* Highest speed of the pointer on the way to the bowl. */

    /* Wheel notches by which the player tilts the ring before the dip. Negative values lower the
     * far edge. */
    float tilt_notches;
    /* True if the player levels the ring under water; false if the ring stays tilted until the
     * lift. */
    bool levels;

    /* The following fields are used only for PLAYER_POI: */
    float dip_m_s, lift_m_s; /* Vertical speeds of the ring when it goes down and when it is
                                lifted. */
    float entry_rad;         /* Tilt of the ring while it goes down, in radians. */
    float tremor_m;          /* Amplitude of the tremor of the player's hand. */
    float depth_m;           /* Height of the dipped ring; 0 means DIP_DEPTH_M. */
};

/* Rows of the table of players (habits.c), in the order of the report. */
extern const struct habits sim_player_table[];
extern const uint32_t sim_player_table_count;

/* ---- Player ---------------------------------------------------------------------------------- */

enum player_state {
    PLAYER_CHOOSE = 0, /* The player chooses a fish. */
    PLAYER_REACH,      /* The player moves the ring above the water to the place of the dip. */
    PLAYER_STILL,      /* The player dips and then holds the ring still. */
    PLAYER_FOLLOW,     /* The player follows the fish under water. */
    PLAYER_RISE,       /* The player lifts the ring. */
    PLAYER_CARRY,      /* The player carries the catch to the bowl. */
    PLAYER_STATE_COUNT,
};

#define PLAYER_NO_FISH 0xffffu
#define PLAYER_FISH_MAX 512u
/* Capacity of the ring buffer of pictures, in frames. The longest reaction time plus SPEED_FRAMES
 * must fit in the buffer. */
#define PLAYER_SIGHT_MAX 48u

struct sight_fish {
    vec3 position_m;
    float length_m;
    bool swims; /* True while the fish is in the water of the tank. */
};

/* Picture of one frame, as one player sees it. */
struct sight {
    bool in_round;  /* True while the round runs. */
    bool has_catch; /* True while a fish lies on the player's paper. */
    uint8_t hint;   /* Hint beside the player's poi (enum scene_hint). */
    bool has_arrow, has_ghost;
    uint16_t marked; /* Index of the fish with the player's ring, or PLAYER_NO_FISH. */
    vec3 ring_m, bowl_m;
    /* Positions of the other players' bowls. */
    vec3 other_bowls_m[POI_MAX];
    uint32_t other_bowl_count;
    float bowl_radius_m;
    vec3 tank_m; /* Inner size of the tank. */
    uint32_t fish_count;
    struct sight_fish fish[PLAYER_FISH_MAX];
};

/* Command that a player gives to the input device in one frame. */
struct player_command {
    float x_px, y_px;   /* Position on the screen to which the ring should move. */
    float speed_px_s;   /* Highest speed of the ring while it moves to the position `x_px`,
                           `y_px`. */
    bool dips;          /* True while the ring should be under water. */
    bool tips;          /* True while the catch should slide from the paper into the bowl. */
    float tilt_notches; /* Tilt of the ring in notches of a wheel. */
    /* Position on the screen at which the player sees the ring now. */
    float ring_x_px, ring_y_px;
};

struct sim_player {
    const struct habits *habits;
    struct view view;
    uint32_t seed;
    uint32_t frame;       /* Number of frames that the player has seen. */
    uint32_t round_frame; /* Number of frames of the round seen. */
    uint8_t state;        /* Current state (enum player_state). */
    uint32_t state_frame; /* Frame in which the state began. */
    uint32_t tries;       /* Number of fish chosen so far. */
    uint16_t prey;        /* Index of the chosen fish, or PLAYER_NO_FISH. */
    float side;           /* Side of the fish at which the player dips: -1 is left, 1 is right. */
    float error_x_px, error_y_px; /* Aiming error of the current attempt, in pixels. */
    /* Random durations of the current attempt, in seconds: the time of holding the ring still, and
     * the time of following the fish. */
    float hold_s, follow_s;
    struct player_command command;
    struct sight sights[PLAYER_SIGHT_MAX];
};

/* Initializes a player. All random numbers of the player depend only on `seed`. The struct keeps
 * the pointer `habits`, so `habits` must stay valid. */
void sim_player_init(struct sim_player *player, const struct habits *habits,
                     const struct view *view, uint32_t seed);

/* Copies what the player at bowl `slot` can see in `scene` to `sight`. */
void sim_player_see(const struct scene *scene, uint32_t slot, struct sight *sight);

/* Advances the player by one frame, in which the screen shows the picture `now`. Returns the
 * player's command to the input device. */
struct player_command sim_player_frame(struct sim_player *player, const struct sight *now);

/* Computes the position of `point_m` on the screen in pixels. */
void sim_player_to_screen(const struct view *view, vec3 point_m, float *x_px, float *y_px);

#endif
