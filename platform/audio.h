/* audio.h -- audio output: the core's synthesizer, played through SDL's audio device.
 *
 * play() puts an event into a ring buffer and never blocks. SDL's audio thread takes the event,
 * starts the sound and renders it. A missing device is reported by describe() only, and the kiosk
 * is silent. open() may be called repeatedly. It searches for a device only if a card appeared or
 * disappeared since the last call, or after AUDIO_TRY_S. */
#ifndef KINGYO_PLATFORM_AUDIO_H
#define KINGYO_PLATFORM_AUDIO_H

#include <stdatomic.h>
#include <stdbool.h>
#include <stdint.h>

#include "core/sound/synth.h"
#include "platform/hal.h"

#define AUDIO_QUEUE_MAX 64u /* Four times OUTPUT_SOUND_MAX. */
/* Search interval; the start of a sound server causes no event, and a search takes 5 ms. */
#define AUDIO_TRY_S 10u
#define AUDIO_FRAME_COUNT 512u /* Samples per callback: 11 ms, less than one displayed frame. */

/* State of the audio output. The caller owns the structure and clears it. The address must not
 * change while the device is open. */
struct audio {
    const char *cards;  /* Folder of the kernel's sound devices; null: /dev/snd. */
    uint32_t device;    /* SDL's device id; 0: no device. */
    struct synth synth; /* Used only by the audio thread while the device runs. */
    char text[HAL_TEXT_SIZE];
    uint64_t tried_ns; /* Time of the last search that found no card. */
    uint64_t cards_ns; /* Last change of the folder of cards at that search. */

    /* Queue with one producer (the frame loop) and one consumer (the audio thread). Both indexes
     * only increase. */
    struct sound_event queue[AUDIO_QUEUE_MAX];
    atomic_uint pushed, taken;
};

/* Returns the device of `audio`, which must outlive the device. */
struct hal_audio audio_device(struct audio *audio);

#endif
