/* fish.h -- the state of one goldfish: size, pose, stamina and current goals. A poi is the paper
 * scoop of a player; a tick is 1/120 s. */
#ifndef KINGYO_CORE_TANK_FISH_H
#define KINGYO_CORE_TANK_FISH_H

#include <stdint.h>

#include "core/tank/behavior_params.h"
#include "core/tank/collision/box.h"

/* Largest number of fish in a tank of the kiosk program. A tank preset can have a lower limit
 * (tank_preset_fish_max()). */
#define TANK_FISH_KIOSK 2048u
/* Capacity of struct tank. `kingyoctl tank` and the benchmark are compiled with a larger capacity
 * (platform/ctl/tank/tank.mk). */
#ifndef TANK_FISH_MAX
#define TANK_FISH_MAX TANK_FISH_KIOSK
#endif
_Static_assert(TANK_FISH_MAX >= TANK_FISH_KIOSK, "the kiosk's tank fits in every tank");
#if TANK_FISH_MAX < 65536u
typedef uint16_t fish_index; /* Index of a fish or number of fish, 0 .. TANK_FISH_MAX. */
#else
typedef uint32_t fish_index;
#endif

/* Returns the fish capacity from which a tank with `fish_count` fish derives its limits, for
 * example the length of its contact list. Every build returns TANK_FISH_KIOSK for up to
 * TANK_FISH_KIOSK fish, so that all builds compute equal state hashes. */
static inline uint32_t fish_capacity(uint32_t fish_count)
{
    return fish_count <= TANK_FISH_KIOSK ? TANK_FISH_KIOSK : TANK_FISH_MAX;
}

/* Height above the still water surface. A fish is in the air if the top of its body is higher.
 * Ripples of the surface are lower than this height. */
#define FISH_AIRBORNE_M 0.003f

enum fish_gait {
    GAIT_REST = 0,
    GAIT_SWIM = 1,
    GAIT_BURST = 2,
    GAIT_ESCAPE = 3,  /* The fish escapes from a poi or another stimulus. */
    GAIT_SURFACE = 4, /* The fish gulps at the surface. */
    GAIT_HELD = 5,    /* The fish lies on the paper of a poi, which moves the fish, or the fish is
                         in reentry; see `holder`. */
    GAIT_BOWL = 6,    /* The fish was caught and its bowl moves it. */
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

/* Stage of the surface breathing of a fish; see surface_breathing.h. */
enum fish_air {
    AIR_ENOUGH = 0,
    AIR_RISES = 1, /* The fish is on its way up, in GAIT_SWIM. */
    AIR_GULPS = 2, /* The fish is at the surface, in GAIT_SURFACE. A fish in AIR_DIVES or AIR_DUCKS
                      also stays in GAIT_SURFACE until its body is under water. */
    AIR_DIVES = 3,
    AIR_DUCKS = 4, /* The fish was startled at the surface and goes under water. */
};

/* State of a fish. The members that every tick uses stand first, in groups of four floats (quads).
 * SIMD code transposes a quad of several fish into columns (core/base/simd.h). New members must
 * follow the quads. */
struct fish {
    vec3 position_m; /* Centre of the body box in world coordinates. */
    float speed_m_s; /* Speed >= 0 along the fish's forward axis that the fish's own fins
                        produce. */
    struct angles angles;
    float yaw_rate_rad_s;
    vec3 push_m_s;     /* Velocity that is added to the fish's own motion: repulsion by near fish
                          (as in the 2013 thesis), the flow around a poi, and sidesteps. */
    float climb_m_s;   /* Vertical speed caused by swim bladder, fins and pitch; > 0 is upward. */
    float heading_rad; /* Goal of the yaw, without the attraction of shades. The yaw approaches its
                          goal at a bounded rate. */
    float drawn_rad;   /* Angle by which the attraction of shades turns the goal of the yaw away
                          from `heading_rad`. A value > 0 means to the left. */
    float brake;       /* Factor [0, 1] on the goal of the speed. The factor is below 1 if another
                          fish is close ahead. */
    float room;        /* Factor [0, 1] on the largest turning rate. The factor is below 1 if other
                          fish are close beside the fish. */

    /* The next members and `heading_rad` are goals. Each decision of the fish sets the goals, and
     * the fish approaches the goals in every tick. */
    float speed_goal_m_s; /* Goal of `speed_m_s`, before the multiplication by `brake`. */
    float speed_up_keep;  /* Fraction [0, 1) of the difference to a higher speed goal that remains
                             after one tick. 0 means that the fraction is not yet computed. */
    float slow_keep;      /* Fraction [0, 1) of the difference to a lower speed goal that remains
                             after one tick if the fish does not brake. */
    float turn_rate_max_rad_s;
    float haste; /* Factor >= 1 on the rates at which the fish turns, pitches, bends and changes its
                    tail beat. */
    float climb_goal_m_s, pitch_goal_rad;
    float beats; /* 1 while the tail drives the fish, 0 while the fish glides. */

