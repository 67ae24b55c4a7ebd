/* fish_colours.c -- the colours of a goldfish, computed once for each fish instead of each vertex.
 *  */
#include "platform/render/fish_colours.h"

#include <stdbool.h>

#include "core/base/fmath.h"

/* The white of a goldfish below the bulbs, whose light exceeds 1. A brighter skin would lose its
 * scales. */
static const float silver[3] = { 0.80f, 0.755f, 0.70f };
static const float fry[3] = { 0.45f, 0.36f, 0.20f };
static const float fry_belly[3] = { 0.82f, 0.74f, 0.56f };
/* Brightness of a young fish at its back and of its fins, relative to `fry`. */
#define FRY_BACK 0.72f
#define FRY_FIN 1.25f
/* Black of a goldfish. Bronze shows through, most of all at the belly. */
static const float black[3] = { 0.055f, 0.048f, 0.045f };
static const float bronze[3] = { 0.42f, 0.30f, 0.16f };
/* Number of pattern layers whose fish have fins of one colour, as assets/bake/patterns.c lists the
 * layers. */
#define PLAIN_LAYERS 3.0f

/* Returns the fraction of the young colour that a point of the skin has lost. `ahead` is above 0
 * where the loss begins earlier. */
static float turned(float maturity, float ahead)
{
    return f_smoothstep(0.10f, 0.42f, maturity + ahead);
}

static float fraction(float value)
{
    return value - f_floor(value);
}

void fish_colours_compute(struct fish_colours *colours, float maturity, float hue, float layer)
{
    const bool is_black = hue > 1.0f;
    const float orange = hue * hue * hue;
    const float vermilion[3] = { 1.0f, f_lerp(0.085f, 0.40f, orange),
                                 f_lerp(0.015f, 0.03f, orange) };
    const float *const red = is_black ? black : vermilion;
    const float *const white = is_black ? bronze : silver;
    const float fin = turned(maturity, 0.0f);
    for (int i = 0; i < 3; i++) {
        const float below = f_lerp(white[i], red[i], 0.25f);
        const float back = FRY_BACK * fry[i];
        colours->pale_back[i] = f_lerp(back, white[i], turned(maturity, -0.06f));
        colours->stain_back[i] = f_lerp(back, red[i], turned(maturity, 0.06f));
        colours->pale_belly[i] =
            f_lerp(fry_belly[i], f_lerp(white[i], below, 0.55f), turned(maturity, 0.04f));
        colours->stain_belly[i] =
            f_lerp(fry_belly[i], f_lerp(red[i], below, 0.55f), turned(maturity, 0.16f));
        colours->pale_fin[i] = f_lerp(FRY_FIN * fry[i], white[i], fin);
        colours->stain_fin[i] = f_lerp(FRY_FIN * fry[i], red[i], fin);
    }
    colours->pale_fin[3] = hue * 20.0f;
    colours->seed = fraction(hue * 17.31f);
    const float stained = fraction(colours->seed * 7.7f + layer * 0.37f);
    colours->stained = layer < PLAIN_LAYERS ? 0.45f + 0.55f * stained : stained;
}

void fish_colours_illuminate(struct fish_colours *colours, const float light[3])
{
    for (int i = 0; i < 3; i++) {
        colours->pale_back[i] *= light[i];
        colours->stain_back[i] *= light[i];
        colours->pale_belly[i] *= light[i];
        colours->stain_belly[i] *= light[i];
        colours->pale_fin[i] *= light[i];
        colours->stain_fin[i] *= light[i];
    }
}
