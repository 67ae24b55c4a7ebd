/* test_synth.c -- checks that every sound is audible, does not clip, and ends. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "core/sound/recipe.h"
#include "core/sound/mixer.h"

#define SECONDS_MAX 3u
#define FRAMES_MAX (SECONDS_MAX * SOUND_RATE_HZ)

static struct mixer mixer;
static int16_t heard[2u * FRAMES_MAX];

static void play(uint8_t sound, float gain, float pan)
{
    mixer_play(&mixer, &(struct sound_event){ .sound = sound, .gain = gain, .pan = pan });
}

static int peak(const int16_t *stereo, uint32_t frame_count, uint32_t channel)
{
    int most = 0;
    for (uint32_t i = 0; i < frame_count; i++) {
        const int level = abs(stereo[2u * i + channel]);
        most = level > most ? level : most;
    }
    return most;
}

static void test_a_new_synth_is_silent(void **state)
{
    (void)state;
    mixer_init(&mixer, 1);
    mixer_render(&mixer, heard, 1000);
    assert_int_equal(peak(heard, 1000, 0), 0);
    assert_int_equal(peak(heard, 1000, 1), 0);
}

static uint32_t active_voices(void)
{
    uint32_t count = 0;
    for (uint32_t i = 0; i < SYNTH_VOICE_MAX; i++) {
        count += mixer.synth.voice[i].sound != SOUND_NONE;
    }
    return count;
}

static void test_each_sound_starts_immediately_does_not_clip_and_ends(void **state)
{
    (void)state;
    for (uint8_t sound = SOUND_NONE + 1; sound < SOUND_COUNT; sound++) {
        mixer_init(&mixer, 1);
        play(sound, 1.0f, 0.0f);
        mixer_render(&mixer, heard, FRAMES_MAX);
        /* The peak must be between -21 dB (3000) and -2 dB (26000) of full scale. */
        assert_in_range(peak(heard, FRAMES_MAX, 0), 3000, 26000);
        /* The peak of the first 50 ms must be above 1000, so that the sound starts without a
         * noticeable delay. */
        assert_true(peak(heard, SOUND_RATE_HZ / 20u, 0) > 1000);
        assert_int_equal(active_voices(), 0);
    }
}

/* If a voice ended at full amplitude, its end would be audible as a click. */
static void test_each_sound_fades_before_its_voice_is_freed(void **state)
{
    (void)state;
    for (uint8_t sound = SOUND_NONE + 1; sound < SOUND_COUNT; sound++) {
        mixer_init(&mixer, 1);
        play(sound, 1.0f, 0.0f);
        const uint32_t length =
            (uint32_t)(sound_recipes[sound].length_ms * (float)SOUND_RATE_HZ / 1000.0f);
        mixer_render(&mixer, heard, FRAMES_MAX);
        const int whole = peak(heard, FRAMES_MAX, 0);
        const int last_20_ms = peak(heard + 2u * (length - 960u), 960u, 0);
        /* The last 20 ms must be at least 34 dB quieter (a factor of 50) than the loudest part. */
        assert_true(last_20_ms * 50 < whole);
    }
}

static void test_strings_fit_their_delay_line_and_decay(void **state)
{
    (void)state;
    for (uint8_t sound = SOUND_NONE + 1; sound < SOUND_COUNT; sound++) {
        const struct sound_recipe *recipe = &sound_recipes[sound];
        if (recipe->string_hz > 0.0f) {
            assert_true((float)SOUND_RATE_HZ / recipe->string_hz <= (float)SYNTH_PLUCK_MAX);
            assert_true(recipe->string_keep > 0.0f && recipe->string_keep < 1.0f);
        }
    }
}

static void test_the_wave_does_not_depend_on_the_block_size(void **state)
{
    (void)state;
    enum { FRAMES = 4801 };
    static int16_t pieces[2 * FRAMES];
    mixer_init(&mixer, 1);
    play(SOUND_RESULT, 0.8f, 0.3f);
    mixer_render(&mixer, heard, FRAMES);

    mixer_init(&mixer, 1);
    play(SOUND_RESULT, 0.8f, 0.3f);
    uint32_t size = 1;
    for (uint32_t at = 0; at < FRAMES; at += size) {
        size = at % 97u + 1u;
        size = at + size > FRAMES ? FRAMES - at : size;
        mixer_render(&mixer, pieces + 2u * at, size);
    }
    assert_memory_equal(pieces, heard, sizeof pieces);
}

static void test_pan_moves_a_sound_between_the_ears(void **state)
{
    (void)state;
    mixer_init(&mixer, 1);
    play(SOUND_TICK, 1.0f, -1.0f);
    mixer_render(&mixer, heard, 4800);
    assert_true(peak(heard, 4800, 0) > 3000);
    assert_int_equal(peak(heard, 4800, 1), 0);
    mixer_init(&mixer, 1);
    /* The pan of 7 is clamped to 1, so the left channel must be silent. */
    play(SOUND_DIP, 1.0f, 7.0f);
    mixer_render(&mixer, heard, 4800);
    assert_int_equal(peak(heard, 4800, 0), 0);
}

static void test_many_loud_sounds_stay_inside_the_format(void **state)
{
    (void)state;
    mixer_init(&mixer, 1);
    for (uint32_t i = 0; i < 3u * SYNTH_VOICE_MAX; i++) {
        play(SOUND_START, 9.0f, 0.0f); /* The gain of 9 is clamped to 1. */
    }
    assert_int_equal(active_voices(), SYNTH_VOICE_MAX);
    mixer_render(&mixer, heard, SOUND_RATE_HZ / 10u);
    const int most = peak(heard, SOUND_RATE_HZ / 10u, 0);
    assert_in_range(most, 24000, 32000);
}

