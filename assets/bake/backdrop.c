/* backdrop.c -- bakes the street behind the stall: strings of bulbs and lanterns, a stall with
 * striped cloth, passers-by, bags with goldfish, and the price sign of a neighbour.
 *
 * The picture is out of focus like a photograph with a wide lens. Each layer is painted sharply in
 * linear light, far brighter than 1 where a lamp is. A disc of the layer's circle of confusion then
 * blurs the layer, so that each lamp becomes a bright disc. Row 0 is the street. Column 0 is at the
 * left of the player. The picture exists twice: at night, and by day. */
#include "assets/bake/bake.h"

#include <assert.h>
#include <math.h>
#include <stdbool.h>
#include <stdlib.h>
#include <string.h>
#include <stb/stb_truetype.h>

#define WIDTH BACKDROP_WIDTH
#define HEIGHT BACKDROP_HEIGHT
/* Row of the soles of the passers-by. The far rim of the tank hides the lowest rows. */
#define STREET_ROW 26.0f
#define BRUSH "/usr/share/fonts/truetype/kouzan-mouhitsu/kouzan-mouhitsu.ttf"

struct colour {
    float r, g, b;
};

/* Colours are premultiplied by the opacity. Painted texels are moved toward the column `foot` and
 * the row STREET_ROW by the fraction `shrink` of their distance. */
struct layer {
    float rgba[HEIGHT][WIDTH][4];
    float foot, shrink;
};

struct point {
    float x, y;
};

static struct layer far_layer, people_layer, near_layer, blurred;

static struct colour times(struct colour colour, float factor)
{
    return (struct colour){ colour.r * factor, colour.g * factor, colour.b * factor };
}

/* Covers a texel with a colour. `opacity` is in [0, 1]. The light of a lamp may exceed 1. */
static void cover(struct layer *layer, int32_t x, int32_t y, struct colour colour, float opacity)
{
    x -= (int32_t)lroundf(((float)x - layer->foot) * layer->shrink);
    y -= (int32_t)lroundf(((float)y - STREET_ROW) * layer->shrink);
    if (x < 0 || x >= (int32_t)WIDTH || y < 0 || y >= (int32_t)HEIGHT || opacity <= 0.0f) {
        return;
    }
    float *const texel = layer->rgba[y][x];
    const float light[4] = { colour.r, colour.g, colour.b, 1.0f };
    for (uint32_t i = 0; i < 4; i++) {
        texel[i] = texel[i] * (1.0f - opacity) + light[i] * opacity;
    }
}

/* Paints a line with round ends, from `a` with the radius `radius_a` to `b` with `radius_b`. The
 * left side is brighter than the right side, so that the line looks round. */
static void paint_limb(struct layer *layer, struct point a, struct point b, float radius_a,
                       float radius_b, struct colour colour)
{
    const float widest = fmaxf(radius_a, radius_b) + 1.0f;
    const float dx = b.x - a.x, dy = b.y - a.y, length2 = fmaxf(dx * dx + dy * dy, 1e-6f);
    for (int32_t y = (int32_t)(fminf(a.y, b.y) - widest); y <= (int32_t)(fmaxf(a.y, b.y) + widest);
         y++) {
        for (int32_t x = (int32_t)(fminf(a.x, b.x) - widest);
             x <= (int32_t)(fmaxf(a.x, b.x) + widest); x++) {
            const float px = (float)x + 0.5f - a.x, py = (float)y + 0.5f - a.y;
            const float t = fminf(fmaxf((px * dx + py * dy) / length2, 0.0f), 1.0f);
            const float ox = px - t * dx, oy = py - t * dy;
            const float radius = noise_mix(radius_a, radius_b, t);
            const float inside = radius - sqrtf(ox * ox + oy * oy) + 0.5f;
            const float lit = 0.85f - 0.55f * ox / fmaxf(radius, 1.0f);
            cover(layer, x, y, times(colour, lit), fminf(inside, 1.0f));
        }
    }
}

