/* loudness.h -- measures the loudness of stereo sound at 48 kHz by ITU-R BS.1770-4, its true peak,
 * its digital silence, and the share of its energy below a frequency. */
#ifndef KINGYO_TESTS_UNIT_CORE_SOUND_LOUDNESS_H
#define KINGYO_TESTS_UNIT_CORE_SOUND_LOUDNESS_H

#include <math.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#define LOUDNESS_RATE_HZ 48000u
/* A step is 100 ms. A gating block consists of four steps, so that blocks overlap by 75 %. */
#define LOUDNESS_STEP (LOUDNESS_RATE_HZ / 10u)
#define LOUDNESS_BLOCK_STEPS 4u
#define LOUDNESS_STEPS_MAX 4000u
#define LOUDNESS_ABSOLUTE_LUFS (-70.0)
#define LOUDNESS_RELATIVE_LU (-10.0)
/* Oversampling and taps for each phase of the filter that measures the true peak. */
#define LOUDNESS_PHASES 4
#define LOUDNESS_TAPS 24

struct loudness_biquad {
    double b0, b1, b2, a1, a2;
};

/* The K weighting at 48 kHz: a high shelf for the head, and a high pass. */
static const struct loudness_biquad loudness_weighting[2] = {
    { 1.53512485958697, -2.69169618940638, 1.19839281085285, -1.69065929318241, 0.73248077421585 },
    { 1.0, -2.0, 1.0, -1.99004745483398, 0.99007225036621 },
};

static inline double loudness_filter(const struct loudness_biquad *q, double state[2], double x)
{
    const double y = q->b0 * x + state[0];
    state[0] = q->b1 * x - q->a1 * y + state[1];
    state[1] = q->b2 * x - q->a2 * y;
    return y;
}

static inline double loudness_lufs(double power)
{
    return power > 0.0 ? -0.691 + 10.0 * log10(power) : -200.0;
}

/* Returns the mean power of the gating blocks louder than `gate_lufs`. */
static inline double loudness_gated(const double *step, uint32_t step_count, double gate_lufs)
{
    double sum = 0.0;
    uint32_t count = 0;
    for (uint32_t i = 0; i + LOUDNESS_BLOCK_STEPS <= step_count; i++) {
        double power = 0.0;
        for (uint32_t k = 0; k < LOUDNESS_BLOCK_STEPS; k++) {
            power += step[i + k] / LOUDNESS_BLOCK_STEPS;
        }
        if (loudness_lufs(power) > gate_lufs) {
            sum += power;
            count++;
        }
    }
    return count > 0 ? sum / count : 0.0;
}

/* Returns the integrated loudness in LUFS of `frame_count` stereo frames. */
static inline double loudness_integrated(const int16_t *stereo, uint32_t frame_count)
{
    static double step[LOUDNESS_STEPS_MAX];
    double state[2][2][2] = { { { 0.0 } } };
    const uint32_t count = frame_count / LOUDNESS_STEP < LOUDNESS_STEPS_MAX
                               ? frame_count / LOUDNESS_STEP
                               : LOUDNESS_STEPS_MAX;
    for (uint32_t i = 0; i < count; i++) {
        step[i] = 0.0;
        for (uint32_t k = 0; k < 2u * LOUDNESS_STEP; k++) {
            const uint32_t side = k % 2u;
            double x = stereo[2u * i * LOUDNESS_STEP + k] / 32768.0;
            x = loudness_filter(&loudness_weighting[0], state[side][0], x);
            x = loudness_filter(&loudness_weighting[1], state[side][1], x);
            step[i] += x * x / LOUDNESS_STEP;
        }
    }
    const double open = loudness_gated(step, count, LOUDNESS_ABSOLUTE_LUFS);
    const double gate = loudness_lufs(open) + LOUDNESS_RELATIVE_LU;
    return loudness_lufs(
        loudness_gated(step, count, gate > LOUDNESS_ABSOLUTE_LUFS ? gate : LOUDNESS_ABSOLUTE_LUFS));
}

/* Returns the true peak in dBTP: the largest value of the signal between the samples, computed by
 * a windowed sine cardinal at four times the rate. */
static inline double loudness_true_peak(const int16_t *stereo, uint32_t frame_count)
{
    const double pi = 3.14159265358979323846;
    double taps[LOUDNESS_PHASES][LOUDNESS_TAPS], peak = 0.0;
    for (int p = 0; p < LOUDNESS_PHASES; p++) {
        for (int k = 0; k < LOUDNESS_TAPS; k++) {
            const double at = k - LOUDNESS_TAPS / 2 + 1 - (double)p / LOUDNESS_PHASES;
            const double window = 0.5 + 0.5 * cos(2.0 * pi * at / (LOUDNESS_TAPS + 1));
            taps[p][k] = fabs(at) < 1e-9 ? 1.0 : window * sin(pi * at) / (pi * at);
        }
    }
    for (uint32_t i = 0; i + LOUDNESS_TAPS <= frame_count; i++) {
        for (uint32_t side = 0; side < 2; side++) {
            /* The value between two samples that are far below the peak cannot exceed the peak. */
            const int16_t *middle = &stereo[2u * (i + LOUDNESS_TAPS / 2u - 1u) + side];
            if (abs(middle[0]) < 0.4 * peak && abs(middle[2]) < 0.4 * peak) {
                continue;
            }
            for (int p = 0; p < LOUDNESS_PHASES; p++) {
                double sum = 0.0;
                for (uint32_t k = 0; k < LOUDNESS_TAPS; k++) {
                    sum += taps[p][k] * stereo[2u * (i + k) + side];
                }
                peak = fabs(sum) > peak ? fabs(sum) : peak;
            }
        }
    }
    return peak > 0.0 ? 20.0 * log10(peak / 32768.0) : -200.0;
}

/* Returns the share [0, 1] of frames whose two samples are 0. */
static inline double loudness_silence(const int16_t *stereo, uint32_t frame_count)
{
    uint32_t silent = 0;
    for (uint32_t i = 0; i < frame_count; i++) {
        silent += stereo[2u * i] == 0 && stereo[2u * i + 1u] == 0;
    }
    return frame_count > 0 ? (double)silent / frame_count : 0.0;
}

/* Returns the energy of the two channels below `hz`: two Butterworth low passes of second order in
 * series. If `hz` is 0, returns the energy of the unfiltered channels. */
static inline double loudness_energy_below(const int16_t *stereo, uint32_t frame_count, double hz)
{
    const double w = tan(3.14159265358979323846 * hz / LOUDNESS_RATE_HZ), r = sqrt(2.0);
    const double norm = 1.0 / (1.0 + r * w + w * w);
    const struct loudness_biquad low = { w * w * norm, 2.0 * w * w * norm, w * w * norm,
                                         2.0 * (w * w - 1.0) * norm, (1.0 - r * w + w * w) * norm };
    double state[2][2][2] = { { { 0.0 } } }, energy = 0.0;
    for (uint32_t i = 0; i < 2u * frame_count; i++) {
        double x = stereo[i] / 32768.0;
        if (hz > 0.0) {
            x = loudness_filter(&low, state[i % 2u][0], x);
            x = loudness_filter(&low, state[i % 2u][1], x);
        }
        energy += x * x;
    }
    return energy;
}

#endif
