/* quality.h -- how much work a frame may be, chosen once from what draws it. */
#ifndef KINGYO_PLATFORM_RENDER_QUALITY_H
#define KINGYO_PLATFORM_RENDER_QUALITY_H

#include <stdbool.h>
#include <stdint.h>

struct quality {
    bool software;     /* The renderer is a CPU: llvmpipe, softpipe, SwiftShader. */
    float scene_scale; /* Pixels of what swims, per screen pixel and axis; (0, 2]. */
    float floor_scale; /* The same for floor and walls, which are soft anyway. */
    uint32_t samples;  /* Multisamples of scene and screen; 1 is none. */
    float lod_near_px; /* Fish at least this long on their target get the near mesh. */
};

struct quality_wish {
    const char *renderer;   /* What GL_RENDERER says. */
    uint32_t width, height; /* Of the screen, in pixels, > 0. */
    float scene_scale;      /* 0: automatic; else taken, clamped to [0.25, 2]. */
    uint32_t samples;       /* 0: automatic; else taken, up to ... */
    uint32_t samples_max;   /* ... what the context offers. */
    uint32_t side_max;      /* Pixels a side of what it draws on, beside the screen; > 0. */
};

struct quality quality_choose(const struct quality_wish *wish);

#define QUALITY_STEP_MAX 4u /* Then the scene has a sixth of its pixels: less is no picture. */

/* `step` steps less than `best`, up to QUALITY_STEP_MAX; 0 is `best`. Words stay as sharp. */
struct quality quality_lower(const struct quality *best, uint32_t step);

#endif
