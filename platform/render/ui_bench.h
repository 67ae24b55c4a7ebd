/* ui_bench.h -- what the growth lab's screen keeps from frame to frame: the species on the table,
 * as the lab blends it and as the ordinary morph would, and the ways of two of its points. */
#ifndef KINGYO_PLATFORM_RENDER_UI_BENCH_H
#define KINGYO_PLATFORM_RENDER_UI_BENCH_H

#include <stdbool.h>

#include "core/morph/morph.h"
#include "core/scene.h"
#include "platform/render/specimen.h"

#define BENCH_STEPS 64u /* Of a way through life. */

enum bench_point { BENCH_DORSAL = 0, BENCH_EYE, BENCH_POINT_COUNT };

struct bench_way {
    bool is_there; /* A ray has no dorsal root. */
    vec3 at[BENCH_STEPS + 1u];       /* In lengths, in the body's frame, from hatching on. */
    vec3 ordinary[BENCH_STEPS + 1u]; /* The same point of the ordinary morph. */
    float bow; /* The farthest that it goes from the straight line, in lengths. */
};

/* About 180 KB: the ordinary morph's own tables are most of it. Zero knows nothing yet. */
struct ui_bench {
    const struct species *species; /* On the table; null: none. */
    uint32_t edition;              /* Counts the species that were on it. */
    struct species_card card;      /* As it was when the rest was made. */
    struct morph_rig rig;          /* As edited. */
    struct morph_rig ordinary_rig;
    struct species ordinary;
    struct straight_memory memory;
    struct bench_way ways[BENCH_POINT_COUNT];
    struct specimen_bounds bounds; /* How far it reaches in any age, in its portrait. */
    struct morph_pose pose;        /* Scratch. */
};

/* Puts a species on the table with that card, or leaves it where it lies: only what changed is made
 * anew. `card` has as many keys as the species. */
void ui_bench_set(struct ui_bench *bench, const struct species *species,
                  const struct species_card *card);

#endif
