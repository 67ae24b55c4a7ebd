/* audio_sim.h -- a simulated audio device that counts sounds. */
#ifndef KINGYO_DRIVERS_SIM_AUDIO_SIM_H
#define KINGYO_DRIVERS_SIM_AUDIO_SIM_H

#include "platform/hal.h"

struct audio_sim {
    uint32_t played[SOUND_COUNT];
    float gain;    /* Gain of the sound played last. */
    uint8_t fails; /* 1 if every play must return HAL_ERR_IO. */
    uint8_t gone;  /* 1 if every play must return HAL_ERR_GONE and open() must fail. */
    uint32_t open_count;
};

struct hal_audio audio_sim_device(struct audio_sim *sim);

#endif
