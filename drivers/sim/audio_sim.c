/* audio_sim.c -- counts sounds and plays nothing. */
#include "drivers/sim/audio_sim.h"

static int audio_sim_open(void *self)
{
    struct audio_sim *sim = self;
    sim->open_count++;
    return sim->gone ? HAL_ERR_ABSENT : HAL_OK;
}

static int audio_sim_play(void *self, const struct sound_event *event)
{
    struct audio_sim *sim = self;
    if (sim->gone) {
        return HAL_ERR_GONE;
    }
    if (sim->fails || event->sound >= SOUND_COUNT) {
        return HAL_ERR_IO;
    }
    sim->played[event->sound]++;
    sim->gain = event->gain;
    return HAL_OK;
}

static const char *audio_sim_describe(void *self)
{
    (void)self;
    return "simulated sound";
}

static void audio_sim_close(void *self)
{
    (void)self;
}

struct hal_audio audio_sim_device(struct audio_sim *sim)
{
    static const struct hal_audio_ops ops = {
        .open = audio_sim_open,
        .play = audio_sim_play,
        .describe = audio_sim_describe,
        .close = audio_sim_close,
    };
    return (struct hal_audio){ .ops = &ops, .self = sim };
}
