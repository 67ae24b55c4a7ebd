/* morph_ages.c -- checks the conversions between age, progress and length over the whole life of a
 * fish. */
#include <math.h>

#include "platform/ctl/morph/morph_walk.h"

/* Counts a moment at which the fish is not older than at the previous moment. */
static void measure_age(struct morph_walk *w, float before_days, float age_days)
{
    if (!(age_days > before_days)) {
        w->out->age_stands_at =
            w->out->moments_not_older == 0 ? w->progress : w->out->age_stands_at;
        w->out->moments_not_older++;
    }
}

/* Compares the fish's length with the growth curve at its age. A key whose size the author of the
 * species drew is skipped. */
static void measure_length(struct morph_walk *w, float age_days)
{
    const struct species_card *card = &w->species->card;
    const float length_m = life_length_m(card, w->progress);
    const float again_m = life_length_m(card, morph_progress(card, length_m));
    morph_walk_keep(w, &w->out->length_lost, fabsf(again_m / length_m - 1.0f),
                    MORPH_SURVEY_NOWHERE);
    if (card->scale_knot_count == 0) {
        const float grown_m = growth_length_m(&card->growth, age_days);
        morph_walk_keep(w, &w->out->off_growth, fabsf(length_m / grown_m - 1.0f),
                        MORPH_SURVEY_NOWHERE);
    }
}

void morph_ages_measure(struct morph_walk *w, uint32_t steps)
{
    const struct species_card *card = &w->species->card;
    float before_days = -1.0f;
    for (uint32_t i = 0; i <= steps; i++) {
        w->progress = (float)i / (float)steps;
        const float age_days = life_age_days(card, w->progress);
        measure_age(w, before_days, age_days);
        measure_length(w, age_days);
        const float back = fabsf(life_progress(card, age_days) - w->progress);
        morph_walk_keep(w, &w->out->progress_lost, back, MORPH_SURVEY_NOWHERE);
        before_days = age_days;
    }
}