static void paint_disc(struct layer *layer, struct point at, float radius_x, float radius_y,
                       struct colour colour, float opacity)
{
    for (int32_t y = (int32_t)(at.y - radius_y - 1.0f); y <= (int32_t)(at.y + radius_y); y++) {
        for (int32_t x = (int32_t)(at.x - radius_x - 1.0f); x <= (int32_t)(at.x + radius_x); x++) {
            const float dx = ((float)x + 0.5f - at.x) / radius_x;
            const float dy = ((float)y + 0.5f - at.y) / radius_y;
            const float inside = (1.0f - sqrtf(dx * dx + dy * dy)) * fminf(radius_x, radius_y);
            cover(layer, x, y, colour, opacity * fminf(inside + 0.5f, 1.0f));
        }
    }
}

/* A piece of cloth or wood between the rows `low` and `high`. Half its width is `half_low` at the
 * first row and `half_high` at the second one. The colours `a` and `b` alternate in stripes of
 * `stripe` texels. */
struct sheet {
    float x, low, high, half_low, half_high, stripe;
    struct colour a, b;
};

static void paint_sheet(struct layer *layer, const struct sheet *sheet, uint32_t seed)
{
    for (int32_t y = (int32_t)sheet->low; y < (int32_t)sheet->high; y++) {
        const float t = ((float)y - sheet->low) / (sheet->high - sheet->low);
        const float half = noise_mix(sheet->half_low, sheet->half_high, t);
        for (int32_t x = (int32_t)(sheet->x - half); x <= (int32_t)(sheet->x + half); x++) {
            const float across = ((float)x - sheet->x) / half;
            const bool is_b = sinf(((float)x - sheet->x) * TAU * 0.5f / sheet->stripe) < 0.0f;
            const float fold = 0.75f + 0.5f * noise_2d((float)x * 0.09f + across * t,
                                                       (float)y * 0.012f, 4096, 4096, seed);
            cover(layer, x, y, times(is_b ? sheet->b : sheet->a, fold * (0.85f - 0.3f * across)),
                  1.0f);
        }
    }
}

/* Light that falls on cloth, skin and wood, and the strength of the lamps in the picture. */
struct hour {
    struct colour light;
    float lamps;
};

static const struct hour night = { { 0.62f, 0.40f, 0.24f }, 1.0f };
static const struct hour day = { { 1.30f, 1.27f, 1.20f }, 0.10f };

static struct colour lit(const struct hour *hour, float r, float g, float b)
{
    return (struct colour){ r * hour->light.r, g * hour->light.g, b * hour->light.b };
}

/* Paints the street, the front of the stall across the street, and the air above it. */
static void paint_street(const struct hour *hour)
{
    const bool is_night = hour == &night;
    for (int32_t y = 0; y < (int32_t)HEIGHT; y++) {
        for (int32_t x = 0; x < (int32_t)WIDTH; x++) {
            const float height = (float)y / (float)HEIGHT;
            const float uneven = noise_2d_sum((float)x / 90.0f, (float)y / 40.0f, 4096, 4096, 5, 3);
            const float low = expf(-9.0f * height);
            const struct colour air = is_night ? (struct colour){ 0.030f, 0.014f, 0.016f }
                                               : (struct colour){ 0.62f, 0.70f, 0.66f };
            const struct colour ground = lit(hour, 0.34f, 0.30f, 0.27f);
            const float t = noise_ramp(0.10f, 0.19f, height);
            const float glow = is_night ? 0.20f * low : 0.0f;
            const struct colour at = {
                noise_mix(ground.r * (0.4f + uneven), air.r + glow, t),
                noise_mix(ground.g * (0.4f + uneven), air.g + 0.42f * glow, t),
                noise_mix(ground.b * (0.4f + uneven), air.b + 0.16f * glow, t),
            };
            cover(&far_layer, x, y, at, 1.0f);
        }
    }
    static const float fronts[][2] = { { 105.0f, 92.0f }, { 905.0f, 100.0f }, { 452.0f, 66.0f } };
    for (uint32_t i = 0; i < 3; i++) {
        const struct sheet front = { .x = fronts[i][0],
                                     .low = 38.0f,
                                     .high = 72.0f,
                                     .half_low = fronts[i][1],
                                     .half_high = fronts[i][1],
                                     .stripe = 13.0f,
                                     .a = lit(hour, 0.95f, 0.07f, 0.04f),
                                     .b = lit(hour, 1.15f, 1.05f, 0.90f) };
        paint_sheet(&far_layer, &front, 11 + i);
    }
}

