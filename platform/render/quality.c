/* quality.c -- implementation of quality.h: the choice of the quality, and the governor. The cost
 * of a frame is estimated from its number of pixels only, because the vertices of 300 fish cost
 * little time. */
#include "platform/render/quality.h"

#include <string.h>

#include "core/base/fmath.h"
#include "core/base/panic.h"

/* A kind of graphics hardware, with the amount of drawing that this hardware can do in a frame. */
struct machine {
    bool software;
    float pixels;       /* Maximum number of scene pixels in a frame, regardless of the screen
                          size. */
    float floor_scale;  /* Resolution of the floor and the walls, which have no fine detail, as a
                          fraction of the scene's resolution. */
    float mirror_scale; /* Resolution of the reflections on the water surface, likewise. */
    uint32_t samples;
    float lod_near_px; /* Minimum fish length in pixels from which the near mesh is used. In a
                          shorter fish, the triangles of the near mesh would cover only a few pixels
                          each. */
};

#define SCALE_MIN 0.4f

/* Limits for rendering on a CPU. Two CPU cores of a single-board computer draw 1280x720 scene
 * pixels in 20 ms. */
static const struct machine cpu = { true, 1280.0f * 720.0f, 0.6f, 0.5f, 1, 130.0f };
/* Limits for the GPU of a single-board computer, which shares its memory with the CPU. On a V3D
 * GPU, writing and resolving 4 samples of a full screen takes most of the memory bandwidth of a
 * frame. Instead of multisampling, the shaders blend the outlines, as they do on a CPU. */
static const struct machine board = { false, 1600.0f * 900.0f, 0.5f, 0.4f, 1, 120.0f };
static const struct machine desktop = { false, 3840.0f * 2160.0f, 1.0f, 1.0f, 4, 24.0f };

/* Table of parts of the GL_RENDERER string. The first entry that occurs in the string is used. If
 * no entry occurs in the string, the hardware counts as a desktop GPU. */
static const struct {
    const char *name;
    const struct machine *machine;
} known[] = {
    { "llvmpipe", &cpu },   { "softpipe", &cpu }, { "SwiftShader", &cpu }, { "Software", &cpu },
    { "V3D", &board },      { "VC4", &board },    { "VideoCore", &board }, { "Mali", &board },
    { "Panfrost", &board }, { "Lima", &board },
};

struct quality quality_choose(const struct quality_request *request)
{
    CORE_ASSERT(request->width > 0 && request->height > 0 && request->side_max > 0);
    const struct machine *machine = NULL;
    for (size_t i = 0; i < sizeof known / sizeof *known && !machine; i++) {
        machine = strstr(request->renderer, known[i].name) ? known[i].machine : NULL;
    }
    machine = machine ? machine : &desktop;
    const float share = machine->pixels / ((float)request->width * (float)request->height);
    struct quality quality = {
        .software = machine->software,
        .scene_scale = f_clamp(f_sqrt(share), SCALE_MIN, 1.0f),
        .samples = machine->samples,
        .lod_near_px = machine->lod_near_px,
    };
    if (request->scene_scale > 0.0f) {
        quality.scene_scale = f_clamp(request->scene_scale, 0.25f, 2.0f);
    }
    quality.floor_scale = quality.scene_scale * machine->floor_scale;
    quality.mirror_scale = quality.scene_scale * machine->mirror_scale;
    if (request->samples > 0) {
        quality.samples = request->samples;
    }
    if (quality.samples > request->samples_max) {
        quality.samples = request->samples_max ? request->samples_max : 1u;
    }
    /* No render target may be larger than the driver's largest texture size. If the screen is
     * larger, the scene is drawn at the largest texture size, and the screen is drawn without
     * multisampling. */
    const uint32_t side = request->width > request->height ? request->width : request->height;
    const float scale_max = (float)request->side_max / (float)side;
    quality.scene_scale = f_min(quality.scene_scale, scale_max);
    quality.floor_scale = f_min(quality.floor_scale, scale_max);
    quality.mirror_scale = f_min(quality.mirror_scale, scale_max);
    if (side > request->side_max) {
        quality.samples = 1;
    }
    CORE_ASSERT(quality.scene_scale > 0.0f && quality.samples >= 1u);
    return quality;
}

