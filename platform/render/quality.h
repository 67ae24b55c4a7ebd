/* quality.h -- chooses the drawing quality, which is the amount of drawing work in a frame, and
 * adapts the quality to the speed of the machine.
 *
 * The initial quality is chosen once from the graphics hardware. The quality governor lowers the
 * quality if frames are late or the machine is hot, so that the game never waits for a picture. The
 * governor raises the quality again when frames are on time.
 *
 * Because a finished frame waits for the next refresh of the screen, the duration of a frame shows
 * whether drawing was too slow, but not how much time was left. Therefore the governor can only try
 * a finer quality step, which it does between two games. After each failed trial the governor waits
 * longer before the next trial. */
#pragma once

#include <stdbool.h>
#include <stdint.h>

struct quality {
    /* True if the picture is rendered by a CPU (llvmpipe, softpipe, SwiftShader) and not by a
     * GPU. */
    bool software;
    /* Width of the underwater scene's picture in pixels, divided by the width of the screen in
     * pixels, (0, 2]. The same factor applies to the height. */
    float scene_scale;
    /* Width of the picture without its words, divided by the width of the screen, (0, 1]. The words
     * are drawn at the resolution of the screen. */
    float screen_scale;
    /* Width of the picture of the tank's floor and walls, divided by the width of the screen, (0,
     * 2]. The floor and the walls have no fine detail. */
    float floor_scale;
    /* Width of the picture of the reflections on the water surface, divided by the width of the
     * screen, (0, 2]. */
    float mirror_scale;
    /* Number of multisampling samples of the scene and the screen. 1 means no multisampling. */
    uint32_t samples;
    /* Fish length from which the near mesh is drawn, in pixels of the render target. Shorter fish
     * are drawn with the far mesh. */
    float lod_near_px;
    /* Fish length below which the mesh for small fish is drawn, in pixels of the render target, at
     * most lod_near_px. */
    float lod_small_px;
};

struct quality_request {
    const char *renderer;   /* Name of the graphics hardware (GL_RENDERER). */
    uint32_t width, height; /* Screen size in pixels, > 0. */
    /* Requested value of quality.scene_scale, clamped to [0.25, 2], and of quality.screen_scale,
     * clamped to [0.25, 1]. 0 means automatic. */
    float scene_scale;
    /* Requested number of multisampling samples, limited to samples_max. 0 means automatic. */
    uint32_t samples;
    /* Maximum number of multisampling samples that the OpenGL context supports. */
    uint32_t samples_max;
    /* Maximum side in pixels of a render target other than the screen, > 0. */
    uint32_t side_max;
};

/* Returns the best quality for the hardware and the screen size, within the limits in `request`. */
struct quality quality_choose(const struct quality_request *request);

/* Maximum number of quality steps below the best quality. The last step draws the fish with a third
 * of their pixels. */
#define QUALITY_STEP_MAX 7u

/* Returns the quality that is `step` steps below `best`. Steps above QUALITY_STEP_MAX count as
 * QUALITY_STEP_MAX, and step 0 returns `best`. Text stays equally sharp at every step. */
struct quality quality_lower(const struct quality *best, uint32_t step);

/* Measurement interval in seconds. The mean frame duration is computed over this interval. */
#define GOVERNOR_PERIOD_S 2u
/* Initial number of seconds without late frames after which a finer quality step is tried. */
#define GOVERNOR_PATIENCE_S 30u
/* Maximum number of seconds without late frames before a finer quality step is tried, about half an
 * hour. Each failed trial doubles the number, up to this maximum. */
#define GOVERNOR_PATIENCE_MAX_S 1920u
/* Temperature margin in m°C below which a machine is hot. The margin is the difference between the
 * temperature at which the machine throttles itself and its present temperature. */
#define GOVERNOR_HOT_MDEG 3000
/* Temperature margin in m°C above which a hot machine has cooled down. The margin is the difference
 * between the temperature at which the machine throttles itself and its present temperature. */
#define GOVERNOR_COOL_MDEG 8000

struct governor {
    /* Refresh period of the screen in ns, the shortest possible frame duration. */
    uint64_t turn_ns;
    uint64_t last_ns; /* Time of the previous frame in ns. 0 means no previous frame. */
    /* Intended frame duration in refresh periods: 1, or 2 if the last quality step is too slow. */
    uint32_t turns;
    /* Total duration in ns (`sum_ns`) and number (`count`) of the frames in the current measurement
     * interval. */
    uint64_t sum_ns, count;
    /* Number of consecutive stalls. A stall is a frame longer than a quarter of a second, which
     * usually has another cause than drawing. */
    uint32_t stalls;
    uint32_t timely_s; /* Number of consecutive seconds without late frames. */
    /* Number of seconds without late frames that must pass before a finer quality step is tried. */
    uint32_t patience_s;
    /* Number of quality steps below the best quality that the drawing speed requires. */
    uint8_t step;
    /* Value that `step` gets when the intended frame duration becomes two refresh periods. The
     * value is saved each time before the full frame rate is tried. */
    uint8_t half_step;
    /* Number of quality steps below the best quality that keep the machine cool, at most
     * QUALITY_STEP_MAX. */
    uint8_t heat;
    bool is_trying; /* True while a finer quality step is on trial. */
};

/* Initializes the governor. `refresh_hz` is the screen's refresh rate. A value of 0 or above 60
 * counts as 60 Hz, which is enough for the game. */
void quality_governor_begin(struct governor *governor, uint32_t refresh_hz);

/* Updates the governor. Must be called after each frame. `may_refine` is true between two games. A
 * frame longer than a quarter of a second is a stall. A stall counts as drawing time only if at
 * least two stalls directly precede it. Returns the argument `step` of quality_lower() for the next
 * frame. */
uint32_t quality_governor_frame(struct governor *governor, uint64_t now_ns, bool may_refine);

/* Updates governor->heat, the number of quality steps that keep the machine cool. Must be called
 * every few seconds. `margin_mdeg` is the temperature margin in m°C: the difference between the
 * temperature at which the machine throttles itself and its current temperature. */
void quality_governor_set_temperature(struct governor *governor, int32_t margin_mdeg);
