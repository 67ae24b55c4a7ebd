/* quality.h -- how much work a frame may be, chosen once from what draws it. */
#ifndef KINGYO_PLATFORM_RENDER_QUALITY_H
#define KINGYO_PLATFORM_RENDER_QUALITY_H

#include <stdbool.h>
#include <stdint.h>

struct quality {
    bool software;        /* The renderer is a CPU: llvmpipe, softpipe, SwiftShader. */
    float scene_scale;    /* Pixels of what swims, per screen pixel and axis; (0, 2]. */
    float floor_scale;    /* The same for floor and walls, which are soft anyway. */
    uint32_t samples;     /* Multisamples of scene and screen; 1 is none. */
    float lod_near_px;    /* Fish at least this long on their target get the near mesh. */
};

/* `renderer` is what GL_RENDERER says; `scene_scale` and `samples` of 0 mean automatic, anything
 * else is taken as it is (scale clamped to [0.25, 2], samples to `samples_max`). */
struct quality quality_choose(const char *renderer, float scene_scale, uint32_t samples,
                              uint32_t samples_max);

#endif
