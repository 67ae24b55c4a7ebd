/* law.h -- how the fish of a tank behave, as data.
 *
 * Every preset has one. No code asks which preset it runs; it reads the law. Lengths and speeds are
 * in body lengths, so that a law holds for fish of every size; stamina is in [0, 1] where the 2013
 * thesis counts 0 .. 100. A zero switches off what it speaks of. */
#ifndef KINGYO_CORE_TANK_LAW_H
#define KINGYO_CORE_TANK_LAW_H

#include <stdint.h>

struct law {
    /* The body's box (thesis, section 3.1: 5 x 2 x 1 cm). */
    float height_per_length, width_per_length;

    /* Personal space (section 3.4): so far beyond the body on every side ... */
    float space_per_length;
    float space_fill_max; /* ... but shrunk where the spaces of all would fill more of the water. */

    /* Speeds at full stamina, body lengths a second (sections 2.1 and 3.3). At none they are 0.8 of
     * it. `drift_speed` is the most that a resting fish drifts. */
    float burst_speed, swim_speed, swim_speed_max, drift_speed;

    /* With a new gait comes a new heading (section 3.3): a bell about the old one, so wide. */
    float turn_swim_rad, turn_rest_rad;
    float depth_stray; /* Deviation about the depth of its stamina's band, of the water's depth. */

    /* Giving way (section 3.4). */
    float meet_within_s; /* Only to what it would touch sooner than that. */
    float meet_miss;     /* Only to what would pass nearer than that share of their lengths. */
    float brake_s;       /* Slows for a body that it would touch sooner than that. */
    float swerve_haste;  /* >= 1: so many times as quick as usual it sets into a turn. */

    /* Walls (section 3.1): it turns away from what is nearer than that before its nose ... */
    float wall_per_length; /* ... body lengths, ... */
    float wall_within_s;   /* ... and so long a way at its speed. */

    /* What a real fish does beyond the thesis' law. */
    float kick_rad;       /* Deviation of its turns, one with each kick; where it glides. A fish
                             that does not keeps its course until its gait changes. */
    uint8_t glides;       /* Beats its tail and coasts in turn. */
    uint8_t banks;        /* Rolls into its turns. */
    float flow_share;     /* [0, 1] of the flow round a poi (flow.h) that carries it along. */
    float wall_follow;    /* [0, 1] how much a wall draws a fish along itself. */
    float shade_dwell_s;  /* A shadow gathers fish after it has been still so long ... */
    uint8_t shade_draws_bursts; /* ... even those that burst: section 3.5 moves every fish ... */
    uint8_t shade_frights; /* ... and a new or moving one frightens them. */
    uint8_t escapes;      /* C-starts away from the poi and other frights. */

    /* Gulping at the surface (section 3.6). */
    uint8_t air_by_oxygen;  /* When the water is out of oxygen; else when it is out of stamina. */
    float gulp_min_s, gulp_max_s; /* A bout, uniform. */
    float gulp_gain_per_s;  /* Stamina while its mouth is in the film. */
    float stifle_per_s;     /* Stamina that water without any oxygen costs; from 4 mg/L on. */
};

#endif
