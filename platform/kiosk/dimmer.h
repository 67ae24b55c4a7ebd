/* dimmer.h -- dims the picture and moves it slowly to prevent burn-in.
 *
 * The brightness is the operator's while a player is present, lower after a time without input, and
 * dark at night. */
#ifndef KINGYO_PLATFORM_KIOSK_DIMMER_H
#define KINGYO_PLATFORM_KIOSK_DIMMER_H

#include <stdint.h>

#include "core/display_geometry.h"
#include "core/input.h"
#include "core/settings.h"

/* Time in which a player who wakes the kiosk at night can start a game. */
#define DIMMER_NIGHT_IDLE_S 60u
/* Movement of a poi in metres that counts as input; smaller movements are noise. */
#define DIMMER_STIR_M 0.03f
/* Shift in each direction as a share of the height: 4 pixels of 720, 6 of 1080. */
#define DIMMER_SHIFT (1.0f / 180.0f)

struct dimmer {
    uint64_t seen_ns;     /* Time of the previous frame; 0: none. */
    uint64_t touched_ns;  /* Time of the last input. */
    float light;          /* Share [0, 1] of the operator's brightness; changes gradually. */
    uint32_t wander_ms;   /* Phase of the movement; wraps at its period. */
    uint8_t was_stirred;  /* 1: a press, a coin, a movement or a game since the last step. */
    vec3 hand_m[POI_MAX]; /* Position of each poi at its last detected movement. */
};

/* Detects input: a press, a coin, or a running game. Call before the frame's ticks. */
void dimmer_notice(struct dimmer *dimmer, const struct input *input, int is_attract);

/* Detects movements of the pois and returns the display transform of this frame. Call after the
 * frame's ticks. `now_ns` is monotonic; `settings` are in range. Night is decided by input->minute,
 * and is disabled while input->day is 0. */
struct display_settings dimmer_step(struct dimmer *dimmer, const struct settings *settings,
                                    const struct input *input, int is_attract, uint64_t now_ns);

#endif
