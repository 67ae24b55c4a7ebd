/* test_poi_mouse.c -- tests that the motion of a mouse loads the paper hardly more than a smooth
 * motion, although a mouse moves in whole pixels. */
#include "tests/unit/support/poi_fixture.h"

/* The fixture is static, because the struct is too large for some stacks. */
static struct poi_fixture fixture;

#define SCREEN_PX 1280.0f
/* Width of the visible part of the tank, in metres. */
#define VIEW_M 0.95f

static float whole_pixel(float at_m)
{
    const float pixel_m = VIEW_M / SCREEN_PX;
    return pixel_m * f_floor(at_m / pixel_m + 0.5f);
}

/* Moves the poi by 0.4 m. If `by_mouse` is set, the position is rounded to whole pixels at 60 Hz
 * and interpolated linearly to 120 Hz, as the kiosk does with a mouse. */
static void glide(float speed_m_s, float course_rad, float roll_rad, int by_mouse)
{
    fixture_init(&fixture, 4, 3);
    fixture.hand.angles.roll_rad = roll_rad;
    const vec3 way = v3(f_cos(course_rad), 0.0f, f_sin(course_rad));
    const vec3 start = v3(-0.2f * way.x, -0.075f, -0.2f * way.z);
    fixture.hand.position_m = fixture.poi.position_m = start;
    fixture_wait(&fixture, 2.0f);
    vec3 reports[2] = { start, start };
    const uint32_t ticks = (uint32_t)(0.4f / speed_m_s * (float)CORE_TICK_HZ);
    for (uint32_t tick = 0; tick < ticks; tick++) {
        const float at_m = speed_m_s * (float)(tick + 1u) * CORE_TICK_S;
        const vec3 smooth = v3_muladd(start, way, at_m);
        if (tick % 2u == 0) {
            const vec3 next = v3_muladd(smooth, way, speed_m_s * CORE_TICK_S);
            reports[0] = reports[1];
            reports[1] = v3(whole_pixel(next.x), next.y, whole_pixel(next.z));
        }
        fixture.hand.position_m = smooth;
        if (by_mouse) {
            fixture.hand.position_m =
                tick % 2u == 0 ? v3_lerp(reports[0], reports[1], 0.5f) : reports[1];
        }
        fixture_tick(&fixture);
        if (tick == ticks / 3u) {
            /* Starts the measurement here. The first step of the mouse, from the exact start
             * position to a whole pixel, is therefore excluded. */
            fixture.tension_max_n_m = fixture.tension_sum_n_m = 0.0f;
        }
    }
}

/* Returns the fraction by which the maximum tension of the paper is higher with the mouse than with
 * the smooth motion. */
static float excess_strain(float speed_m_s, float course_rad, float roll_rad)
{
    glide(speed_m_s, course_rad, roll_rad, 0);
    const float smooth_max = fixture.tension_max_n_m, smooth_sum = fixture.tension_sum_n_m;
    glide(speed_m_s, course_rad, roll_rad, 1);
    assert_float_equal(fixture.tension_sum_n_m / smooth_sum, 1.0f, 0.01f);
    return fixture.tension_max_n_m / smooth_max - 1.0f;
}

static const float rolls_rad[] = { 90.0f * F_DEG, 45.0f * F_DEG, 20.0f * F_DEG };
static const float courses_rad[] = { 0.0f, 0.20f, 0.35f, 0.80f, 1.20f, -0.80f };

static void assert_grain(float speed_m_s, float most)
{
    for (uint32_t i = 0; i < 3; i++) {
        for (uint32_t k = 0; k < sizeof courses_rad / sizeof courses_rad[0]; k++) {
            assert_float_equal(excess_strain(speed_m_s, courses_rad[k], rolls_rad[i]), 0.0f, most);
        }
    }
}

static void test_whole_pixel_mouse_motion_loads_the_paper_like_the_smooth_path(void **state)
{
    (void)state;
    assert_grain(0.20f, 0.10f);
    assert_grain(0.30f, 0.05f);
}

/* At 0.15 m/s the poi moves by about 3.4 pixels per frame, which are rounded to 3 or 4. The drag
 * grows with the square of the speed, so its maximum is higher than with a smooth motion. A filter
 * would avoid this, but would add lag. */
static void test_slower_mouse_motion_adds_at_most_an_eighth_of_the_strain(void **state)
{
    (void)state;
    assert_grain(0.15f, 0.13f);
    for (uint32_t i = 0; i < 3; i++) {
        for (uint32_t k = 0; k < 4; k++) {
            assert_float_equal(excess_strain(0.15f, courses_rad[k], rolls_rad[i]), 0.0f, 0.10f);
        }
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_whole_pixel_mouse_motion_loads_the_paper_like_the_smooth_path),
        cmocka_unit_test(test_slower_mouse_motion_adds_at_most_an_eighth_of_the_strain),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
