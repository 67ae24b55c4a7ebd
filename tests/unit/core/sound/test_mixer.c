/* test_mixer.c -- checks the mix of a round: loudness, peak, ducking, the limiter, and a hash of
 * the samples that is the same on every platform. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include <cmocka.h>

#include "core/base/hash.h"
#include "core/sound/mixer.h"
#include "core/sound/recipe.h"
#include "tests/unit/core/sound/loudness.h"
#include "tests/unit/core/sound/sound_round.h"

#define FRAMES_PER_TICK (SOUND_RATE_HZ / CORE_TICK_HZ)
#define FRAMES_MAX (SOUND_ROUND_TICKS_MAX * FRAMES_PER_TICK)

static const struct sound_levels full = { 1.0f, 1.0f, 1.0f, 0, true, false };
static struct mixer mixer;
static struct sound_round played;
static int16_t heard[2u * FRAMES_MAX];

/* Renders `seconds` of the mixer without effects. Returns the number of frames. */
static uint32_t render_bed(const struct sound_levels *levels, uint32_t seed, uint32_t seconds)
{
    mixer_init(&mixer, seed);
    mixer_set_levels(&mixer, levels);
    mixer_render(&mixer, heard, seconds * SOUND_RATE_HZ);
    return seconds * SOUND_RATE_HZ;
}

static uint32_t render_round(uint32_t players, uint32_t seed)
{
    uint32_t next = 0;
    assert_int_equal(sound_round_play(&played, players, seed), 0);
    mixer_init(&mixer, 1);
    mixer_set_levels(&mixer, &full);
    for (uint32_t tick = 0; tick < played.ticks; tick++) {
        while (next < played.count && played.events[next].tick == tick) {
            mixer_play(&mixer, &played.events[next++].event);
        }
        mixer_render(&mixer, heard + 2u * FRAMES_PER_TICK * tick, FRAMES_PER_TICK);
    }
    return played.ticks * FRAMES_PER_TICK;
}

static void write_u32(FILE *file, uint32_t value)
{
    for (uint32_t i = 0; i < 4u; i++) {
        fputc((int)(value >> 8u * i & 255u), file);
    }
}

/* Reads a number from the last line of ffmpeg's report that contains `label`. */
static double ffmpeg_number(const char *wav, const char *label)
{
    char command[256], line[256];
    double value = NAN;
    snprintf(command, sizeof command,
             "ffmpeg -hide_banner -nostats -nostdin -i %s -af ebur128=peak=true -f null - 2>&1",
             wav);
    FILE *pipe = popen(command, "r");
    assert_non_null(pipe);
    while (fgets(line, sizeof line, pipe)) {
        const char *at = strstr(line, label);
        value = at ? strtod(at + strlen(label), NULL) : value;
    }
    pclose(pipe);
    return value;
}

/* Writes `frames` frames of `heard` to `file` as a WAV file, and closes the file. */
static void write_wav(FILE *file, uint32_t frames)
{
    assert_non_null(file);
    fwrite("RIFF", 1, 4, file);
    write_u32(file, 4u * frames + 36u);
    fwrite("WAVEfmt ", 1, 8, file);
    write_u32(file, 16u);
    write_u32(file, 0x00020001u); /* PCM with two channels. */
    write_u32(file, SOUND_RATE_HZ);
    write_u32(file, 4u * SOUND_RATE_HZ);
    write_u32(file, 0x00100004u); /* Four bytes in a frame, 16 bits in a sample. */
    fwrite("data", 1, 4, file);
    write_u32(file, 4u * frames);
    fwrite(heard, 4, frames, file);
    fclose(file);
}

/* Asserts that ffmpeg, an independent judge of our meter, measures the same loudness and the same
 * true peak. */
