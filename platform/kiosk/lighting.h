/* lighting.h -- dims the picture and moves it slowly to prevent burn-in.
 *
 * The brightness is the operator's while a player is present, lower after a time without input, and
 * dark at night. */
#ifndef KINGYO_PLATFORM_KIOSK_LIGHTING_H
#define KINGYO_PLATFORM_KIOSK_LIGHTING_H

#include <stdint.h>

#include "core/input.h"
#include "core/placing.h"
#include "core/settings.h"

#define LIGHTING_NIGHT_IDLE_S 60u   /* Time in which a player who wakes the kiosk at night can start
                                       a game. */
#define LIGHTING_STIR_M 0.03f       /* Movement of a poi in metres that counts as input; smaller
                                       movements are noise. */
#define LIGHTING_SHIFT (1.0f / 180.0f) /* Shift in each direction as a share of the height: 4 pixels
                                          of 720, 6 of 1080. */

struct lighting {
    uint64_t seen_ns;          /* Time of the previous frame; 0: none. */
    uint64_t touched_ns;       /* Time of the last input. */
    float light;               /* Share [0, 1] of the operator's brightness; changes gradually. */
    uint32_t wander_ms;        /* Phase of the movement; wraps at its period. */
    uint8_t was_stirred;       /* 1: a press, a coin, a movement or a game since the last step. */
    vec3 hand_m[POI_MAX];      /* Position of each poi at its last detected movement. */
};

/* Detects input: a press, a coin, or a running game. Call before the frame's ticks. */
void lighting_notice(struct lighting *lighting, const struct input *input, int is_attract);

/* Detects movements of the pois and returns the display transform of this frame. Call after the
 * frame's ticks. `now_ns` is monotonic; `settings` are in range. Night is decided by input->minute,
 * and is disabled while input->day is 0. */
struct showing lighting_step(struct lighting *lighting, const struct settings *settings,
                             const struct input *input, int is_attract, uint64_t now_ns);

#endif
