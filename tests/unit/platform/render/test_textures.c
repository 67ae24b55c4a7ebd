/* test_textures.c -- Tests how frequent the patterns and colours of goldfish are. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "core/base/rng.h"
#include "platform/render/fish_colours.h"
#include "platform/render/textures.h"

#define FISH_COUNT 10000u
#define PLAIN_LAYERS 3.0f /* Layers that are all red or have a pale belly. */

static uint32_t look_of(uint32_t index)
{
    return rng_u32((struct rng_key){ 1, 0, index, RNG_FISH_LOOK });
}

static void test_twelve_of_sixteen_fish_are_plain_and_one_is_black(void **state)
{
    (void)state;
    uint32_t plain = 0;
    uint32_t black = 0;
    for (uint32_t i = 0; i < FISH_COUNT; i++) {
        const uint32_t look = look_of(i);
        const uint32_t is_black = textures_hue(look) > 1.0f;
        black += is_black;
        plain += !is_black && textures_pattern(look) < PLAIN_LAYERS;
    }
    assert_in_range(plain, FISH_COUNT * 73u / 100u, FISH_COUNT * 77u / 100u);
    assert_in_range(black, FISH_COUNT * 5u / 100u, FISH_COUNT * 8u / 100u);
}

static void test_a_black_fish_is_dark_at_the_back_and_bronze_when_young(void **state)
{
    (void)state;
    struct fish_colours black, red, young, young_red;
    fish_colours_compute(&black, 1.0f, 1.5f, 1.0f);
    fish_colours_compute(&red, 1.0f, 0.5f, 1.0f);
    fish_colours_compute(&young, 0.0f, 1.5f, 1.0f);
    fish_colours_compute(&young_red, 0.0f, 0.5f, 1.0f);
    assert_true(black.stain_back[0] < 0.1f && red.stain_back[0] > 0.9f);
    assert_float_equal(young.stain_back[0], young_red.stain_back[0], 1e-6f);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_twelve_of_sixteen_fish_are_plain_and_one_is_black),
        cmocka_unit_test(test_a_black_fish_is_dark_at_the_back_and_bronze_when_young),
    };
    return cmocka_run_group_tests_name("textures", tests, NULL, NULL);
}
