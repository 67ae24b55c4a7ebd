/* audio_sim.h -- counts what would have been heard. */
#ifndef KINGYO_DRIVERS_AUDIO_SIM_H
#define KINGYO_DRIVERS_AUDIO_SIM_H

#include "platform/hal.h"

struct audio_sim {
    uint32_t played[SOUND_COUNT];
    float gain;          /* Of the last one. */
    uint8_t fails;       /* Set: every play answers HAL_ERR_IO. */
    uint8_t gone;        /* Set: every play answers HAL_ERR_GONE, and no open finds a card. */
    uint32_t open_count;
};

struct hal_audio audio_sim_device(struct audio_sim *sim);

#endif
