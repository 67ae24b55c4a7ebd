/* audio.c -- plays the synthesizer's output through SDL's audio callback; see audio.h. */
#include "platform/audio.h"

#include <dlfcn.h>
#include <signal.h>
#include <stdio.h>
#include <string.h>
#include <sys/stat.h>

#include <SDL.h>

#include "core/base/panic.h"
#include "platform/os/clock.h"
#include "platform/os/panic.h"

/* Stack on which SDL's audio thread handles a fatal signal. SDL starts one thread at a time. */
static uint8_t signal_stack[PANIC_STACK_SIZE];

/* Renders one buffer of samples. SDL calls this function on its audio thread. SDL starts the thread
 * without a signal stack, therefore the first call on a thread installs `signal_stack`. If the
 * address sanitizer has already installed a signal stack, that stack is kept. */
static void render(void *context, Uint8 *bytes, int size)
{
    CORE_ASSERT(size >= 0);
    struct audio *audio = context;
    stack_t present, own = { .ss_sp = signal_stack, .ss_size = sizeof signal_stack };
    if (sigaltstack(NULL, &present) == 0 && (present.ss_flags & SS_DISABLE)) {
        sigaltstack(&own, NULL);
    }
    const unsigned packed = atomic_load(&audio->levels);
    const struct sound_levels levels = {
        .effects = (float)(packed & 255u) / 255.0f,
        .music = (float)(packed >> 8 & 255u) / 255.0f,
        .ambience = (float)(packed >> 16 & 255u) / 255.0f,
        .has_pump = (packed >> 24 & 1u) != 0,
        .is_stone_right = (packed >> 25 & 1u) != 0,
        .song = atomic_load(&audio->song),
    };
    mixer_set_levels(&audio->mixer, &levels);
    unsigned taken = atomic_load(&audio->taken);
    while (taken != atomic_load(&audio->pushed)) {
        mixer_play(&audio->mixer, &audio->queue[taken % AUDIO_QUEUE_MAX]);
        atomic_store(&audio->taken, ++taken);
    }
    const uint32_t frame_count = (uint32_t)size / (2u * (uint32_t)sizeof(int16_t));
    /* SDL passes a pointer to bytes, but the samples in the buffer are of type int16_t. */
    void *const samples = bytes;
    mixer_render(&audio->mixer, samples, frame_count);
}

static void discard_alsa_message(const char *file, int line, const char *function, int error,
                                 const char *format, ...)
{
    (void)file, (void)line, (void)function, (void)error, (void)format;
}

/* Installs an empty error handler in ALSA. SDL loads ALSA at run time, and without a sound card
 * ALSA writes eight lines to standard error. describe() reports a missing card in one line. */
static void quiet_alsa(void)
{
    typedef void handler(const char *, int, const char *, int, const char *, ...);
    int (*set_handler)(handler *);
    void *library = dlopen("libasound.so.2", RTLD_LAZY);
    void *symbol = library ? dlsym(library, "snd_lib_error_set_handler") : NULL;
    if (symbol) {
        memcpy(&set_handler, &symbol, sizeof set_handler); /* POSIX permits the conversion of an
                                                              object pointer to a function pointer,
                                                              but C has no cast for it. */
        set_handler(discard_alsa_message);
    }
}

/* Returns true if another search for a sound card is due, and records the search. A search is due
 * if a sound card appeared or disappeared, which changes the modification time of the folder of
 * sound devices, or if AUDIO_TRY_S has passed. SDL takes 3 to 5 ms for a search that finds no
 * card. */
static bool is_search_due(struct audio *audio)
{
    struct stat folder = { 0 };
    const struct hal_clock clock = clock_device();
    const uint64_t now = clock.ops->now_ns(clock.self);
    const bool is_due = now - audio->tried_ns >= AUDIO_TRY_S * 1000000000ull;
    (void)stat(audio->cards ? audio->cards : "/dev/snd", &folder);
    const uint64_t changed =
        (uint64_t)folder.st_mtim.tv_sec * 1000000000u + (uint64_t)folder.st_mtim.tv_nsec;
    if (audio->tried_ns > 0 && !is_due && changed == audio->cards_ns) {
        return false;
    }
    audio->tried_ns = now;
    audio->cards_ns = changed;
    return true;
}

