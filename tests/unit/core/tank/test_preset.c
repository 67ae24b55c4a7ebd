/* test_preset.c -- checks that every preset of a tank can be played: it must have room for bowls
 * and fish, and its camera must show the whole tank. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "core/morph/morph.h"
#include "core/poi/bowl/bowl.h"
#include "core/tank/collision/narrow_phase.h"
#include "core/tank/preset.h"

static void test_the_festival_preset_has_the_documented_values(void **state)
{
    (void)state;
    const struct tank_preset *preset = tank_preset(TANK_PRESET_FESTIVAL);
    assert_string_equal(preset->name, "festival");
    assert_float_equal(preset->size_m.x, 0.85f, 1e-6f);
    assert_float_equal(preset->size_m.z, 0.55f, 1e-6f);
    assert_true(preset->wall_height_m > preset->size_m.y);
    assert_int_equal(preset->fish_count, 300);
}

static void test_the_ages_of_the_festival_give_fish_of_3_to_8_cm(void **state)
{
    (void)state;
    const struct tank_preset *preset = tank_preset(TANK_PRESET_FESTIVAL);
    assert_float_equal(growth_length_m(&species_wakin.card.growth, preset->age_days_min), 0.033f,
                       0.003f);
    assert_float_equal(growth_length_m(&species_wakin.card.growth, preset->age_days_max), 0.080f,
                       0.003f);
}

static void test_four_bowls_float_inside_each_tank_and_apart(void **state)
{
    (void)state;
    for (uint8_t id = 0; id < TANK_PRESET_COUNT; id++) {
        const struct tank_preset *preset = tank_preset(id);
        const float radius_m = preset->bowl_radius_m;
        /* The preset computes the places of the bowls for this radius, which must equal the radius
         * of the simulated bowl. */
        assert_float_equal(radius_m, BOWL_RADIUS_M, 0.0f);
        for (uint32_t i = 0; i < POI_MAX; i++) {
            assert_true(f_abs(preset->bowl_m[i].x) + radius_m < 0.5f * preset->size_m.x);
            assert_true(f_abs(preset->bowl_m[i].z) + radius_m < 0.5f * preset->size_m.z);
            /* Between any two bowls there must be a gap of at least 4 cm, so that a fish can
             * pass. */
            for (uint32_t k = 0; k < i; k++) {
                const vec3 apart_m = v3_sub(preset->bowl_m[i], preset->bowl_m[k]);
                assert_true(v3_length(apart_m) > 2.0f * radius_m + 0.04f);
            }
        }
        /* At least 40 % of the depth must be free below a bowl, so that fish can pass below it. */
        assert_true(BOWL_DEPTH_M < 0.6f * preset->size_m.y);
    }
}

/* Returns the position of a point on the screen. Points with x and y from -1 to 1 are visible. */
static vec3 on_screen(const struct view *view, float aspect, vec3 point_m)
{
    const struct basis axes = view_basis(view);
    const vec3 p = vec_basis_to_body(&axes, v3_sub(point_m, view->eye_m));
    const float tan_y = view_half_height_tan(view, aspect);
    return v3(p.x / (-p.z * tan_y * aspect), p.y / (-p.z * tan_y), -p.z);
}

static void check_fits(uint8_t id, float aspect)
{
    const struct tank_preset *preset = tank_preset(id);
    const float rim_m = preset->wall_height_m - preset->size_m.y;
    float widest = 0.0f;
    for (int corner = 0; corner < 4; corner++) {
        const float x = (corner & 1 ? 0.5f : -0.5f) * preset->size_m.x;
        const float z = (corner & 2 ? 0.5f : -0.5f) * preset->size_m.z;
        const vec3 rim = on_screen(&preset->view, aspect, v3(x, rim_m, z));
        assert_true(rim.z > 0.0f);
        assert_true(f_abs(rim.x) < 0.98f);
        assert_true(f_abs(rim.y) < 0.95f);
        widest = f_max(widest, f_abs(rim.x));
    }
    if (aspect > 1.7f && aspect < 1.8f) {
        /* On a 16:9 screen, the tank must fill most of the width. The edge of the screen is at
         * 1. */
        assert_true(widest > 0.85f);
    }
}