    float length_m;          /* Total length. */
    float height_m, width_m; /* Height and width of the body box. */
    float stamina;           /* Stamina [0, 1]; 0 means exhausted. */
    vec3 velocity_m_s;       /* Velocity in world coordinates, computed from the real motion of the
                                last tick including pushes. */
    float bend_rad;
    float tail_phase_rad, tail_beat_hz, tail_amplitude;
    float bend_goal_rad; /* Goal of `bend_rad`. swim_settle() adds the bend along the arc of a
                            turn. */
    float age_days;

    uint32_t look;        /* Random bits that select the fish's appearance and individual traits. */
    uint8_t gait;         /* Present gait (enum fish_gait). */
    uint8_t avoiding;     /* Present avoidance of another fish (enum fish_avoiding). */
    uint8_t holder;       /* Index of the poi or bowl that holds the fish: a poi in GAIT_HELD, a
                             bowl in GAIT_BOWL. FISH_HOLDER_WATER in GAIT_HELD means reentry. */
    uint8_t thought_tick; /* Low 8 bits of the tick in which the fish last decided. */
    float gait_left_s;    /* Time until the fish chooses its next gait. For a fish in reentry: time
                             since the fish came back into the water. */
    float avoid_left_s;   /* Time left of the current avoidance. If `avoiding` is AVOID_NONE: time
                             left in which the fish keeps its depth. */
    float avoid_turn;     /* Direction of the avoidance. In AVOID_YAW the value is -1 (sharp
                             right) to +1 (sharp left). In AVOID_PITCH the value is -1 (down) or
                             +1 (up). */
    uint32_t avoid_since; /* First tick of the current encounter with the fish of index
                             `avoid_with`. */
    fish_index avoid_with;
    uint8_t avoid_kind; /* Role of the fish at the beginning of the encounter (enum
                           meeting_kind). */
    uint8_t falls;      /* 1 while the fish falls through the air and only gravity and water
                           resistance move it, otherwise 0. */
    uint8_t air;        /* Stage of surface breathing (enum fish_air). */
    uint8_t startle;    /* Cause of a startle whose latency has not yet ended (enum startle_cause);
                           0 means none. */
    float depth_goal_m; /* Preferred depth as a y coordinate, < 0. */
    float depth_stray;  /* Random offset that is added to the preferred depth for the fish's
                           stamina, as a fraction of the water depth. A value > 0 means upward. */

    /* The next members are the state of the startle response; see startle.h. */
    float alarm;     /* Alarm [0, 1], which decays over time. */
    float habit;     /* Habituation [0, 1] to startling stimuli, which decays over time. */
    float startle_s; /* Time left of the startle latency. */
    vec3 startle_from_m;
    float refractory_s;      /* Time until the fish can begin another C-start. */
    float escape_s;          /* Time from the beginning of the last C-start to the current tick. */
    float escape_from_rad;   /* Yaw at the beginning of the C-start. */
    float escape_turn_rad;   /* Turn of the head in stage 1 of the C-start; > 0 is to the left. */
    float escape_course_rad; /* Turn of the body in the whole C-start; > 0 is to the left. */
};

/* Returns the largest height above the still surface, m, at which the top of the fish's box still
 * counts as in the water. A gulping fish may rise by its own height. */
static inline float fish_emerges_m(const struct fish *fish)
{
    return (fish->gait == GAIT_SURFACE ? fish->height_m : 0.0f) + FISH_AIRBORNE_M;
}

/* Returns 1 if the fish swims or falls freely. Returns 0 if a poi or bowl carries the fish or if
 * the fish is in reentry. */
static inline int fish_swims(const struct fish *fish)
{
    return fish->gait != GAIT_HELD && fish->gait != GAIT_BOWL;
}

/* Sets the length of the fish, and computes the height and width of its box from the behavior
 * parameters of the tank. */
void fish_grow(struct fish *fish, float length_m, const struct behavior_params *params);

struct box fish_box(const struct fish *fish);

/* Returns the wet mass of a goldfish (Carassius auratus, Lake Egirdir): W = 0.0210 * L^3.0598 with
 * the mass W in g and the length L in cm. */
float fish_mass_kg(float length_m);

/* Returns the unit vector along the fish's forward axis in world coordinates. */
vec3 fish_forward(const struct fish *fish);

uint64_t fish_hash(uint64_t hash, const struct fish *fish);       /* Hashes every field. */
uint64_t fish_hash_quick(uint64_t hash, const struct fish *fish); /* Hashes pose and gait only. */

#endif
