/* drawing.h -- a species as its maker writes it, and the shapes that are lofted from it.
 *
 * Shared by the build's bake and `kingyoctl morph`; the kiosk reads only their output. All lengths
 * of a drawing are fractions of its own length (snout to tail root), x from the snout backward, y
 * up from the body's axis. assets/species/README.md explains every keyword to makers. */
#ifndef KINGYO_PLATFORM_SPECIES_DRAWING_H
#define KINGYO_PLATFORM_SPECIES_DRAWING_H

#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>

#include "core/morph/species.h"

#define STATION_MAX 24 /* A real fish needs fewer stations than this. */
#define RAY_MAX 12
#define FINLET_MAX 10 /* A bigeye tuna has eight to ten above and below. */
#define AREA_MAX 4    /* Maximum painted areas of one curve. */
/* Body coordinate of the gill cover's edge in every key, wherever it is drawn. */
#define GILL_U 0.30f

/* A cross section: a superellipse of this height and width, its centre `offset` above the axis. */
struct station {
    float x, depth, width, offset, exponent;
};

/* One fin ray at `at` (0 .. 1 along the fin's base): its length and its direction in degrees.
 * The reference directions of `sweep` and `side` depend on the fin: see fin_direction() in
 * shape_fin.c. */
struct ray {
    float at, length, sweep_deg, side_deg;
};

struct fin {
    float start, end; /* The base, along the body; for the tail its height, from bottom to top. */
    float girth;      /* Position of a paired fin round the girth, 0 back .. 0.5 belly. */
    float curl_deg;   /* Additional bend of a ray at its tip. */
    uint32_t ray_count;
    struct ray rays[RAY_MAX];
};

/* A row of small fins, each leaning `sweep_deg` backward from upright. */
struct finlets {
    uint32_t count; /* 0 .. FINLET_MAX */
    float start, end, length, sweep_deg;
};

/* `bulge`: protrusion as a fraction of the diameter. `turn_deg`: migration over the back: 0 is the
 * eye's own flank at height `y`, 90 the midline, 180 the other flank at `y`. */
struct eye {
    float x, y, diameter, bulge, turn_deg;
};

struct key_text {
    char name[SPECIES_NAME_SIZE];
    float length_m;
    float age_days; /* Below 0: not written; computed from the length. */
    float gill;     /* End of the gill cover; 0: not written. */
    bool confluent; /* Copy of the species' `confluent`. */
    uint32_t substep_count;
    struct station stations[STATION_MAX];
    struct eye eyes[2];          /* Right, left. */
    struct fin fins[PART_COUNT]; /* Indexed by part. A fin without rays is not drawn. */
    struct finlets finlets[2];   /* Upper, lower. */
    struct species_coat coat;
};

/* Further parts that a curve may own: the body before and behind the gill cover. */
enum { PART_HEAD = PART_COUNT, PART_TRUNK, OWNED_COUNT };

/* A painted area of the body: range along x, range of height from belly 0 to back 1, and `soft`,
 * the width of its edge. */
struct area {
    float from, to, low, high, soft;
};

/* A deformation graph and the parts that it moves. The first graph is the whole fish's and moves
 * everything that no other graph owns. */
struct curve_text {
    char name[SPECIES_NAME_SIZE];
    uint32_t parts; /* A bit for each enum species_part, PART_HEAD and PART_TRUNK. */
    uint32_t area_count;
    struct area areas[AREA_MAX];
    struct graph graph;
};

struct species_text {
    char id[SPECIES_NAME_SIZE];
    uint8_t measure, motion, form; /* As struct species_card. */
    bool confluent;                /* As in an eel, the dorsal and anal fins merge with the tail
                                      fin. */
    uint32_t without;              /* A bit for each enum species_part that the species lacks. */
    struct growth growth;
    uint32_t scale_knot_count;
    struct scale_knot scale_knots[GRAPH_KNOT_MAX];
    uint8_t thesis_key[3], thesis_template;
    uint32_t key_count;
    struct key_text keys[MORPH_KEY_MAX];
    uint32_t curve_count;
    struct curve_text curves[MORPH_CURVE_MAX];
};

/* One level of detail: number of rings and spokes of the body, rays and points along each fin. */
struct detail {
    uint32_t rings, spokes;
    bool round_end; /* An additional ring rounds off the tail root. */
    uint32_t eye_rings, eye_spokes;
    struct {
        uint32_t across, along;
    } fins[PART_COUNT];
};

struct loft {
    uint32_t vertex_count, index_count, anchor_count;
    uint32_t grid_first, grid_rings, grid_spokes; /* Same meaning as in struct species_mesh. */
    float reach;
    struct species_vertex vertices[MESH_VERTEX_MAX];
    vec3 positions[MORPH_KEY_MAX][MESH_VERTEX_MAX]; /* Relative to the anchor, where a vertex has
                                                       one. */
    vec3 normals[MORPH_KEY_MAX][MESH_VERTEX_MAX];
    struct species_anchor anchors[ANCHOR_MAX];
    uint16_t indices[MESH_INDEX_MAX];
};

/* Near, then far. */
extern const struct detail species_detail[SPECIES_LOD_COUNT];

/* Reads a whole species file. On invalid input, writes one line 'PATH:LINE: what' to `complaints`
 * and returns false; `species` is then incomplete and must not be used. */
bool species_read(FILE *file, const char *path, FILE *complaints, struct species_text *species);

/* Builds every key's shape with one topology, scaled so that the species' measure is 1. */
void species_loft(const struct species_text *species, const struct detail *detail,
                  struct loft *loft);

/* Writes the card and the coats of a species text. */
void species_compile(const struct species_text *species, struct species *out);

/* The tables of one level of detail. */
struct mesh_tables {
    struct species_vertex vertices[MESH_VERTEX_MAX];
    struct species_point points[MORPH_KEY_MAX][MESH_VERTEX_MAX];
    struct species_anchor anchors[ANCHOR_MAX];
    uint16_t indices[MESH_INDEX_MAX];
};

/* Quantizes a loft into the units of species_point. `mesh` then points into `tables`. */
void species_pack(const struct loft *loft, uint32_t key_count, struct mesh_tables *tables,
                  struct species_mesh *mesh);

#endif
