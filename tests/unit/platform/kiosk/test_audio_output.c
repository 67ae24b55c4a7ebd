/* test_audio_output.c -- Tests the settings of the volumes, the quiet hours, the sound in attract
 * mode, and a sound card that is plugged in late or removed. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include <cmocka.h>

#include "drivers/sim/hal_sim.h"
#include "core/scene.h"
#include "platform/kiosk/output_devices.h"

#define S 1000000000ull

static struct output_audio voice;
static struct audio_sim sim;
static struct hal_audio audio;
static struct settings settings;
static struct output output;
static struct input input;

static int set_up(void **state)
{
    (void)state;
    memset(&voice, 0, sizeof voice);
    memset(&sim, 0, sizeof sim);
    audio = sim_audio_device(&sim);
    settings_reset(&settings);
    memset(&input, 0, sizeof input);
    memset(&output, 0, sizeof output);
    output_sound(&output, SOUND_DIP, 0.5f, 0.0f);
    return 0;
}

static uint32_t put(int is_attract, uint64_t now_ns)
{
    return output_audio_play(&voice, &audio, &output, &settings, &input, is_attract, now_ns);
}

static void test_the_volume_setting_is_a_power_law_and_zero_is_silent(void **state)
{
    (void)state;
    output_audio_open(&voice, &audio, 1 * S);
    settings.value[SET_VOLUME] = 100;
    put(0, 2 * S);
    assert_float_equal(sim.gain, 0.5f, 1e-6f);
    assert_float_equal(sim.levels.effects, 1.0f, 1e-6f);
    settings.value[SET_VOLUME] = 50;
    put(0, 2 * S);
    assert_float_equal(sim.gain, 0.5f, 1e-6f);
    assert_float_equal(sim.levels.effects, 0.25f, 1e-6f);
    settings.value[SET_VOLUME] = 0;
    put(0, 2 * S);
    assert_int_equal(sim.played[SOUND_DIP], 2);
    assert_float_equal(sim.levels.effects, 0.0f, 1e-6f);
    assert_float_equal(sim.levels.music, 0.0f, 1e-6f);
}

static void test_a_full_frame_drops_quiet_sounds_of_the_water_first(void **state)
{
    (void)state;
    memset(&output, 0, sizeof output);
    for (uint32_t i = 0; i < OUTPUT_SOUND_MAX; i++) {
        output_sound(&output, i == 3 ? SOUND_GULP : SOUND_SLAP, 0.5f, 0.0f);
    }
    output_sound(&output, SOUND_ESCAPE, 1.0f, 0.0f);
    assert_int_equal(output.sounds[3].sound, SOUND_GULP);
    output_sound(&output, SOUND_CATCH, 1.0f, 0.0f);
    assert_int_equal(output.sounds[3].sound, SOUND_CATCH);
    output_sound(&output, SOUND_TEAR, 1.0f, 0.0f);
    for (uint32_t i = 0; i < OUTPUT_SOUND_MAX; i++) {
        assert_int_not_equal(output.sounds[i].sound, SOUND_TEAR);
    }
    assert_int_equal(output.sound_count, OUTPUT_SOUND_MAX);
}

static void test_music_plays_in_a_game_and_not_in_the_operators_menu(void **state)
{
    (void)state;
    output_audio_open(&voice, &audio, 1 * S);
    settings.value[SET_VOLUME] = 100;
    output.phase = PHASE_ROUND;
    output.round_tick = 77;
    put(0, 2 * S);
    assert_float_equal(sim.levels.music, 1.0f, 1e-6f);
    assert_int_equal(sim.levels.song, 77);
    assert_false(sim.levels.is_stone_right);
    input.is_turned = 1;
    put(0, 2 * S);
    assert_true(sim.levels.is_stone_right);
    output.phase = PHASE_MENU;
    put(0, 2 * S);
    assert_float_equal(sim.levels.music, 0.0f, 1e-6f);
    assert_float_equal(sim.levels.effects, 1.0f, 1e-6f);
}

static void test_music_and_effects_have_volumes_of_their_own_and_each_can_be_silent(void **state)
{
    (void)state;
    output_audio_open(&voice, &audio, 1 * S);
    settings.value[SET_VOLUME] = 100;
    output.phase = PHASE_ROUND;
    settings.value[SET_MUSIC] = 2; /* 50 per cent */
    put(0, 2 * S);
    assert_float_equal(sim.levels.music, 0.25f, 1e-6f);
    assert_float_equal(sim.levels.ambience, 0.25f, 1e-6f);
    assert_float_equal(sim.levels.effects, 1.0f, 1e-6f);
    settings.value[SET_MUSIC] = 4;   /* silent */
    settings.value[SET_EFFECTS] = 1; /* 75 per cent */
    put(0, 2 * S);
    assert_float_equal(sim.levels.music, 0.0f, 1e-6f);
    assert_float_equal(sim.levels.effects, 0.5625f, 1e-6f);
    assert_int_equal(sim.played[SOUND_DIP], 2);
    settings.value[SET_MUSIC] = 0;
    settings.value[SET_EFFECTS] = 4;
    put(0, 2 * S);
    assert_float_equal(sim.levels.music, 1.0f, 1e-6f);
    assert_float_equal(sim.levels.effects, 0.0f, 1e-6f);
    assert_int_equal(sim.played[SOUND_DIP], 2);
}

