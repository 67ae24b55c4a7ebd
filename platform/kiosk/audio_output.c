/* audio_output.c -- plays the sounds of a frame; see audio_output.h. */
#include "platform/kiosk/audio_output.h"

#define NS_PER_S 1000000000ull
#define RETRY_NS NS_PER_S /* Interval between two searches for a sound card. */

static void look_for_card(struct audio_output *voice, const struct hal_audio *audio,
                          uint64_t now_ns)
{
    voice->retry_ns = audio->ops->open(audio->self) == HAL_OK ? 0 : now_ns + RETRY_NS;
}

void audio_output_open(struct audio_output *voice, const struct hal_audio *audio, uint64_t now_ns)
{
    look_for_card(voice, audio, now_ns);
}

float audio_output_gain(const struct settings *settings)
{
    const float share = 0.01f * (float)settings->value[SET_VOLUME];
    return share * share;
}

int audio_output_is_audible(const struct settings *settings, uint64_t attract_s)
{
    const uint64_t every = (uint64_t)settings->value[SET_ATTRACT_SOUND];
    return every > 0 && attract_s / AUDIO_OUTPUT_SHOW_S % every == 0;
}

static int is_silent(struct audio_output *voice, const struct settings *settings, int is_attract,
                     uint64_t now_ns)
{
    if (!is_attract) {
        voice->attract_ns = 0;
        return 0;
    }
    if (voice->attract_ns == 0) {
        voice->attract_ns = now_ns;
    }
    return !audio_output_is_audible(settings, (now_ns - voice->attract_ns) / NS_PER_S);
}

uint32_t audio_output_play(struct audio_output *voice, const struct hal_audio *audio,
                           const struct output *output, const struct settings *settings,
                           int is_attract, uint64_t now_ns)
{
    const float gain = audio_output_gain(settings);
    uint32_t faults = 0;
    if (voice->retry_ns > 0 && now_ns >= voice->retry_ns) {
        look_for_card(voice, audio, now_ns);
    }
    if (is_silent(voice, settings, is_attract, now_ns) || gain <= 0.0f) {
        return 0;
    }
    for (uint32_t i = 0; i < output->sound_count && voice->retry_ns == 0; i++) {
        struct sound_event event = output->sounds[i];
        event.gain *= gain;
        const int result = audio->ops->play(audio->self, &event);
        faults += (uint32_t)hal_is_fault(result);
        if (result == HAL_ERR_GONE) { /* The loss of the sound card counts as one fault. The
                                         remaining sounds of the frame are dropped. */
            voice->retry_ns = now_ns + RETRY_NS;
        }
    }
    return faults;
}
