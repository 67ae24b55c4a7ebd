/* test_audio.c -- Tests the sound output. Sounds must reach the device, and a kiosk without a sound
 * device must continue without sound. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include <SDL.h>
#include <cmocka.h>

#include "platform/audio.h"

static struct audio audio;

static int silence_before(void **state)
{
    (void)state;
    memset(&audio, 0, sizeof audio);
    return 0;
}

static int close_after(void **state)
{
    (void)state;
    const struct hal_audio device = audio_device(&audio);
    device.ops->close(device.self);
    return 0;
}

/* Returns the largest absolute sample value in a file of 16-bit samples, which is 0 for silence. */
static int loudest(const char *path)
{
    int16_t samples[1024];
    int peak = 0;
    FILE *file = fopen(path, "rb");
    assert_non_null(file);
    for (size_t count; (count = fread(samples, sizeof samples[0], 1024, file)) > 0;) {
        for (size_t i = 0; i < count; i++) {
            peak = abs(samples[i]) > peak ? abs(samples[i]) : peak;
        }
    }
    fclose(file);
    return peak;
}

/* Opens the sound output, and plays a sound if `play_something` is 1. Returns the largest sample
 * value in the file to which SDL's `disk` driver writes the output. */
static int heard_through_sdl(int play_something)
{
    char path[] = "/tmp/kingyo-sound-XXXXXX";
    close(mkstemp(path));
    setenv("SDL_AUDIODRIVER", "disk", 1);
    setenv("SDL_DISKAUDIOFILE", path, 1);
    const struct hal_audio device = audio_device(&audio);
    assert_int_equal(device.ops->open(device.self), HAL_OK);
    assert_non_null(strstr(device.ops->describe(device.self), "disk"));
    if (play_something) {
        const struct sound_event event = { .sound = SOUND_CATCH, .gain = 1.0f };
        assert_int_equal(device.ops->play(device.self, &event), HAL_OK);
    }
    SDL_Delay(200);
    device.ops->close(device.self);
    const int peak = loudest(path);
    unlink(path);
    return peak;
}

static void test_a_sound_reaches_the_device(void **state)
{
    (void)state;
    assert_true(heard_through_sdl(1) > 1000);
}

static void test_without_a_sound_the_output_is_silent(void **state)
{
    (void)state;
    assert_int_equal(heard_through_sdl(0), 0);
}

static void test_a_missing_sound_device_gives_a_one_line_message(void **state)
{
    (void)state;
    setenv("SDL_AUDIODRIVER", "nonesuch", 1);
    const struct hal_audio device = audio_device(&audio);
    assert_int_equal(device.ops->open(device.self), HAL_ERR_ABSENT);
    const char *text = device.ops->describe(device.self);
    assert_non_null(strstr(text, "no sound"));
    assert_null(strchr(text, '\n'));
    const struct sound_event event = { .sound = SOUND_DIP, .gain = 1.0f };
    assert_int_equal(device.ops->play(device.self, &event), HAL_ERR_ABSENT);
}

/* The first open() fails, because there is no driver. Further calls must fail without a call to SDL
 * until the file of a sound card appears in the folder `cards`. */
static void test_a_sound_card_plugged_in_later_is_opened_without_useless_attempts(void **state)
{
    (void)state;
    char cards[] = "/tmp/kingyo-cards-XXXXXX", card[64];
    assert_non_null(mkdtemp(cards));
    audio.cards = cards;
    setenv("SDL_AUDIODRIVER", "nonesuch", 1);
    const struct hal_audio device = audio_device(&audio);
    assert_int_equal(device.ops->open(device.self), HAL_ERR_ABSENT);
    /* SDL would find a driver from now on, but the folder `cards` has not changed. */
    setenv("SDL_AUDIODRIVER", "dummy", 1);
    for (uint32_t i = 0; i < 1000; i++) {
        assert_int_equal(device.ops->open(device.self), HAL_ERR_ABSENT);
    }
    /* The file system may store times in steps of 10 ms. After 20 ms, the change below certainly
     * gets a later time. */
    SDL_Delay(20);
    snprintf(card, sizeof card, "%s/pcmC0D0p", cards);
    fclose(fopen(card, "w"));
    assert_int_equal(device.ops->open(device.self), HAL_OK);
    unlink(card);
    rmdir(cards);
}

static void test_a_sound_server_started_later_is_used_within_ten_seconds(void **state)
{
    (void)state;
    audio.cards = "/nonexistent";
    setenv("SDL_AUDIODRIVER", "nonesuch", 1);
    const struct hal_audio device = audio_device(&audio);
    assert_int_equal(device.ops->open(device.self), HAL_ERR_ABSENT);
    setenv("SDL_AUDIODRIVER", "dummy", 1);
    assert_int_equal(device.ops->open(device.self), HAL_ERR_ABSENT);
    audio.tried_ns -= AUDIO_TRY_S * 1000000000ull; /* Moves the last attempt into the past, so that
                                                      the next attempt is due. */
    assert_int_equal(device.ops->open(device.self), HAL_OK);
}

static void test_a_sound_card_that_requests_no_data_never_blocks_a_frame(void **state)
{
    (void)state;
    setenv("SDL_AUDIODRIVER", "dummy", 1);
    const struct hal_audio device = audio_device(&audio);
    assert_int_equal(device.ops->open(device.self), HAL_OK);
    SDL_PauseAudioDevice(audio.device, 1);
    /* The device is paused, but SDL may still be running one callback that takes sounds from the
     * queue. The callback has ended after 50 ms. */
    SDL_Delay(50);
    const struct sound_event event = { .sound = SOUND_DIP, .gain = 1.0f };
    for (uint32_t i = 0; i < AUDIO_QUEUE_MAX; i++) {
        assert_int_equal(device.ops->play(device.self, &event), HAL_OK);
    }
    assert_int_equal(device.ops->play(device.self, &event), HAL_ERR_BUSY);
}

#define WITH_AUDIO(test) cmocka_unit_test_setup_teardown(test, silence_before, close_after)

int main(void)
{
    const struct CMUnitTest tests[] = {
        WITH_AUDIO(test_a_sound_reaches_the_device),
        WITH_AUDIO(test_without_a_sound_the_output_is_silent),
        WITH_AUDIO(test_a_missing_sound_device_gives_a_one_line_message),
        WITH_AUDIO(test_a_sound_card_plugged_in_later_is_opened_without_useless_attempts),
        WITH_AUDIO(test_a_sound_server_started_later_is_used_within_ten_seconds),
        WITH_AUDIO(test_a_sound_card_that_requests_no_data_never_blocks_a_frame),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