static void assert_ffmpeg_agrees(uint32_t frames, double lufs, double peak)
{
    char path[] = "/tmp/kingyo-mix-XXXXXX";
    write_wav(fdopen(mkstemp(path), "wb"), frames);
    const double their_lufs = ffmpeg_number(path, "I:"), their_peak = ffmpeg_number(path, "Peak:");
    unlink(path);
    print_message("%.2f LUFS, %.2f dBTP; ffmpeg %.1f LUFS, %.1f dBTP\n", lufs, peak, their_lufs,
                  their_peak);
    assert_true(fabs(their_lufs - lufs) < 0.3);
    assert_true(fabs(their_peak - peak) < 0.3);
}

/* Renders rounds of one player and of four players with two seeds. The rounds of four players have
 * most effects. ffmpeg repeats the measurement where it is installed. */
static void test_a_round_has_about_minus_18_lufs_and_no_silence(void **state)
{
    (void)state;
    static const uint32_t rounds[3][2] = { { 1, 1 }, { POI_MAX, 1 }, { POI_MAX, 2 } };
    const bool has_ffmpeg = system("command -v ffmpeg >/dev/null 2>&1") == 0;
    for (uint32_t i = 0; i < 3; i++) {
        const uint32_t frames = render_round(rounds[i][0], rounds[i][1]);
        const double lufs = loudness_integrated(heard, frames);
        const double peak = loudness_true_peak(heard, frames);
        assert_true(lufs > -19.5 && lufs < -16.5);
        assert_true(peak < -1.0);
        assert_true(loudness_silence(heard, frames) < 0.01);
        /* Small loudspeakers do not render low frequencies. */
        assert_true(loudness_energy_below(heard, frames, 250.0) <
                    0.25 * loudness_energy_below(heard, frames, 0.0));
        if (has_ffmpeg) {
            assert_ffmpeg_agrees(frames, lufs, peak);
        }
    }
}

/* Every platform and every compiler renders the same samples. The constant changes only if the
 * sound changes on purpose. */
static void test_the_samples_have_the_known_hash(void **state)
{
    (void)state;
    mixer_init(&mixer, 7);
    mixer_set_levels(&mixer, &full);
    for (uint32_t second = 0; second < 40u; second++) {
        const uint8_t sound = (uint8_t)(1u + second % (SOUND_COUNT - 1u));
        mixer_play(&mixer, &(struct sound_event){ sound, 0.7f, 0.05f * (float)second - 1.0f });
        mixer_render(&mixer, heard + 2u * second * SOUND_RATE_HZ, SOUND_RATE_HZ);
    }
    uint64_t hash = HASH_START;
    for (uint32_t i = 0; i < 40u * SOUND_RATE_HZ; i++) {
        const uint32_t left = (uint16_t)heard[2u * i], right = (uint16_t)heard[2u * i + 1u];
        hash = hash_u32(hash, left | right << 16);
    }
    assert_true(hash == 0x7f70b8626f59c637u);
}

static void test_the_music_differs_with_the_seed_and_starts_anew_with_a_new_song(void **state)
{
    (void)state;
    static int16_t first[2u * SOUND_RATE_HZ * 10u];
    struct sound_levels levels = { .music = 1.0f };
    render_bed(&levels, 0, 10);
    memcpy(first, heard, sizeof first);
    render_bed(&levels, 5, 10);
    assert_memory_not_equal(first, heard, sizeof first);
    levels.song = 5;
    mixer_set_levels(&mixer, &levels);
    assert_int_equal(mixer.music.step, 0);
    assert_int_equal(mixer.music.part, 0);
    assert_int_equal(mixer.music.seed, 5);
}

/* Returns the power of the music in a tenth of a second. */
static double power(const int16_t *stereo, uint32_t frame_count)
{
    return loudness_energy_below(stereo, frame_count, 0.0) / frame_count;
}

