/* quality.c -- see quality.h. Costs are of pixels, not of vertices: those of 300 fish are cheap. */
#include "platform/render/quality.h"

#include <string.h>

#include "core/base/fmath.h"

#define SOFTWARE_SCENE_SCALE 0.75f
#define SOFTWARE_FLOOR_SCALE 0.6f
#define GPU_SAMPLES 4u

/* On a CPU a near mesh pays off only where its triangles are a few pixels each. */
#define SOFTWARE_LOD_NEAR_PX 44.0f
#define GPU_LOD_NEAR_PX 24.0f

static bool is_software(const char *renderer)
{
    static const char *const names[] = { "llvmpipe", "softpipe", "SwiftShader", "Software" };
    for (size_t i = 0; i < sizeof names / sizeof *names; i++) {
        if (strstr(renderer, names[i])) {
            return true;
        }
    }
    return false;
}

struct quality quality_choose(const char *renderer, float scene_scale, uint32_t samples,
                              uint32_t samples_max)
{
    const bool software = is_software(renderer);
    struct quality quality = {
        .software = software,
        .scene_scale = software ? SOFTWARE_SCENE_SCALE : 1.0f,
        .floor_scale = software ? SOFTWARE_FLOOR_SCALE : 1.0f,
        .samples = software ? 1u : GPU_SAMPLES,
        .lod_near_px = software ? SOFTWARE_LOD_NEAR_PX : GPU_LOD_NEAR_PX,
    };
    if (scene_scale > 0.0f) {
        quality.scene_scale = f_clamp(scene_scale, 0.25f, 2.0f);
        quality.floor_scale = f_min(quality.scene_scale, 1.0f);
    }
    if (samples > 0) {
        quality.samples = samples;
    }
    if (quality.samples > samples_max) {
        quality.samples = samples_max ? samples_max : 1u;
    }
    return quality;
}
