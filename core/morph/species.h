/* species.h -- a species: the life as plain data, the bodies as constant tables.
 *
 * Three to eight key shapes share one topology and one size: the species' own measure (total,
 * fork or standard length, or the disc width of a ray) is 1 in every key. The snout is at z =
 * -0.5 of the body frame of vec.h. Size is a separate curve, independent of shape (2005 thesis,
 * section 3.2). Built-in species are baked from assets/species/NAME.txt; others are read from
 * packed files. */
#ifndef KINGYO_CORE_MORPH_SPECIES_H
#define KINGYO_CORE_MORPH_SPECIES_H

#include <stdint.h>

#include "core/base/vec.h"

#define MORPH_KEY_MAX 8u /* Limit of the vertex shader's attributes. */
/* The curve of the whole fish and those of three parts: the four masks of a vertex. */
#define MORPH_CURVE_MAX 4u
#define GRAPH_KNOT_MAX 12u    /* A hand-drawn curve with more knots would be a table. */
#define GROWTH_POINT_MAX 12u  /* The conger has the most: nine measured lengths. */
#define SPECIES_NAME_SIZE 24u /* Size with the terminating zero: a-z, 0-9 and _. */
#define SPECIES_LOD_COUNT 2u  /* 0 near, 1 far. */
#define SPECIES_BUILT_IN 7u
#define SPECIES_EXTRA_MAX 8u /* Fixed slots for packed files of makers. */
#define SPECIES_MAX (SPECIES_BUILT_IN + SPECIES_EXTRA_MAX)
#define MESH_VERTEX_MAX 1024u /* Per level of detail; a near bigeye has 847. */
#define MESH_INDEX_MAX 8192u
#define ANCHOR_MAX 96u /* A root for each ray column of each fin, and two eyes. */
#define ANCHOR_NONE 255u
#define MARK_MAX 8u /* Painted marks of one key. */

enum species_part {
    PART_BODY = 0,
    PART_EYE = 1,
    PART_TAIL = 2,
    PART_DORSAL = 3,
    PART_ANAL = 4,
    PART_PECTORAL = 5,
    PART_PELVIC = 6,
    PART_DORSAL_2 = 7,     /* Second dorsal fin of a tuna. */
    PART_FINLET_UPPER = 8, /* The finlets behind a tuna's second dorsal fin. */
    PART_FINLET_LOWER = 9, /* The finlets behind a tuna's anal fin. */
    PART_COUNT,
};

enum species_side { SIDE_MIDDLE = 0, SIDE_RIGHT = 1, SIDE_LEFT = 2 };

/* Body coordinates of a vertex. Body: u from the snout 0 to the tail root 1; v around the girth, 0
 * at the back, over the right flank, 0.5 at the belly, over the left flank to 1 at the back again
 * (the seam column is doubled). Fins: u from the leading ray 0 to the last ray 1 (tail: top to
 * bottom), v from root 0 to tip 1. Eyes: u from the pupil's centre 0 over the visible edge 1 and
 * beyond behind it; v is the body's v on that side, for the skin around. */
struct species_vertex {
    float u, v;
    uint8_t part;   /* enum species_part */
    uint8_t side;   /* enum species_side, for a part of a pair. */
    uint8_t flex;   /* 0 .. 255: how far a fin's point trails in the water; 0 on body and eyes. */
    uint8_t anchor; /* Anchor of the vertex: an index into the mesh's anchors, or ANCHOR_NONE. */
    uint8_t mask[MORPH_CURVE_MAX]; /* Share of each curve in the vertex; the four sum to 255. */
};

/* A vertex in one key. Position: counts of mesh->reach / 32767, from the body's origin, or from the
 * vertex's anchor if it has one. Normal: folded on an octahedron, see morph_normal(). The vertex
 * shader reads the same table. */
struct species_point {
    int16_t x, y, z, normal;
};

/* An anchor: a point on the skin, given by body coordinates in every key, such as the root of a
 * fin's ray or an eye. Between keys the body coordinates are blended, and the place is found on the
 * blended skin. The anchor therefore slides along the body and never cuts through it. */
struct species_anchor {
    uint8_t curve; /* Index of the curve that blends the anchor. */
    uint8_t turns; /* 1: its vertices rotate with the skin (an eye: x out of the skin, z backward
                      along it, y = z cross x). 0: they keep the body's axes (a fin's ray). */
    float u[MORPH_KEY_MAX]; /* [0, 1] */
    float v[MORPH_KEY_MAX]; /* Around the girth; a value outside [0, 1) gives the direction of the
                               way around. */
};

/* Triangles are counter-clockwise seen from outside. The body is closed. An eye is a closed ball
 * half sunk in the skin. A fin is a sheet of one layer of vertices whose triangles exist in both
 * windings, so that back faces may be culled. A renderer turns the normal of a fin toward the
 * viewer (part >= PART_TAIL). */