static void test_a_new_sound_replaces_the_oldest_voice(void **state)
{
    (void)state;
    mixer_init(&mixer, 1);
    play(SOUND_RESULT, 1.0f, 0.0f);
    mixer_render(&mixer, heard, 480);
    for (uint32_t i = 1; i < SYNTH_VOICE_MAX; i++) {
        play(SOUND_START, 0.1f, 0.0f);
    }
    play(SOUND_TICK, 1.0f, 0.0f);
    for (uint32_t i = 0; i < SYNTH_VOICE_MAX; i++) {
        assert_int_not_equal(mixer.synth.voice[i].sound, SOUND_RESULT);
    }
}

static void test_unknown_and_empty_sounds_are_silent(void **state)
{
    (void)state;
    mixer_init(&mixer, 1);
    play(SOUND_NONE, 1.0f, 0.0f);
    play(SOUND_COUNT, 1.0f, 0.0f);
    play(255, 1.0f, 0.0f);
    assert_int_equal(active_voices(), 0);
}

/* Returns the largest amplitude between the times `from_ms` and `to_ms`. */
static int loudest(uint32_t from_ms, uint32_t to_ms)
{
    const uint32_t per_ms = SOUND_RATE_HZ / 1000u;
    return peak(heard + 2u * from_ms * per_ms, (to_ms - from_ms) * per_ms, 0);
}

static void test_the_clappers_sound_twice(void **state)
{
    (void)state;
    mixer_init(&mixer, 1);
    play(SOUND_CALL, 1.0f, 0.0f);
    mixer_render(&mixer, heard, FRAMES_MAX);
    const int first = loudest(0, 20), between = loudest(150, 185), second = loudest(190, 215);
    assert_true(first > 6000 && second > 6000);
    assert_true(between * 10 < first);
}

/* The pea in the whistle makes the loudness rise and fall about 36 times a second. The test counts
 * the rises. */
static void test_the_umpires_whistle_flutters(void **state)
{
    (void)state;
    mixer_init(&mixer, 1);
    play(SOUND_FOUL, 1.0f, 0.0f);
    mixer_render(&mixer, heard, FRAMES_MAX);
    uint32_t flutters = 0;
    int loud = 0;
    for (uint32_t ms = 200; ms < 480u; ms++) {
        /* Largest amplitude within 15 ms before and after this time, which is about one period of
         * the flutter. */
        const int most = loudest(ms - 15u, ms + 15u), now = loudest(ms, ms + 1u);
        const int was_loud = loud;
        loud = now * 10 > most * 8 || (loud && now * 10 > most * 5);
        flutters += loud && !was_loud;
    }
    /* At 36 Hz, the 0.28 s that are measured contain ten rises. */
    assert_in_range(flutters, 9, 11);
}

static void test_two_dips_sound_slightly_different(void **state)
{
    (void)state;
    static int16_t second[2 * 4800];
    mixer_init(&mixer, 1);
    play(SOUND_DIP, 1.0f, 0.0f);
    mixer_render(&mixer, heard, 48000);
    play(SOUND_DIP, 1.0f, 0.0f);
    mixer_render(&mixer, second, 4800);
    assert_memory_not_equal(second, heard, sizeof second);
}

/* The pitches of drops that follow each other must not rise or fall steadily. Of independent
 * pitches, two of three lie above both or below both of their neighbours. */
static void test_the_pitches_of_drops_do_not_follow_each_other(void **state)
{
    (void)state;
    static int16_t wave[2u * SOUND_RATE_HZ / 5u];
    const struct sound_event drop = { SOUND_DRIP, 0.5f, 0.0f };
    float hz[60];
    uint32_t turns = 0;
    mixer_init(&mixer, 1);
    for (uint32_t i = 0; i < 60; i++) {
        mixer_play(&mixer, &drop);
        hz[i] = mixer.synth.voice[0].layer[0].hz;
        mixer_render(&mixer, wave, SOUND_RATE_HZ / 5u);
        turns += i >= 2 && (hz[i] > hz[i - 1u]) != (hz[i - 1u] > hz[i - 2u]);
    }
    assert_in_range(turns, 30, 50);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_a_new_synth_is_silent),
        cmocka_unit_test(test_each_sound_starts_immediately_does_not_clip_and_ends),
        cmocka_unit_test(test_each_sound_fades_before_its_voice_is_freed),
        cmocka_unit_test(test_strings_fit_their_delay_line_and_decay),
        cmocka_unit_test(test_the_wave_does_not_depend_on_the_block_size),
        cmocka_unit_test(test_pan_moves_a_sound_between_the_ears),
        cmocka_unit_test(test_many_loud_sounds_stay_inside_the_format),
        cmocka_unit_test(test_a_new_sound_replaces_the_oldest_voice),
        cmocka_unit_test(test_unknown_and_empty_sounds_are_silent),
        cmocka_unit_test(test_the_clappers_sound_twice),
        cmocka_unit_test(test_the_umpires_whistle_flutters),
        cmocka_unit_test(test_two_dips_sound_slightly_different),
        cmocka_unit_test(test_the_pitches_of_drops_do_not_follow_each_other),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
