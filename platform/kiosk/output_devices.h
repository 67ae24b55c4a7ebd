/* output_devices.h -- passes the results of a frame to the sound card, the start lamp, the coin
 * lockout, the coin counter and the ticket dispenser. The module also computes the brightness and
 * the position of the picture. The sound card may be connected and disconnected while the kiosk
 * runs. In attract mode (the demonstration between rounds) sounds are played only at intervals. */
#pragma once

#include <stdbool.h>
#include <stdint.h>

#include "core/display_geometry.h"
#include "core/input.h"
#include "core/output.h"
#include "core/scene.h"
#include "core/settings.h"
#include "platform/hal.h"

/* Length in seconds of one section of attract mode. Sounds are played only in each n-th section,
 * where n is the setting SET_ATTRACT_SOUND. If n is 0, no section has sounds. */
#define OUTPUT_AUDIO_SHOW_S 60u

/* Returns true if a device accepted a request, or if the cabinet has no such device. `result` is
 * the result of the request. After a fault, sets `retry_ns` to the time of the next attempt, which
 * is one second later. */
bool output_is_settled(int result, uint64_t now_ns, uint64_t *retry_ns);

struct output_audio {
    /* Time of the next search for a missing sound card. 0 means that a sound card is open. */
    uint64_t retry_ns;
    uint64_t attract_ns; /* Start time of attract mode. 0 means that a game is in progress. */
};

/* Opens the sound card. If no sound card is found, output_audio_play() repeats the search once per
 * second. */
void output_audio_open(struct output_audio *voice, const struct hal_audio *audio, uint64_t now_ns);

/* Plays the sounds of one frame with the volumes of the settings. `input` supplies the time of day.
 * Returns the number of faults. The loss of the sound card counts as one fault. */
uint32_t output_audio_play(struct output_audio *voice, const struct hal_audio *audio,
                           const struct output *output, const struct settings *settings,
                           const struct input *input, bool is_attract, uint64_t now_ns);

/* ---- Lamp, lockout, counter and tickets ---------------------------------------------------- */

/* Sends the core's outputs (start lamp, coin lockout, coin counter, tickets) to a driver that may
 * fail.
 *
 * An output counts as sent only after the driver has accepted it. */

struct output_lines {
    /* Levels that the driver accepted last, one bit (1 << enum hal_switch) per output. */
    uint32_t active;
    uint32_t given[HAL_SWITCH_COUNT]; /* Pulses that the driver accepted since program start. */
    /* Time of the next attempt for an output whose last request failed. */
    uint64_t retry_ns[HAL_SWITCH_COUNT];
};

/* Sets the start lamp and the coin lockout. Sends one pulse to the coin counter or the ticket
 * dispenser for each increase of its count. Call once per frame. Returns the number of faults. */
uint32_t output_lines_put(struct output_lines *switches, const struct hal_switches *device,
                          const struct output *output, uint64_t now_ns);

/* Returns the number of completed pulses since program start. Pulses of an output that the cabinet
 * does not have are completed immediately. */
uint32_t output_lines_are_done(const struct output_lines *switches,
                               const struct hal_switches *device, enum hal_switch which);

/* ---- Brightness and position of the picture ------------------------------------------------ */

/* Dims the picture, and moves the picture slowly to prevent burn-in of the screen. While a player
 * is present, the picture has the brightness that the operator has set. After a time without input
 * the brightness is lower, and at night the picture is dark. */

/* Seconds without input after which the picture becomes dark at night. A player who has inserted a
 * coin has enough time to start a game. */
#define DIMMER_NIGHT_IDLE_S 60u
/* Distance in metres that a poi must move to count as input. Shorter movements may be sensor
 * noise. */
#define DIMMER_STIR_M 0.03f
/* Maximum shift of the picture in each direction, as a fraction of the picture height. The shift is
 * 4 pixels at a height of 720 pixels, and 6 pixels at a height of 1080 pixels. */
#define DIMMER_SHIFT (1.0f / 180.0f)

