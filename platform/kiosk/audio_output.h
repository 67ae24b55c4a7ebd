/* audio_output.h -- plays the core's sounds at the operator's volume on a sound card that may be
 * connected and disconnected.
 *
 * In attract mode (the demonstration between rounds) sounds are played only at intervals. */
#ifndef KINGYO_PLATFORM_KIOSK_AUDIO_OUTPUT_H
#define KINGYO_PLATFORM_KIOSK_AUDIO_OUTPUT_H

#include <stdint.h>

#include "core/output.h"
#include "core/settings.h"
#include "platform/hal.h"

/* Length in seconds of one section of attract mode. Sounds are played only in each n-th section,
 * where n is the setting SET_ATTRACT_SOUND. If n is 0, no section has sounds. */
#define AUDIO_OUTPUT_SHOW_S 60u

struct audio_output {
    uint64_t retry_ns;   /* Time of the next search for a missing sound card. 0 means that a sound
                            card is open. */
    uint64_t attract_ns; /* Start time of attract mode. 0 means that a game runs. */
};

/* Opens the sound card. If no sound card is found, audio_output_play() repeats the search once per
 * second. */
void audio_output_open(struct audio_output *voice, const struct hal_audio *audio, uint64_t now_ns);

/* Returns the gain [0, 1] of a sound of full volume. The gain is the square of the volume setting,
 * because hearing follows a power law: half of the setting sounds about half as loud. */
float audio_output_gain(const struct settings *settings);

/* Returns 1 if sounds are played `attract_s` seconds after the start of attract mode, otherwise
 * 0. */
int audio_output_is_audible(const struct settings *settings, uint64_t attract_s);

/* Plays the sounds of one frame. Returns the number of faults. The loss of the sound card counts as
 * one fault. */
uint32_t audio_output_play(struct audio_output *voice, const struct hal_audio *audio,
                           const struct output *output, const struct settings *settings,
                           int is_attract, uint64_t now_ns);

#endif
