/* poi_pass.h -- draws the pois (paper scoops): the ring, the handle, and the paper with the wet
 * cells and holes that the simulation computes. Also computes the place and the level of the water
 * that a poi carries. */
#pragma once

#include "core/scene.h"
#include "platform/render/shape.h"
#include "platform/render/textures.h"

/* Maximum thickness in metres of the water film on the poi's paper. Further water collects in a
 * pool. */
#define POI_FILM_M 0.0006f
/* Time in ticks in which a hole of the paper opens in the picture, from a slit to its full size. */
#define POI_OPEN_TICKS (CORE_TICK_HZ / 4u)
/* Level in metres of the water pool of a poi without a pool. This level is far below all
 * objects. */
#define POI_NO_POOL_M -1e3f

struct poi_pool {
    float level_m; /* World height of the pool's surface in metres. POI_NO_POOL_M means no pool. */
    float film_m;  /* Thickness of the water film on the paper in metres, at most POI_FILM_M. */
};

/* Returns the pool of water that a poi carries. The pool's surface is horizontal in every pose of
 * the poi. The water lies in the sagging paper or against the low side of the ring. If the poi is
 * upside down, the water lies inside the ring. The pool and the film on the paper together contain
 * the water of poi->water_m, a mean depth over the paper. */
struct poi_pool poi_pool_of(const struct scene_poi *poi);

/* Variants of the program for the paper, whose names are combined with the operator |. */
enum paper_variant {
    PAPER_POOL = 1,     /* The poi carries a pool of water. */
    PAPER_PRACTICE = 2, /* The colour of the paper shows its stress. */
    PAPER_VARIANTS = 4,
};

struct paper_program {
    GLuint name;
    GLint pose, paper, rests, spines, pool;
};

struct poi_pass {
    GLuint frame_program, cap_program;
    GLint frame_pose, frame_paint, cap_pose;
    struct paper_program papers[PAPER_VARIANTS]; /* Indexed by enum paper_variant. */
    struct shape_buffers solid, disc;
    /* Ring buffer of array textures of the paper sheets, with one layer for each player. */
    struct gl_ring sheet_ring;
    uint8_t cells[SHEET_SIDE * SHEET_SIDE][4];      /* Buffer of poi_sheet_cells(). */
    uint8_t ages[POI_MAX][SHEET_SIDE * SHEET_SIDE]; /* As in poi_sheet_age(). */
    uint32_t tick; /* Tick of the scene at the latest call of poi_pass_prepare(). */
};

/* Writes the pose of a poi or of another object to `out` as a column-major matrix. `scale` (> 0) is
 * the length in metres of one unit along each axis of the object. */
void poi_pose(float out[16], vec3 position_m, struct angles angles, float scale);
/* Writes the pose of an object with the axes `axes` to `out`, as poi_pose() does. */
void poi_pose_of_axes(float out[16], vec3 position_m, const struct basis *axes, float scale);

/* Returns the colour of player `owner` (red, green, blue). The fourth value is the number of white
 * marks on the poi, which distinguish the players without colour. `owner` must be below POI_MAX. */
const float *poi_paint(uint8_t owner);

void poi_pass_open(struct gl_status *status, struct poi_pass *pass);
void poi_pass_close(struct poi_pass *pass);

/* Adds `ticks` to the age of each hole cell of a poi's paper. The largest age is POI_OPEN_TICKS.
 * The age of a cell with paper becomes 0. */
void poi_sheet_age(const struct scene_poi *poi, uint32_t ticks,
                   uint8_t ages[SHEET_SIDE * SHEET_SIDE]);
/* Computes the texels of a poi's paper. The four values of each cell are the wetness, the
 * integrity, the presence and, in practice mode, the stress. In a hole, the presence falls from 255
 * at the edge over 128 at the end of a flap to 0, and the last value is the distance from the edge
 * in 1/32 cells. A hole opens with the ages of its cells (poi_sheet_age()). */
void poi_sheet_cells(const struct scene_poi *poi, const uint8_t ages[SHEET_SIDE * SHEET_SIDE],
                     uint8_t cells[SHEET_SIDE * SHEET_SIDE][4]);
/* Uploads the cells of each poi's paper (poi_sheet_cells()) to the textures. */
void poi_pass_prepare(struct poi_pass *pass, const struct scene *scene);

/* Returns true if any part of the poi is below the water surface. */
bool poi_is_below(const struct scene_poi *poi);
/* Returns true if any part of the poi is above the water surface. */
bool poi_is_above(const struct scene_poi *poi);

/* Returns the largest horizontal distance in metres from the centre of the poi at which
 * poi_refraction_share() is below 1. */
float poi_calm_reach_m(const struct scene_poi *poi);
/* Returns the share, from 0 to 1, of the refraction that the water surface has at a point. `axes`
 * are the axes of poi->angles. The picture of all objects in the water is shifted as if they lay on
 * the floor. The share is therefore 0 where the paper and the ring cross the surface, so that the
 * part of the poi in the water joins the part in the air without a gap. */
float poi_refraction_share(const struct scene_poi *poi, const struct basis *axes, float x_m,
                           float z_m);

/* Draws the ring and the handle of one poi into a render target with a depth buffer. */
void poi_pass_frame(const struct poi_pass *pass, const struct scene_poi *poi);
/* Draws the paper of poi number `index` of the scene with blending, into a render target with a
 * depth buffer. The paper is darker where fish lie on it. If `is_below` is true, draws only the
 * part below the water surface. */
void poi_pass_paper(const struct poi_pass *pass, const struct scene *scene, uint32_t index,
                    const struct textures *textures, bool is_below);

/* Writes depth over the paper and the ring of each poi of the scene, so that nothing drawn later
 * covers them. */
void poi_pass_cap(const struct poi_pass *pass, const struct scene *scene);
