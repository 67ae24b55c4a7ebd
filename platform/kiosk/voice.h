/* voice.h -- what the stall calls out, brought to a sound card that may come and go: as loud as the
 * operator set it, and while nobody plays only now and then. */
#ifndef KINGYO_PLATFORM_KIOSK_VOICE_H
#define KINGYO_PLATFORM_KIOSK_VOICE_H

#include <stdint.h>

#include "core/output.h"
#include "core/settings.h"
#include "platform/hal.h"

#define VOICE_SHOW_S 60u /* Attract is shown in parts of so long; each n-th is heard. */

struct voice {
    uint64_t retry_ns;   /* When a card that is not there is looked for again; 0: it is there. */
    uint64_t attract_ns; /* When attract began; 0: somebody plays. */
};

/* Who found no card at the start looks for one from now on. */
void voice_open(struct voice *voice, const struct hal_audio *audio, uint64_t now_ns);

/* [0, 1], how loud a sound of full gain is. Half the slider sounds half as loud: an ear hears
 * powers. */
float voice_gain(const struct settings *settings);

/* Whether attract is heard so long after it began. */
int voice_is_heard(const struct settings *settings, uint64_t attract_s);

/* The sounds of a frame. Returns how many faults it met; a card that goes is one. */
uint32_t voice_put(struct voice *voice, const struct hal_audio *audio,
                   const struct output *output, const struct settings *settings, int is_attract,
                   uint64_t now_ns);

#endif
