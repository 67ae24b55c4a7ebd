/* drawing.h -- the parsed content of a species text, and the meshes that are built from this
 * content. A maker (a user who draws a species) writes the species text. Building a mesh from cross
 * sections is called lofting.
 *
 * `kingyoctl morph` and the program that generates the built-in species at build time use this
 * header. The kiosk reads only their output. A key is one modelled growth stage of the species,
 * with its own drawing. All lengths of a drawing are fractions of the distance from the snout to
 * the tail root. The x axis points from the snout backward, and the y axis from the body's axis
 * upward. assets/species/README.md explains every keyword to makers. */
#pragma once

#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>

#include "core/morph/species.h"

/* Maximum number of drawn cross sections of the body in one key (modelled growth stage). Real fish
 * need fewer. */
#define STATION_MAX 24
/* Maximum number of drawn rays of a fin. */
#define RAY_MAX 12
/* Maximum number of finlets (small fins behind the dorsal or anal fin) in a row. A bigeye tuna has
 * eight to ten finlets in each of its two rows. */
#define FINLET_MAX 10
/* Maximum number of painted areas (struct area) that one deformation curve moves. */
#define AREA_MAX 4
/* Body coordinate u of the rear edge of the gill cover, the same in every key (modelled growth
 * stage). The edge's coordinate x in the drawings differs from key to key. */
#define GILL_U 0.30f

/* A cross section of the body at position `x`. The outline of the cross section is a superellipse
 * with height `depth`, width `width` and exponent `exponent`. The centre of the outline is `offset`
 * above the body's axis. */
struct station {
    float x, depth, width, offset, exponent;
};

/* One fin ray. `at` is the position of the ray along the fin's base, [0, 1]. `length` is a fraction
 * of the distance from the snout to the tail root. `sweep_deg` and `side_deg` are the ray's angles.
 * Their zero directions depend on the fin: see fin_direction() in shape_fin.c. */
struct ray {
    float at, length, sweep_deg, side_deg;
};

struct fin {
    /* Coordinates x of the start and the end of the fin's base. For the tail fin, these are the
     * coordinates y of the lower and the upper end. */
    float start, end;
    /* Position of a paired fin on the cross section. 0 is the middle of the back, 0.25 the flank,
     * and 0.5 the middle of the belly. */
    float girth;
    /* Angle in degrees by which a ray is bent at its tip. The angle is added to the direction of
     * the ray. */
    float curl_deg;
    uint32_t ray_count;
    struct ray rays[RAY_MAX];
};

/* A row of finlets, which are small fins behind the dorsal or anal fin. Each finlet leans backward
 * by `sweep_deg` degrees from the upright position. */
struct finlets {
    float start, end, length, sweep_deg;
    uint32_t count; /* Number of finlets, 0 to FINLET_MAX. */
};

/* An eye. `bulge` is how far the eye protrudes from the skin, as a fraction of the eye's diameter.
 * `turn_deg` is the angle in degrees by which the eye has migrated over the back, as in a flatfish:
 * an eye with 0 is on its original side at height `y`, an eye with 90 is on the middle of the back,
 * and an eye with 180 is on the opposite side at height `y`. */
struct eye {
    float x, y, diameter, bulge, turn_deg;
};

struct key_text {
    /* Position x of the rear edge of the gill cover. 0 means that the species text has no `gill`
     * line. */
    float gill;
    /* Copies of the fields `confluent` and `double_tail` of struct species_text. */
    bool confluent, double_tail;
    uint32_t substep_count;
    struct station stations[STATION_MAX];
    struct eye eyes[2]; /* Right eye, then left eye. */
    /* Fins, indexed by enum species_part. A fin without rays does not exist. */
    struct fin fins[PART_COUNT];
    /* Rows of finlets: element 0 is the upper row, and element 1 is the lower row. */
    struct finlets finlets[2];
    struct species_coat coat;
};

/* Body parts, in addition to those of enum species_part, that a deformation curve may move. The
 * head is in front of the gill cover's rear edge, and the trunk is behind this edge. */
enum { PART_HEAD = PART_COUNT, PART_TRUNK, OWNED_COUNT };