/* The rim of the tank is 32 mm wide (deck.vert.glsl). */
#define RIM_M 0.032f

/* The street behind the stall takes a tenth of the height of a 16:9 screen, and the panels of the
 * players, which take a seventh, cover no water. */
static void test_the_street_is_visible_behind_each_tank(void **state)
{
    (void)state;
    for (uint8_t id = 0; id < TANK_PRESET_COUNT; id++) {
        const struct tank_preset *preset = tank_preset(id);
        const float rim_m = preset->wall_height_m - preset->size_m.y;
        const float far_m = -0.5f * preset->size_m.z;
        const float aspect = 16.0f / 9.0f;
        const vec3 rim = on_screen(&preset->view, aspect, v3(0.0f, rim_m, far_m - RIM_M));
        const vec3 water = on_screen(&preset->view, aspect, v3(0.0f, 0.0f, far_m));
        const vec3 near = on_screen(&preset->view, aspect, v3(0.0f, rim_m, RIM_M - far_m));
        assert_true(rim.y < 0.80f && water.y < 1.0f - 2.0f / 7.0f && near.y > -0.90f);
    }
}

static void test_each_tank_is_visible_on_wide_and_narrow_screens(void **state)
{
    (void)state;
    for (uint8_t id = 0; id < TANK_PRESET_COUNT; id++) {
        check_fits(id, 16.0f / 9.0f);
        check_fits(id, 4.0f / 3.0f);
        check_fits(id, 21.0f / 9.0f);
        check_fits(id, 9.0f / 16.0f);
    }
}

/* Returns the y coordinate (-1 to 1) at which the portrait camera shows a point of the player's
 * axes, and checks that the point is visible. */
static float upright_y(uint8_t id, float aspect, vec3 point_m)
{
    const struct view view = tank_preset_view(tank_preset(id), true);
    const vec3 at = on_screen(&view, aspect, view_to_world(true, point_m));
    assert_true(at.z > 0.0f && f_abs(at.x) < 0.98f && f_abs(at.y) < 0.90f);
    return at.y;
}

static void test_the_tank_fills_a_portrait_screen(void **state)
{
    (void)state;
    static const float aspects[] = {
        9.0f / 21.0f, 9.0f / 16.0f, 0.625f, 2.0f / 3.0f, 0.75f, 0.77f
    };
    for (uint32_t k = 0; k < 6u * TANK_PRESET_COUNT; k++) {
        const uint8_t id = (uint8_t)(k / 6u);
        const struct tank_preset *preset = tank_preset(id);
        const float aspect = aspects[k % 6u];
        const float x = 0.5f * preset->size_m.z, z = 0.5f * preset->size_m.x;
        const float far = upright_y(id, aspect, v3(-x, 0.0f, -z));
        const float near = upright_y(id, aspect, v3(x, 0.0f, z));
        /* From a screen of 9:16 on, the water takes at least 55 % of the height, which is 2. */
        assert_true(aspect < 0.56f || far - near >= 2.0f * 0.55f);
        for (uint32_t i = 0; i < POI_MAX; i++) {
            upright_y(id, aspect, view_from_world(true, preset->bowl_m[i]));
        }
    }
}