static float effects_at(uint16_t minute, uint8_t phase)
{
    input.minute = minute;
    output.phase = phase;
    put(0, 2 * S);
    return sim.levels.effects;
}

static void test_the_quiet_hours_lower_all_sounds_except_in_the_operators_menu(void **state)
{
    (void)state;
    output_audio_open(&voice, &audio, 1 * S);
    settings.value[SET_VOLUME] = 100;
    settings.value[SET_QUIET_FROM_MIN] = 21 * 60;
    settings.value[SET_QUIET_TO_MIN] = 7 * 60;
    input.day = 20000;
    assert_float_equal(effects_at(21 * 60 - 1, PHASE_ROUND), 1.0f, 1e-6f);
    assert_float_equal(effects_at(21 * 60, PHASE_ROUND), 0.25f, 1e-6f);
    assert_float_equal(sim.levels.music, 0.25f, 1e-6f);
    assert_float_equal(effects_at(3 * 60, PHASE_ROUND), 0.25f, 1e-6f);
    assert_float_equal(effects_at(3 * 60, PHASE_MENU), 1.0f, 1e-6f);
    assert_float_equal(effects_at(7 * 60, PHASE_ROUND), 1.0f, 1e-6f);
    settings.value[SET_QUIET_VOLUME] = QUIET_VOLUME_SILENT;
    assert_float_equal(effects_at(3 * 60, PHASE_ROUND), 0.0f, 1e-6f);
    assert_float_equal(sim.levels.music, 0.0f, 1e-6f);
    /* A machine without a correct clock, and equal times, have no quiet hours. */
    input.day = 0;
    assert_float_equal(effects_at(3 * 60, PHASE_ROUND), 1.0f, 1e-6f);
    input.day = 20000;
    settings.value[SET_QUIET_TO_MIN] = 21 * 60;
    assert_float_equal(effects_at(21 * 60, PHASE_ROUND), 1.0f, 1e-6f);
}

static uint32_t heard_in_ten_shows(int32_t every)
{
    sim.played[SOUND_DIP] = 0;
    voice.attract_ns = 0;
    settings.value[SET_ATTRACT_SOUND] = every;
    for (uint64_t show = 0; show < 10; show++) {
        put(1, (100u + show * OUTPUT_AUDIO_SHOW_S) * S);
    }
    return sim.played[SOUND_DIP];
}

static void test_sound_plays_in_every_nth_attract_cycle_and_in_every_game(void **state)
{
    (void)state;
    output_audio_open(&voice, &audio, 1 * S);
    assert_int_equal(heard_in_ten_shows(0), 0);
    assert_int_equal(heard_in_ten_shows(1), 10);
    assert_int_equal(heard_in_ten_shows(3), 4);
    assert_int_equal(heard_in_ten_shows(10), 1);
    settings.value[SET_ATTRACT_SOUND] = 0;
    put(0, 2000 * S);
    assert_int_equal(sim.played[SOUND_DIP], 2);
}

static void test_a_sound_card_plugged_in_after_the_start_is_used(void **state)
{
    (void)state;
    sim.gone = 1;
    output_audio_open(&voice, &audio, 10 * S);
    for (uint64_t ms = 0; ms < 3000; ms += 10) {
        /* put() returns the number of faults, and a missing sound card is not a fault. */
        assert_int_equal(put(0, 10 * S + ms * 1000000ull), 0);
    }
    assert_in_range(sim.open_count, 3, 4);
    sim.gone = 0;
    put(0, 14 * S);
    assert_int_equal(sim.played[SOUND_DIP], 1);
}

static void test_a_silent_attract_mode_retries_the_sound_card(void **state)
{
    (void)state;
    settings.value[SET_ATTRACT_SOUND] = 0;
    sim.gone = 1;
    output_audio_open(&voice, &audio, 10 * S);
    sim.gone = 0;
    put(1, 12 * S);
    assert_int_equal(sim.open_count, 2);
    assert_int_equal(voice.retry_ns, 0);
}

static void test_a_removed_sound_card_is_counted_as_one_fault(void **state)
{
    (void)state;
    output_audio_open(&voice, &audio, 10 * S);
    output_sound(&output, SOUND_DIP, 0.5f, 0.0f);
    sim.gone = 1;
    assert_int_equal(put(0, 11 * S), 1);
    assert_int_equal(put(0, 11 * S + S / 2), 0);
    assert_int_equal(put(0, 13 * S), 0);
    sim.gone = 0;
    put(0, 15 * S);
    assert_int_equal(sim.played[SOUND_DIP], 2);
}

#define TEST(test) cmocka_unit_test_setup(test, set_up)

int main(void)
{
    const struct CMUnitTest tests[] = {
        TEST(test_a_full_frame_drops_quiet_sounds_of_the_water_first),
        TEST(test_the_volume_setting_is_a_power_law_and_zero_is_silent),
        TEST(test_music_plays_in_a_game_and_not_in_the_operators_menu),
        TEST(test_music_and_effects_have_volumes_of_their_own_and_each_can_be_silent),
        TEST(test_the_quiet_hours_lower_all_sounds_except_in_the_operators_menu),
        TEST(test_sound_plays_in_every_nth_attract_cycle_and_in_every_game),
        TEST(test_a_sound_card_plugged_in_after_the_start_is_used),
        TEST(test_a_silent_attract_mode_retries_the_sound_card),
        TEST(test_a_removed_sound_card_is_counted_as_one_fault),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