/* Paints strings of bulbs and a row of red lanterns. A reflection of each lamp lies on the wet
 * street. */
static void paint_lamps(const struct hour *hour)
{
    static const float rows[][4] = {
        /* Row of the lamps, sag of the string, number of lamps, radius of a lamp. */
        { 84.0f, 16.0f, 31.0f, 2.2f },
        { 128.0f, 26.0f, 17.0f, 6.5f },
        { 176.0f, 30.0f, 23.0f, 2.6f },
        { 224.0f, 34.0f, 15.0f, 7.5f },
    };
    const bool is_day = hour == &day;
    for (uint32_t row = 0; row < sizeof rows / sizeof *rows; row++) {
        const int32_t count = (int32_t)rows[row][2];
        for (int32_t i = 0; i < count; i++) {
            const float t = ((float)i + 0.5f) / (float)count;
            const float swing = fabsf(sinf(t * TAU * 1.5f + (float)row));
            const struct point at = {
                t * (float)WIDTH + 8.0f * (noise_hash01(i, 3, row) - 0.5f),
                rows[row][0] - rows[row][1] * swing + 5.0f * noise_hash01(i, 5, row),
            };
            const bool is_lantern = rows[row][3] > 4.0f;
            const float hue = noise_hash01(i, 9, row);
            const struct colour bulb = hue < 0.72f   ? (struct colour){ 30.0f, 15.0f, 5.0f }
                                       : hue < 0.86f ? (struct colour){ 26.0f, 5.0f, 2.5f }
                                                     : (struct colour){ 14.0f, 20.0f, 13.0f };
            const struct colour paper =
                is_day ? lit(hour, 0.95f, 0.10f, 0.05f) : (struct colour){ 3.6f, 0.42f, 0.06f };
            const float strength = (is_lantern && is_day ? 1.0f : hour->lamps) *
                                   (0.6f + 0.6f * noise_hash01(i, 11, row));
            const struct colour light = times(is_lantern ? paper : bulb, strength);
            paint_disc(&far_layer, at, rows[row][3], rows[row][3] * (is_lantern ? 1.25f : 1.0f),
                       light, 1.0f);
            paint_disc(&far_layer, (struct point){ at.x, 26.0f }, 2.0f * rows[row][3], 9.0f,
                       times(light, is_lantern ? 0.30f : 0.035f), 0.5f);
        }
    }
}

/* A passer-by, before `shrink` of the layer. */
struct walker {
    float x, hem, step; /* Column, row of the hem, and distance of the feet. */
    struct colour cloth, stripe;
};

/* Paints the cotton robe of a passer-by with its sash and sleeves, and the head and the hands.
 * Only a portrait screen shows more than the hem. */
static void paint_yukata(const struct walker *walker, const struct hour *hour, uint32_t seed)
{
    const struct colour a = lit(hour, walker->cloth.r, walker->cloth.g, walker->cloth.b);
    const struct colour b = lit(hour, walker->stripe.r, walker->stripe.g, walker->stripe.b);
    const struct colour sash =
        seed % 2 == 0 ? lit(hour, 0.80f, 0.55f, 0.14f) : lit(hour, 0.50f, 0.07f, 0.09f);
    const struct colour skin = lit(hour, 0.85f, 0.52f, 0.36f);
    const float x = walker->x, tall = walker->hem - 48.0f, hem = 15.0f + 0.4f * walker->step;
    const struct sheet skirt = { x, walker->hem, 138.0f + tall, hem, 27.0f, 6.0f, a, b };
    const struct sheet body = { x, 138.0f + tall, 190.0f + tall, 26.0f, 19.0f, 6.0f, a, b };
    const struct sheet belt = { x, 130.0f + tall, 149.0f + tall, 26.5f, 26.0f, 1e3f, sash, sash };
    const struct point neck = { x, 188.0f + tall }, face = { x + 2.0f, 210.0f + tall };
    paint_limb(&people_layer, neck, face, 6.0f, 6.0f, skin);
    paint_sheet(&people_layer, &skirt, seed);
    paint_sheet(&people_layer, &body, seed);
    paint_sheet(&people_layer, &belt, seed);
    for (int32_t side = -1; side <= 1; side += 2) {
        const struct point shoulder = { x + 17.0f * (float)side, 182.0f + tall };
        const struct point wrist = { x + 33.0f * (float)side, 134.0f + tall };
        const struct point fingers = { wrist.x, wrist.y - 15.0f };
        paint_limb(&people_layer, wrist, fingers, 5.0f, 4.0f, skin);
        paint_limb(&people_layer, shoulder, wrist, 9.0f, 11.0f, side < 0 ? a : b);
    }
    paint_disc(&people_layer, face, 12.0f, 15.0f, times(skin, 0.8f), 1.0f);
    paint_disc(&people_layer, (struct point){ face.x - 3.0f, face.y + 6.0f }, 13.0f, 13.0f,
               lit(hour, 0.05f, 0.035f, 0.03f), 1.0f);
}

