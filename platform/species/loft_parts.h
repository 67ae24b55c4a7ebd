/* loft_parts.h -- functions that the lofting of body, fins and eyes shares. Private to loft*.c. */
#ifndef KINGYO_PLATFORM_SPECIES_LOFT_PARTS_H
#define KINGYO_PLATFORM_SPECIES_LOFT_PARTS_H

#include "platform/species/shape.h"

/* State of the lofting of one species. `vertex_count` rises while the keys' arrays are filled. */
struct lofting {
    const struct species_text *species;
    const struct detail *detail;
    struct loft *loft;
    double unit[MORPH_KEY_MAX]; /* Measure of each key, in its drawing's units. */
};

/* Adds a vertex, which becomes the newest, and returns its index. loft_paint_masks() computes its
 * masks. */
uint16_t loft_next_vertex(struct lofting *l, struct species_vertex vertex);

/* Set the newest vertex's position in one key, as a point of the drawing or as an offset from its
 * anchor. */
void loft_place(struct lofting *l, uint32_t key, v3d p, v3d normal);
void loft_place_from_anchor(struct lofting *l, uint32_t key, v3d offset, v3d normal);

void loft_triangle(struct lofting *l, uint32_t a, uint32_t b, uint32_t c);

/* Adds an anchor with the same body coordinates in every key, until the caller changes them. */
struct species_anchor *loft_next_anchor(struct lofting *l, enum species_part part, uint8_t turns);

/* loft_rings.c: writes u of `count` rings, the last at 1. Rings are denser where an outline bends
 * in any key. */
void loft_place_rings(const struct species_text *species, uint32_t count, double *u);

/* loft_mask.c: returns the curve that moves `part`; 0 is the whole fish's. */
uint8_t loft_curve_of(const struct species_text *species, uint32_t part);
/* Computes every vertex's masks. */
void loft_paint_masks(struct lofting *l);

void loft_add_eyes(struct lofting *l);
void loft_add_fins(struct lofting *l);

#endif
