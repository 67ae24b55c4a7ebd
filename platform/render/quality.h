/* quality.h -- the amount of drawing work in a frame, chosen once from the graphics hardware. */
#ifndef KINGYO_PLATFORM_RENDER_QUALITY_H
#define KINGYO_PLATFORM_RENDER_QUALITY_H

#include <stdbool.h>
#include <stdint.h>

struct quality {
    bool software;     /* The renderer is a CPU: llvmpipe, softpipe, SwiftShader. */
    float scene_scale; /* Pixels of the underwater scene per screen pixel and axis, (0, 2]. */
    float floor_scale; /* Same as scene_scale, for floor and walls, which have no fine detail. */
    uint32_t samples;  /* Multisamples of scene and screen; 1 is none. */
    float lod_near_px; /* Fish at least this long on their target get the near mesh. */
};

struct quality_wish {
    const char *renderer;   /* GL_RENDERER string. */
    uint32_t width, height; /* Screen size in pixels, > 0. */
    float scene_scale;      /* Requested scale, clamped to [0.25, 2]; 0: automatic. */
    uint32_t samples;       /* Requested samples, limited to samples_max; 0: automatic. */
    uint32_t samples_max;   /* Largest number of samples of the context. */
    uint32_t side_max;      /* Largest side in pixels of a render target, apart from the screen; >
                               0. */
};

struct quality quality_choose(const struct quality_wish *wish);

/* Number of steps. The last one draws the scene with a sixth of its pixels, which is the least
 * usable picture. */
#define QUALITY_STEP_MAX 4u

/* Returns a quality `step` steps lower than `best`, up to QUALITY_STEP_MAX; 0 is `best`. The
 * sharpness of text does not change. */
struct quality quality_lower(const struct quality *best, uint32_t step);

#endif