static void paint_walker(const struct walker *walker, const struct hour *hour, uint32_t seed)
{
    const struct colour skin = lit(hour, 0.85f, 0.52f, 0.36f);
    const struct colour wood = lit(hour, 0.60f, 0.34f, 0.18f);
    const struct colour straw = lit(hour, 0.75f, 0.58f, 0.32f);
    for (int32_t side = -1; side <= 1; side += 2) {
        const float foot = STREET_ROW + (side > 0 ? 13.0f : 9.0f);
        const struct point hip = { walker->x + 9.0f * (float)side, walker->hem + 6.0f };
        const struct point heel = { walker->x + walker->step * (float)side, foot };
        const struct point toe = { heel.x + 9.0f, foot - 2.5f };
        const struct point back = { heel.x - 6.0f, foot - 5.5f },
                           front = { toe.x + 5.0f, foot - 6.5f };
        /* Wooden sandals stand on two teeth, and straw sandals lie flat. */
        for (uint32_t tooth = 0; seed % 2 == 0 && tooth < 2; tooth++) {
            const struct point top = { noise_mix(back.x, front.x, tooth == 0 ? 0.25f : 0.7f),
                                       foot - 6.0f };
            paint_limb(&people_layer, top, (struct point){ top.x, foot - 10.5f }, 2.0f, 2.0f, wood);
        }
        paint_limb(&people_layer, back, front, 2.4f, 2.4f, seed % 2 == 0 ? wood : straw);
        paint_limb(&people_layer, hip, heel, 8.0f, 4.4f, skin);
        paint_limb(&people_layer, heel, toe, 4.4f, 3.2f, skin);
        paint_limb(&people_layer, (struct point){ heel.x + 2.0f, foot + 2.5f }, toe, 1.6f, 1.3f,
                   lit(hour, 0.9f, 0.08f, 0.06f));
    }
    paint_yukata(walker, hour, seed);
}

static void paint_walkers(const struct hour *hour)
{
    static const struct walker walkers[] = {
        { 38.0f, 50.0f, 11.0f, { 0.10f, 0.13f, 0.42f }, { 0.14f, 0.18f, 0.52f } },
        { 226.0f, 46.0f, 12.0f, { 0.62f, 0.10f, 0.22f }, { 0.82f, 0.30f, 0.36f } },
        { 296.0f, 44.0f, 9.0f, { 0.85f, 0.80f, 0.72f }, { 0.25f, 0.34f, 0.66f } },
        { 672.0f, 47.0f, 12.0f, { 0.08f, 0.10f, 0.26f }, { 0.11f, 0.14f, 0.36f } },
        { 736.0f, 52.0f, 10.0f, { 0.80f, 0.66f, 0.40f }, { 0.72f, 0.16f, 0.12f } },
        { 812.0f, 45.0f, 12.0f, { 0.16f, 0.34f, 0.28f }, { 0.22f, 0.44f, 0.36f } },
        { 990.0f, 48.0f, 11.0f, { 0.56f, 0.14f, 0.34f }, { 0.70f, 0.24f, 0.44f } },
    };
    for (uint32_t i = 0; i < sizeof walkers / sizeof *walkers; i++) {
        people_layer.foot = walkers[i].x;
        /* The panels of a portrait screen would cover the heads of taller people. */
        people_layer.shrink = 0.25f - 0.05f * (float)(i % 3);
        paint_walker(&walkers[i], hour, 31 + i);
    }
}

