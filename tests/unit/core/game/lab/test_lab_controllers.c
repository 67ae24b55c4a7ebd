/* test_lab_controllers.c -- tests how a mouse and a poi select and hold parts of the growth lab's
 * page. */
#include "tests/unit/support/lab_fixture.h"

/* The pointer must select the part of the page at its position, whatever shape the window has. */
static void test_a_mouse_selects_the_part_under_it_on_any_screen(void **state)
{
    (void)state;
    static const float sizes[][2] = { { 1280, 720 },  { 1920, 1080 }, { 1024, 768 },
                                      { 2560, 1080 }, { 1080, 1920 }, { 480, 800 } };
    const struct view *view = &tank_preset(core.world.tank.preset)->view;
    for (size_t s = 0; s < sizeof sizes / sizeof *sizes; s++) {
        const float width = sizes[s][0], height = sizes[s][1];
        const int upright = width < POINTER_UPRIGHT_ASPECT * height;
        const struct layout_point canvas = pointer_layout_size(upright);
        const float unit = upright ? width / canvas.x : f_min(width / canvas.x, height / canvas.y);
        for (uint32_t i = 0; i < 25; i++) {
            const struct layout_point expected = { canvas.x * (0.1f + 0.2f * (float)(i % 5u)),
                                                   canvas.y * (0.1f + 0.2f * (float)(i / 5u)) };
            const float x_px = 0.5f * width + (expected.x - 0.5f * canvas.x) * unit;
            const float y_px = 0.5f * height + (expected.y - 0.5f * canvas.y) * unit;
            for (uint32_t dipped = 0; dipped < 2; dipped++) {
                const vec3 hand_m =
                    view_point_on_plane(view, width / height, 2.0f * x_px / width - 1.0f,
                                        1.0f - 2.0f * y_px / height, dipped ? -0.05f : UP_M);
                const struct layout_point got = pointer_project(view, upright, hand_m);
                assert_float_equal(got.x, expected.x, 0.5f);
                assert_float_equal(got.y, expected.y, 0.5f);
            }
        }
    }
}

static void test_a_mouse_presses_as_a_poi_does(void **state)
{
    (void)state;
    const struct view *view = &tank_preset(core.world.tank.preset)->view;
    const struct layout_point at = middle_of(LAB_COMPARE);
    const float x = at.x / 640.0f - 1.0f, y = 1.0f - at.y / 360.0f;
    for (uint32_t i = 0; i < 3; i++) {
        const float height_m = i == 1 ? -0.05f : UP_M;
        input.poi[0] = (struct poi_input){
            .link = POI_SOURCE_LIVE,
            .target.position_m = view_point_on_plane(view, 16.0f / 9.0f, x, y, height_m),
        };
        ticks(3);
    }
    assert_int_equal(look()->lab.compare, 1);
    assert_int_equal(scene.lab.points, LAB_COMPARE);
}

static void test_parts_do_not_overlap_and_lie_on_the_canvas(void **state)
{
    (void)state;
    for (uint32_t k = 0; k < 2u * 6u; k++) {
        const int upright = (int)(k % 2u);
        const uint32_t keys = 3u + k / 2u;
        const struct layout_point canvas = pointer_layout_size(upright);
        for (uint32_t a = 1; a < LAB_PRESSED_COUNT; a++) {
            const struct layout_box box = lab_box(upright, keys, (enum lab_part)a);
            if (box.width == 0.0f) {
                assert_in_range(a, LAB_KEY + keys, LAB_KEY_LAST);
                continue;
            }
            assert_true(box.x >= 0.0f && box.x + box.width <= canvas.x);
            assert_true(box.y >= 0.0f && box.y + box.height <= canvas.y);
            /* Each part is at least 40 units of the canvas high, so that a finger on a touch screen
             * can press it. */
            assert_true(box.height >= 40.0f);
            for (uint32_t b = a + 1u; b < LAB_PRESSED_COUNT; b++) {
                const struct layout_box other = lab_box(upright, keys, (enum lab_part)b);
                const int apart = box.x + box.width <= other.x || other.x + other.width <= box.x ||
                                  box.y + box.height <= other.y || other.y + other.height <= box.y;
                if (!apart && other.width > 0.0f) {
                    fail_msg("parts %u and %u overlap (%d, %u keys)", a, b, upright, keys);
                }
            }
            const struct layout_point middle = { box.x + 0.5f * box.width,
                                                 box.y + 0.5f * box.height };
            assert_int_equal(lab_part_at(upright, keys, middle), a);
        }
    }
}

static void test_a_lost_controller_releases_its_part(void **state)
{
    (void)state;
    hover(knot_at(1, 1));
    go_down();
    assert_int_equal(core.game.lab.holds, HOLD_WEIGHT);
    input.poi[0].link = POI_SOURCE_LOST;
    tick();
    assert_int_equal(core.game.lab.holds, HOLD_NOTHING);
    assert_int_equal(look()->lab.has_pointer, 0);
    hover(middle_of(LAB_STAGE));
    /* A pose with NaN must count as an absent controller. */
    input.poi[0].target.position_m.x = 0.0f / 0.0f;
    tick();
    assert_int_equal(look()->lab.has_pointer, 0);
}

/* While one controller holds a part, no other controller may get the part. The other controller
 * presses too while the first controller is lost and found again. */
static void test_a_held_part_never_jumps_to_another_controller(void **state)
{
    (void)state;
    const struct core_config config = {
        .seed = 5, .fish_count = 12, .players = 2, .modes = 1u << CHOICE_LAB
    };
    open_core(&config);
    hover(knot_at(1, 1));
    go_down();
    assert_int_equal(core.game.lab.holds, HOLD_WEIGHT);
    const struct lab_edit before = core.game.lab.edit;
    const struct poi_input first = input.poi[0];
    hold(1, v3(0.0f, DOWN_M, 0.0f));
    ticks(3);
    for (uint32_t i = 0; i < 2; i++) {
        input.poi[0].link = i == 0 ? POI_SOURCE_LOST : POI_SOURCE_LIVE;
        ticks(3);
        assert_int_equal(look()->lab.has_pointer, 1);
        assert_int_equal(core.game.lab.pointer_player, 1u - i);
        assert_int_equal(core.game.lab.holds, HOLD_BUTTON);
        assert_memory_equal(&core.game.lab.edit, &before, sizeof before);
    }
    come_up();
    input.poi[0] = first;
    tick();
    assert_int_equal(core.game.lab.holds, HOLD_WEIGHT);
}

int main(void)
{
#define TEST(name) cmocka_unit_test_setup(name, open_lab)
    const struct CMUnitTest tests[] = {
        TEST(test_a_mouse_selects_the_part_under_it_on_any_screen),
        TEST(test_a_mouse_presses_as_a_poi_does),
        TEST(test_parts_do_not_overlap_and_lie_on_the_canvas),
        TEST(test_a_lost_controller_releases_its_part),
        TEST(test_a_held_part_never_jumps_to_another_controller),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
