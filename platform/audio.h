/* audio.h -- the stall's voice: SDL's audio device plays the core's synthesiser.
 *
 * play() puts an event into a ring and never waits; SDL's audio thread takes it out, starts the
 * voice and renders. No device is no error that anybody hears: describe() says so and the kiosk
 * is silent. open() may be called again and again: it asks SDL only when a card came or went since,
 * or after AUDIO_TRY_S. */
#ifndef KINGYO_PLATFORM_AUDIO_H
#define KINGYO_PLATFORM_AUDIO_H

#include <stdatomic.h>
#include <stdbool.h>
#include <stdint.h>

#include "core/sound/sound.h"
#include "platform/hal.h"

#define AUDIO_QUEUE_MAX 64u   /* Four frames' worth of OUTPUT_SOUND_MAX. */
#define AUDIO_TRY_S 10u       /* Nothing says when a sound server starts; asking costs 5 ms. */
#define AUDIO_FRAME_COUNT 512u /* Asked for at a time: 11 ms, less than one displayed frame. */

/* The caller owns it and leaves it zero. It stays at its address while open. */
struct audio {
    const char *cards;    /* The folder where the kernel shows cards; null: /dev/snd. */
    uint32_t device;      /* SDL's id; 0: silent. */
    struct synth synth;   /* The audio thread's alone once the device runs. */
    char text[HAL_TEXT_SIZE];
    uint64_t tried_ns;    /* When a card was last looked for in vain, ... */
    uint64_t cards_ns;    /* ... and when the folder of cards had last changed by then. */

    /* One writer (the frame loop) and one reader (the audio thread): indexes only grow. */
    struct sound_event queue[AUDIO_QUEUE_MAX];
    atomic_uint pushed, taken;
};

struct hal_audio audio_device(struct audio *audio);

#endif
