/* test_raster.c -- Tests the software rasterizer of kingyoctl: coverage, depth order and
 * transparency. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <cmocka.h>

#include "platform/ctl/lib/raster.h"

#define SIDE 32u

/* Colour and opacity of a triangle in one colour. */
struct flat {
    vec3 colour;
    float hides;
};

static uint32_t asked;

static struct raster_colour look(const void *triangle, const float part[3])
{
    const struct flat *flat = triangle;
    assert_true(part[0] >= -1e-4f && part[1] >= -1e-4f && part[2] >= -1e-4f);
    assert_true(f_abs(part[0] + part[1] + part[2] - 1.0f) < 1e-4f);
    asked++;
    return (struct raster_colour){ flat->colour, flat->hides };
}

struct stand {
    struct canvas canvas;
    struct raster raster;
};

static struct stand set_up(void)
{
    struct stand s;
    assert_true(canvas_open(&s.canvas, SIDE, SIDE));
    assert_true(raster_open(&s.raster, SIDE, SIDE));
    asked = 0;
    return s;
}

static void tear_down(struct stand *s)
{
    raster_close(&s->raster);
    canvas_close(&s->canvas);
}

static void draw(struct stand *s, vec3 a, vec3 b, vec3 c, const struct flat *flat)
{
    const vec3 corners[3] = { a, b, c };
    raster_triangle(&s->raster, corners, (struct raster_skin){ look, flat });
}

static float sum_of_red(const struct stand *s)
{
    float sum = 0.0f;
    for (size_t i = 0; i < (size_t)SIDE * SIDE; i++) {
        sum += s->canvas.pixels[i].x;
    }
    return sum;
}

static const struct flat red = { { 1.0f, 0.0f, 0.0f }, 1.0f };
static const struct flat green = { { 0.0f, 1.0f, 0.0f }, 1.0f };
static const struct flat glass = { { 1.0f, 0.0f, 0.0f }, 0.5f };

static void test_a_triangle_covers_its_pixel_area(void **state)
{
    (void)state;
    struct stand s = set_up();
    draw(&s, v3(3.3f, 4.1f, 0.0f), v3(5.7f, 27.9f, 0.0f), v3(28.2f, 20.4f, 0.0f), &red);
    assert_true(raster_finish(&s.raster, &s.canvas, 0, 0));
    const float area = 0.5f * ((27.9f - 4.1f) * (28.2f - 3.3f) - (5.7f - 3.3f) * (20.4f - 4.1f));
    assert_true(f_abs(sum_of_red(&s) - area) < 0.01f * area);
    tear_down(&s);
}

static void test_a_back_facing_triangle_is_not_drawn(void **state)
{
    (void)state;
    struct stand s = set_up();
    draw(&s, v3(3.0f, 4.0f, 0.0f), v3(28.0f, 20.0f, 0.0f), v3(5.0f, 27.0f, 0.0f), &red);
    raster_finish(&s.raster, &s.canvas, 0, 0);
    assert_true(sum_of_red(&s) == 0.0f);
    assert_int_equal(asked, 0);
    tear_down(&s);
}

/* Six half-transparent red triangles meet at one point. A sample that two triangles cover would be
 * too red, and a sample that no triangle covers would not be red enough. */
static void test_triangles_around_a_point_cover_every_sample_once(void **state)
{
    (void)state;
    static const vec3 middles[] = { { 16.0f, 16.0f, 0.0f },
                                    { 15.5f, 16.5f, 0.0f },
                                    { 13.37f, 17.93f, 0.0f } };
    for (uint32_t m = 0; m < 3; m++) {
        struct stand s = set_up();
        const vec3 rim[6] = { { 2, 2, 0 },   { 2, 16, 0 },  { 7, 30, 0 },
                              { 30, 30, 0 }, { 30, 16, 0 }, { 30, 2, 0 } };
        for (uint32_t i = 0; i < 6; i++) {
            draw(&s, middles[m], rim[i], rim[(i + 1) % 6], &glass);
        }
        raster_finish(&s.raster, &s.canvas, 0, 0);
        for (uint32_t y = 4; y < 28; y++) {
            for (uint32_t x = 8; x < 29; x++) {
                assert_true(f_abs(s.canvas.pixels[y * SIDE + x].x - 0.5f) < 1e-5f);
            }
        }
        tear_down(&s);
    }
}