/* Paints a bag of water with a goldfish that hangs on a red string. */
static void paint_bag(struct point at, float radius, const struct hour *hour)
{
    const struct colour string = lit(hour, 0.95f, 0.06f, 0.05f);
    const struct colour water = lit(hour, 0.55f, 0.95f, 1.10f);
    const struct colour film = lit(hour, 1.5f, 1.6f, 1.6f);
    const struct colour fish = lit(hour, 2.6f, 0.55f, 0.08f);
    const float top = at.y + 1.9f * radius;
    paint_limb(&near_layer, (struct point){ at.x, top },
               (struct point){ at.x + 4.0f, (float)HEIGHT }, 1.1f, 1.1f, string);
    for (uint32_t i = 0; i < 5; i++) {
        const float t = (float)i / 4.0f;
        paint_disc(&near_layer, (struct point){ at.x, at.y + radius * (0.5f + 1.3f * t) },
                   radius * (0.85f - 0.65f * t), radius * 0.42f, film, 0.09f);
    }
    paint_disc(&near_layer, at, radius, radius * 1.08f, film, 0.45f);
    paint_disc(&near_layer, at, radius - 1.5f, radius * 1.08f - 1.5f, times(water, 0.55f), 0.75f);
    const struct point body = { at.x - 0.1f * radius, at.y - 0.2f * radius };
    paint_limb(&near_layer, (struct point){ body.x + 0.35f * radius, body.y },
               (struct point){ body.x + 0.75f * radius, body.y + 0.25f * radius }, 0.12f * radius,
               0.22f * radius, fish);
    paint_limb(&near_layer, (struct point){ body.x - 0.35f * radius, body.y },
               (struct point){ body.x + 0.35f * radius, body.y }, 0.26f * radius, 0.13f * radius,
               fish);
    paint_disc(&near_layer, (struct point){ at.x - 0.45f * radius, at.y + 0.5f * radius },
               0.16f * radius, 0.26f * radius, times(film, 2.0f), 0.9f);
    paint_limb(&near_layer, (struct point){ at.x - 2.0f, top - 2.0f },
               (struct point){ at.x + 2.0f, top - 2.0f }, 2.4f, 2.4f, string);
}

/* Writes one character in brush writing. `at` is the lower left corner of its square. */
static void paint_character(const stbtt_fontinfo *font, uint32_t code, struct point at, float side,
                            struct colour ink)
{
    const float scale = stbtt_ScaleForMappingEmToPixels(font, side);
    int width = 0, height = 0, left = 0, top = 0;
    uint8_t *const ink8 =
        stbtt_GetCodepointBitmap(font, scale, scale, (int)code, &width, &height, &left, &top);
    if (!ink8) {
        bake_fail("%s: no character %04x", BRUSH, code);
    }
    const float x0 = at.x + 0.5f * (side - (float)width);
    const float y0 = at.y + 0.5f * (side + (float)height);
    for (int y = 0; y < height; y++) {
        for (int x = 0; x < width; x++) {
            cover(&near_layer, (int32_t)x0 + x, (int32_t)y0 - y, ink,
                  (float)ink8[y * width + x] / 255.0f);
        }
    }
    stbtt_FreeBitmap(ink8, NULL);
}

/* Paints the sign of the neighbour, who sells candied apples for 300 yen. The sign never states the
 * price of this stall, which is a setting. */
static void paint_sign(const struct hour *hour)
{
    static const uint32_t words[] = { 0x308a, 0x3093, 0x3054, 0x98f4, 0, 0x4e09, 0x767e, 0x5186 };
    stbtt_fontinfo font;
    size_t size;
    uint8_t *const bytes = bake_read(BRUSH, &size);
    if (!stbtt_InitFont(&font, bytes, 0)) {
        bake_fail("%s is not a TrueType font", BRUSH);
    }
    const struct point low = { 492.0f, 30.0f };
    const float side = 21.0f, length = 7.6f * side;
    const struct sheet board = { .x = low.x + 0.5f * length,
                                 .low = low.y,
                                 .high = low.y + 34.0f,
                                 .half_low = 0.5f * length + 9.0f,
                                 .half_high = 0.5f * length + 9.0f,
                                 .stripe = 1000.0f,
                                 .a = lit(hour, 1.75f, 1.55f, 1.15f),
                                 .b = lit(hour, 1.75f, 1.55f, 1.15f) };
    paint_sheet(&near_layer, &board, 71);
    float x = low.x;
    for (uint32_t i = 0; i < sizeof words / sizeof *words; i++) {
        const struct colour ink =
            i > 4 ? lit(hour, 0.85f, 0.05f, 0.03f) : lit(hour, 0.05f, 0.03f, 0.03f);
        if (words[i]) {
            paint_character(&font, words[i], (struct point){ x, low.y + 6.0f }, side + 3.0f, ink);
        }
        x += words[i] ? side : 0.6f * side;
    }
    free(bytes);
}

