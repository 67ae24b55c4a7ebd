/* quality.h -- chooses the drawing quality, which is the amount of drawing work in a frame. The
 * initial quality is chosen once from the graphics hardware. */
#ifndef KINGYO_PLATFORM_RENDER_QUALITY_H
#define KINGYO_PLATFORM_RENDER_QUALITY_H

#include <stdbool.h>
#include <stdint.h>

struct quality {
    bool software;     /* True if the picture is rendered by a CPU (llvmpipe, softpipe, SwiftShader)
                          and not by a GPU. */
    float scene_scale; /* Width of the underwater scene's picture in pixels, divided by the width of
                          the screen in pixels, (0, 2]. The same factor applies to the height. */
    float floor_scale; /* Width of the picture of the tank's floor and walls, divided by the width
                          of the screen, (0, 2]. The floor and the walls have no fine detail. */
    uint32_t samples;  /* Number of multisampling samples of the scene and the screen. 1 means no
                          multisampling. */
    float lod_near_px; /* Fish length from which the near mesh is drawn, in pixels of the render
                          target. Shorter fish are drawn with the far mesh. */
};

struct quality_wish {
    const char *renderer;   /* Name of the graphics hardware (GL_RENDERER). */
    uint32_t width, height; /* Screen size in pixels, > 0. */
    float scene_scale;      /* Requested value of quality.scene_scale, clamped to [0.25, 2]. 0 means
                               automatic. */
    uint32_t samples;       /* Requested number of multisampling samples, limited to samples_max. 0
                               means automatic. */
    uint32_t samples_max;   /* Maximum number of multisampling samples that the OpenGL context
                               supports. */
    uint32_t side_max;      /* Maximum side in pixels of a render target other than the screen, >
                               0. */
};

/* Returns the best quality for the hardware and the screen size, within the limits that `wish`
 * requests. */
struct quality quality_choose(const struct quality_wish *wish);

/* Number of quality steps below the best quality. The last step draws the scene with a sixth of its
 * pixels, which is the lowest usable resolution. */
#define QUALITY_STEP_MAX 4u

/* Returns the quality that is `step` steps below `best`. Steps above QUALITY_STEP_MAX count as
 * QUALITY_STEP_MAX, and step 0 returns `best`. Text stays equally sharp at every step. */
struct quality quality_lower(const struct quality *best, uint32_t step);

#endif
