/* caption.c -- draws the caption and the scale bar of a fish. */
#include "platform/ctl/lib/caption.h"

#include <math.h>
#include <stdio.h>

#include "core/base/panic.h"
#include "platform/key_colour.h"

#define DAYS_PER_YEAR 365.25

void caption_age(char out[CAPTION_WORDS_SIZE], float age_days)
{
    const double days = (double)age_days;
    if (days < 0.05) {
        snprintf(out, CAPTION_WORDS_SIZE, "hatching");
    } else if (days < 2.0 * DAYS_PER_YEAR) {
        snprintf(out, CAPTION_WORDS_SIZE, "%.*f days", days < 100.0 ? 1 : 0, days);
    } else {
        snprintf(out, CAPTION_WORDS_SIZE, "%.1f years", days / DAYS_PER_YEAR);
    }
}

void caption_length(char out[CAPTION_WORDS_SIZE], float length_m)
{
    const double m = (double)length_m;
    if (m < 0.1) {
        snprintf(out, CAPTION_WORDS_SIZE, "%.*f mm", m < 1e-3 ? 2 : 1, 1e3 * m);
    } else if (m < 1.0) {
        snprintf(out, CAPTION_WORDS_SIZE, "%.1f cm", 1e2 * m);
    } else {
        snprintf(out, CAPTION_WORDS_SIZE, "%.2f m", m);
    }
}

void caption_name(char out[CAPTION_WORDS_SIZE], const char *name)
{
    uint32_t i = 0;
    for (; name[i] != '\0' && i < CAPTION_WORDS_SIZE - 1u; i++) {
        out[i] = name[i] == '_' ? ' ' : name[i];
    }
    out[i] = '\0';
}

const char *caption_measure(const struct species_card *card)
{
    static const char *const names[] = { [MEASURE_TOTAL] = "TL",
                                         [MEASURE_STANDARD] = "SL",
                                         [MEASURE_FORK] = "FL",
                                         [MEASURE_DISC] = "DW" };
    return names[card->measure];
}

float caption_round_length_m(float length_m)
{
    CORE_ASSERT(length_m > 0.0f);
    const float decade = powf(10.0f, floorf(log10f(length_m) + 1e-4f));
    const float steps = length_m / decade;
    return decade * (steps >= 4.999f ? 5.0f : steps >= 1.999f ? 2.0f : 1.0f);
}

void caption_bar(struct canvas *canvas, float x, float y, float width_max_px, float px_per_m,
                 float size_px)
{
    char words[CAPTION_WORDS_SIZE];
    const float length_m = caption_round_length_m(width_max_px / px_per_m);
    const float width = length_m * px_per_m, tick = 0.45f * size_px;
    const float thick = f_max(0.12f * size_px, 1.5f), left = x - 0.5f * width;
    canvas_fill(canvas, (struct canvas_box){ left, y - 0.5f * thick, width, thick }, CAPTION_INK,
                CAPTION_INK);
    for (uint32_t end = 0; end < 2; end++) {
        const float at = end ? left + width - thick : left;
        canvas_fill(canvas, (struct canvas_box){ at, y - 0.5f * tick, thick, tick }, CAPTION_INK,
                    CAPTION_INK);
    }
    static const struct {
        double from_m, per_m;
        const char *name;
    } units[] = { { 0.995, 1.0, "m" }, { 9.5e-3, 1e2, "cm" }, { 0.0, 1e3, "mm" } };
    uint32_t unit = 0;
    while ((double)length_m < units[unit].from_m) {
        unit++;
    }
    snprintf(words, sizeof words, "%.3g %s", (double)length_m * units[unit].per_m,
             units[unit].name);
    canvas_words(canvas, x, y + 1.15f * size_px, size_px, ALIGN_CENTRE, CAPTION_INK, words);
}

void caption_weights(struct canvas *canvas, struct canvas_box box, uint32_t key_count,
                     const float weights[MORPH_KEY_MAX])
{
    float left = box.left;
    CORE_ASSERT(key_count <= MORPH_KEY_MAX);
    for (uint32_t i = 0; i < key_count; i++) {
        const float width = box.width * f_clamp(weights[i], 0.0f, 1.0f);
        const uint32_t colour = key_colour(key_count, i);
        canvas_fill(canvas, (struct canvas_box){ left, box.top, width, box.height }, colour,
                    colour);
        left += width;
    }
}
