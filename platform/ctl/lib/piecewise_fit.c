/* piecewise_fit.c -- adds samples in several passes. Each pass halves the intervals whose error is
 * too large. */
#include "platform/ctl/lib/piecewise_fit.h"

#include <stdlib.h>
#include <string.h>

#include "core/base/panic.h"

struct sample {
    float progress;
    /* True if no sample is needed between this sample and the next one, because the straight line
     * between them is accurate enough. */
    bool settled;
};

struct samples {
    uint32_t count, room, width;
    struct sample *at;
    float *values;
};

static bool samples_open(struct samples *s, uint32_t room, uint32_t width)
{
    *s = (struct samples){ .room = room, .width = width };
    s->at = malloc(room * sizeof *s->at);
    s->values = malloc((size_t)room * width * sizeof *s->values);
    return s->at && s->values;
}

static void samples_free(struct samples *s)
{
    free(s->at);
    free(s->values);
}

static float *append_fit_sample(struct samples *s, float progress, bool settled,
                                const float *values)
{
    CORE_ASSERT(s->count < s->room);
    float *place = &s->values[(size_t)s->count * s->width];
    s->at[s->count++] = (struct sample){ progress, settled };
    if (values) {
        memcpy(place, values, s->width * sizeof *values);
    }
    return place;
}

/* Copies the samples `from` to `to`, and inserts a sample in the middle of each interval whose
 * error is too large. Returns the number of inserted samples. */
static uint32_t refine(const struct samples *from, struct samples *to,
                       const struct piecewise_fit_function *f, float tolerance)
{
    uint32_t halved = 0;
    for (uint32_t i = 0; i < from->count; i++) {
        const float *values = &from->values[(size_t)i * from->width];
        const struct sample *at = &from->at[i];
        const uint32_t place = to->count;
        append_fit_sample(to, at->progress, at->settled, values);
        if (at->settled) {
            continue;
        }
        const float middle = 0.5f * (at->progress + at[1].progress);
        float *exact = append_fit_sample(to, middle, false, NULL);
        f->sample(f->self, middle, exact);
        if (f->error(f->self, values, values + from->width, exact) <= tolerance) {
            to->count--;
            to->at[place].settled = true;
        } else {
            halved++;
        }
    }
    return halved;
}

bool piecewise_fit_fit(struct piecewise_fit *track, const struct piecewise_fit_function *function,
                       const float *marks, uint32_t mark_count, float tolerance)
{
    CORE_ASSERT(mark_count >= 2);
    struct samples s;
    uint32_t halved = 1;
    bool good = samples_open(&s, mark_count, function->width);
    for (uint32_t i = 0; good && i < mark_count; i++) {
        CORE_ASSERT(i == 0 || marks[i] > marks[i - 1]);
        function->sample(function->self, marks[i],
                         append_fit_sample(&s, marks[i], i + 1 == mark_count, NULL));
    }
    for (uint32_t pass = 0; good && halved > 0 && pass < PIECEWISE_FIT_HALVINGS; pass++) {
        struct samples finer;
        good = samples_open(&finer, 2u * s.count, s.width);
        if (good) {
            halved = refine(&s, &finer, function, tolerance);
            samples_free(&s);
            s = finer;
        } else {
            samples_free(&finer);
        }
    }
    *track = (struct piecewise_fit){ .count = good ? s.count : 0, .width = s.width };
    track->progress = good ? malloc(s.count * sizeof *track->progress) : NULL;
    if (!track->progress) {
        samples_free(&s);
        return false;
    }
    for (uint32_t i = 0; i < s.count; i++) {
        track->progress[i] = s.at[i].progress;
    }
    free(s.at);
    track->values = s.values;
    return true;
}

void piecewise_fit_free(struct piecewise_fit *track)
{
    free(track->progress);
    free(track->values);
    *track = (struct piecewise_fit){ 0 };
}