/* A painted area of the body. `from` and `to` limit the area along x, and `low` and `high` limit
 * its height (0 is the belly, 1 is the back). `soft` is the width of the transition at the area's
 * edge. */
struct area {
    float from, to, low, high, soft;
};

/* The parts of the fish that one deformation graph moves. A deformation graph gives the weight of
 * each key over the fish's life. The first graph of a species moves all parts that no other graph
 * moves. */
struct curve_text {
    /* Set of the parts that the graph moves. Each enum species_part, PART_HEAD and PART_TRUNK has
     * one bit. */
    uint32_t parts;
    uint32_t area_count;
    struct area areas[AREA_MAX];
};

struct species_text {
    /* Card of the species, with the names of its keys and its graphs. While the species text is
     * parsed, a key with a negative age has no age in the text. Its age is later computed from its
     * length. */
    struct species_card card;
    /* True if the dorsal fin, the tail fin and the anal fin form one continuous fin, as in an
     * eel. */
    bool confluent;
    /* True if the tail fin is double, as in a ryukin. The rays of the text are those of its right
     * half, from the fold on the midline to the lower edge. */
    bool double_tail;
    /* Set of the parts that the species lacks in every key. Each enum species_part has one bit. */
    uint32_t without;
    struct key_text keys[MORPH_KEY_MAX]; /* Drawing of each key (modelled growth stage). */
    /* The parts of the fish that each graph of the card moves. */
    struct curve_text curves[MORPH_CURVE_MAX];
};

/* Numbers of vertices in a mesh of one level of detail. The body and the eyes consist of rings
 * (cross sections). The spokes are the vertices of one ring. A fin consists of rays and of points
 * along each ray. */
struct detail {
    uint32_t rings, spokes;
    /* True if the rear end of the body is rounded by an additional ring at the tail root. */
    bool round_end;
    uint32_t eye_rings, eye_spokes;
    struct {
        uint32_t across, along;
    } fins[PART_COUNT];
};

struct loft {
    uint32_t vertex_count, index_count, anchor_count;
    /* The vertices of the body form a grid: index of the grid's first vertex, number of rings, and
     * number of vertices per ring, as in struct species_mesh. */
    uint32_t grid_first, grid_rings, grid_spokes;
    float reach;
    struct species_vertex vertices[MESH_VERTEX_MAX];
    /* Position of each vertex in each key. If the vertex has an anchor, the position is relative to
     * the anchor. */
    vec3 positions[MORPH_KEY_MAX][MESH_VERTEX_MAX];
    vec3 normals[MORPH_KEY_MAX][MESH_VERTEX_MAX];
    struct species_anchor anchors[ANCHOR_MAX];
    uint16_t indices[MESH_INDEX_MAX];
};

/* Numbers of vertices of the near mesh (first element) and of the far mesh (second element). The
 * far mesh has fewer vertices and is drawn for distant fish. */
extern const struct detail species_detail[SPECIES_LOD_COUNT];

/* Reads a whole species file. Returns true if the text is valid. Otherwise writes one line
 * 'PATH:LINE: error' to `errors` and returns false. `species` is then incomplete and must not
 * be used. */
bool species_read(FILE *file, const char *path, FILE *errors, struct species_text *species);

/* Builds the meshes of all keys. Vertex numbers and triangles are the same in every key. Each mesh
 * is scaled so that its length is 1, measured as the species' length measure (enum species_measure)
 * defines. */
void species_loft(const struct species_text *species, const struct detail *detail,
                  struct loft *loft);

/* Storage for the tables of one level of detail. */
struct mesh_tables {
    struct species_vertex vertices[MESH_VERTEX_MAX];
    struct species_point points[MORPH_KEY_MAX][MESH_VERTEX_MAX];
    struct species_anchor anchors[ANCHOR_MAX];
    uint16_t indices[MESH_INDEX_MAX];
};

/* Quantizes the meshes of `loft` to the units of species_point and stores them in `tables`. `mesh`
 * then points to `tables`. */
void species_pack(const struct loft *loft, uint32_t key_count, struct mesh_tables *tables,
                  struct species_mesh *mesh);
