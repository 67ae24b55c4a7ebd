/* fish.h -- the state of one goldfish: size, pose, stamina and current goals. A poi is the paper
 * scoop with which a player catches fish. A tick is one step of the simulation, 1/120 s. */
#pragma once

#include <stdbool.h>
#include <stdint.h>

#include "core/tank/behavior_params.h"
#include "core/tank/collision/box.h"

/* Largest number of fish in a tank of the kiosk program. A tank preset can have a lower limit
 * (tank_preset_fish_max()). */
#define TANK_FISH_KIOSK 2048u
/* Capacity of struct tank in fish. The program `kingyoctl tank` and the benchmark are compiled with
 * a larger capacity (platform/ctl/tank/tank.mk). */
#ifndef TANK_FISH_MAX
#define TANK_FISH_MAX TANK_FISH_KIOSK
#endif
_Static_assert(TANK_FISH_MAX >= TANK_FISH_KIOSK, "the kiosk's tank fits in every tank");
#if TANK_FISH_MAX < 65536u
typedef uint16_t fish_index; /* Index of a fish or number of fish, 0 .. TANK_FISH_MAX. */
#else
typedef uint32_t fish_index;
#endif

/* Returns the capacity, in fish, of the lists of a tank with `fish_count` fish. The contact list is
 * such a list. Up to TANK_FISH_KIOSK fish, the result does not depend on TANK_FISH_MAX. Therefore
 * programs that were compiled with different values of TANK_FISH_MAX compute equal state hashes. */
static inline uint32_t fish_capacity(uint32_t fish_count)
{
    return fish_count <= TANK_FISH_KIOSK ? TANK_FISH_KIOSK : TANK_FISH_MAX;
}

/* A fish counts as in the air if the top of its body is higher than this height above the still
 * water surface. Ripples are lower, so a ripple alone never puts a fish into the air. */
#define FISH_AIRBORNE_M 0.003f

enum fish_gait {
    GAIT_REST = 0,
    GAIT_SWIM = 1,
    GAIT_BURST = 2,
    GAIT_ESCAPE = 3,  /* The fish escapes from a poi or another stimulus. */
    GAIT_SURFACE = 4, /* The fish gulps at the surface. */
    /* The fish lies on the paper of a poi (paper scoop), which moves the fish. A fish in reentry
     * also has this gait: it is back in the water but still overlaps other fish. `holder`
     * distinguishes the two cases. */
    GAIT_HELD = 5,
    GAIT_BOWL = 6, /* The fish was caught and is in a bowl, which moves the fish. */
    GAIT_COUNT,
};

/* Value of `holder` for a GAIT_HELD fish in reentry: the fish is back in the water but still
 * overlaps other fish (reentry.c). */
#define FISH_HOLDER_WATER 255u

enum fish_avoiding {
    AVOID_NONE = 0,
    AVOID_YAW = 1,
    AVOID_PITCH = 2,
};

/* Stages of surface breathing, in which a fish short of oxygen swims up and gulps at the water
 * surface (surface_breathing.h). */
enum fish_air {
    AIR_ENOUGH = 0,
    AIR_RISES = 1, /* The fish is on its way up, in GAIT_SWIM. */
    /* The fish is at the surface, in GAIT_SURFACE. A fish in AIR_DIVES or AIR_DUCKS also stays in
     * GAIT_SURFACE until its body is under water. */
    AIR_GULPS = 2,
    AIR_DIVES = 3,
    AIR_DUCKS = 4, /* The fish was startled at the surface and dives to get under water. */
};

/* State of a fish. The members that every tick uses stand first, in groups of four floats (quads).
 * SIMD code transposes a quad of several fish into columns (core/base/simd.h). New members must
 * follow the quads. */
struct fish {
    vec3 position_m; /* Centre of the body box in world coordinates. */
    /* Speed >= 0 along the fish's forward axis that the fish's own fins produce. */
    float speed_m_s;
    struct angles angles;
    float yaw_rate_rad_s;
    /* Velocity that is added to the velocity of the fish's own swimming. Causes are repulsion by
     * nearby fish, the flow around a moving poi (paper scoop), and sidesteps beside a poi. */
    vec3 push_m_s;
    float climb_m_s; /* Vertical speed caused by swim bladder, fins and pitch; > 0 is upward. */
    /* Yaw to which the fish turns, without the attraction of shades on the water. The fish turns at
     * a bounded rate. */
    float heading_rad;
    /* Angle that is added to `heading_rad` because a shade on the water attracts the fish. A value
     * > 0 turns the fish to the left. */
    float drawn_rad;
    /* Factor [0, 1] by which the speed goal of the fish is multiplied. The factor is below 1 if
     * another fish is close ahead. */
    float brake;
    /* Factor [0, 1] by which the largest turning rate of the fish is multiplied. The factor is
     * below 1 if other fish are close beside the fish. */
    float room;

    /* The goals of the fish are `heading_rad` and the members from here to `beats`. Each decision
     * of the fish sets new goals. In every tick, the present values approach the goals. For
     * example, `speed_m_s` approaches `speed_goal_m_s`. */
    float speed_goal_m_s; /* Speed that the fish approaches. `brake` multiplies this speed while
                             another fish is close ahead. */
    /* Acceleration: while the speed is below its goal, each tick multiplies the difference by this
     * factor [0, 1). A larger factor means slower acceleration. 0 means that the factor is not yet
     * computed. */
    float speed_up_keep;
    /* Deceleration without braking: while the speed is above its goal, each tick multiplies the
     * difference by this factor [0, 1). A larger factor means slower deceleration. */
    float slow_keep;
    float turn_rate_max_rad_s;
    /* Factor >= 1 by which the fish turns, pitches, bends and changes its tail beat faster than
     * normal. */
    float haste;
    float climb_goal_m_s, pitch_goal_rad;
    float beats; /* 1 while the tail drives the fish, 0 while the fish glides. */

