/* species.h -- a species as constant tables, baked from its text under assets/species/.
 *
 * Key shapes share one topology; all are scaled to unit length (snout to tail tip, body frame of
 * vec.h: the snout at z = -0.5). Size is the growth curve, apart from shape (2005 thesis). */
#ifndef KINGYO_CORE_MORPH_SPECIES_H
#define KINGYO_CORE_MORPH_SPECIES_H

#include <stdint.h>

#include "core/scene.h"

#define MORPH_KEY_MAX SCENE_KEY_MAX
#define SPECIES_LOD_COUNT 2u /* 0 near, 1 far. */
#define CURVE_KNOT_MAX 8u    /* A hand-drawn curve with more knots is a table. */

enum species_part {
    PART_BODY = 0,
    PART_EYE = 1,
    PART_TAIL = 2,
    PART_DORSAL = 3,
    PART_ANAL = 4,
    PART_PECTORAL = 5,
    PART_PELVIC = 6,
    PART_COUNT,
};

/* Body: u from the snout 0 to the tail root 1; v round the girth, 0 at the back, over the right
 * flank, 0.5 at the belly, over the left flank to 1 at the back again (its seam column is doubled).
 * Fins: u from the leading ray 0 to the last 1 (tail: top to bottom), v from root 0 to tip 1.
 * Eyes: u from the centre 0 to the rim 1; v is the body's on that side, for the skin around. */
struct species_vertex {
    float u, v;
    uint8_t part;    /* enum species_part */
    uint8_t flex;    /* 0 .. 255: how far a fin's point trails the water; 0 on body and eyes. */
};

/* Triangles are counter-clockwise seen from outside. The body is closed; an eye is a dome whose rim
 * lies under the skin; a fin is a sheet of one layer of vertices whose triangles come twice, once
 * in each winding, so that back faces may be culled: whoever draws it turns a fin's normal toward
 * the viewer (part >= PART_TAIL). */
struct species_mesh {
    uint32_t vertex_count, index_count;
    const struct species_vertex *vertices;
    const vec3 *positions[MORPH_KEY_MAX]; /* One per key; unit length. */
    const vec3 *normals[MORPH_KEY_MAX];   /* Unit. */
    const uint16_t *indices;
};

/* How a key is painted, 0xRRGGBB in sRGB; patterns of an individual lie over it. */
struct species_tint {
    uint32_t back, flank, belly, fin;
};

/* A knot of the deformation graph: progress, then each key's weight (sum 1, each >= 0). */
struct graph_knot {
    float progress;
    float weight[MORPH_KEY_MAX];
};

/* von Bertalanffy (2005 thesis, eq. 3.3) with a start that keeps hatchlings their true length. */
struct growth {
    float length_inf_m, k_per_year, t0_year;
    float hatch_length_m, hatch_tau_year;
};

struct species {
    const char *id;
    uint32_t key_count;                      /* 3 .. MORPH_KEY_MAX */
    const char *key_names[MORPH_KEY_MAX];
    float key_length_m[MORPH_KEY_MAX];       /* True length at each key; rising. */
    struct species_tint key_tint[MORPH_KEY_MAX];
    struct growth growth;
    uint32_t knot_count;
    struct graph_knot knots[CURVE_KNOT_MAX]; /* Progress rises from 0 to 1. */
    struct species_mesh lod[SPECIES_LOD_COUNT];
};

extern const struct species species_wakin;

#endif
