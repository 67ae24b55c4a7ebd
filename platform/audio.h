/* audio.h -- audio output: SDL's audio device plays the output of the core's mixer.
 *
 * play() puts an event into a ring buffer and never blocks. SDL's audio thread takes the event from
 * the ring buffer, starts the sound and renders it. Without an audio device the kiosk is silent;
 * only describe() reports the missing device. open() may be called repeatedly. open() searches for
 * a device only if a sound card appeared or disappeared since the last call, or if AUDIO_TRY_S has
 * passed. */
#pragma once

#include <stdatomic.h>
#include <stdint.h>

#include "core/sound/mixer.h"
#include "platform/hal.h"

/* Capacity of the ring buffer in sounds, four times OUTPUT_SOUND_MAX. */
#define AUDIO_QUEUE_MAX 64u
/* Interval in seconds between two searches for an audio device. The start of a sound server changes
 * no device file, therefore a timer is needed. A search takes 5 ms. */
#define AUDIO_TRY_S 10u
/* Number of stereo samples per audio callback. The samples last 11 ms, which is less than one
 * displayed frame. */
#define AUDIO_FRAME_COUNT 512u

/* State of the audio output. The caller owns the structure and initializes it to zero. Its address
 * must not change while the device is open. */
struct audio {
    const char *cards;  /* Folder of the kernel's sound devices. Null means /dev/snd. */
    uint32_t device;    /* SDL's device id. 0 means no open device. */
    struct mixer mixer; /* Mixer. Only the audio thread uses it while the device is open. */
    char text[HAL_TEXT_SIZE];
    uint64_t tried_ns; /* Time in nanoseconds of the last search that found no sound card. */
    uint64_t cards_ns; /* Modification time of the folder `cards` at the last search. */

    /* Ring buffer with one producer (the frame loop) and one consumer (the audio thread). `pushed`
     * and `taken` only increase. */
    struct sound_event queue[AUDIO_QUEUE_MAX];
    atomic_uint pushed, taken;
    /* Levels for the audio thread: effects, music and ambience, one byte (0 to 255) each from
     * the lowest byte on. Bit 24 is 1 if the air pump bubbles, and bit 25 if its air stone is on
     * the right. */
    atomic_uint levels;
    atomic_uint song; /* Seed of the music (struct sound_levels). */
};

/* Returns the HAL device that uses `audio`. `audio` must outlive the returned device. */
struct hal_audio audio_device(struct audio *audio);
