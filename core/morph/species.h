/* species.h -- a species: its growth data as a plain struct, and its meshes as constant tables.
 *
 * A key shape (key) is one modelled growth stage. A species has three to eight keys. All keys have
 * the same mesh topology, and the body has the length 1 in every key. Each species measures this
 * length in one way: total, fork or standard length, or the disc width of a ray.
 *
 * The snout is at z = -0.5 of the body frame (core/base/vec.h). The length in metres is a separate
 * curve that does not depend on the shape (2005 thesis, section 3.2).
 *
 * The build generates the built-in species from assets/species/NAME.txt, and other species are read
 * from packed files. */
#pragma once

#include <stdint.h>

#include "core/base/vec.h"

/* Largest number of keys of a species. The number of vertex shader attributes limits the value. */
#define MORPH_KEY_MAX 8u
/* Largest number of curves (deformation graphs) of a species: one for the whole fish and three for
 * parts. Each vertex has a mask for each curve. */
#define MORPH_CURVE_MAX 4u
/* Largest number of knots of a curve, which is more than a hand-drawn curve needs. */
#define GRAPH_KNOT_MAX 12u
/* Largest number of measured lengths of a species. The conger has nine, more than any other
 * species. */
#define GROWTH_POINT_MAX 12u
/* Size of a species name or key name in bytes, with its terminating zero. A name consists of a-z,
 * 0-9 and _. */
#define SPECIES_NAME_SIZE 24u
/* Number of levels of detail (LOD). Level 0 is for near fish, and level 1 is for distant fish. */
#define SPECIES_LOD_COUNT 2u
/* Largest number of built-in species (SPECIES in assets/bake/species.mk). The state hash covers a
 * slot of each species, so a change of this number moves the hash of every recording. */
#define SPECIES_BUILT_IN 7u
#define SPECIES_EXTRA_MAX 8u /* Number of slots for species that are read from packed files. */
#define SPECIES_MAX (SPECIES_BUILT_IN + SPECIES_EXTRA_MAX)
/* Largest number of vertices of a level of detail; the near level of the bigeye has 847. */
#define MESH_VERTEX_MAX 1024u
#define MESH_INDEX_MAX 8192u
/* Largest number of anchors of a mesh: one for each ray column of each fin, and two for the
 * eyes. */
#define ANCHOR_MAX 96u
#define ANCHOR_NONE 255u
#define MARK_MAX 8u /* Largest number of painted marks in the coat of one key. */

enum species_part {
    PART_BODY = 0,
    PART_EYE = 1,
    PART_TAIL = 2,
    PART_DORSAL = 3,
    PART_ANAL = 4,
    PART_PECTORAL = 5,
    PART_PELVIC = 6,
    PART_DORSAL_2 = 7,     /* Second dorsal fin of a tuna. */
    PART_FINLET_UPPER = 8, /* Finlets behind a tuna's second dorsal fin. */
    PART_FINLET_LOWER = 9, /* Finlets behind a tuna's anal fin. */
    PART_COUNT,
};

enum species_side { SIDE_MIDDLE = 0, SIDE_RIGHT = 1, SIDE_LEFT = 2 };

/* Vertex of a mesh with its body coordinates u and v.
 *
 * On the body, u runs from 0 at the snout to 1 at the tail root. v runs around the girth: 0 at the
 * back, 0.25 on the right flank, 0.5 at the belly, 0.75 on the left flank and 1 at the back again.
 * The vertices at the back are stored twice, with v = 0 and with v = 1. On a fin, u runs from 0 at
 * the leading ray to 1 at the last ray, and v runs from 0 at the root to 1 at the tip. On the tail
 * fin, u runs from top to bottom. On an eye, u is 0 at the centre of the pupil, 1 at the visible
 * edge and greater than 1 behind the edge. v of an eye is the v of the body at the eye. */
struct species_vertex {
    float u, v;
    uint8_t part; /* Part of the fish (enum species_part). */
    uint8_t side; /* Side of a paired fin or an eye (enum species_side). */
    /* Flexibility of a fin's vertex in the water, from 0 (rigid) to 255 (most flexible). The value
     * is 0 on the body and the eyes. */
    uint8_t flex;
    /* Index of the vertex's anchor in the mesh, or ANCHOR_NONE if the vertex has no anchor. */
    uint8_t anchor;
    /* Influence of each curve on the vertex. The four values sum to 255. */
    uint8_t mask[MORPH_CURVE_MAX];
};

