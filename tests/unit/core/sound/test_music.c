/* test_music.c -- checks the score and its player: lengths, pitches, the swing, and the strokes. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include <cmocka.h>

#include "core/sound/music.h"

static uint32_t hex(char c)
{
    return (uint32_t)(c <= '9' ? c - '0' : c - 'A' + 10);
}

static void check_melody(const char *melody, const char *scale)
{
    uint32_t steps = 0;
    for (; melody[0] != '\0'; melody += 2) {
        const float hz = music_hz(melody[0]);
        assert_true(melody[0] == '-' || strchr(scale, melody[0]) != NULL);
        assert_true(hz == 0.0f || (hz > 580.0f && hz < 2000.0f));
        steps += hex(melody[1]);
    }
    assert_int_equal(steps, SCORE_STEPS_PER_PHRASE);
}

static bool is_in_scale(const char *scale, float hz)
{
    bool is_in = false;
    for (; *scale != '\0'; scale++) {
        is_in |= f_abs(music_hz(*scale) - hz) < 0.1f;
    }
    return is_in;
}

/* Each grace note and each tap must be the neighbour of its note in the scale of the part. */
static void test_the_ornaments_stay_in_the_scale(void **state)
{
    (void)state;
    static struct music music;
    uint32_t graces = 0, taps = 0;
    music_init(&music, 4);
    while (music.part < SCORE_PARTS) {
        float mix[2u * SOUND_BLOCK] = { 0 };
        const char *const scale = score_parts[music.part].scale;
        music_render(&music, mix);
        const struct flute *const flute = &music.flute[0];
        if (flute->age_blocks == 1u && music.part < SCORE_PARTS) {
            const float other_hz = flute->goal_hz * flute->other;
            const bool is_grace = flute->ornament == FLUTE_GRACE;
            const bool is_tap = flute->ornament == FLUTE_TAP;
            assert_true(!is_grace || flute->other >= 1.0f);
            assert_true(!is_tap || flute->other <= 1.0f);
            assert_true(is_in_scale(scale, flute->goal_hz) && is_in_scale(scale, other_hz));
            graces += is_grace;
            taps += is_tap;
        }
    }
    assert_true(graces > 20u && taps > 10u);
}

static void check_bar(const struct score_bar *bar)
{
    assert_int_equal(strlen(bar->taiko), SCORE_STEPS_PER_BAR);
    assert_int_equal(strlen(bar->shime), SCORE_STEPS_PER_BAR);
    assert_int_equal(strlen(bar->bell), SCORE_STEPS_PER_BAR);
    assert_int_equal(strspn(bar->taiko, "DdK."), SCORE_STEPS_PER_BAR);
    assert_int_equal(strspn(bar->shime, "TtR."), SCORE_STEPS_PER_BAR);
    assert_int_equal(strspn(bar->bell, "Cc."), SCORE_STEPS_PER_BAR);
}

static void test_each_phrase_and_each_bar_has_its_full_length(void **state)
{
    (void)state;
    for (uint32_t p = 0; p < SCORE_PARTS; p++) {
        const struct score_part *part = &score_parts[p];
        assert_true(part->phrases > 0 && part->melody_count > 0 && part->close_count > 0);
        for (uint32_t i = 0; i < part->melody_count; i++) {
            check_melody(part->melody[i], part->scale);
        }
        for (uint32_t i = 0; i < part->close_count; i++) {
            check_melody(part->close[i], part->scale);
        }
        for (uint32_t i = 0; i < part->bar_count; i++) {
            check_bar(&part->bar[i]);
        }
        check_bar(&part->fill);
    }
}

static uint32_t blocks(float seconds)
{
    return (uint32_t)(seconds * SOUND_BLOCKS_PER_S);
}

