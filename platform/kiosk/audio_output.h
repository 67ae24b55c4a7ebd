/* audio_output.h -- audio output: plays the core's sounds at the operator's volume on a sound card
 * that may appear and disappear.
 *
 * In attract mode sounds are played only at intervals. */
#ifndef KINGYO_PLATFORM_KIOSK_AUDIO_OUTPUT_H
#define KINGYO_PLATFORM_KIOSK_AUDIO_OUTPUT_H

#include <stdint.h>

#include "core/output.h"
#include "core/settings.h"
#include "platform/hal.h"

/* Seconds in one part of attract mode; sounds are played in each n-th part. */
#define AUDIO_OUTPUT_SHOW_S 60u

struct audio_output {
    uint64_t retry_ns;   /* Time of the next search for a missing card; 0: the card is present. */
    uint64_t attract_ns; /* Start of attract mode; 0: a game runs. */
};

/* Opens the sound card. If there is none, audio_output_play() retries later. */
void audio_output_open(struct audio_output *voice, const struct hal_audio *audio, uint64_t now_ns);

/* Returns the gain [0, 1] of a sound of full volume. Half of the volume setting is perceived as
 * half as loud, because hearing follows a power law. */
float audio_output_gain(const struct settings *settings);

/* Returns 1 if sounds are played at this time after the start of attract mode. */
int audio_output_is_audible(const struct settings *settings, uint64_t attract_s);

/* Plays the sounds of a frame. Returns the number of faults; the loss of a card is one. */
uint32_t audio_output_play(struct audio_output *voice, const struct hal_audio *audio,
                           const struct output *output, const struct settings *settings,
                           int is_attract, uint64_t now_ns);

#endif