/* Position and normal of a vertex in one key. The unit of the position is mesh->reach / 32767. The
 * position is relative to the vertex's anchor, or to the body's origin if the vertex has no anchor.
 * The normal is in octahedral encoding (see morph_normal()). The vertex shader reads this table
 * without conversion. */
struct species_point {
    int16_t x, y, z, normal;
};

/* Anchor: a point on the skin, such as the root of a fin's ray or the place of an eye. An anchor
 * has body coordinates in every key. Between keys, the body coordinates are blended, and the anchor
 * is placed on the blended skin. The anchor therefore slides along the body and never passes
 * through the body. */
struct species_anchor {
    uint8_t curve; /* Index of the curve that blends the anchor. */
    /* 1 if the vertices of the anchor rotate with the skin, as the vertices of an eye do: x points
     * out of the skin, z points backward along the skin, and y = z cross x. 0 if the vertices keep
     * the body's axes, as the vertices of a fin's ray do. */
    uint8_t turns;
    float u[MORPH_KEY_MAX]; /* Body coordinate u of the anchor in each key, in [0, 1]. */
    /* Body coordinate v of the anchor in each key. Between keys, the values are blended. A value
     * outside [0, 1) therefore selects in which direction around the girth the anchor moves. */
    float v[MORPH_KEY_MAX];
};

/* Triangle mesh of one level of detail. Triangles are counter-clockwise as seen from outside. The
 * body is closed.
 *
 * An eye is a closed ball that is half embedded in the skin. A fin is a single layer of vertices,
 * and each triangle of a fin is stored in both windings, so that a renderer may use back-face
 * culling. A renderer must turn the normals of fins (part >= PART_TAIL) toward the viewer. */
struct species_mesh {
    uint32_t vertex_count, index_count, anchor_count;
    /* The vertices of the skin form a grid. The vertex at ring r and spoke s has the index
     * grid_first + r * (grid_spokes + 1) + s. s runs from 0 to grid_spokes, and the last spoke has
     * the same positions as the first spoke. grid_rings is 0 if the mesh has no anchors. */
    uint16_t grid_first, grid_rings, grid_spokes;
    float reach; /* Coordinate, in body lengths, that is stored as 32767: 1, 2 or 4. */
    const struct species_vertex *vertices;
    const struct species_point *points[MORPH_KEY_MAX];
    const struct species_anchor *anchors;
    const uint16_t *indices;
};

/* Knot of a deformation graph: a value of progress, and the weight of each key at this progress.
 * Each weight is at least 0, and the weights sum to 1. */
struct graph_knot {
    float progress;
    float weight[MORPH_KEY_MAX];
};

enum graph_line {
    GRAPH_STRAIGHT = 0, /* Weights are linear between knots. */
    /* The weight of each key follows a monotone cubic curve through the knots. The weights are then
     * divided by their sum. */
    GRAPH_SMOOTH = 1,
};

/* Deformation graph (2005 thesis, section 3.3): a list of knots whose progress increases from 0 to
 * 1. */
struct graph {
    uint8_t knot_count; /* Number of knots, 2 .. GRAPH_KNOT_MAX. */
    uint8_t line;       /* Interpolation between knots (enum graph_line). */
    /* 1 if graph_solve() exaggerates the key shapes before they are blended, so that the fish has
     * exactly the drawn shape of each key at the progress of the key. 0 if the drawn key shapes are
     * blended directly. */
    uint8_t solved;
    struct graph_knot knots[GRAPH_KNOT_MAX];
};

/* Length of a fish as a function of its age. A monotone cubic curve joins the measured points, of
 * which the first is hatching at age 0. After the last point, the length gradually approaches von
 * Bertalanffy's curve (2005 thesis, eq. 3.3). */
