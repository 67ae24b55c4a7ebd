/* quality.c -- see quality.h. Costs are of pixels, not of vertices: those of 300 fish are cheap. */
#include "platform/render/quality.h"

#include <string.h>

#include "core/base/fmath.h"

/* What two cores of a small board draw in a fiftieth of a second, more or less: the scene keeps
 * every pixel up to 720p and no more pixels than that on larger screens. */
#define SOFTWARE_PIXELS (1280.0f * 720.0f)
#define SOFTWARE_SCALE_MIN 0.4f
#define SOFTWARE_FLOOR_SCALE 0.6f /* Of the scene's: floor and walls are soft anyway. */
#define GPU_SAMPLES 4u

/* A near mesh pays off only where its triangles are several pixels each. */
#define SOFTWARE_LOD_NEAR_PX 130.0f
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

/* The automatic scale for a screen of that many pixels. */
static float software_scale(uint32_t width, uint32_t height)
{
    const float share = SOFTWARE_PIXELS / ((float)width * (float)height);
    return f_clamp(f_sqrt(share), SOFTWARE_SCALE_MIN, 1.0f);
}

struct quality quality_choose(const struct quality_wish *wish)
{
    const bool software = is_software(wish->renderer);
    struct quality quality = {
        .software = software,
        .scene_scale = software ? software_scale(wish->width, wish->height) : 1.0f,
        .samples = software ? 1u : GPU_SAMPLES,
        .lod_near_px = software ? SOFTWARE_LOD_NEAR_PX : GPU_LOD_NEAR_PX,
    };
    if (wish->scene_scale > 0.0f) {
        quality.scene_scale = f_clamp(wish->scene_scale, 0.25f, 2.0f);
    }
    quality.floor_scale = quality.scene_scale * (software ? SOFTWARE_FLOOR_SCALE : 1.0f);
    if (wish->samples > 0) {
        quality.samples = wish->samples;
    }
    if (quality.samples > wish->samples_max) {
        quality.samples = wish->samples_max ? wish->samples_max : 1u;
    }
    return quality;
}
