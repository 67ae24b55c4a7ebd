/* test_pointer_mapping.c -- tests that a pointer, a point of the tank and a point of the canvas
 * agree on wide screens and on portrait screens. */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "core/game/pointer_mapping.h"
#include "core/poi/world.h"

static struct world world;
static struct input input;

static void open_world(uint8_t preset, bool upright, bool is_turned)
{
    world.tank.preset = preset;
    world.tank.size_m = tank_preset(preset)->size_m;
    input = (struct input){ .upright = upright, .is_turned = is_turned };
    input.poi[0].link = POI_SOURCE_LIVE;
}

/* For points of the canvas, finds the point of the tank that the picture shows there at the height
 * of a mouse, and requires that the pointer of a mouse at this point is on the canvas point. */
static void test_a_mouse_points_at_the_canvas_point_above_its_point_of_the_tank(void **state)
{
    (void)state;
    for (uint32_t k = 0; k < 2u * TANK_PRESET_COUNT; k++) {
        const bool is_turned = k & 1u;
        const uint8_t preset = (uint8_t)(k / 2u);
        const struct view view = tank_preset_view(tank_preset(preset), is_turned);
        const struct layout_point canvas = pointer_layout_size(is_turned);
        open_world(preset, is_turned, is_turned);
        for (uint32_t i = 0; i < 49; i++) {
            const float x = 0.3f * (float)(i % 7u) - 0.9f, y = 0.25f * (float)(i / 7u) - 0.85f;
            const float height_m = i % 2u ? 0.035f : -0.05f;
            input.poi[0].target.position_m =
                view_point_on_plane(&view, canvas.x / canvas.y, x, y, height_m);
            const struct pointer_state pointer = pointer_of_player(&world, &input, is_turned, 0);
            assert_int_equal(pointer.present, 1);
            assert_true(fabsf(pointer.at.x - 0.5f * canvas.x * (1.0f + x)) < 0.5f);
            assert_true(fabsf(pointer.at.y - 0.5f * canvas.y * (1.0f - y)) < 0.5f);
            assert_float_equal(pointer.height_m, height_m, 1e-4f);
        }
    }
}

/* The near edge of the tank is at the bottom of the canvas, and the player's right is at the
 * right. */
static void test_a_measured_poi_maps_the_floor_plan_to_the_canvas(void **state)
{
    (void)state;
    for (uint32_t is_turned = 0; is_turned < 2u; is_turned++) {
        const struct layout_point canvas = pointer_layout_size(is_turned);
        open_world(TANK_PRESET_FESTIVAL, is_turned, is_turned);
        const vec3 size_m = tank_preset(TANK_PRESET_FESTIVAL)->size_m;
        const float right_m = 0.25f * (is_turned ? size_m.z : size_m.x);
        const float near_m = 0.4f * (is_turned ? size_m.x : size_m.z);
        input.poi[0].has_wrist = 1;
        input.poi[0].target.position_m = view_to_world(is_turned, v3(right_m, 0.05f, near_m));
        const struct pointer_state pointer = pointer_of_player(&world, &input, is_turned, 0);
        assert_float_equal(pointer.at.x, 0.75f * canvas.x, 0.5f);
        assert_float_equal(pointer.at.y, 0.9f * canvas.y, 0.5f);
    }
}

/* Older recordings show the wide camera on the portrait canvas, and must play as before. */
static void test_an_older_recording_keeps_its_mapping(void **state)
{
    (void)state;
    open_world(TANK_PRESET_FESTIVAL, true, false);
    input.poi[0].target.position_m = v3(0.2f, 0.035f, 0.1f);
    const struct layout_point wanted =
        pointer_project(&tank_preset(TANK_PRESET_FESTIVAL)->view, true, v3(0.2f, 0.035f, 0.1f));
    const struct pointer_state pointer = pointer_of_player(&world, &input, true, 0);
    assert_float_equal(pointer.at.x, wanted.x, 1e-3f);
    assert_float_equal(pointer.at.y, wanted.y, 1e-3f);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_a_mouse_points_at_the_canvas_point_above_its_point_of_the_tank),
        cmocka_unit_test(test_a_measured_poi_maps_the_floor_plan_to_the_canvas),
        cmocka_unit_test(test_an_older_recording_keeps_its_mapping),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
