/* paper_options.h -- the options of `kingyoctl paper`, which tests the paper of a poi (a paper
 * scoop). */
#ifndef KINGYO_PLATFORM_CTL_PLAY_PAPER_OPTIONS_H
#define KINGYO_PLATFORM_CTL_PLAY_PAPER_OPTIONS_H

#include <stdint.h>

#include "platform/config/options.h"

#define PAPER_WEIGHTS_MAX 64u

struct paper_options {
    uint8_t grade; /* Grade of the paper, SHEET_GRADE_MIN .. SHEET_GRADE_MAX. */
    float wetness; /* Wetness of the wet part of the paper, in [0, 1]. */
    /* Share of the paper that is wet, in [0, 1]. A straight line separates the wet part from the
     * dry part. */
    float wet_fraction;
    /* Angle between the plane of the paper and the direction of motion, in [0, pi / 2] rad. At pi /
     * 2, the paper is perpendicular to the motion. */
    float tilt_rad;
    float speed_m_s; /* Speed of the carriage that moves the poi, in [0, 5] m/s. */
    uint8_t in_air;  /* 1 if the poi moves in air, 0 if the poi moves deep under water. */
    uint8_t upside_down;
    uint8_t still; /* 1 if the fish on the paper do not slap the paper with their tails, otherwise
                      0. */
    /* 1 for the membrane formula alone, 0 for the full paper model. The full model varies the
     * strength over the paper and includes stress concentration. */
    uint8_t ideal;
    uint8_t as_json;
    uint32_t fish_count; /* Number of fish on the paper, 0 .. POI_CARRIED_MAX. */
    float fish_m;
    uint32_t tick_count; /* Length of the simulation in ticks of 1/120 s, at least 1. */
    double seconds;      /* Length of the simulation in seconds, as given by the option. */
    uint32_t seed;
    /* Number of weights in `weights_kg`. 0 selects the simulation of a moving poi. Any other value
     * selects the computation of paper strength from hung weights. */
    uint32_t weight_count;
    double weights_kg[PAPER_WEIGHTS_MAX];
    /* `footprint_m` is the size of the area on which each weight rests, in m. `hang_s` is the time
     * in seconds for which each weight hung on the paper. */
    double footprint_m, hang_s;
};

/* Parses the options in `argv` and checks their ranges. Returns EXIT_OK, or prints one line to
 * standard error and returns EXIT_USAGE. */
enum exit_code paper_options_read(struct paper_options *plan, int argc, const char *const *argv);

/* Options and further text that `kingyoctl paper --help` prints. */
extern const struct option_table paper_options_table;
extern const char paper_options_notes[];

#endif