static vec3 centre_of_three(const uint32_t order[3])
{
    static const struct flat flats[3] = { { { 1.0f, 0.0f, 0.0f }, 0.5f },
                                          { { 0.0f, 1.0f, 0.0f }, 0.25f },
                                          { { 0.0f, 0.0f, 1.0f }, 1.0f } };
    struct stand s = set_up();
    for (uint32_t i = 0; i < 3; i++) {
        const float depth = (float)(3 - order[i]); /* The red triangle is nearest and the blue one
                                                      is farthest. */
        draw(&s, v3(-9.0f, -9.0f, depth), v3(-9.0f, 90.0f, depth), v3(90.0f, -9.0f, depth),
             &flats[order[i]]);
    }
    raster_finish(&s.raster, &s.canvas, 0, 0);
    const vec3 centre = s.canvas.pixels[16 * SIDE + 16];
    tear_down(&s);
    return centre;
}

static void test_layers_are_sorted_by_depth_in_any_drawing_order(void **state)
{
    (void)state;
    static const uint32_t commands[6][3] = { { 0, 1, 2 }, { 0, 2, 1 }, { 1, 0, 2 },
                                             { 1, 2, 0 }, { 2, 0, 1 }, { 2, 1, 0 } };
    for (uint32_t i = 0; i < 6; i++) {
        const vec3 centre = centre_of_three(commands[i]);
        assert_true(f_abs(centre.x - 0.5f) < 1e-5f);
        assert_true(f_abs(centre.y - 0.125f) < 1e-5f);
        assert_true(f_abs(centre.z - 0.375f) < 1e-5f);
    }
}

/* A red and a green triangle intersect along x = 16.25. About one quarter of pixel 16 must
 * therefore be red. The tolerance is large because each pixel has few samples. */
static void test_crossing_sheets_are_resolved_below_a_pixel(void **state)
{
    (void)state;
    struct stand s = set_up();
    draw(&s, v3(-40.0f, -40.0f, 0.0f), v3(-40.0f, 99.0f, 0.0f), v3(99.0f, -40.0f, 0.0f), &green);
    draw(&s, v3(-40.0f, -40.0f, 56.25f), v3(-40.0f, 99.0f, 56.25f), v3(99.0f, -40.0f, -82.75f),
         &red);
    raster_finish(&s.raster, &s.canvas, 0, 0);
    const vec3 *row = &s.canvas.pixels[8 * SIDE];
    assert_true(row[15].x > 0.999f && row[17].x < 0.001f);
    assert_true(row[16].x > 0.12f && row[16].x < 0.38f);
    assert_true(f_abs(row[16].x + row[16].y - 1.0f) < 1e-5f);
    tear_down(&s);
}

static void test_too_many_layers_keep_the_nearest(void **state)
{
    (void)state;
    struct stand s = set_up();
    for (uint32_t i = 0; i < 100; i++) {
        const struct flat *flat = i == 57 ? &red : &green;
        const float depth = i == 57 ? 1000.0f : (float)(i * 37 % 100);
        draw(&s, v3(-9.0f, -9.0f, depth), v3(-9.0f, 90.0f, depth), v3(90.0f, -9.0f, depth), flat);
    }
    raster_finish(&s.raster, &s.canvas, 0, 0);
    assert_true(s.canvas.pixels[16 * SIDE + 16].x == 1.0f);
    tear_down(&s);
}

static void test_a_finished_raster_is_empty(void **state)
{
    (void)state;
    struct stand s = set_up();
    draw(&s, v3(-9.0f, -9.0f, 0.0f), v3(-9.0f, 90.0f, 0.0f), v3(90.0f, -9.0f, 0.0f), &red);
    raster_finish(&s.raster, &s.canvas, 0, 0);
    canvas_fill(&s.canvas, (struct canvas_box){ 0.0f, 0.0f, SIDE, SIDE }, 0, 0);
    raster_finish(&s.raster, &s.canvas, 0, 0);
    assert_true(sum_of_red(&s) == 0.0f);
    tear_down(&s);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_a_triangle_covers_its_pixel_area),
        cmocka_unit_test(test_a_back_facing_triangle_is_not_drawn),
        cmocka_unit_test(test_triangles_around_a_point_cover_every_sample_once),
        cmocka_unit_test(test_layers_are_sorted_by_depth_in_any_drawing_order),
        cmocka_unit_test(test_crossing_sheets_are_resolved_below_a_pixel),
        cmocka_unit_test(test_too_many_layers_keep_the_nearest),
        cmocka_unit_test(test_a_finished_raster_is_empty),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
