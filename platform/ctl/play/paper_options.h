/* paper_options.h -- the options of `kingyoctl paper`. */
#ifndef KINGYO_PLATFORM_CTL_PLAY_PAPER_OPTIONS_H
#define KINGYO_PLATFORM_CTL_PLAY_PAPER_OPTIONS_H

#include <stdint.h>

#include "platform/config/options.h"

#define PAPER_WEIGHTS_MAX 64u

struct paper_options {
    uint8_t grade; /* Grade of the paper, SHEET_GRADE_MIN .. SHEET_GRADE_MAX. */
    float wetness; /* Wetness of the wetted part, in [0, 1]. */
    /* Wetted share of the paper, in [0, 1]. The border of the wetted part is a straight line. */
    float wet_fraction;
    /* Angle between the paper's plane and the direction of motion, in [0, pi / 2]. The paper is
     * perpendicular to the motion at pi / 2. */
    float tilt_rad;
    float speed_m_s; /* Speed of the carriage, in [0, 5] m/s. */
    uint8_t in_air;  /* 1 for a run in air. Otherwise the run is deep under water. */
    uint8_t upside_down;
    uint8_t still; /* 1 if the fish on the paper do not slap with their tails. */
    /* 1 for the membrane formula alone, without spread of strength and without stress
     * concentration. */
    uint8_t ideal;
    uint8_t as_json;
    uint32_t fish_count; /* Number of fish on the paper, at most POI_CARRIED_MAX. */
    float fish_m;
    uint32_t tick_count; /* Number of ticks of the run, at least 1. */
    double seconds;      /* Duration in seconds, as the option gives it. */
    uint32_t seed;
    /* Number of calibration weights. A value above 0 selects the calibration by weights. */
    uint32_t weight_count;
    double weights_kg[PAPER_WEIGHTS_MAX];
    /* `footprint_m` is the size of the footprint of each weight. `hang_s` is the time for which
     * each weight hung. */
    double footprint_m, hang_s;
};

/* Parses the options in `argv` and checks their ranges. Returns EXIT_OK, or prints one line to
 * standard error and returns EXIT_USAGE. */
enum exit_code paper_options_read(struct paper_options *plan, int argc, const char *const *argv);

extern const char paper_options_usage[];

#endif
