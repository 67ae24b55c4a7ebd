/* test_fish_sounds.c -- checks that each sound of a fish at the surface has its cause: a gulp of
 * air, or an escape close below the surface. */
#include "core/game/phases.h"
#include "core/tank/behavior/surface_breathing.h"
#include "tests/unit/support/core_fixture.h"

/* Oxygen in mg/L at which fish breathe at the surface, and at which no fish does. */
#define STALE_MG_L 1.0f
#define FRESH_MG_L 8.0f
/* Depth in heights of a fish above which its escape splashes, as in core.c. */
#define SPLASH_DEPTH 1.2f

static int open_attract(void **state)
{
    (void)state;
    const struct core_config config = { .seed = 3, .fish_count = 300, .round_s = 60 };
    open_core(&config);
    return 0;
}

/* Returns the number of fish that have the gait `gait`, swim at most `depth` of their heights below
 * the surface, and lie at the position `pan` of a sound. */
static uint32_t causes(uint8_t gait, float depth, float pan)
{
    const struct tank *tank = &core.world.tank;
    uint32_t count = 0;
    for (uint32_t i = 0; i < tank->fish_count; i++) {
        const struct fish *fish = &tank->fish[i];
        /* The player at a portrait screen looks along -x. */
        const float fish_pan = input.is_turned ? -2.0f * fish->position_m.z / tank->size_m.z
                                               : 2.0f * fish->position_m.x / tank->size_m.x;
        count += fish->gait == gait && fish->position_m.y > -depth * fish->height_m &&
                 f_abs(f_clamp(fish_pan, -1.0f, 1.0f) - pan) < 1e-6f;
    }
    return count;
}

/* Runs `tick_count` ticks and checks the cause of each sound of kind `sound`. Returns the number of
 * these sounds. */
static uint32_t count_caused(enum sound sound, uint8_t gait, float depth, uint32_t tick_count)
{
    uint32_t count = 0;
    for (uint32_t i = 0; i < tick_count; i++) {
        tick();
        for (uint32_t k = 0; k < output.sound_count; k++) {
            if (output.sounds[k].sound == sound) {
                assert_true(causes(gait, depth, output.sounds[k].pan) > 0);
                count++;
            }
        }
    }
    return count;
}

static void test_fish_gulp_only_at_the_surface_of_stale_water(void **state)
{
    (void)state;
    core.world.tank.oxygen.dissolved_mg_l = FRESH_MG_L;
    ticks(10u * CORE_TICK_HZ);
    assert_int_equal(sounds[SOUND_GULP], 0);
    core.world.tank.oxygen.dissolved_mg_l = STALE_MG_L;
    for (uint8_t is_turned = 0; is_turned < 2; is_turned++) {
        input.is_turned = is_turned;
        assert_true(count_caused(SOUND_GULP, GAIT_SURFACE, 1.5f, 20u * CORE_TICK_HZ) > 10);
    }
}

/* Returns the number of fish that began to escape less than 0.2 s ago at more than `depth` of their
 * heights below the surface. */
static uint32_t deep_escapes(float depth)
{
    const struct tank *tank = &core.world.tank;
    uint32_t count = 0;
    for (uint32_t i = 0; i < tank->fish_count; i++) {
        const struct fish *fish = &tank->fish[i];
        count += fish->gait == GAIT_ESCAPE && fish->escape_s < 0.2f &&
                 fish->position_m.y < -depth * fish->height_m;
    }
    return count;
}

static void test_an_escape_splashes_only_close_below_the_surface(void **state)
{
    (void)state;
    uint32_t deep = 0, splashes = 0;
    for (uint32_t i = 0; i < 12; i++) {
        const float x_m = -0.3f + 0.05f * (float)i;
        input.is_turned = i % 2u;
        hold(0, v3(x_m, ABOVE_M, 0.0f));
        ticks(30);
        hold(0, v3(x_m, BELOW_M, 0.0f));
        for (uint32_t k = 0; k < 5; k++) {
            splashes += count_caused(SOUND_ESCAPE, GAIT_ESCAPE, SPLASH_DEPTH, 20);
            deep += deep_escapes(2.0f * SPLASH_DEPTH);
        }
    }
    assert_true(splashes > 0);
    assert_true(deep > 0);
    assert_int_equal(sounds[SOUND_ESCAPE], splashes);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup(test_fish_gulp_only_at_the_surface_of_stale_water, open_attract),
        cmocka_unit_test_setup(test_an_escape_splashes_only_close_below_the_surface, open_attract),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