struct output_dimmer {
    uint64_t seen_ns;    /* Time of the previous frame. 0 means no frame yet. */
    uint64_t touched_ns; /* Time of the last input. */
    /* Current brightness as a fraction [0, 1] of the brightness that the operator has set. The
     * fraction changes gradually. */
    float light;
    /* Phase of the picture's slow movement in milliseconds. The phase returns to 0 at the end of
     * its period. */
    uint32_t wander_ms;
    /* True if input was detected since the previous call of output_dimmer_step(): a button press, a
     * coin, a poi movement or a running game. */
    bool was_stirred;
    vec3 hand_m[POI_MAX]; /* Position in metres of each poi at its last detected movement. */
};

/* Detects input: a pressed button, a coin or a running game. Call before the ticks of the frame. */
void output_dimmer_notice(struct output_dimmer *dimmer, const struct input *input, bool is_attract);

/* Detects movements of the pois and returns the display settings of the frame. Call after the ticks
 * of the frame. `now_ns` is monotonic. The caller guarantees that `settings` are valid. Night is
 * determined from input->minute, and there is no night while input->day is 0. */
struct display_settings output_dimmer_step(struct output_dimmer *dimmer,
                                           const struct settings *settings,
                                           const struct input *input, bool is_attract,
                                           uint64_t now_ns);

/* Seconds without a touch after which the camera begins to drift in attract mode, seconds in which
 * the camera reaches a place, and seconds for which the camera shows a fish closely. */
#define CAMERA_IDLE_S 10.0f
#define CAMERA_MOVE_S 1.5f
#define CAMERA_CLOSE_S 4.0f

/* Largest share of the distance to the poi by which the camera comes closer in a round with one
 * player, and the rate in 1/s of the critically damped motion. */
#define CAMERA_CLOSER_MAX 0.15f
#define CAMERA_CLOSER_RATE 1.5f
/* Largest distances from the middle of the picture at which the closer camera shows the edges of
 * the visible water, as shares of half the picture's height or width. The far edge stays below the
 * counters, which are lower in a wide picture. */
#define CAMERA_FAR_EDGE 0.71f
#define CAMERA_FAR_EDGE_TURNED 0.84f
#define CAMERA_NEAR_EDGE 0.98f
#define CAMERA_SIDE_EDGE 1.0f

/* Greatest width of a strip of water at the left, right and near walls that may leave the picture,
 * and the distances of the poi from such a wall between which the strip grows from 0. The strip is
 * narrower than the poi (POI_OUTER_RADIUS_M). The picture thus always shows every place of the
 * poi's centre, also while the poi is under water, where the camera does not follow the poi. */
#define CAMERA_HIDDEN_M 0.040f
#define CAMERA_HIDES_FROM_M 0.12f
#define CAMERA_HIDES_TO_M 0.30f

/* One coordinate of a critically damped motion. */
struct camera_spring {
    float at, speed; /* The speed is per second. */
};

/* Motion of the camera. All zero: the camera rests. */
struct output_camera {
    float drift; /* Share [0, 1] of the slow motion around the place of rest. */
    float close; /* Share [0, 1] of the way to a bowl into which a fish has fallen. */
    uint32_t seen_tick, close_until_tick;
    uint32_t caught[POI_MAX]; /* Number of fish in each bowl in the previous frame. */
    vec3 close_m;             /* Position of the bowl. */
    /* The share by which the camera is closer to a point of the water, and x and z of the point
     * multiplied by this share. All possible places of the camera then form a convex set, so that
     * the picture never hides more than the strips, also while the camera moves. */
    struct camera_spring closer[3];
};

/* Moves the camera `view`, which is at rest, to its place in this frame. In attract mode, while
 * nobody has touched the kiosk for CAMERA_IDLE_S, the camera drifts slowly, and comes close to a
 * bowl for a moment after a fish has fallen into the bowl. In a round with one player the camera
 * comes closer around the poi if `follows` is true. It does not move while the poi is under water,
 * because the poi is at the place of the pointer in the picture: a moving picture would press the
 * water against the paper. Otherwise the camera returns to its place of rest. It never moves
 * without ticks. Must be called after output_dimmer_step(), which detects touches. */
void output_camera_step(struct output_camera *camera, const struct output_dimmer *dimmer,
                        const struct scene *scene, bool is_turned, bool follows, struct view *view);
