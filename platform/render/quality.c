/* quality.c -- implementation of quality.h. The cost of a frame is estimated from its number of
 * pixels only, because the vertices of 300 fish cost little time. */
#include "platform/render/quality.h"

#include <string.h>

#include "core/base/fmath.h"

/* Kind of graphics hardware, and the amount of drawing that it can do in a frame. */
struct machine {
    bool software;
    float pixels;      /* Maximum number of scene pixels in a frame, regardless of the screen
                          size. */
    float floor_scale; /* Resolution of the floor and the walls, which have no fine detail, as a
                          fraction of the scene's resolution. */
    uint32_t samples;
    float lod_near_px; /* Fish length in pixels from which the near mesh is used. In a shorter fish,
                          the triangles of the near mesh would cover only a few pixels each. */
};

#define SCALE_MIN 0.4f

/* Two CPU cores of a single-board computer draw 1280x720 scene pixels in a fiftieth of a second. */
static const struct machine cpu = { true, 1280.0f * 720.0f, 0.6f, 1, 130.0f };
/* The GPU of a single-board computer shares its memory with the CPU. On a V3D GPU, writing and
 * resolving 4 samples of a full screen takes most of the memory bandwidth of a frame. Instead of
 * multisampling, the shaders blend the outlines, as they do on a CPU. */
static const struct machine board = { false, 1600.0f * 900.0f, 0.75f, 1, 60.0f };
static const struct machine desktop = { false, 3840.0f * 2160.0f, 1.0f, 4, 24.0f };

/* Parts of the GL_RENDERER string. The first entry that the string contains is used. A string that
 * contains no entry counts as a desktop GPU. */
static const struct {
    const char *name;
    const struct machine *machine;
} known[] = {
    { "llvmpipe", &cpu },   { "softpipe", &cpu }, { "SwiftShader", &cpu }, { "Software", &cpu },
    { "V3D", &board },      { "VC4", &board },    { "VideoCore", &board }, { "Mali", &board },
    { "Panfrost", &board }, { "Lima", &board },
};

static const struct machine *machine_of(const char *renderer)
{
    for (size_t i = 0; i < sizeof known / sizeof *known; i++) {
        if (strstr(renderer, known[i].name)) {
            return known[i].machine;
        }
    }
    return &desktop;
}

/* Returns the automatic scene scale for a screen of `width` x `height` pixels. */
static float scale_for(const struct machine *machine, uint32_t width, uint32_t height)
{
    const float share = machine->pixels / ((float)width * (float)height);
    return f_clamp(f_sqrt(share), SCALE_MIN, 1.0f);
}

/* Limits the sizes of the render targets to the largest texture size of the driver. If the screen
 * is larger than this limit, the scene is drawn at the limit, and the screen is drawn without
 * multisampling. */
static void fit_textures(struct quality *quality, const struct quality_wish *wish)
{
    const uint32_t side = wish->width > wish->height ? wish->width : wish->height;
    const float scale_max = (float)wish->side_max / (float)side;
    quality->scene_scale = f_min(quality->scene_scale, scale_max);
    quality->floor_scale = f_min(quality->floor_scale, scale_max);
    if (side > wish->side_max) {
        quality->samples = 1;
    }
}

struct quality quality_choose(const struct quality_wish *wish)
{
    const struct machine *const machine = machine_of(wish->renderer);
    struct quality quality = {
        .software = machine->software,
        .scene_scale = scale_for(machine, wish->width, wish->height),
        .samples = machine->samples,
        .lod_near_px = machine->lod_near_px,
    };
    if (wish->scene_scale > 0.0f) {
        quality.scene_scale = f_clamp(wish->scene_scale, 0.25f, 2.0f);
    }
    quality.floor_scale = quality.scene_scale * machine->floor_scale;
    if (wish->samples > 0) {
        quality.samples = wish->samples;
    }
    if (quality.samples > wish->samples_max) {
        quality.samples = wish->samples_max ? wish->samples_max : 1u;
    }
    fit_textures(&quality, wish);
    return quality;
}

struct quality quality_lower(const struct quality *best, uint32_t step)
{
    static const float share[QUALITY_STEP_MAX + 1u] = { 1.0f, 0.85f, 0.70f, 0.55f, 0.42f };
    struct quality quality = *best;
    const float of_best = share[step < QUALITY_STEP_MAX ? step : QUALITY_STEP_MAX];
    if (step > 0) {
        quality.samples = 1; /* Multisampling is removed first because it costs the most time and
                                its absence is the least visible. */
        quality.scene_scale = f_max(of_best * best->scene_scale, 0.25f);
        quality.floor_scale = f_max(of_best * best->floor_scale, 0.2f);
        quality.lod_near_px = best->lod_near_px / of_best;
    }
    return quality;
}
