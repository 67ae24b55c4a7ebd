/* test_creak.c -- checks that wet paper creaks audibly while its load rises, and is silent at
 * rest. The sounds of a real poi are synthesised as for the loudspeaker. */
#include "tests/unit/support/poi_fixture.h"

#include <math.h>

#include "core/sound/mixer.h"

#define FRAMES_PER_TICK (SOUND_RATE_HZ / CORE_TICK_HZ)
/* Band-pass filter for the crackles of the creak, which are between 1,500 and 2,400 Hz. */
#define BAND_HZ 1900.0
#define BAND_DAMPING 0.4

static struct poi_fixture fixture;
static struct mixer mixer;

/* Sound of a part of the motion. */
struct part {
    /* Root mean square of all sounds (`rms`), and of the sounds in the band of the creak
     * (`band_rms`). 1 is full scale. */
    double rms, band_rms;
    float warning;   /* Largest result of sheet_warning() during the motion. */
    uint32_t creaks; /* Number of creaks that began. */
};

/* Moves the poi at `speed_m_s` to `to_m`, and then waits for `wait_s`. */
static struct part hear(vec3 to_m, float speed_m_s, float wait_s)
{
    const vec3 from_m = fixture.hand.position_m, way_m = v3_sub(to_m, from_m);
    const uint32_t moves = (uint32_t)(v3_length(way_m) / speed_m_s * (float)CORE_TICK_HZ) + 1u;
    const uint32_t ticks = moves + (uint32_t)(wait_s * (float)CORE_TICK_HZ);
    const double tune = 2.0 * sin(3.14159265358979 * BAND_HZ / SOUND_RATE_HZ);
    double sum = 0.0, band_sum = 0.0, low = 0.0, band = 0.0;
    struct part part = { 0 };
    for (uint32_t i = 1; i <= ticks; i++) {
        int16_t wave[2u * FRAMES_PER_TICK];
        fixture.hand.position_m = v3_muladd(from_m, way_m, f_min((float)i / (float)moves, 1.0f));
        fixture_tick(&fixture);
        part.warning = f_max(part.warning, sheet_warning(&fixture.poi.sheet));
        for (uint32_t k = 0; k < fixture.output.sound_count; k++) {
            mixer_play(&mixer, &fixture.output.sounds[k]);
            part.creaks += fixture.output.sounds[k].sound == SOUND_CREAK;
        }
        mixer_render(&mixer, wave, FRAMES_PER_TICK);
        for (uint32_t k = 0; k < FRAMES_PER_TICK; k++) {
            const double sample = (double)wave[2u * k] / 32768.0;
            low += tune * band;
            band += tune * (sample - low - BAND_DAMPING * band);
            sum += sample * sample;
            band_sum += band * band;
        }
    }
    part.rms = sqrt(sum / (double)(ticks * FRAMES_PER_TICK));
    part.band_rms = sqrt(band_sum / (double)(ticks * FRAMES_PER_TICK));
    return part;
}

/* Sweeps the paper through the water, broadside. */
static struct part sweep(float to_x_m, float speed_m_s)
{
    return hear(v3(to_x_m, -0.06f, -0.12f), speed_m_s, 0.0f);
}

static void test_the_creak_is_heard_while_the_load_rises_and_not_at_rest(void **state)
{
    (void)state;
    fixture_init(&fixture, 6, 3);
    mixer_init(&mixer, 1);
    const struct part air = hear(fixture.hand.position_m, 0.1f, 2.0f);
    assert_true(air.rms < 1e-6);
    fixture.hand.angles.roll_rad = 1.2f;
    const struct part dip = hear(v3(0.0f, -0.06f, -0.12f), 0.1f, 2.0f);
    assert_int_equal(dip.creaks, 0);
    const struct part rest = hear(fixture.hand.position_m, 0.1f, 2.0f);
    const struct part slow = sweep(-0.35f, 0.20f);
    assert_true(rest.rms < 1e-6 && slow.rms < 1e-6);
    const struct part fast = sweep(0.35f, 0.48f), faster = sweep(-0.35f, 0.52f);
    print_message("band of the creak: dip %.1f dB, fast %.1f dB, faster %.1f dB of full scale\n",
                  20.0 * log10(dip.band_rms), 20.0 * log10(fast.band_rms + 1e-9),
                  20.0 * log10(faster.band_rms + 1e-9));
    assert_int_equal(fixture.poi.sheet.paper_cells, fixture.poi.sheet.paper_cells_new);
    assert_true(fast.warning > 0.3f && faster.warning > fast.warning);
    /* The creak is at least as loud in its band as the splash of the dip. */
    assert_true(fast.creaks > 0 && fast.band_rms > dip.band_rms);
    assert_true(faster.creaks >= fast.creaks && faster.band_rms > fast.band_rms);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_the_creak_is_heard_while_the_load_rises_and_not_at_rest),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
