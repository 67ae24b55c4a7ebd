/* fish.h -- one goldfish: what it is, where it is, what it is about to do. */
#ifndef KINGYO_CORE_TANK_FISH_H
#define KINGYO_CORE_TANK_FISH_H

#include <stdint.h>

#include "core/tank/box.h"
#include "core/tank/law.h"

#define TANK_FISH_KIOSK 2048u /* Room for the deepest tank; preset.h has the limit of each. */
/* `kingyoctl tank` and the bench compile a tank with more room (platform/ctl/tank.mk). */
#ifndef TANK_FISH_MAX
#define TANK_FISH_MAX TANK_FISH_KIOSK
#endif
_Static_assert(TANK_FISH_MAX >= TANK_FISH_KIOSK, "the kiosk's tank fits in every tank");
#if TANK_FISH_MAX < 65536u
typedef uint16_t fish_index; /* Counts of fish are held in it, too: up to all of them. */
#else
typedef uint32_t fish_index;
#endif

/* Returns the number of fish that the limits of a tank with `fish_count` fish are made for. Up to
 * TANK_FISH_KIOSK fish every build has the limits of the kiosk, so that they swim to the same hash.
 */
static inline uint32_t fish_capacity(uint32_t fish_count)
{
    return fish_count <= TANK_FISH_KIOSK ? TANK_FISH_KIOSK : TANK_FISH_MAX;
}

/* A body whose top stands so far out of the water is in the air; a ripple is not. */
#define FISH_AIRBORNE_M 0.003f

enum fish_gait {
    GAIT_REST = 0,
    GAIT_SWIM = 1,
    GAIT_BURST = 2,
    GAIT_ESCAPE = 3,  /* From the poi. */
    GAIT_SURFACE = 4, /* Gulping at the surface. */
    GAIT_HELD = 5,    /* On a poi's paper, out of the water: the poi moves it; see `holder`. */
    GAIT_BOWL = 6,    /* Caught: the bowl moves it. */
    GAIT_COUNT,
};

/* Who holds a GAIT_HELD fish that is back in the water and not yet clear of others (loose.h). */
#define FISH_HOLDER_WATER 255u

enum fish_avoiding {
    AVOID_NONE = 0,
    AVOID_YAW = 1,
    AVOID_PITCH = 2,
};

/* What a fish that is short of air is about; see surface.h. */
enum fish_air {
    AIR_ENOUGH = 0,
    AIR_RISES = 1, /* On its way up: GAIT_SWIM. */
    AIR_GULPS = 2, /* GAIT_SURFACE, as the next two: until its body is under again. */
    AIR_DIVES = 3,
    AIR_DUCKS = 4, /* Frightened. */
};

/* What is done in every tick stands first, four floats at a time: lanes turn a quad of several fish
 * into columns (core/base/lanes.h). A new member belongs behind them. */
struct fish {
    vec3 position_m; /* Centre of the body box, world. */
    float speed_m_s; /* Along the nose, by its own fins, >= 0. */
    struct angles angles;
    float yaw_rate_rad_s;
    vec3 push_m_s;   /* Neighbours' nearness pushes it so (the thesis' repulsion). */
    float climb_m_s; /* Up, by swim bladder, fins and pitch. */
    float heading_rad; /* Yaw it turns toward, at a bounded rate. */
    float drawn_rad;   /* A shadow draws its nose so far off the heading, + left. */
    float brake;       /* [0, 1] of its speed that a fish ahead leaves it. */
    float room;        /* [0, 1] of its turning rate that bodies at its sides leave it. */

    /* Orders: what it resolved on when it last thought, beside heading_rad. Each tick obeys. */
    float speed_goal_m_s; /* Along the nose; `brake` takes its share. */
    float speed_up_keep;  /* [0, 1) of what it is too slow by that is left a tick later ... */
    float slow_keep;      /* ... and of what it is too fast by, when nothing brakes it. */
    float turn_rate_max_rad_s;
    float haste; /* >= 1: so many times as quick as usual it turns, tilts, bends and beats. */
    float climb_goal_m_s, pitch_goal_rad;
    float beats; /* 1: its tail drives; 0: it glides. */

    float length_m;          /* Total length; from the growth curve at `age_days`. */
    float height_m, width_m; /* Of its box. */
    float stamina;           /* [0, 1]; 0 is exhausted. */
    vec3 velocity_m_s;       /* World; true motion of the last tick, pushes included. */
    float bend_rad;
    float tail_phase_rad, tail_beat_hz, tail_amplitude;
    float bend_goal_rad; /* Order, beside what the arc of its course bends it by. */
    float age_days;

    uint32_t look;        /* Random bits for the renderer. */
    uint8_t gait;         /* enum fish_gait */
    uint8_t avoiding;     /* enum fish_avoiding */
    uint8_t holder;       /* Poi or bowl index while GAIT_HELD or GAIT_BOWL. */
    uint8_t thought_tick; /* Low bits of the tick in which it last thought. */
    float gait_left_s;    /* Until the next choice of gait; of one that is loose: since when. */
    float avoid_left_s;   /* Of giving way; then, of keeping its depth a little longer. */
    float avoid_turn;     /* -1 right .. +1 left (yaw), or -1 down, +1 up (pitch). */
    uint32_t avoid_since; /* Tick and partner of the encounter it gives way in. */
    fish_index avoid_with;
    uint8_t avoid_kind; /* enum meeting_kind: its part in the encounter, as it began. */
    uint8_t falls;      /* Through the air: nothing else moves it. */
    uint8_t air;        /* enum fish_air */
    uint8_t startle;    /* enum fright_cause whose latency runs; 0 is none. */
    float depth_goal_m; /* Wanted y, < 0. */
    float depth_stray;  /* Where its band's depth lies for it: so much higher, of the water's. */

    /* Fright and its answer; see fright.h and escape.h. */
    float alarm; /* [0, 1]; fades. */
    float habit; /* [0, 1] how used to frights it is; fades. */
    float startle_s;   /* Left of the latency. */
    vec3 startle_from_m;
    float refractory_s; /* Until it can start again. */
    float escape_s;     /* From the start of its last C-start to this tick's. */
    float escape_from_rad;   /* Its yaw then. */
    float escape_turn_rad;   /* What stage 1 turns its head by, + left, ... */
    float escape_course_rad; /* ... and the whole start its body. */
};

/* How far out of the water the top of its box may stand before it is in the air: a gulper's snout
 * is out by as much as its height. */
static inline float fish_emerges_m(const struct fish *fish)
{
    return (fish->gait == GAIT_SURFACE ? fish->height_m : 0.0f) + FISH_AIRBORNE_M;
}

/* Whether this module moves it: not held by a poi, not in a bowl. */
static inline int fish_swims(const struct fish *fish)
{
    return fish->gait != GAIT_HELD && fish->gait != GAIT_BOWL;
}

/* Gives it a length, and the box that its tank's law makes of it. */
void fish_grow(struct fish *fish, float length_m, const struct law *law);

struct box fish_box(const struct fish *fish);

/* Wet mass of a goldfish (Carassius auratus, L. Egirdir): W = 0.0210 L^3.0598, g and cm. */
float fish_mass_kg(float length_m);

/* Unit vector along the nose. */
vec3 fish_forward(const struct fish *fish);

uint64_t fish_hash(uint64_t hash, const struct fish *fish);       /* Every field. */
uint64_t fish_hash_quick(uint64_t hash, const struct fish *fish); /* Pose and gait. */

#endif