static int audio_open(void *self)
{
    struct audio *audio = self;
    if (audio->device) {
        return HAL_OK;
    }
    if (!is_search_due(audio)) {
        return HAL_ERR_ABSENT;
    }
    const SDL_AudioSpec wanted = {
        .freq = (int)SOUND_RATE_HZ,
        .format = AUDIO_S16SYS,
        .channels = 2,
        .samples = AUDIO_FRAME_COUNT,
        .callback = render,
        .userdata = audio,
    };
    quiet_alsa();
    mixer_init(&audio->mixer, atomic_load(&audio->song));
    atomic_store(&audio->taken, atomic_load(&audio->pushed)); /* Discards the sounds that were
                                                                 queued for a lost card. */
    if (SDL_InitSubSystem(SDL_INIT_AUDIO) == 0) {
        /* The last argument 0 permits no change of the format `wanted`. SDL then converts the
         * samples to the format of the sound card. */
        audio->device = SDL_OpenAudioDevice(NULL, 0, &wanted, NULL, 0);
        if (!audio->device) {
            SDL_QuitSubSystem(SDL_INIT_AUDIO);
        }
    }
    if (!audio->device) {
        snprintf(audio->text, sizeof audio->text,
                 "no sound: %.70s; plug a sound device in or set SDL_AUDIODRIVER", SDL_GetError());
        return HAL_ERR_ABSENT;
    }
    snprintf(audio->text, sizeof audio->text, "sound through SDL %s", SDL_GetCurrentAudioDriver());
    SDL_PauseAudioDevice(audio->device, 0);
    audio->tried_ns = 0; /* If the card is lost, the next open() searches immediately. */
    return HAL_OK;
}

static void audio_close(void *self)
{
    struct audio *audio = self;
    if (audio->device) {
        SDL_CloseAudioDevice(audio->device);
        SDL_QuitSubSystem(SDL_INIT_AUDIO);
        audio->device = 0;
    }
}

static int audio_play(void *self, const struct sound_event *event)
{
    struct audio *audio = self;
    CORE_ASSERT(event);
    if (!audio->device) {
        return HAL_ERR_ABSENT;
    }
    if (SDL_GetAudioDeviceStatus(audio->device) == SDL_AUDIO_STOPPED) {
        audio_close(audio); /* The next open() searches for a card. */
        return HAL_ERR_GONE;
    }
    const unsigned pushed = atomic_load(&audio->pushed);
    if (pushed - atomic_load(&audio->taken) == AUDIO_QUEUE_MAX) {
        return HAL_ERR_BUSY; /* The card does not consume samples. The sound is dropped because it
                                would be played too late. */
    }
    audio->queue[pushed % AUDIO_QUEUE_MAX] = *event;
    atomic_store(&audio->pushed, pushed + 1);
    return HAL_OK;
}

static unsigned level_byte(float level)
{
    return (unsigned)(int)(255.0f * f_clamp(level, 0.0f, 1.0f) + 0.5f);
}

static void audio_set_levels(void *self, const struct sound_levels *levels)
{
    struct audio *audio = self;
    CORE_ASSERT(levels);
    atomic_store(&audio->song, levels->song);
    atomic_store(&audio->levels, level_byte(levels->effects) | level_byte(levels->music) << 8 |
                                     level_byte(levels->ambience) << 16 |
                                     (levels->has_pump ? 1u << 24 : 0u) |
                                     (levels->is_stone_right ? 1u << 25 : 0u));
}

static const char *audio_describe(void *self)
{
    const struct audio *audio = self;
    return audio->text[0] ? audio->text : "no sound: not opened";
}

struct hal_audio audio_device(struct audio *audio)
{
    CORE_ASSERT(audio);
    static const struct hal_audio_ops ops = {
        .open = audio_open,
        .play = audio_play,
        .set_levels = audio_set_levels,
        .describe = audio_describe,
        .close = audio_close,
    };
    return (struct hal_audio){ .ops = &ops, .self = audio };
}
