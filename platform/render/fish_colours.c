/* fish_colours.c -- the colours of a goldfish, computed once for each fish. */
#include "platform/render/fish_colours.h"

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

void fish_colours_red(float red[3], float hue)
{
    static const float deep[3] = { 0.82f, 0.10f, 0.05f };
    static const float vermilion[3] = { 1.0f, 0.23f, 0.07f };
    static const float orange[3] = { 1.0f, 0.44f, 0.10f };
    static const float gold[3] = { 1.0f, 0.55f, 0.17f };
    const float to_vermilion = f_smoothstep(0.0f, 0.36f, hue);
    const float to_orange = f_smoothstep(0.48f, 0.90f, hue);
    const float to_gold = f_smoothstep(0.86f, 1.0f, hue);
    for (int i = 0; i < 3; i++) {
        const float plain = f_lerp(deep[i], vermilion[i], to_vermilion);
        const float bright = f_lerp(f_lerp(plain, orange[i], to_orange), gold[i], to_gold);
        red[i] = hue > 1.0f ? black[i] : bright;
    }
}

void fish_colours_compute(struct fish_colours *colours, float maturity, float hue, float layer)
{
    float red[3];
    fish_colours_red(red, hue);
    const float *const white = hue > 1.0f ? bronze : silver;
    const float fin = turned(maturity, 0.0f);
    for (int i = 0; i < 3; i++) {
        const float below = f_lerp(white[i], red[i], 0.25f);
        const float back = FRY_BACK * fry[i];
        colours->pale_back[i] = f_lerp(back, white[i], turned(maturity, -0.06f));
        colours->stain_back[i] = f_lerp(back, red[i], turned(maturity, 0.06f));
        colours->pale_belly[i] =
            f_lerp(fry_belly[i], f_lerp(white[i], below, 0.55f), turned(maturity, 0.04f));
        colours->stain_belly[i] =
            f_lerp(fry_belly[i], f_lerp(red[i], below, 0.80f), turned(maturity, 0.16f));
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
    const float brightest = f_max(light[0], f_max(light[1], light[2]));
    const float knee = 1.75f / (1.0f + 0.95f * brightest);
    for (int i = 0; i < 3; i++) {
        const float here = light[i] * knee;
        colours->pale_back[i] *= here;
        colours->stain_back[i] *= here;
        colours->pale_belly[i] *= here;
        colours->stain_belly[i] *= here;
        colours->pale_fin[i] *= here;
        colours->stain_fin[i] *= here;
    }
}