    float length_m;          /* Total length. */
    float height_m, width_m; /* Height and width of the body box. */
    float stamina;           /* Stamina [0, 1]; 0 means exhausted. */
    /* Velocity in world coordinates, computed from the real motion of the fish in the last tick.
     * The motion includes pushes by other fish and obstacles. */
    vec3 velocity_m_s;
    float bend_rad;
    float tail_phase_rad, tail_beat_hz, tail_amplitude;
    /* Intended bend of the body, not counting the bend that follows from a turn. swim_settle()
     * moves `bend_rad` toward the sum of both bends. */
    float bend_goal_rad;
    float age_days;

    uint32_t look;    /* Random bits that select the fish's appearance and individual traits. */
    uint8_t gait;     /* Present gait (enum fish_gait). */
    uint8_t avoiding; /* Present avoidance of another fish (enum fish_avoiding). */
    /* Index of the poi or bowl that holds the fish: a poi in GAIT_HELD, a bowl in GAIT_BOWL.
     * FISH_HOLDER_WATER in GAIT_HELD means reentry. */
    uint8_t holder;
    uint8_t thought_tick; /* Low 8 bits of the number of the tick in which the fish last decided. */
    /* Time until the fish chooses its next gait. For a fish in reentry: time since the fish came
     * back into the water. */
    float gait_left_s;
    /* Remaining time of the present avoidance of another fish. After an avoidance, when `avoiding`
     * is AVOID_NONE: remaining time in which the fish keeps its depth. */
    float avoid_left_s;
    /* Direction of the avoidance. In AVOID_YAW the value is -1 (sharp right) to +1 (sharp left). In
     * AVOID_PITCH the value is -1 (down) or +1 (up). */
    float avoid_turn;
    /* First tick of the current encounter with the fish of index `avoid_with`. */
    uint32_t avoid_since;
    fish_index avoid_with;
    /* Role of the fish at the beginning of the encounter with another fish (enum meeting_kind). */
    uint8_t avoid_kind;
    /* True while the fish falls through the air and only gravity and water resistance move the
     * fish. */
    bool falls;
    uint8_t air; /* Present stage of the fish's surface breathing (enum fish_air). */
    /* Cause of a startle to which the fish has not yet reacted (enum startle_cause). 0 means that
     * the fish is not startled. */
    uint8_t startle;
    float depth_goal_m; /* Depth that the fish prefers, as a y coordinate < 0. */
    /* Random offset of the depth that the fish prefers, as a fraction of the water depth. A value >
     * 0 means upward. The preferred depth without the offset follows from the stamina. */
    float depth_stray;

    /* State of the startle response: the members from here to the end of the struct. A startled
     * fish escapes by a C-start, a fast turn and thrust (startle.h). */
    float alarm;     /* Alarm [0, 1] of the fish. Startling stimuli raise the alarm, and the alarm
                        decays over time. */
    float habit;     /* Habituation [0, 1] to startling stimuli, which decays over time. */
    float startle_s; /* Time until the startled fish begins its escape. */
    vec3 startle_from_m;
    float refractory_s; /* Time until the fish can begin another C-start (escape). */
    /* Time from the beginning of the last C-start (escape) to the current tick. */
    float escape_s;
    float escape_from_rad; /* Yaw of the fish at the beginning of its last C-start (escape). */
    /* Angle by which the head turns in the first stage of the C-start (escape). A value > 0 means
     * to the left. */
    float escape_turn_rad;
    /* Angle by which the body turns in the whole C-start (escape). A value > 0 means to the
     * left. */
    float escape_course_rad;
};

/* Returns the height of the top of the body, m, above which the fish counts as in the air. The
 * height is measured from the still water surface and is FISH_AIRBORNE_M. For a gulping fish the
 * height is greater by the height of its body, because a gulping fish puts its head out of the
 * water. */
static inline float fish_emerges_m(const struct fish *fish)
{
    return (fish->gait == GAIT_SURFACE ? fish->height_m : 0.0f) + FISH_AIRBORNE_M;
}

/* Returns true if the fish swims or falls freely. Returns false while a poi (paper scoop) or a bowl
 * carries the fish. Also returns false in reentry, while a fish that came back into the water still
 * overlaps other fish. */
static inline bool fish_swims(const struct fish *fish)
{
    return fish->gait != GAIT_HELD && fish->gait != GAIT_BOWL;
}

/* Sets the length of the fish, and computes the height and width of its box from the behavior
 * parameters of the tank. */
void fish_grow(struct fish *fish, float length_m, const struct behavior_params *params);

struct box fish_box(const struct fish *fish);

/* Returns the wet mass of a goldfish from its length. The formula was measured on Carassius auratus
 * in Lake Egirdir: W = 0.0210 * L^3.0598 with the mass W in g and the length L in cm. */
float fish_mass_kg(float length_m);

/* Returns the unit vector along the fish's forward axis in world coordinates. */
vec3 fish_forward(const struct fish *fish);

/* Returns true if the fish is one of the calm fish of `temper`: a small fish that stays near the
 * surface. */
bool fish_is_calm(const struct fish *fish, const struct temper *temper);