static void test_a_loud_effect_lowers_the_music_and_the_music_returns(void **state)
{
    (void)state;
    mixer_init(&mixer, 1);
    mixer_set_levels(&mixer, &full);
    mixer_render(&mixer, heard, SOUND_RATE_HZ);
    assert_true(mixer.duck > 0.99f);
    mixer_play(&mixer, &(struct sound_event){ SOUND_START, 1.0f, 0.0f });
    mixer_render(&mixer, heard, SOUND_RATE_HZ / 10u);
    assert_true(mixer.duck < 0.7f);
    mixer_render(&mixer, heard, 2u * SOUND_RATE_HZ);
    assert_true(mixer.duck > 0.97f);
}

static void test_levels_are_separate_and_zero_is_digital_silence(void **state)
{
    (void)state;
    const struct sound_levels none = { 0 };
    struct sound_levels music = { .music = 1.0f };
    assert_true(loudness_silence(heard, render_bed(&none, 1, 2)) == 1.0);
    const uint32_t frames = render_bed(&music, 1, 10);
    const double loud = power(heard, frames);
    music.music = 0.5f;
    render_bed(&music, 1, 10);
    assert_true(fabs(power(heard, frames) / loud - 0.25) < 0.02);
    const struct sound_levels effects = { .effects = 1.0f };
    mixer_init(&mixer, 1);
    mixer_set_levels(&mixer, &music);
    mixer_render(&mixer, heard, SOUND_RATE_HZ);
    mixer_set_levels(&mixer, &effects);
    mixer_render(&mixer, heard, SOUND_RATE_HZ);
    mixer_render(&mixer, heard, SOUND_RATE_HZ);
    assert_true(loudness_silence(heard, SOUND_RATE_HZ) == 1.0);
}

static void test_the_loudest_sounds_together_stay_below_the_true_peak(void **state)
{
    (void)state;
    mixer_init(&mixer, 1);
    mixer_set_levels(&mixer, &full);
    for (uint32_t i = 0; i < 30u; i++) {
        for (uint8_t sound = 1; sound < SOUND_COUNT; sound++) {
            mixer_play(&mixer, &(struct sound_event){ sound, 1.0f, 0.0f });
        }
        mixer_render(&mixer, heard + 2u * i * SOUND_RATE_HZ / 10u, SOUND_RATE_HZ / 10u);
    }
    const double peak = loudness_true_peak(heard, 3u * SOUND_RATE_HZ);
    assert_true(peak < -1.0 && peak > -3.0);
}

static void test_calls_and_repeated_sounds_follow_their_recipes(void **state)
{
    (void)state;
    const struct sound_event call = { SOUND_WELCOME, 1.0f, 0.0f };
    const struct sound_event gulp = { SOUND_GULP, 1.0f, 0.0f };
    mixer_init(&mixer, 1);
    mixer_play(&mixer, &call);
    assert_int_equal(mixer.synth.call[0].call, VOCAL_WELCOME);
    mixer_render(&mixer, heard, 2u * SOUND_RATE_HZ);
    assert_int_equal(mixer.synth.call[0].call, VOCAL_NONE);
    mixer_play(&mixer, &gulp);
    mixer_render(&mixer, heard, SOUND_RATE_HZ / 10u);
    mixer_play(&mixer, &gulp);
    assert_int_equal(mixer.synth.played, 2);
    mixer_render(&mixer, heard, SOUND_RATE_HZ / 5u);
    mixer_play(&mixer, &gulp);
    assert_int_equal(mixer.synth.played, 3);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_a_round_has_about_minus_18_lufs_and_no_silence),
        cmocka_unit_test(test_the_samples_have_the_known_hash),
        cmocka_unit_test(test_the_music_differs_with_the_seed_and_starts_anew_with_a_new_song),
        cmocka_unit_test(test_a_loud_effect_lowers_the_music_and_the_music_returns),
        cmocka_unit_test(test_levels_are_separate_and_zero_is_digital_silence),
        cmocka_unit_test(test_the_loudest_sounds_together_stay_below_the_true_peak),
        cmocka_unit_test(test_calls_and_repeated_sounds_follow_their_recipes),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
