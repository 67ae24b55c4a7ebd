/* drawing.h -- a species as a maker writes it, and the shapes that are lofted from it.
 *
 * The bake of the build and `kingyoctl morph` share this; the kiosk reads only what they made. All
 * lengths of a drawing are fractions of its own length (snout to tail root), x from the snout
 * backward, y up from the body's axis. assets/species/README.md explains every word to makers. */
#ifndef KINGYO_PLATFORM_SPECIES_DRAWING_H
#define KINGYO_PLATFORM_SPECIES_DRAWING_H

#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>

#include "core/morph/species.h"

#define STATION_MAX 24 /* More would be a scan, not a drawing. */
#define RAY_MAX 12
#define FINLET_MAX 10  /* A bigeye has eight to ten above and below. */
#define AREA_MAX 4     /* Painted areas of one curve. */
#define GILL_U 0.30f   /* Body coordinate of the gill cover's edge, wherever a key draws it. */

/* A cross section: a superellipse of this height and width, its centre `offset` above the axis. */
struct station {
    float x, depth, width, offset, exponent;
};

/* One fin ray at `at` (0 .. 1 along the fin's base): its length and where it points, in degrees.
 * What `sweep` and `side` turn from is the fin's own: see fin_direction() in shape_fin.c. */
struct ray {
    float at, length, sweep_deg, side_deg;
};

struct fin {
    float start, end; /* The base, along the body; of the tail: its height, bottom to top. */
    float girth;      /* Where a paired fin sits, 0 back .. 0.5 belly. */
    float curl_deg;   /* How far a ray has bent on at its tip. */
    uint32_t ray_count;
    struct ray rays[RAY_MAX];
};

/* A row of little fins, each leaning `sweep_deg` backward from upright. */
struct finlets {
    uint32_t count; /* 0 .. FINLET_MAX */
    float start, end, length, sweep_deg;
};

/* `bulge`: how far it stands out, of its diameter. `turn_deg`: how far round it has gone, over the
 * back: 0 on its own flank at height `y`, 90 on the midline, 180 on the other flank at `y`. */
struct eye {
    float x, y, diameter, bulge, turn_deg;
};

struct key_text {
    char name[SPECIES_NAME_SIZE];
    float length_m;
    float age_days; /* Below 0: not written; it follows from the length. */
    float gill;     /* Where the gill cover ends; 0: not written. */
    bool confluent; /* As the species says. */
    uint32_t station_count;
    struct station stations[STATION_MAX];
    struct eye eyes[2];          /* Right, left. */
    struct fin fins[PART_COUNT]; /* By part; of those without rays none is drawn. */
    struct finlets finlets[2];   /* Upper, lower. */
    struct species_coat coat;
};

/* What a curve may own besides parts: the body before and behind the gill cover. */
enum { PART_HEAD = PART_COUNT, PART_TRUNK, OWNED_COUNT };

/* A painted piece of the body: along x, and by height from belly 0 to back 1; `soft` at its rim. */
struct area {
    float from, to, low, high, soft;
};

/* A deformation graph and what it moves; the first is the whole fish's and moves all else. */
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
    bool confluent;                /* An eel's: dorsal and anal fin run into the tail's. */
    uint32_t without;              /* A bit for each enum species_part that it has not. */
    struct growth growth;
    uint32_t scale_knot_count;
    struct scale_knot scale_knots[GRAPH_KNOT_MAX];
    uint8_t thesis_key[3], thesis_template;
    uint32_t key_count;
    struct key_text keys[MORPH_KEY_MAX];
    uint32_t curve_count;
    struct curve_text curves[MORPH_CURVE_MAX];
};

/* One level of detail: how many rings and spokes the body has, rays and points along each fin. */
struct detail {
    uint32_t rings, spokes;
    bool round_end; /* A ring more rounds off the tail root. */
    uint32_t eye_rings, eye_spokes;
    struct { uint32_t across, along; } fins[PART_COUNT];
};

struct loft {
    uint32_t vertex_count, index_count, anchor_count;
    uint32_t grid_first, grid_rings, grid_spokes; /* As species_mesh says. */
    float reach;
    struct species_vertex vertices[MESH_VERTEX_MAX];
    vec3 positions[MORPH_KEY_MAX][MESH_VERTEX_MAX]; /* From the anchor, where a vertex has one. */
    vec3 normals[MORPH_KEY_MAX][MESH_VERTEX_MAX];
    struct species_anchor anchors[ANCHOR_MAX];
    uint16_t indices[MESH_INDEX_MAX];
};

/* Near, then far. */
extern const struct detail species_detail[SPECIES_LOD_COUNT];

/* Reads a whole species file. On bad input writes one line 'PATH:LINE: what' to `complaints` and
 * answers false; `species` is then half filled and of no use. */
bool species_read(FILE *file, const char *path, FILE *complaints, struct species_text *species);

/* Makes every key's shape on one topology, scaled so that the species' measure is 1. */
void species_loft(const struct species_text *species, const struct detail *detail,
                  struct loft *loft);

/* The card and the coats of what was read. */
void species_compile(const struct species_text *species, struct species *out);

/* The tables of one level of detail. */
struct mesh_tables {
    struct species_vertex vertices[MESH_VERTEX_MAX];
    struct species_point points[MORPH_KEY_MAX][MESH_VERTEX_MAX];
    struct species_anchor anchors[ANCHOR_MAX];
    uint16_t indices[MESH_INDEX_MAX];
};

/* Rounds a loft into the counts of species_point; `mesh` then points into `tables`. */
void species_pack(const struct loft *loft, uint32_t key_count, struct mesh_tables *tables,
                  struct species_mesh *mesh);

#endif
