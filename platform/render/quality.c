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
    float pixels;      /* Maximum number of scene pixels in a frame, regardless of the screen
                          size. */
    float floor_scale; /* Resolution of the floor and the walls, which have no fine detail, as a
                          fraction of the scene's resolution. */
    /* Resolution of the reflections on the water surface, as a fraction of the scene's
     * resolution. */
    float mirror_scale;
    uint32_t samples;
    float lod_near_px;  /* Minimum fish length in pixels from which the near mesh is used. In a
                          shorter fish, the triangles of the near mesh would cover only a few pixels
                          each. */
    float lod_small_px; /* Fish length in pixels below which the mesh for small fish is used. */
};

#define SCALE_MIN 0.4f

/* Limits for rendering on a CPU. Two CPU cores of a single-board computer draw 1280x720 scene
 * pixels in 20 ms. */
static const struct machine cpu = { true, 1280.0f * 720.0f, 0.6f, 0.5f, 1, 130.0f, 50.0f };
/* Limits for the GPU of a single-board computer, which shares its memory with the CPU. On a V3D
 * GPU, writing and resolving 4 samples of a full screen takes most of the memory bandwidth of a
 * frame. Instead of multisampling, the shaders blend the outlines, as they do on a CPU. */
static const struct machine board = { false, 1600.0f * 900.0f, 0.6f, 0.3f, 1, 120.0f, 50.0f };
/* Raspberry Pi 4: as `board`, with at most 1280x720 pixels above the water too. */
static const struct machine pi4 = { false, 1280.0f * 720.0f, 0.6f, 0.3f, 1, 120.0f, 50.0f };
/* Raspberry Pi 5, whose GPU is four times as fast. */
static const struct machine pi5 = { false, 1920.0f * 1080.0f, 0.6f, 0.4f, 1, 120.0f, 50.0f };
static const struct machine desktop = { false, 3840.0f * 2160.0f, 1.0f, 1.0f, 4, 24.0f, 0.0f };

/* Table of parts of the GL_RENDERER string. The first entry that occurs in the string is used. If
 * no entry occurs in the string, the hardware counts as a desktop GPU. */
static const struct {
    const char *name;
    const struct machine *machine;
} known[] = {
    { "llvmpipe", &cpu }, { "softpipe", &cpu },   { "SwiftShader", &cpu }, { "Software", &cpu },
    { "V3D 7", &pi5 },    { "V3D", &pi4 },        { "VC4", &pi4 },         { "VideoCore", &board },
    { "Mali", &board },   { "Panfrost", &board }, { "Lima", &board },
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
        .screen_scale = 1.0f,
        .samples = machine->samples,
        .lod_near_px = machine->lod_near_px,
        .lod_small_px = machine->lod_small_px,
    };
    if (machine == &pi4) {
        quality.screen_scale = quality.scene_scale;
    }
    if (request->scene_scale > 0.0f) {
        quality.screen_scale = f_clamp(request->scene_scale, 0.25f, 1.0f);
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
    quality.screen_scale = f_min(quality.screen_scale, scale_max);
    quality.floor_scale = f_min(quality.floor_scale, scale_max);
    quality.mirror_scale = f_min(quality.mirror_scale, scale_max);
    if (side > request->side_max) {
        quality.samples = 1;
    }
    CORE_ASSERT(quality.scene_scale > 0.0f && quality.samples >= 1u);
    return quality;
}

/* Fractions of the best quality at each step. The change that a viewer notices least comes first.
 * The order is: the meshes of distant fish, the floor, the reflections, the screen without its
 * words, the fish. */
static const struct share {
    float lod, floor, mirror, screen, scene;
} shares[QUALITY_STEP_MAX + 1u] = {
    { 1.0f, 1.0f, 1.0f, 1.0f, 1.0f },   { 0.6f, 1.0f, 1.0f, 1.0f, 1.0f },
    { 0.6f, 0.7f, 1.0f, 1.0f, 1.0f },   { 0.6f, 0.7f, 0.6f, 1.0f, 1.0f },
    { 0.6f, 0.7f, 0.6f, 0.8f, 1.0f },   { 0.6f, 0.7f, 0.6f, 0.65f, 1.0f },
    { 0.6f, 0.7f, 0.6f, 0.65f, 0.75f }, { 0.6f, 0.7f, 0.6f, 0.65f, 0.55f },
};