struct growth {
    float length_inf_m, k_per_year, t0_year;
    /* Time constant with which the length approaches von Bertalanffy's curve; greater than 0. */
    float fade_year;
    uint32_t point_count; /* Number of measured points, 1 .. GROWTH_POINT_MAX. */
    struct growth_point {
        float age_days, length_m;
    } points[GROWTH_POINT_MAX];
};

/* Kind of length that the tables of a species contain: total, standard or fork length, or disc
 * width. */
enum species_measure { MEASURE_TOTAL, MEASURE_STANDARD, MEASURE_FORK, MEASURE_DISC };

/* Style of swimming. */
enum species_motion {
    MOTION_TAIL, /* The tail beats (fusiform and compressed bodies). */
    MOTION_EEL,  /* A wave runs along the whole body (eels). */
    /* The dorsal and anal fins move like oars, and the body does not bend (puffers). */
    MOTION_FINS,
    MOTION_TUNA, /* Only the tail fin beats (tunas). */
    MOTION_WING, /* A wave runs along the edges of the disc (rays). */
};

enum body_form { FORM_FUSIFORM, FORM_COMPRESSED, FORM_DEPRESSED, FORM_EEL, FORM_PUFFER };

/* Description of a species without its meshes and coats: plain data of about 2 KiB. */
struct species_card {
    char id[SPECIES_NAME_SIZE];
    uint8_t key_count; /* Number of keys, 3 .. MORPH_KEY_MAX. */
    uint8_t measure, motion, form;
    /* Indices of the three keys that correspond to the three key shapes of the 2005 thesis, chapter
     * 4. */
    uint8_t thesis_key[3];
    /* Template that the 2005 thesis, chapter 4, uses for the species (enum graph_template). */
    uint8_t thesis_template;
    char key_names[MORPH_KEY_MAX][SPECIES_NAME_SIZE];
    /* Age of each key in days after hatching. The ages increase from key to key. */
    float key_age_days[MORPH_KEY_MAX];
    /* Length of each key in metres, measured as `measure` states. The lengths increase from key to
     * key, except for a conger. */
    float key_length_m[MORPH_KEY_MAX];
    struct growth growth;
    /* Number of knots of the hand-drawn size curve, at least 2. 0 means that the species has no
     * hand-drawn size curve and that the length follows `growth`. */
    uint8_t scale_knot_count;
    struct scale_knot {
        float progress, length_m;
    } scale_knots[GRAPH_KNOT_MAX];
    /* Number of curves, 1 .. MORPH_CURVE_MAX. Curve 0 blends the whole fish, and the other curves
     * blend parts. */
    uint8_t curve_count;
    char curve_names[MORPH_CURVE_MAX][SPECIES_NAME_SIZE];
    struct graph curves[MORPH_CURVE_MAX];
};

/* Kinds of painted marks. */
enum mark_kind {
    MARK_SPOTS,
    MARK_BANDS,
    MARK_STRIPES,
    MARK_EDGE,
    MARK_PATCH,
    MARK_SIDE,
    MARK_ROWS,
    MARK_MOUTH,
    MARK_GILL,
    MARK_COUNT,
};

struct species_mark {
    /* Kind of the mark (enum mark_kind). The kind determines the meaning of the following members
     * (see mark.c). */
    uint8_t kind;
    uint8_t part; /* Part of the fish on which the mark is painted (enum species_part). */
    uint8_t count, seed;
    uint32_t colour;
    float from, to; /* Range of the mark along the body coordinate u. */
    float width;
    float slant;
    float low, high; /* Range of the mark in height, where 0 is the belly and 1 is the back. */
};

struct species_coat {
    uint32_t back, flank, belly, fin, iris;
    uint8_t clear; /* Transparency of the skin: 0 is opaque, 255 is transparent like a larva. */
    uint8_t shine; /* Shine of the skin: 0 is dull, 255 is silver. */
    uint8_t mark_count;
    struct species_mark marks[MARK_MAX];
};

struct species {
    struct species_card card;
    struct species_coat coats[MORPH_KEY_MAX];
    struct species_mesh lod[SPECIES_LOD_COUNT];
};

extern const struct species species_wakin;

/* All built-in species, of which the wakin is the first. The table has species_table_count
 * entries. */
extern const struct species *const species_table[];
extern const uint32_t species_table_count;
