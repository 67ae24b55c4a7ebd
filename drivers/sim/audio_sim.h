/* audio_sim.h -- a simulated audio device that counts the played sounds. */
#ifndef KINGYO_DRIVERS_SIM_AUDIO_SIM_H
#define KINGYO_DRIVERS_SIM_AUDIO_SIM_H

#include "platform/hal.h"

struct audio_sim {
    uint32_t played[SOUND_COUNT];
    float gain;    /* Gain of the last played sound. */
    uint8_t fails; /* 1 if every play() returns HAL_ERR_IO, otherwise 0. */
    uint8_t gone;  /* 1 if every play() returns HAL_ERR_GONE and every open() returns
                      HAL_ERR_ABSENT, otherwise 0. */
    uint32_t open_count;
};

/* Returns the simulated audio device. */
struct hal_audio audio_sim_device(struct audio_sim *sim);

#endif
