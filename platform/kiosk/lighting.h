/* lighting.h -- how light the picture is, and where on the screen: as bright as the operator wants
 * it while somebody is there, dimmer when nobody was for a while, dark at night; and never long in
 * the same place, since what stands still for weeks burns into a screen. */
#ifndef KINGYO_PLATFORM_KIOSK_LIGHTING_H
#define KINGYO_PLATFORM_KIOSK_LIGHTING_H

#include <stdint.h>

#include "core/input.h"
#include "core/placing.h"
#include "core/settings.h"

#define LIGHTING_NIGHT_IDLE_S 60u   /* At night whoever wakes the stall has so long to begin. */
#define LIGHTING_STIR_M 0.03f       /* A hand that moved so far is somebody's; noise is less. */
#define LIGHTING_SHIFT (1.0f / 180.0f) /* Of the height, each way: 4 pixels of 720, 6 of 1080. */

struct lighting {
    uint64_t seen_ns;          /* The frame before; 0: there was none. */
    uint64_t touched_ns;       /* When somebody was there last. */
    float light;               /* [0, 1] of what the operator set; it fades. */
    uint32_t wander_ms;        /* How long the picture has wandered; wraps with the way. */
    uint8_t was_stirred;       /* A press, a coin, a hand or a game, since the last step. */
    vec3 hand_m[POI_MAX];      /* Where each hand's last stir ended. */
};

/* Before the frame's ticks: a press, a coin, or a game that runs is somebody. */
void lighting_notice(struct lighting *lighting, const struct input *input, int is_attract);

/* After them: so are hands that moved. Then the picture for this frame. `now_ns` is monotonic;
 * `settings` are in range. The night is told by input->minute and there is none while input->day
 * is 0. */
struct showing lighting_step(struct lighting *lighting, const struct settings *settings,
                             const struct input *input, int is_attract, uint64_t now_ns);

#endif