/* Plays the music and hashes its decisions: the pitches of the flute. */
static uint32_t pitches(struct music *music, float seconds)
{
    float mix[2u * SOUND_BLOCK], last = 0.0f;
    uint32_t hash = 0;
    for (uint32_t i = 0; i < blocks(seconds); i++) {
        memset(mix, 0, sizeof mix);
        music_render(music, mix);
        if (music->flute[0].goal_hz != last) {
            last = music->flute[0].goal_hz;
            hash = hash * 31u + (uint32_t)last;
        }
    }
    return hash;
}

static void test_seeds_choose_different_phrases_and_a_seed_always_the_same(void **state)
{
    (void)state;
    static struct music music;
    uint32_t different = 0;
    music_init(&music, 1);
    const uint32_t first = pitches(&music, 20.0f);
    for (uint32_t seed = 2; seed < 8u; seed++) {
        music_init(&music, seed);
        different += pitches(&music, 20.0f) != first;
    }
    music_init(&music, 1);
    assert_int_equal(pitches(&music, 20.0f), first);
    assert_in_range(different, 5, 6);
}

static void test_the_form_repeats_with_other_variants(void **state)
{
    (void)state;
    static struct music music;
    uint32_t first = 0;
    music_init(&music, 3);
    for (uint32_t pass = 0; pass < 2u; pass++) {
        const uint32_t begin = music.part;
        while (music.part == begin) {
            pitches(&music, 0.1f);
        }
        const uint32_t theme = pitches(&music, 12.0f);
        assert_int_not_equal(theme, first);
        first = theme;
        while (music.part % SCORE_PARTS != 0) {
            pitches(&music, 0.1f);
        }
    }
    assert_int_equal(music.part, 2u * SCORE_PARTS);
}

static void test_a_stroke_decays_and_frees_its_place(void **state)
{
    (void)state;
    for (uint8_t kind = DRUM_NONE + 1; kind < DRUM_KIND_COUNT; kind++) {
        static struct drums drums;
        memset(&drums, 0, sizeof drums);
        drum_strike(&drums, kind, 1.0f, 3);
        float mix[2u * SOUND_BLOCK], loudest = 0.0f;
        for (uint32_t i = 0; i < blocks(4.0f); i++) {
            memset(mix, 0, sizeof mix);
            drum_render(&drums, mix);
            for (uint32_t k = 0; k < 2u * SOUND_BLOCK; k++) {
                loudest = f_max(loudest, f_abs(mix[k]));
                assert_true(i >= 3u || mix[k] == 0.0f);
            }
        }
        assert_true(loudest > 0.1f && loudest < 3.0f);
        assert_int_equal(drums.stroke[0].kind, DRUM_NONE);
    }
}

/* The flute must have the pitch of its note. The test counts the periods of one second. */
static void test_the_flute_has_the_pitch_of_its_note(void **state)
{
    (void)state;
    static struct flute flute;
    flute = (struct flute){ .noise = 1 };
    flute_play(&flute, 880.0f, 0.3f, blocks(2.0f), FLUTE_PLAIN, 880.0f);
    float mix[2u * SOUND_BLOCK], last = 0.0f;
    uint32_t rises = 0;
    for (uint32_t i = 0; i < blocks(1.5f); i++) {
        memset(mix, 0, sizeof mix);
        flute_render(&flute, tone_pan(0.0f), mix);
        if (i >= blocks(0.5f)) {
            rises += last < 0.0f && flute.wave.y >= 0.0f;
        }
        last = flute.wave.y;
    }
    /* A block has 0.59 periods, so the rises between blocks alias to 880 - 1500 = -620 Hz. */
    assert_in_range(rises, 605, 635);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_each_phrase_and_each_bar_has_its_full_length),
        cmocka_unit_test(test_seeds_choose_different_phrases_and_a_seed_always_the_same),
        cmocka_unit_test(test_the_form_repeats_with_other_variants),
        cmocka_unit_test(test_the_ornaments_stay_in_the_scale),
        cmocka_unit_test(test_a_stroke_decays_and_frees_its_place),
        cmocka_unit_test(test_the_flute_has_the_pitch_of_its_note),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