struct quality quality_lower(const struct quality *best, uint32_t step)
{
    static const float share[QUALITY_STEP_MAX + 1u] = { 1.0f, 0.85f, 0.70f, 0.55f, 0.42f };
    struct quality quality = *best;
    const float of_best = share[step < QUALITY_STEP_MAX ? step : QUALITY_STEP_MAX];
    if (step > 0) {
        /* Every step switches multisampling off, because multisampling costs much time and its
         * absence is hardly visible. */
        quality.samples = 1;
        quality.scene_scale = f_max(of_best * best->scene_scale, 0.25f);
        quality.floor_scale = f_max(of_best * best->floor_scale, 0.2f);
        quality.mirror_scale = f_max(of_best * best->mirror_scale, 0.2f);
        quality.lod_near_px = best->lod_near_px / of_best;
    }
    return quality;
}

#define NS_PER_S 1000000000ull
#define STALL_NS (NS_PER_S / 4u)
/* Number of consecutive stalls (very long frames) from which slow drawing is assumed to be the
 * cause. Fewer stalls are assumed to have another cause. */
#define STALLS 3u
#define HZ 60u
/* Maximum mean frame duration that counts as on time, in per cent of a refresh period. At this
 * maximum, one frame in nine is late by one refresh period. */
#define LATE_PERCENT 111u
/* Number of seconds without late frames after which the trial of a finer quality step counts as
 * successful. */
#define HELD_S 60u

void quality_governor_begin(struct governor *governor, uint32_t refresh_hz)
{
    CORE_ASSERT(governor);
    const uint32_t hz = refresh_hz == 0 || refresh_hz > HZ ? HZ : refresh_hz;
    *governor = (struct governor){ .turn_ns = NS_PER_S / hz, .patience_s = GOVERNOR_PATIENCE_S };
}

uint32_t quality_governor_frame(struct governor *governor, uint64_t now_ns, bool may_refine)
{
    const uint64_t frame_ns = now_ns - governor->last_ns;
    governor->stalls = frame_ns < STALL_NS ? 0 : governor->stalls + 1u;
    const bool is_drawing = governor->stalls == 0 || governor->stalls >= STALLS;
    const bool counts = governor->last_ns > 0 && is_drawing;
    governor->last_ns = now_ns;
    if (counts) {
        governor->sum_ns += frame_ns;
        governor->count++;
    }
    if (governor->sum_ns >= GOVERNOR_LOOK_S * NS_PER_S) {
        const uint64_t mean_ns = governor->sum_ns / governor->count;
        governor->sum_ns = governor->count = 0;
        if (mean_ns * 100u > governor->turn_ns * LATE_PERCENT) {
            if (governor->is_trying && governor->patience_s < GOVERNOR_PATIENCE_MAX_S) {
                governor->patience_s *= 2u;
            }
            governor->is_trying = false;
            governor->timely_s = 0;
            if (governor->step < QUALITY_STEP_MAX) {
                governor->step++;
            }
        } else {
            governor->timely_s += GOVERNOR_LOOK_S;
            if (governor->is_trying && governor->timely_s >= HELD_S) {
                governor->is_trying = false;
                governor->patience_s = GOVERNOR_PATIENCE_S;
            }
            if (governor->step > 0 && governor->timely_s >= governor->patience_s && may_refine) {
                governor->step--;
                governor->is_trying = true;
                governor->timely_s = 0;
            }
        }
    }
    CORE_ASSERT(governor->step <= QUALITY_STEP_MAX && governor->heat <= QUALITY_STEP_MAX);
    return governor->step > governor->heat ? governor->step : governor->heat;
}

void quality_governor_set_temperature(struct governor *governor, int32_t margin_mdeg)
{
    if (margin_mdeg < GOVERNOR_HOT_MDEG && governor->heat < QUALITY_STEP_MAX) {
        governor->heat++;
    } else if (margin_mdeg > GOVERNOR_COOL_MDEG && governor->heat > 0) {
        governor->heat--;
    }
}