static void test_turned_axes_convert_back(void **state)
{
    (void)state;
    const vec3 v = v3(1.0f, 2.0f, 3.0f);
    const vec3 back = view_from_world(true, view_to_world(true, v));
    assert_true(back.x == v.x && back.y == v.y && back.z == v.z);
    /* The player's right is -z, and the direction toward the player is +x. */
    assert_true(view_to_world(true, v3(1.0f, 0.0f, 0.0f)).z == -1.0f);
    assert_true(view_to_world(true, v3(0.0f, 0.0f, 1.0f)).x == 1.0f);
    /* A handle with yaw 0 extends toward the player. */
    const struct angles turn = { .yaw_rad = VIEW_TURN_RAD };
    assert_true(vec_basis_from_angles(turn).back.x > 0.9999f);
    assert_true(view_to_world(false, v).z == v.z);
}

/* The rules of the goldfish scooping federation prescribe tank type A, 1,000 fish of about 4 cm, 10
 * cm of water, no pump, and 20 to 30 C. */
static void test_the_official_preset_is_the_championship(void **state)
{
    (void)state;
    const struct tank_preset *preset = tank_preset(TANK_PRESET_OFFICIAL);
    assert_string_equal(preset->name, "official");
    assert_float_equal(preset->size_m.x, 1.36f, 1e-6f);
    assert_float_equal(preset->size_m.z, 0.65f, 1e-6f);
    assert_float_equal(preset->size_m.y, 0.10f, 1e-6f);
    assert_int_equal(preset->fish_count, 1000);
    assert_float_equal(preset->length_m, 0.04f, 1e-6f);
    assert_in_range((uint32_t)preset->temperature_c, 20, 30);
    assert_int_equal(preset->pump, 0);
    assert_true(tank_preset_fish_max(preset, 1.0f) >= 1500);
}

static void test_fish_of_other_presets_have_a_slimmer_box_than_thesis_fish(void **state)
{
    (void)state;
    for (uint8_t id = 0; id < TANK_PRESET_COUNT; id++) {
        const struct behavior_params *params = &tank_preset(id)->params;
        const float height = id == TANK_PRESET_THESIS ? 0.40f : 0.36f;
        assert_float_equal(params->height_per_length, height, 1e-6f);
        assert_float_equal(params->width_per_length, 0.20f, 1e-6f);
    }
}

static void test_the_maximum_fish_count_follows_the_water_volume(void **state)
{
    (void)state;
    struct tank_preset preset = *tank_preset(TANK_PRESET_FESTIVAL);
    const uint32_t max = tank_preset_fish_max(&preset, 1.0f);
    assert_in_range(max, 600, 700); /* The maximum is about twice the 300 fish of this preset. */
    preset.size_m.y *= 2.0f;
    assert_in_range(tank_preset_fish_max(&preset, 1.0f), 2u * max, 2u * max + 1u);
    preset.size_m.y *= 100.0f;
    assert_int_equal(tank_preset_fish_max(&preset, 1.0f), TANK_FISH_MAX);
    preset.size_m.y = 1e-6f;
    assert_int_equal(tank_preset_fish_max(&preset, 1.0f), 1);
}

static void test_an_unknown_preset_fails_an_assertion(void **state)
{
    (void)state;
    expect_assert_failure(tank_preset(TANK_PRESET_COUNT));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_the_festival_preset_has_the_documented_values),
        cmocka_unit_test(test_the_ages_of_the_festival_give_fish_of_3_to_8_cm),
        cmocka_unit_test(test_four_bowls_float_inside_each_tank_and_apart),
        cmocka_unit_test(test_the_street_is_visible_behind_each_tank),
        cmocka_unit_test(test_each_tank_is_visible_on_wide_and_narrow_screens),
        cmocka_unit_test(test_the_tank_fills_a_portrait_screen),
        cmocka_unit_test(test_turned_axes_convert_back),
        cmocka_unit_test(test_the_official_preset_is_the_championship),
        cmocka_unit_test(test_fish_of_other_presets_have_a_slimmer_box_than_thesis_fish),
        cmocka_unit_test(test_the_maximum_fish_count_follows_the_water_volume),
        cmocka_unit_test(test_an_unknown_preset_fails_an_assertion),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
