/* morph_outline.h -- a fish as a flat outline in an SVG: its parts in one colour. */
#ifndef KINGYO_PLATFORM_CTL_MORPH_OUTLINE_H
#define KINGYO_PLATFORM_CTL_MORPH_OUTLINE_H

#include "core/morph/morph.h"
#include "platform/ctl/svg.h"

/* key_colour() as SVG writes it, "#d23a2c"; the answer is static, for each key its own. */
const char *outline_key_colour(const struct species_card *card, uint32_t key);

/* A name as people write it: "long leaf". */
void outline_words(char out[SPECIES_NAME_SIZE], const char name[SPECIES_NAME_SIZE]);

/* The same, its first letter a capital. */
void outline_title(char out[SPECIES_NAME_SIZE], const char name[SPECIES_NAME_SIZE]);

#define MORPH_SCALE_COLOUR "#8e4bb8" /* The size is purple, as in the 2005 thesis. */

enum outline_view {
    OUTLINE_SIDE,  /* From its left, the head to the left. */
    OUTLINE_FRONT, /* From ahead, the back up. */
    OUTLINE_TOP,   /* From above, the head to the left. */
};

struct outline {
    const struct species *species;
    const struct morph_rig *rig;
    float progress;
    enum outline_view view;
    double x, y;      /* Where the body frame's origin is, in pixels. */
    double length_px; /* What one body length is. */
    const char *colour;
    double opacity;   /* Of the body; fins have half of it. */
    double line_px;   /* How thick its contour is drawn; 0: not at all. */
};

/* What shows most of a body of that form. */
enum outline_view outline_view_of(const struct species_card *card);

/* Where a point of the body frame is on the paper. */
void outline_project(const struct outline *outline, vec3 p, double *x, double *y);

/* Grows the box `low` .. `high` on the paper to hold the fish too. */
void outline_measure(const struct outline *outline, double low[2], double high[2]);

void outline_draw(struct svg *svg, const struct outline *outline);

#endif
