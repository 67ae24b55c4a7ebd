/* fish.h -- one goldfish: what it is, where it is, what it is about to do. */
#ifndef KINGYO_CORE_TANK_FISH_H
#define KINGYO_CORE_TANK_FISH_H

#include <stdint.h>

#include "core/base/vec.h"

/* The body box of the 2013 thesis is 5 x 2 x 1 cm; height and width scale with the length. */
#define FISH_HEIGHT_PER_LENGTH 0.36f
#define FISH_WIDTH_PER_LENGTH 0.20f

enum fish_gait {
    GAIT_REST = 0,
    GAIT_SWIM = 1,
    GAIT_BURST = 2,
    GAIT_ESCAPE = 3,  /* From the poi. */
    GAIT_SURFACE = 4, /* Gulping at the surface. */
    GAIT_HELD = 5,    /* On a poi's paper, out of the water: the poi moves it. */
    GAIT_BOWL = 6,    /* Caught: the bowl moves it. */
    GAIT_COUNT,
};

enum fish_avoiding {
    AVOID_NONE = 0,
    AVOID_YAW = 1,
    AVOID_PITCH = 2,
};

struct fish {
    vec3 position_m;   /* Centre of the body box, world. */
    vec3 velocity_m_s; /* World; true motion of the last tick, pushes included. */
    struct angles angles;
    float speed_m_s;   /* Wanted along the nose by the gait, >= 0. */
    float age_days;
    float length_m;    /* Total length; from the growth curve at `age_days`. */
    float stamina;     /* [0, 1]; 0 is exhausted. */
    float tail_phase_rad, tail_beat_hz, tail_amplitude;
    float bend_rad;
    uint32_t look;     /* Random bits for the renderer. */

    uint8_t gait;      /* enum fish_gait */
    uint8_t avoiding;  /* enum fish_avoiding */
    uint8_t holder;    /* Poi or bowl index while GAIT_HELD or GAIT_BOWL. */
    float gait_left_s; /* Until the next choice of gait. */
    float heading_rad; /* Yaw it turns toward, at a bounded rate. */
    float avoid_left_s;
    float avoid_turn;  /* -1 right, 0, +1 left (yaw), or -1 down, +1 up (pitch). */
    float depth_goal_m; /* Wanted y, < 0. */
    float alarm;       /* [0, 1] fright that the poi left behind; fades. */
};

#endif
