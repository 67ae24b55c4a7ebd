/* behavior_params.h -- the behavior parameters of the fish of a tank, as data.
 *
 * Every preset has one set. No code tests which preset runs; the code reads these parameters.
 * Lengths and speeds are in body lengths, so that one set holds for fish of every size. Stamina
 * is in [0, 1], where the 2013 thesis counts 0 .. 100. A zero disables the feature of that
 * parameter. */
#ifndef KINGYO_CORE_TANK_BEHAVIOR_PARAMS_H
#define KINGYO_CORE_TANK_BEHAVIOR_PARAMS_H

#include <stdint.h>

struct behavior_params {
    /* Size of the body's box (thesis, section 3.1: 5 x 2 x 1 cm). */
    float height_per_length, width_per_length;

    /* Personal space beyond the body on every side, in body lengths (section 3.4). */
    float space_per_length;
    float space_fill_max; /* Share of the water that all spaces may fill; larger spaces shrink. */

    /* Speeds at full stamina, body lengths per second (sections 2.1 and 3.3). At zero stamina they
     * are 0.8 of these values. `drift_speed` is the limit of a resting fish. */
    float burst_speed, swim_speed, swim_speed_max, drift_speed;

    /* Standard deviation of the new heading around the old one at a change of gait (section
     * 3.3). */
    float turn_swim_rad, turn_rest_rad;
    float depth_stray; /* Standard deviation of the depth around that of the stamina's band, as a
                          share of the water depth. */

    /* Avoidance of other fish (section 3.4). */
    float meet_within_s; /* Largest time to contact that the fish avoids. */
    float meet_miss;     /* Largest miss distance that the fish avoids, as a share of the
                            lengths. */
    float brake_s;       /* Time to contact below which the fish slows down. */
    float swerve_haste;  /* >= 1: factor on the speed at which an avoiding turn begins. */

    /* Walls (section 3.1): the fish turns away from a wall nearer to its nose than these two
     * distances. */
    float wall_per_length; /* Distance in body lengths. */
    float wall_within_s;   /* Distance as a time at the present speed. */

    /* Behavior of living fish beyond the thesis. */
    float kick_rad;      /* Standard deviation of the turn at each kick, for a fish that glides.
                            A fish that does not glide keeps its course until its gait changes. */
    uint8_t glides;      /* 1: beats its tail and coasts in turn. */
    uint8_t banks;       /* 1: rolls into its turns. */
    float flow_share;    /* [0, 1] share of the flow around a poi (flow.h) that carries the fish
                            along. */
    float wall_follow;   /* [0, 1] strength of a wall's attraction along itself. */
    float shade_dwell_s; /* A shade attracts fish after it has been still for this time. */
    uint8_t shade_draws_bursts; /* 1: a shade also attracts fish that burst; section 3.5 moves every
                                   fish. */
    uint8_t shade_frights;      /* 1: a new or moving shade startles fish. */
    uint8_t escapes;            /* 1: C-starts away from the poi and other stimuli. */

    /* Surface breathing (section 3.6). */
    uint8_t air_by_oxygen;        /* 1: triggered by low oxygen of the water; 0: by low stamina. */
    float gulp_min_s, gulp_max_s; /* Duration of a bout, uniform between both. */
    float gulp_gain_per_s;        /* Stamina gained while the mouth is at the surface film. */
    float stifle_per_s; /* Stamina lost per second in water without oxygen; begins at 4 mg/L. */
};

#endif
