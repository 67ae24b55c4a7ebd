/* fish.h -- one goldfish: identity, pose and current goals. */
#ifndef KINGYO_CORE_TANK_FISH_H
#define KINGYO_CORE_TANK_FISH_H

#include <stdint.h>

#include "core/tank/behavior_params.h"
#include "core/tank/collision/box.h"

/* Capacity for the deepest tank; preset.h has the limit of each tank. */
#define TANK_FISH_KIOSK 2048u
/* `kingyoctl tank` and the benchmark compile a tank with more capacity
 * (platform/ctl/tank/tank.mk). */
#ifndef TANK_FISH_MAX
#define TANK_FISH_MAX TANK_FISH_KIOSK
#endif
_Static_assert(TANK_FISH_MAX >= TANK_FISH_KIOSK, "the kiosk's tank fits in every tank");
#if TANK_FISH_MAX < 65536u
typedef uint16_t fish_index; /* Also holds counts of fish, up to the capacity. */
#else
typedef uint32_t fish_index;
#endif

/* Returns the capacity for which the limits of a tank with `fish_count` fish are computed. Up to
 * TANK_FISH_KIOSK fish every build has the limits of the kiosk, so that all builds reach the same
 * hash. */
static inline uint32_t fish_capacity(uint32_t fish_count)
{
    return fish_count <= TANK_FISH_KIOSK ? TANK_FISH_KIOSK : TANK_FISH_MAX;
}

/* A body whose top stands higher above the surface than this is in the air. A ripple is lower. */
#define FISH_AIRBORNE_M 0.003f

enum fish_gait {
    GAIT_REST = 0,
    GAIT_SWIM = 1,
    GAIT_BURST = 2,
    GAIT_ESCAPE = 3,  /* Escape from the poi or another stimulus. */
    GAIT_SURFACE = 4, /* Gulping at the surface. */
    GAIT_HELD = 5,    /* On a poi's paper, out of the water: the poi moves the fish; see
                         `holder`. */
    GAIT_BOWL = 6,    /* Caught: the bowl moves the fish. */
    GAIT_COUNT,
};

/* `holder` of a GAIT_HELD fish that is back in the water but not yet clear of other fish
 * (reentry.h). */
#define FISH_HOLDER_WATER 255u

enum fish_avoiding {
    AVOID_NONE = 0,
    AVOID_YAW = 1,
    AVOID_PITCH = 2,
};

/* Stage of surface breathing of a fish short of oxygen; see surface_breathing.h. */
enum fish_air {
    AIR_ENOUGH = 0,
    AIR_RISES = 1, /* On the way up, in GAIT_SWIM. */
    AIR_GULPS = 2, /* At the surface, in GAIT_SURFACE. AIR_DIVES and AIR_DUCKS also have that gait,
                      until the body is under water. */
    AIR_DIVES = 3,
    AIR_DUCKS = 4, /* Startled at the surface. */
};

/* The members used in every tick stand first, in groups of four floats: SIMD code transposes a quad
 * of several fish into columns (core/base/simd.h). New members belong behind them. */
struct fish {
    vec3 position_m; /* Centre of the body box, world. */
    float speed_m_s; /* Speed along the nose by the fish's own fins, >= 0. */
    struct angles angles;
    float yaw_rate_rad_s;
    vec3 push_m_s;     /* Repulsion by near fish (the thesis' repulsion). */
    float climb_m_s;   /* Vertical speed by swim bladder, fins and pitch, + up. */
    float heading_rad; /* Goal of the yaw, reached at a bounded rate. */
    float drawn_rad;   /* Offset of the nose from the heading due to a shade, + left. */
    float brake;       /* [0, 1] share of the speed that a fish ahead leaves. */
    float room;        /* [0, 1] share of the turning rate that bodies at the sides leave. */