struct species_mesh {
    uint32_t vertex_count, index_count, anchor_count;
    /* The skin: ring r, spoke s (0 .. spokes, the last on the first) is vertex grid_first + r *
     * (spokes + 1) + s. 0 rings: no anchors. */
    uint16_t grid_first, grid_rings, grid_spokes;
    float reach; /* Length of 32767 counts: 1, 2 or 4 body lengths. */
    const struct species_vertex *vertices;
    const struct species_point *points[MORPH_KEY_MAX];
    const struct species_anchor *anchors;
    const uint16_t *indices;
};

/* A knot of a deformation graph: progress, then each key's weight (sum 1, each >= 0). */
struct graph_knot {
    float progress;
    float weight[MORPH_KEY_MAX];
};

enum graph_line {
    GRAPH_STRAIGHT = 0, /* Linear between knots. */
    GRAPH_SMOOTH = 1,   /* A monotone cubic through the knots of each key, normalised to sum 1. */
};

/* The deformation graph (2005 thesis, section 3.3): knots at increasing progress from 0 to 1. */
struct graph {
    uint8_t knot_count; /* 2 .. GRAPH_KNOT_MAX */
    uint8_t line;       /* enum graph_line */
    uint8_t solved;     /* 1: the weights apply to solved shapes, so that the fish passes through
                           every drawn key; 0: to the drawn keys directly. */
    struct graph_knot knots[GRAPH_KNOT_MAX];
};

/* Length by age: measured points first (the first is hatching, at age 0), joined by a monotone
 * cubic. The last point fades into von Bertalanffy's curve (2005 thesis, eq. 3.3). */
struct growth {
    float length_inf_m, k_per_year, t0_year;
    float fade_year;      /* > 0; after a few times this duration only the curve remains. */
    uint32_t point_count; /* 1 .. GROWTH_POINT_MAX */
    struct growth_point {
        float age_days, length_m;
    } points[GROWTH_POINT_MAX];
};

/* Meaning of `length` for a species; the unit of the tables. */
enum species_measure { MEASURE_TOTAL, MEASURE_STANDARD, MEASURE_FORK, MEASURE_DISC };

/* Style of swimming. */
enum species_motion {
    MOTION_TAIL, /* The tail beats: fusiform and compressed bodies. */
    MOTION_EEL,  /* The wave runs along the whole body. */
    MOTION_FINS, /* A puffer: dorsal and anal fins scull, the body is stiff. */
    MOTION_TUNA, /* Only the blade of the tail beats. */
    MOTION_WING, /* A ray: the wave runs along the edges of the disc. */
};

enum body_form { FORM_FUSIFORM, FORM_COMPRESSED, FORM_DEPRESSED, FORM_EEL, FORM_PUFFER };

/* The life of a species: plain data of about 2 KiB. */
struct species_card {
    char id[SPECIES_NAME_SIZE];
    uint8_t key_count; /* 3 .. MORPH_KEY_MAX */
    uint8_t measure, motion, form;
    uint8_t thesis_key[3];   /* Keys that chapter 4 of the 2005 thesis used. */
    uint8_t thesis_template; /* enum graph_template of chapter 4. */
    char key_names[MORPH_KEY_MAX][SPECIES_NAME_SIZE];
    float key_age_days[MORPH_KEY_MAX]; /* Increasing. */
    float key_length_m[MORPH_KEY_MAX]; /* In the species' measure; not increasing for a conger. */
    struct growth growth;
    uint8_t scale_knot_count; /* 0: size is the growth curve; otherwise 2 or more knots drawn by
                                 hand. */
    struct scale_knot {
        float progress, length_m;
    } scale_knots[GRAPH_KNOT_MAX];
    uint8_t curve_count; /* 1 .. MORPH_CURVE_MAX; curve 0 is that of the whole fish. */
    char curve_names[MORPH_CURVE_MAX][SPECIES_NAME_SIZE];
    struct graph curves[MORPH_CURVE_MAX];
};

/* Paint of a key; colours are 0xRRGGBB in sRGB. */
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
    uint8_t kind; /* enum mark_kind; mark.c defines the meaning of the other members. */
    uint8_t part; /* enum species_part that bears the mark. */
    uint8_t count, seed;
    uint32_t colour;
    float from, to; /* Range along u. */
    float width;
    float slant;
    float low, high; /* Range of height along v: 0 belly .. 1 back. */
};

struct species_coat {
    uint32_t back, flank, belly, fin, iris;
    uint8_t clear; /* 0 opaque .. 255 transparent, as larvae are. */
    uint8_t shine; /* 0 dull .. 255 silver. */
    uint8_t mark_count;
    struct species_mark marks[MARK_MAX];
};

struct species {
    struct species_card card;
    struct species_coat coats[MORPH_KEY_MAX];
    struct species_mesh lod[SPECIES_LOD_COUNT];
};

extern const struct species species_wakin;

/* All built-in species, wakin first; species_table_count entries. */
extern const struct species *const species_table[];
extern const uint32_t species_table_count;

#endif
