/* paper_plan.h -- what `kingyoctl paper` was asked for. */
#ifndef KINGYO_PLATFORM_CTL_PAPER_PLAN_H
#define KINGYO_PLATFORM_CTL_PAPER_PLAN_H

#include <stdint.h>

#include "platform/kiosk/options.h"

#define PAPER_WEIGHTS_MAX 64u

struct paper_plan {
    uint8_t grade;       /* SHEET_GRADE_MIN .. SHEET_GRADE_MAX */
    float wetness;       /* [0, 1] of the wetted part, */
    float wet_fraction;  /* [0, 1] of the paper; the line between is straight. */
    float tilt_rad;      /* [0, pi / 2] between the paper's plane and its way; pi / 2: broadside. */
    float speed_m_s;     /* [0, 5] */
    uint8_t in_air;      /* Else deep under water. */
    uint8_t upside_down;
    uint8_t still;       /* Its fish do not slap. */
    uint8_t ideal;       /* The membrane's formula alone: no spread, no stress concentration. */
    uint8_t as_json;
    uint32_t fish_count; /* <= POI_RIDER_MAX */
    float fish_m;
    uint32_t tick_count; /* >= 1 */
    double seconds;      /* As it was asked. */
    uint32_t seed;
    uint32_t weight_count; /* > 0: calibrate, by these weights ... */
    double weights_kg[PAPER_WEIGHTS_MAX];
    double footprint_m, hang_s; /* ... on such a foot, each hung for so long. */
};

/* The options in `argv`, each in its range. EXIT_OK, or one line told and EXIT_USAGE. */
enum exit_code paper_plan_read(struct paper_plan *plan, int argc, const char *const *argv);

extern const char paper_plan_usage[];

#endif
