/* dimmer.h -- dims the picture and moves it slowly to prevent burn-in.
 *
 * The brightness is the operator's brightness while a player is present. After a time without input
 * the brightness is lower, and at night the picture is dark. */
#ifndef KINGYO_PLATFORM_KIOSK_DIMMER_H
#define KINGYO_PLATFORM_KIOSK_DIMMER_H

#include <stdint.h>

#include "core/display_geometry.h"
#include "core/input.h"
#include "core/settings.h"

/* Seconds without input after which the picture becomes dark at night. The time is long enough to
 * start a game. */
#define DIMMER_NIGHT_IDLE_S 60u
/* Distance in metres that a poi must move to count as input. Shorter movements may be sensor
 * noise. */
#define DIMMER_STIR_M 0.03f
/* Maximum shift of the picture in each direction, as a share of the picture height: 4 pixels at a
 * height of 720 pixels, 6 pixels at 1080. */
#define DIMMER_SHIFT (1.0f / 180.0f)

struct dimmer {
    uint64_t seen_ns;     /* Time of the previous frame. 0 means no frame yet. */
    uint64_t touched_ns;  /* Time of the last input. */
    float light;          /* Current brightness as a share [0, 1] of the operator's brightness.
                             Changes gradually. */
    uint32_t wander_ms;   /* Phase of the slow movement in milliseconds. Wraps around at the end of
                             its period. */
    uint8_t was_stirred;  /* 1 if a button, a coin, a poi movement or a running game was detected
                             after the previous dimmer_step(). */
    vec3 hand_m[POI_MAX]; /* Position in metres of each poi at its last detected movement. */
};

/* Detects input: a pressed button, a coin or a running game. Call before the ticks of the frame. */
void dimmer_notice(struct dimmer *dimmer, const struct input *input, int is_attract);

/* Detects movements of the pois and returns the display settings of the frame. Call after the ticks
 * of the frame. `now_ns` is monotonic. The caller guarantees that `settings` are valid. Night is
 * determined from input->minute, and there is no night while input->day is 0. */
struct display_settings dimmer_step(struct dimmer *dimmer, const struct settings *settings,
                                    const struct input *input, int is_attract, uint64_t now_ns);

#endif