/* Blurs a layer with a disc of the radius `radius` in texels, and lays it over `under`. */
static void add_blurred(struct layer *under, const struct layer *layer, float radius)
{
    const int32_t reach = (int32_t)radius;
    memset(&blurred, 0, sizeof blurred);
    float count = 0.0f;
    for (int32_t dy = -reach; dy <= reach; dy++) {
        const int32_t half = (int32_t)sqrtf(radius * radius - (float)(dy * dy));
        count += (float)(2 * half + 1);
        for (int32_t y = 0; y < (int32_t)HEIGHT; y++) {
            const int32_t from = y + dy < 0                 ? 0
                                 : y + dy < (int32_t)HEIGHT ? y + dy
                                                            : (int32_t)HEIGHT - 1;
            double sums[WIDTH + 1][4] = { 0 };
            for (uint32_t x = 0; x < WIDTH; x++) {
                for (uint32_t i = 0; i < 4; i++) {
                    sums[x + 1][i] = sums[x][i] + (double)layer->rgba[from][x][i];
                }
            }
            for (int32_t x = 0; x < (int32_t)WIDTH; x++) {
                const int32_t left = x - half < 0 ? 0 : x - half;
                const int32_t right = x + half + 1 > (int32_t)WIDTH ? (int32_t)WIDTH : x + half + 1;
                const float share = (float)(2 * half + 1) / (float)(right - left);
                for (uint32_t i = 0; i < 4; i++) {
                    blurred.rgba[y][x][i] += (float)(sums[right][i] - sums[left][i]) * share;
                }
            }
        }
    }
    for (uint32_t y = 0; y < HEIGHT; y++) {
        for (uint32_t x = 0; x < WIDTH; x++) {
            const float left = 1.0f - blurred.rgba[y][x][3] / count;
            for (uint32_t i = 0; i < 4; i++) {
                under->rgba[y][x][i] = under->rgba[y][x][i] * left + blurred.rgba[y][x][i] / count;
            }
        }
    }
}

static void bake_hour(uint8_t *rgb8, const struct hour *hour)
{
    static struct layer picture;
    memset(&picture, 0, sizeof picture);
    memset(&far_layer, 0, sizeof far_layer);
    memset(&people_layer, 0, sizeof people_layer);
    memset(&near_layer, 0, sizeof near_layer);
    paint_street(hour);
    paint_lamps(hour);
    paint_walkers(hour);
    static const float bags[][3] = { { 372.0f, 36.0f, 15.0f }, { 408.0f, 48.0f, 13.0f },
                                     { 441.0f, 34.0f, 14.0f }, { 150.0f, 44.0f, 15.0f },
                                     { 186.0f, 60.0f, 13.0f }, { 866.0f, 52.0f, 15.0f } };
    for (uint32_t i = 0; i < sizeof bags / sizeof *bags; i++) {
        paint_bag((struct point){ bags[i][0], bags[i][1] }, bags[i][2], hour);
    }
    paint_sign(hour);
    add_blurred(&picture, &far_layer, 8.5f);
    add_blurred(&picture, &people_layer, 2.4f);
    add_blurred(&picture, &near_layer, 1.2f);
    for (uint32_t y = 0; y < HEIGHT; y++) {
        for (uint32_t x = 0; x < WIDTH; x++) {
            for (uint32_t i = 0; i < 3; i++) {
                /* A soft knee keeps the colour of a lamp. */
                const float light = picture.rgba[y][x][i];
                *rgb8++ = noise_to_u8(sqrtf(1.0f - expf(-1.15f * light)));
            }
        }
    }
}

void bake_backdrop(uint8_t *rgb8)
{
    bake_hour(rgb8, &night);
    bake_hour(rgb8 + (size_t)WIDTH * HEIGHT * 3u, &day);
}
