/* draw_wires.c -- computes the point at which three draw wires meet, and fits a straight line to
 * the marks of a wire. The point is computed in coordinate axes along the spools, because the
 * equations for two of the three coordinates are then linear. */
#include "board/poi-gadget/draw_wires.h"

#include <assert.h>

#include "core/base/fmath.h"

#define SPOOLS_APART_M 0.1f

/* Coordinate axes along the spools. The origin is the first spool. The second spool lies on +x, and
 * the third spool lies in the plane of x and y. */
struct spool_axes {
    vec3 x, y, normal; /* Unit vectors of the axes. `normal` is perpendicular to the plane of the
                          spools and points up. */
    float second_x_m, third_x_m, third_y_m;
};

static struct spool_axes axes_of(const vec3 spool_m[DRAW_WIRE_COUNT])
{
    const vec3 second_m = v3_sub(spool_m[1], spool_m[0]), third_m = v3_sub(spool_m[2], spool_m[0]);
    struct spool_axes axes = { .x = v3_normalize_or(second_m, v3(1.0f, 0.0f, 0.0f)) };
    axes.second_x_m = v3_length(second_m);
    axes.third_x_m = v3_dot(axes.x, third_m);
    const vec3 aside_m = v3_muladd(third_m, axes.x, -axes.third_x_m);
    axes.y = v3_normalize_or(aside_m, v3(0.0f, 0.0f, 1.0f));
    axes.third_y_m = v3_length(aside_m);
    axes.normal = v3_cross(axes.x, axes.y);
    if (axes.normal.y < 0.0f) {
        axes.normal = v3_scale(axes.normal, -1.0f);
    }
    return axes;
}

bool draw_wires_is_determined(const vec3 spool_m[DRAW_WIRE_COUNT])
{
    const struct spool_axes axes = axes_of(spool_m);
    return axes.second_x_m > SPOOLS_APART_M && axes.third_y_m > SPOOLS_APART_M &&
           axes.normal.y > 0.5f;
}

enum draw_wires_result draw_wires_meet(const vec3 spool_m[DRAW_WIRE_COUNT],
                                       const float length_m[DRAW_WIRE_COUNT], vec3 *out)
{
    assert(draw_wires_is_determined(spool_m));
    const struct spool_axes axes = axes_of(spool_m);
    for (uint32_t i = 0; i < DRAW_WIRE_COUNT; i++) {
        if (!(length_m[i] > 0.0f && length_m[i] < DRAW_WIRE_MAX_M)) {
            return DRAW_WIRES_LENGTH;
        }
    }
    const float a = length_m[0] * length_m[0], b = length_m[1] * length_m[1],
                c = length_m[2] * length_m[2];
    const float d = axes.second_x_m, i = axes.third_x_m, j = axes.third_y_m;
    const float x_m = (a - b + d * d) / (2.0f * d);
    const float y_m = (a - c + i * i + j * j - 2.0f * i * x_m) / (2.0f * j);
    /* `below` is the square of the depth of the eye below the plane of the spools, in m^2. The eye
     * is the point on the poi's neck at which the three wires meet. If the wires are too short to
     * meet, `below` is negative. */
    const float below = a - x_m * x_m - y_m * y_m;
    /* A small negative value of `below` is tolerated. The limit corresponds to wires that are too
     * short by DRAW_WIRE_SLACK_M. */
    if (below < -2.0f * DRAW_WIRE_SLACK_M * length_m[0]) {
        return DRAW_WIRES_APART;
    }
    if (below < DRAW_WIRE_NEAR_M * DRAW_WIRE_NEAR_M) {
        return DRAW_WIRES_HIGH;
    }
    const vec3 flat_m = v3_muladd(v3_muladd(spool_m[0], axes.x, x_m), axes.y, y_m);
    *out = v3_muladd(flat_m, axes.normal, -f_sqrt(below));
    return DRAW_WIRES_OK;
}

void draw_wires_lengths(const vec3 spool_m[DRAW_WIRE_COUNT], vec3 eye_m,
                        float length_m[DRAW_WIRE_COUNT])
{
    for (uint32_t i = 0; i < DRAW_WIRE_COUNT; i++) {
        length_m[i] = v3_length(v3_sub(eye_m, spool_m[i]));
    }
}

const char *draw_wires_text(enum draw_wires_result result)
{
    static const char *const text[DRAW_WIRES_RESULT_COUNT] = {
        [DRAW_WIRES_OK] = "the wires meet",
        [DRAW_WIRES_LENGTH] = "a wire has no length: is it plugged in and calibrated?",
        [DRAW_WIRES_APART] = "the wires do not meet: is one caught, slack or torn?",
        [DRAW_WIRES_HIGH] = "the poi is too close to the spools, where its height is inaccurate",
    };
    assert((uint32_t)result < DRAW_WIRES_RESULT_COUNT);
    return text[result];
}

/* ---- Calibration ----------------------------------------------------------------------------- */

/* All steps and lengths are used as differences from their means over all marks, because sums of
 * large numbers would have larger rounding errors. */

void draw_wires_fit_add(struct wire_fit *fit, float step, float length_m)
{
    assert(fit->count < sizeof fit->step / sizeof fit->step[0]);
    fit->step[fit->count] = step;
    fit->length_m[fit->count] = length_m;
    fit->count++;
}

bool draw_wires_fit_solve(struct wire_fit *fit, const char **why)
{
    assert(fit->count <= sizeof fit->step / sizeof fit->step[0]);
    if (fit->count < 3) {
        *why = "at least three marks are needed, because two marks show no error";
        return false;
    }
    float low = fit->step[0], high = fit->step[0], step_sum = 0.0f, length_sum_m = 0.0f;
    for (uint32_t i = 0; i < fit->count; i++) {
        low = f_min(low, fit->step[i]);
        high = f_max(high, fit->step[i]);
        step_sum += fit->step[i];
        length_sum_m += fit->length_m[i];
    }
    if (high - low < WIRE_FIT_STEPS_MIN) {
        *why = "the converter value hardly changed between the marks: check the channel";
        return false;
    }
    const float step_mean = step_sum / (float)fit->count;
    const float length_mean_m = length_sum_m / (float)fit->count;
    float both = 0.0f, square = 0.0f;
    for (uint32_t i = 0; i < fit->count; i++) {
        const float step = fit->step[i] - step_mean;
        both += step * (fit->length_m[i] - length_mean_m);
        square += step * step;
    }
    fit->step_m = both / square;
    fit->zero_m = length_mean_m - fit->step_m * step_mean;
    fit->miss_m = 0.0f;
    for (uint32_t i = 0; i < fit->count; i++) {
        const float length_m = fit->zero_m + fit->step_m * fit->step[i];
        fit->miss_m = f_max(fit->miss_m, f_abs(length_m - fit->length_m[i]));
    }
    if (fit->miss_m > WIRE_FIT_MISS_MAX_M || fit->step_m == 0.0f) {
        *why = "the marks miss a line by over 5 mm: is one misplaced, or the wire in layers?";
        return false;
    }
    return true;
}
