/* quality.h -- the amount of drawing work in a frame. The initial amount is chosen once from the
 * graphics hardware. */
#ifndef KINGYO_PLATFORM_RENDER_QUALITY_H
#define KINGYO_PLATFORM_RENDER_QUALITY_H

#include <stdbool.h>
#include <stdint.h>

struct quality {
    bool software;     /* True if a CPU renders the picture (llvmpipe, softpipe, SwiftShader). */
    float scene_scale; /* Pixels of the underwater scene per screen pixel and axis, (0, 2]. */
    float floor_scale; /* Same as scene_scale, for the floor and the walls, which have no fine
                          detail. */
    uint32_t samples;  /* Multisampling samples of the scene and the screen. 1 means no
                          multisampling. */
    float lod_near_px; /* Minimum length in pixels of a fish that is drawn with the near mesh.
                          Pixels are those of the render target. */
};

struct quality_wish {
    const char *renderer;   /* Name of the graphics hardware (GL_RENDERER). */
    uint32_t width, height; /* Screen size in pixels, > 0. */
    float scene_scale;      /* Requested scene scale, clamped to [0.25, 2]. 0 means automatic. */
    uint32_t samples;       /* Requested samples, limited to samples_max. 0 means automatic. */
    uint32_t samples_max;   /* Maximum number of samples that the OpenGL context supports. */
    uint32_t side_max;      /* Maximum side in pixels of a render target other than the screen, >
                               0. */
};

/* Returns the best quality for the hardware and the screen size, within the requested values. */
struct quality quality_choose(const struct quality_wish *wish);

/* Number of steps below the best quality. The last step draws the scene with a sixth of its pixels,
 * which is the least usable picture. */
#define QUALITY_STEP_MAX 4u

/* Returns the quality that is `step` steps below `best`. Steps above QUALITY_STEP_MAX count as
 * QUALITY_STEP_MAX, and 0 returns `best`. The sharpness of text does not change. */
struct quality quality_lower(const struct quality *best, uint32_t step);

#endif