struct quality quality_lower(const struct quality *best, uint32_t step)
{
    struct quality quality = *best;
    const struct share *const share = &shares[step < QUALITY_STEP_MAX ? step : QUALITY_STEP_MAX];
    if (step > 0) {
        quality.samples = 1; /* Multisampling is switched off first, because
                                multisampling costs the most time and its absence is the least
                                visible. */
        quality.lod_near_px = best->lod_near_px / share->lod;
        quality.lod_small_px = best->lod_small_px / share->lod;
        quality.floor_scale = f_max(share->floor * best->floor_scale, 0.2f);
        quality.mirror_scale = f_max(share->mirror * best->mirror_scale, 0.15f);
        quality.screen_scale = f_max(share->screen * best->screen_scale, SCALE_MIN);
        quality.scene_scale = f_max(share->scene * best->scene_scale, 0.25f);
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
/* Maximum mean frame duration from which a finer quality may be tried, in per cent of the intended
 * duration. Between this value and LATE_PERCENT the quality stays as it is, because a finer quality
 * would be late. */
#define REFINE_PERCENT 103u
/* Mean frame duration, in per cent of the intended duration, from which quality is lowered by two
 * steps at once. */
#define FAR_PERCENT 150u
/* Number of seconds without late frames after which the trial of a finer quality step counts as
 * successful. */
#define HELD_S 60u

void quality_governor_begin(struct governor *governor, uint32_t refresh_hz)
{
    CORE_ASSERT(governor);
    const uint32_t hz = refresh_hz == 0 || refresh_hz > HZ ? HZ : refresh_hz;
    *governor = (struct governor){ .turn_ns = NS_PER_S / hz,
                                   .turns = 1,
                                   .patience_s = GOVERNOR_PATIENCE_S };
}

/* Lowers the quality after late frames. If the last step is still late, the intended frame duration
 * becomes two refresh periods, and the quality becomes the best that holds this duration. */
static void lower(struct governor *governor, uint64_t mean_ns)
{
    const uint64_t aim_ns = governor->turn_ns * governor->turns;
    const bool is_far = !governor->is_trying && mean_ns * 100u > aim_ns * FAR_PERCENT;
    if (governor->step < QUALITY_STEP_MAX) {
        governor->step++;
        if (is_far && governor->step < QUALITY_STEP_MAX) {
            governor->step++;
        }
    } else if (governor->turns == 1u) {
        governor->turns = 2;
        governor->step = governor->half_step;
    }
}

/* Begins a trial of a finer quality: of the next finer step, or of the full frame rate at the last
 * step. */
static void refine(struct governor *governor)
{
    if (governor->turns > 1u) {
        governor->half_step = governor->step;
        governor->turns = 1;
        governor->step = QUALITY_STEP_MAX;
    } else {
        governor->step--;
    }
    governor->is_trying = true;
    governor->timely_s = 0;
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
    if (governor->sum_ns >= GOVERNOR_PERIOD_S * NS_PER_S) {
        const uint64_t mean_ns = governor->sum_ns / governor->count;
        const uint64_t aim_ns = governor->turn_ns * governor->turns;
        governor->sum_ns = governor->count = 0;
        if (mean_ns * 100u > aim_ns * LATE_PERCENT) {
            if (governor->is_trying && governor->patience_s < GOVERNOR_PATIENCE_MAX_S) {
                governor->patience_s *= 2u;
            }
            lower(governor, mean_ns);
            governor->is_trying = false;
            governor->timely_s = 0;
        } else if (mean_ns * 100u > aim_ns * REFINE_PERCENT) {
            governor->timely_s = 0;
        } else {
            governor->timely_s += GOVERNOR_PERIOD_S;
            if (governor->is_trying && governor->timely_s >= HELD_S) {
                governor->is_trying = false;
                governor->patience_s = GOVERNOR_PATIENCE_S;
            }
            if ((governor->step > 0 || governor->turns > 1u) && may_refine &&
                governor->timely_s >= governor->patience_s) {
                refine(governor);
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
