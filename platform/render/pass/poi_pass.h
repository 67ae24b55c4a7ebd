/* poi_pass.h -- draws the pois (paper scoops): the ring, the handle, and the paper with the wet
 * cells and holes that the simulation computes. */
#ifndef KINGYO_PLATFORM_RENDER_PASS_POI_PASS_H
#define KINGYO_PLATFORM_RENDER_PASS_POI_PASS_H

#include "core/scene.h"
#include "platform/render/frame_block.h"
#include "platform/render/shape.h"
#include "platform/render/textures.h"

struct poi_pass {
    GLuint frame_program, paper_program;
    GLint frame_pose, frame_paint, paper_pose, paper_paper, paper_rests, paper_spines, paper_pool;
    struct shape_buffers solid, disc;
    struct gl_ring sheet_ring;                 /* Ring buffer of array textures of the paper sheets,
                                                  with one layer for each player. */
    uint8_t cells[SHEET_SIDE * SHEET_SIDE][4]; /* Buffer of one paper sheet: wetness, integrity,
                                                  presence and stress of each cell. */
};

/* Returns the colour of player `owner` (red, green, blue). The fourth value is the number of white
 * marks on the poi, which distinguish the players without colour. `owner` must be below POI_MAX. */
const float *poi_paint(uint8_t owner);

void poi_pass_open(struct gl_status *status, struct poi_pass *pass);
void poi_pass_close(struct poi_pass *pass);

/* Uploads the paper sheet of each poi. */
void poi_pass_prepare(struct poi_pass *pass, const struct scene *scene);

/* Returns true if any part of the poi may be below the water surface. */
bool poi_is_below(const struct scene_poi *poi);
/* Returns true if any part of the poi may be above the water surface. */
bool poi_is_above(const struct scene_poi *poi);

/* Draws the ring and the handle of one poi into a render target with depth. */
void poi_pass_frame(const struct poi_pass *pass, const struct scene_poi *poi);
/* Draws the paper of poi number `index` of the scene with blending, into a render target with
 * depth. The paper is darker where fish lie on it. */
void poi_pass_paper(const struct poi_pass *pass, const struct scene *scene, uint32_t index,
                    const struct textures *textures);

#endif
