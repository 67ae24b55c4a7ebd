/* loft_parts.h -- what the lofting of body, fins and eyes shares. Private to loft*.c. */
#ifndef KINGYO_PLATFORM_SPECIES_LOFT_PARTS_H
#define KINGYO_PLATFORM_SPECIES_LOFT_PARTS_H

#include "platform/species/shape.h"

/* What lofting one species needs at hand. `vertex_count` rises while the keys' arrays fill. */
struct lofting {
    const struct species_text *species;
    const struct detail *detail;
    struct loft *loft;
    double unit[MORPH_KEY_MAX]; /* A key's measure, in its drawing's units. */
};

/* Adds a vertex, which then is the newest; its masks come from paint_masks(). */
uint16_t next_vertex(struct lofting *l, struct species_vertex vertex);

/* Sets the newest vertex's place in one key: a point of the drawing, or one told from an anchor. */
void place(struct lofting *l, uint32_t key, point3 p, point3 normal);
void place_from_anchor(struct lofting *l, uint32_t key, point3 offset, point3 normal);

void triangle(struct lofting *l, uint32_t a, uint32_t b, uint32_t c);

/* A new anchor, at the same body coordinates in every key until they are set. */
struct species_anchor *next_anchor(struct lofting *l, enum species_part part, uint8_t turns);

/* loft_rings.c: u of `count` rings, the last at 1, closer where outlines turn in any key. */
void place_rings(const struct species_text *species, uint32_t count, double *u);

/* loft_mask.c: which curve moves `part`; 0 is the whole fish's. */
uint8_t curve_of(const struct species_text *species, uint32_t part);
/* Fills every vertex's masks. */
void paint_masks(struct lofting *l);

void add_eyes(struct lofting *l);
void add_fins(struct lofting *l);

#endif
