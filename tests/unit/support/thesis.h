/* thesis.h -- the tank of the 2013 thesis, for tests of single rules of fish behavior. */
#ifndef KINGYO_TESTS_UNIT_SUPPORT_THESIS_H
#define KINGYO_TESTS_UNIT_SUPPORT_THESIS_H

#include <stdlib.h>

#include "core/input.h"
#include "tests/unit/support/open_tank.h"

/* Returns the behavior parameters of the thesis' tank. */
static inline const struct behavior_params *thesis_params(void)
{
    return &tank_preset(TANK_PRESET_THESIS)->params;
}

/* Returns what a fish of the thesis' tank perceives in tick `tick`. The result is valid until the
 * next call. */
static inline const struct perception *thesis_at(uint32_t seed, uint32_t tick)
{
    static struct perception around;
    around = (struct perception){
        .params = thesis_params(),
        .size_m = tank_preset(TANK_PRESET_THESIS)->size_m,
        .seed = seed,
        .tick = tick,
        .dt_s = CORE_TICK_S,
    };
    return &around;
}

/* Returns a tank of the thesis whose only fish are the `count` fish that `stages` describes. The
 * result is valid until the next call. */
static inline struct tank *thesis_stage(const struct tank_stage *stages, uint32_t count,
                                        uint32_t seed)
{
    static struct tank tank;
    open_tank(&tank, TANK_PRESET_THESIS, count, seed);
    tank_stage_all(&tank, stages, count);
    return &tank;
}

/* Largest misfit of n values that uniform_misfit() may return for a uniform sample. It is the
 * critical value of the Kolmogorov-Smirnov test, which a uniform sample exceeds with a probability
 * of 1 %. */
#define UNIFORM_MISFIT_MAX(n) (1.63f / f_sqrt((float)(n)))

/* Compares two floats for qsort() in ascending order. */
static inline int thesis_by_value(const void *a, const void *b)
{
    const float x = *(const float *)a, y = *(const float *)b;
    return (x > y) - (x < y);
}

/* Returns the Kolmogorov-Smirnov misfit of the sample, which is the greatest distance between its
 * distribution and the uniform distribution in [low, high]. The function sorts the sample. */
static inline float uniform_misfit(float *sample, uint32_t count, float low, float high)
{
    float worst = 0.0f;
    qsort(sample, count, sizeof *sample, thesis_by_value);
    for (uint32_t i = 0; i < count; i++) {
        const float share = (sample[i] - low) / (high - low);
        worst = f_max(worst, f_abs(share - (float)i / (float)count));
        worst = f_max(worst, f_abs(share - (float)(i + 1u) / (float)count));
    }
    return worst;
}

#endif
