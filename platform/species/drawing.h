/* drawing.h -- a species text as its maker writes it, and the shapes that are lofted from the text.
 *
 * The build's bake and `kingyoctl morph` use this header. The kiosk reads only their output. A key
 * is one modelled growth stage of the species, with its own drawing. All lengths of a drawing are
 * fractions of the fish's length in the drawing (snout to tail root), with x backward from the
 * snout and y upward from the body's axis. assets/species/README.md explains every keyword to
 * makers. */
#ifndef KINGYO_PLATFORM_SPECIES_DRAWING_H
#define KINGYO_PLATFORM_SPECIES_DRAWING_H

#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>

#include "core/morph/species.h"

#define STATION_MAX 24 /* Maximum number of cross sections of a key. A real fish needs fewer. */
/* Maximum number of drawn rays of a fin. */
#define RAY_MAX 12
/* Maximum number of finlets in a row. A bigeye tuna has eight to ten above and below. */
#define FINLET_MAX 10
#define AREA_MAX 4 /* Maximum number of painted areas of one deformation curve. */
/* Body coordinate u of the gill cover's edge. The value is the same in every key, wherever the edge
 * is drawn. */
#define GILL_U 0.30f

/* A cross section: a superellipse with height `depth`, width `width` and the given exponent. Its
 * centre is `offset` above the body's axis. */
struct station {
    float x, depth, width, offset, exponent;
};

/* One fin ray. `at` is its position along the fin's base, [0, 1], followed by its length and its
 * direction in degrees. The reference directions of `sweep_deg` and `side_deg` depend on the fin:
 * see fin_direction() in shape_fin.c. */
struct ray {
    float at, length, sweep_deg, side_deg;
};

struct fin {
    float start, end; /* Start and end of the fin's base along the body. For the tail, lower and
                         upper height of its base. */
    float girth;      /* Position of a paired fin round the girth. 0 is the back, 0.5 is the
                         belly. */
    float curl_deg;   /* Additional bend of a ray at its tip, in degrees. */
    uint32_t ray_count;
    struct ray rays[RAY_MAX];
};

/* A row of small fins. Each finlet leans `sweep_deg` backward from upright. */
struct finlets {
    uint32_t count; /* Number of finlets, 0 to FINLET_MAX. */
    float start, end, length, sweep_deg;
};

/* An eye. `bulge` is its protrusion as a fraction of the diameter. `turn_deg` is its migration over
 * the back: 0 is the eye's own flank at height `y`, 90 the midline, and 180 the opposite flank at
 * height `y`. */
struct eye {
    float x, y, diameter, bulge, turn_deg;
};

struct key_text {
    char name[SPECIES_NAME_SIZE];
    float length_m;
    float age_days; /* Age of the key in days. A negative value means that the text has no age and
                       that the age is computed from the length. */
    float gill;     /* Position x of the end of the gill cover. 0 means that the text has no gill
                       line. */
    bool confluent; /* Copy of the field `confluent` of struct species_text. */
    uint32_t substep_count;
    struct station stations[STATION_MAX];
    struct eye eyes[2];          /* Right eye, then left eye. */
    struct fin fins[PART_COUNT]; /* Fins, indexed by enum species_part. A fin without rays is not
                                    drawn. */
    struct finlets finlets[2];   /* Upper row of finlets, then lower row. */
    struct species_coat coat;
};

/* Additional parts that a curve may own: the body before the gill cover (head) and behind it
 * (trunk). */
enum { PART_HEAD = PART_COUNT, PART_TRUNK, OWNED_COUNT };

/* A painted area of the body: its range along x, its range of heights (0 is the belly, 1 is the
 * back), and the width `soft` of its edge. */
struct area {
    float from, to, low, high, soft;
};

/* A deformation graph and the parts that it moves. The first graph belongs to the whole fish and
 * moves every part that no other graph owns. */
struct curve_text {
    char name[SPECIES_NAME_SIZE];
    uint32_t parts; /* Set of parts, with one bit for each enum species_part, PART_HEAD and
                       PART_TRUNK. */
    uint32_t area_count;
    struct area areas[AREA_MAX];
    struct graph graph;
};

struct species_text {
    char id[SPECIES_NAME_SIZE];
    uint8_t measure, motion, form; /* Measure, kind of swimming motion, and body form, with the
                                      values of struct species_card. */
    bool confluent;                /* True if the dorsal and anal fins merge with the tail fin, as
                                      in an eel. */
    uint32_t without;              /* Set of parts that the species lacks, with one bit for each
                                      enum species_part. */
    struct growth growth;
    uint32_t scale_knot_count;
    struct scale_knot scale_knots[GRAPH_KNOT_MAX];
    uint8_t thesis_key[3], thesis_template;
    uint32_t key_count;
    struct key_text keys[MORPH_KEY_MAX];
    uint32_t curve_count;
    struct curve_text curves[MORPH_CURVE_MAX];
};

/* One level of detail: the numbers of rings and spokes of the body and the eyes, and for each fin
 * the numbers of rays and of points along a ray. */
struct detail {
    uint32_t rings, spokes;
    bool round_end; /* True if an additional ring rounds off the tail root. */
    uint32_t eye_rings, eye_spokes;
    struct {
        uint32_t across, along;
    } fins[PART_COUNT];
};

struct loft {
    uint32_t vertex_count, index_count, anchor_count;
    uint32_t grid_first, grid_rings, grid_spokes; /* Grid of the body's vertices, with the same
                                                     meaning as in struct species_mesh. */
    float reach;
    struct species_vertex vertices[MESH_VERTEX_MAX];
    vec3 positions[MORPH_KEY_MAX][MESH_VERTEX_MAX]; /* Position of each vertex in each key. The
                                                       position of a vertex with an anchor is
                                                       relative to the anchor. */
    vec3 normals[MORPH_KEY_MAX][MESH_VERTEX_MAX];
    struct species_anchor anchors[ANCHOR_MAX];
    uint16_t indices[MESH_INDEX_MAX];
};

/* Levels of detail: the near mesh, then the far mesh. */
extern const struct detail species_detail[SPECIES_LOD_COUNT];

/* Reads a whole species file. Returns true if the text is valid. Otherwise writes one line
 * 'PATH:LINE: what' to `complaints` and returns false. `species` is then incomplete and must not be
 * used. */
bool species_read(FILE *file, const char *path, FILE *complaints, struct species_text *species);

/* Builds the shapes of all keys with one topology. The shapes are scaled so that the species'
 * measure is 1. */
void species_loft(const struct species_text *species, const struct detail *detail,
                  struct loft *loft);

/* Writes the card and the coats of a species text to `out`. */
void species_compile(const struct species_text *species, struct species *out);

/* Tables of one level of detail. */
struct mesh_tables {
    struct species_vertex vertices[MESH_VERTEX_MAX];
    struct species_point points[MORPH_KEY_MAX][MESH_VERTEX_MAX];
    struct species_anchor anchors[ANCHOR_MAX];
    uint16_t indices[MESH_INDEX_MAX];
};

/* Quantizes a loft to the units of species_point. `mesh` then points to `tables`. */
void species_pack(const struct loft *loft, uint32_t key_count, struct mesh_tables *tables,
                  struct species_mesh *mesh);

#endif