    /* Goals that the last decision of the fish set, beside heading_rad. Every tick follows them. */
    float speed_goal_m_s; /* Speed goal along the nose, before `brake`. */
    float speed_up_keep;  /* [0, 1) share of a speed deficit that remains one tick later. */
    float slow_keep;      /* [0, 1) share of a speed excess that remains one tick later without a
                             brake. */
    float turn_rate_max_rad_s;
    float haste; /* >= 1: factor on the speed of turning, tilting, bending and tail beats. */
    float climb_goal_m_s, pitch_goal_rad;
    float beats; /* 1: the tail drives the fish; 0: the fish glides. */

    float length_m;          /* Total length, from the growth curve at `age_days`. */
    float height_m, width_m; /* Height and width of the body box. */
    float stamina;           /* [0, 1]; 0 is exhausted. */
    vec3 velocity_m_s;       /* World velocity; true motion of the last tick, pushes included. */
    float bend_rad;
    float tail_phase_rad, tail_beat_hz, tail_amplitude;
    float bend_goal_rad; /* Goal of the bend, beside the bend due to the arc of the course. */
    float age_days;

    uint32_t look;        /* Random bits for the renderer and for individual traits. */
    uint8_t gait;         /* enum fish_gait */
    uint8_t avoiding;     /* enum fish_avoiding */
    uint8_t holder;       /* Index of the poi or bowl while GAIT_HELD or GAIT_BOWL. */
    uint8_t thought_tick; /* Low bits of the tick of the last decision. */
    float gait_left_s;    /* Time until the next choice of gait. For a fish in reentry: time since
                             it came back. */
    float avoid_left_s;   /* Time left of avoidance; afterwards time left of keeping the depth. */
    float avoid_turn;     /* -1 right .. +1 left (yaw), or -1 down, +1 up (pitch). */
    uint32_t avoid_since; /* First tick of the current encounter; `avoid_with` is its partner. */
    fish_index avoid_with;
    uint8_t avoid_kind; /* enum meeting_kind of this fish at the start of the encounter. */
    uint8_t falls;      /* 1 while the fish falls through the air: no other motion applies. */
    uint8_t air;        /* enum fish_air */
    uint8_t startle;    /* enum startle_cause whose latency runs; 0 if none. */
    float depth_goal_m; /* Preferred y, < 0. */
    float depth_stray;  /* Offset of the preferred depth from that of its band, as a share of the
                           water depth, + up. */

    /* Startle state; see startle.h and escape.h. */
    float alarm;     /* [0, 1] alarm; decays. */
    float habit;     /* [0, 1] habituation to startling stimuli; decays. */
    float startle_s; /* Time left of the latency. */
    vec3 startle_from_m;
    float refractory_s;      /* Time until the fish can start again. */
    float escape_s;          /* Time from the start of the last C-start to this tick. */
    float escape_from_rad;   /* Yaw at the start of the C-start. */
    float escape_turn_rad;   /* Turn of the head in stage 1, + left. */
    float escape_course_rad; /* Turn of the body in the whole start, + left. */
};

/* Returns how far the top of the box may stand above the surface before the fish counts as
 * airborne. A gulping fish may rise by its height. */
static inline float fish_emerges_m(const struct fish *fish)
{
    return (fish->gait == GAIT_SURFACE ? fish->height_m : 0.0f) + FISH_AIRBORNE_M;
}

/* Returns 1 if this module moves the fish, which is neither carried by a poi nor in a bowl. */
static inline int fish_swims(const struct fish *fish)
{
    return fish->gait != GAIT_HELD && fish->gait != GAIT_BOWL;
}

/* Sets the length, and the box according to the behavior parameters of the tank. */
void fish_grow(struct fish *fish, float length_m, const struct behavior_params *params);

struct box fish_box(const struct fish *fish);

/* Returns the wet mass of a goldfish (Carassius auratus, L. Egirdir): W = 0.0210 L^3.0598, in g and
 * cm. */
float fish_mass_kg(float length_m);

/* Returns the unit vector along the nose. */
vec3 fish_forward(const struct fish *fish);

uint64_t fish_hash(uint64_t hash, const struct fish *fish);       /* Hashes every field. */
uint64_t fish_hash_quick(uint64_t hash, const struct fish *fish); /* Hashes pose and gait only. */

#endif
