/* test_fish_wave.c -- Tests that the tail of a drawn fish swings as far as the scene specifies, and
 * that its gill covers move, its dorsal fin is visible and its wet skin has a narrow gloss.
 *
 * All are measured in pictures that are drawn from above. */
#include <setjmp.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include <cmocka.h>

#include "core/core.h"
#include "platform/render/display_gl.h"

#define SIDE_PX 600u
#define PIXELS_SIZE (SIDE_PX * SIDE_PX * 3u)
#define PHASES 16u
#define LENGTH_M 0.08f
#define EYE_M 0.25f /* Height of the camera above the fish, in metres. */
/* Height of the fish above the water, in metres. Under water, refraction would distort the
 * picture. */
#define FISH_M 0.06f

static struct core core;
static struct scene scene;
static struct display_gl display;
static struct hal_display device;
static uint8_t empty[PIXELS_SIZE], pixels[PIXELS_SIZE];

/* Outline of a drawn fish, in pixels. The snout points to the top of the picture. */
struct outline {
    float top, bottom, left, right; /* Edges of the fish in the picture. */
    float tail_x, nose_x;           /* Mean x of the tail (last 3 % of the length) and of the nose
                                       (first 3 %). */
};

static int open_display(void **state)
{
    (void)state;
    const struct core_config config = { .seed = 5, .fish_count = 1 };
    core_init(&core, &config);
    core_scene(&core, &scene);
    display.config = (struct display_gl_config){
        .width = SIDE_PX, .height = SIDE_PX, .off_screen = true, .scene_scale = 1.0f
    };
    device = display_gl_device(&display);
    return device.ops->open(device.self);
}

static int close_display(void **state)
{
    (void)state;
    device.ops->close(device.self);
    return 0;
}

static void picture(uint8_t *out)
{
    struct hal_image image = { .rgb = out, .size = PIXELS_SIZE };
    assert_int_equal(device.ops->present(device.self, &scene), HAL_OK);
    assert_int_equal(device.ops->capture(device.self, &image), HAL_OK);
}

static void stage(float phase_rad, float amplitude, float bend_rad)
{
    struct scene_fish *fish = &scene.fish[0];
    scene.view.eye_m = v3(0.0f, FISH_M + EYE_M, 0.0005f);
    scene.view.target_m = v3(0.0f, 0.0f, 0.0f);
    scene.view.half_height_tan = 0.25f;
    scene.view.aspect_min = 1.0f;
    scene.phase = PHASE_ROUND;
    scene.phase_s = 30.0f;
    scene.veil = 0.0f; /* A veil of 0 removes the fade-in from black at the start of a session. */
    scene.poi[0].present = 0;
    scene.hint = HINT_NONE;
    fish->place = SCENE_ON_POI;
    fish->position_m = v3(0.0f, FISH_M, 0.0f);
    fish->angles = (struct angles){ 0.0f, 0.0f, 0.0f };
    fish->length_m = LENGTH_M;
    fish->tail_phase_rad = phase_rad;
    fish->tail_amplitude = amplitude;
    fish->bend_rad = bend_rad;
    fish->look = 0;
    fish->maturity = 1.0f;
}

/* Returns 1 if the pixel is clearly redder than in the picture without a fish. A shadow is not
 * redder. */
static bool is_fish(uint32_t x, uint32_t y)
{
    const size_t at = 3u * ((size_t)y * SIDE_PX + x);
    return pixels[at] > empty[at] + 14;
}

static float middle_x(uint32_t from, uint32_t to)
{
    float sum = 0.0f, count = 0.0f;
    for (uint32_t y = from; y <= to; y++) {
        for (uint32_t x = 0; x < SIDE_PX; x++) {
            sum += is_fish(x, y) ? (float)x : 0.0f;
            count += is_fish(x, y) ? 1.0f : 0.0f;
        }
    }
    assert_true(count > 0.0f);
    return sum / count;
}

static struct outline outline(void)
{
    uint32_t top = SIDE_PX, bottom = 0, left = SIDE_PX, right = 0;
    for (uint32_t y = SIDE_PX / 8u; y < SIDE_PX; y++) {
        for (uint32_t x = SIDE_PX / 4u; x < 3u * SIDE_PX / 4u; x++) {
            if (is_fish(x, y)) {
                top = y < top ? y : top;
                bottom = y > bottom ? y : bottom;
                left = x < left ? x : left;
                right = x > right ? x : right;
            }
        }
    }
    assert_true(bottom > top);
    const uint32_t end = 1u + (bottom - top) * 3u / 100u;
    return (struct outline){ (float)top,
                             (float)bottom,
                             (float)left,
                             (float)right,
                             middle_x(bottom - end, bottom),
                             middle_x(top, top + end) };
}

static struct outline drawn(float phase_rad, float amplitude, float bend_rad)
{
    stage(phase_rad, amplitude, bend_rad);
    scene.fish_count = 0;
    picture(empty);
    scene.fish_count = 1;
    picture(pixels);
    return outline();
}

/* Measures how far the tail and the nose move from side to side in one tail beat, in body
 * lengths. */
static void sweep(float amplitude, float *tail, float *nose)
{
    const struct outline straight = drawn(0.0f, 0.0f, 0.0f);
    const float length_px = straight.bottom - straight.top;
    float left[2] = { 1e6f, 1e6f }, right[2] = { 0.0f, 0.0f };
    for (uint32_t i = 0; i < PHASES; i++) {
        const struct outline shape = drawn(F_TAU * (float)i / (float)PHASES, amplitude, 0.0f);
        left[0] = f_min(left[0], shape.tail_x);
        right[0] = f_max(right[0], shape.tail_x);
        left[1] = f_min(left[1], shape.nose_x);
        right[1] = f_max(right[1], shape.nose_x);
    }
    *tail = (right[0] - left[0]) / length_px;
    *nose = (right[1] - left[1]) / length_px;
    print_message("length %.0f px; at stroke %.1f the tail sweeps %.3f lengths, the snout %.3f\n",
                  (double)length_px, (double)amplitude, (double)*tail, (double)*nose);
}

static void test_a_full_tail_beat_spans_a_fifth_of_the_length(void **state)
{
    (void)state;
    float tail = 0.0f, nose = 0.0f;
    sweep(1.0f, &tail, &nose);
    /* The tail of a real fish moves by a fifth of the body length from side to side (Bainbridge
     * 1958). */
    assert_float_equal(tail, 0.20f, 0.02f);
    assert_float_equal(nose, 0.04f, 0.015f);
    float half = 0.0f;
    sweep(0.5f, &half, &nose);
    assert_float_equal(half, 0.5f * tail, 0.015f);
}

/* A half circle with an arc of length 1 is 0.64 high and 0.32 deep. The fish bends by 2.5 radians,
 * a little less than a half circle, and its tail fin extends beyond the curve. */
static void test_a_startle_bends_the_whole_fish_into_a_c(void **state)
{
    (void)state;
    const struct outline straight = drawn(0.0f, 0.0f, 0.0f), bent = drawn(0.0f, 0.0f, -2.5f);
    const float length_px = straight.bottom - straight.top;
    const float high = (bent.bottom - bent.top) / length_px;
    const float deep = (bent.right - bent.left) / length_px;
    const float off_left = (straight.left - bent.left) / length_px;
    const float off_right = (bent.right - straight.right) / length_px;
    print_message("a C is %.2f lengths high, %.2f deep\n", (double)high, (double)deep);
    assert_true(high < 0.88f && high > 0.60f);
    assert_true(deep > 0.35f && deep < 0.60f);
    assert_true(off_left > off_right); /* Head and tail lie to the left of the middle of the
                                          body. */
}

/* Removes a list of fins, which must be the last list of the meshes that is drawn. Writes the
 * former lengths of the list to `counts`. */
static void remove_fins(enum fish_triangles fins, GLsizei counts[SPECIES_LOD_COUNT])
{
    for (uint32_t i = 0; i < SPECIES_LOD_COUNT; i++) {
        counts[i] = display.renderer.fish.mesh[i].index_counts[fins];
        display.renderer.fish.mesh[i].index_counts[fins] = 0;
    }
}

static void restore_fins(enum fish_triangles fins, const GLsizei counts[SPECIES_LOD_COUNT])
{
    for (uint32_t i = 0; i < SPECIES_LOD_COUNT; i++) {
        display.renderer.fish.mesh[i].index_counts[fins] = counts[i];
    }
}

/* Returns the number of pixels that differ between `empty` and `pixels` within `reach_px` of the
 * middle column, in the rows from `from` to `to`. */
static uint32_t count_changes(uint32_t reach_px, float from, float to)
{
    uint32_t count = 0;
    for (uint32_t y = (uint32_t)from; y < (uint32_t)to; y++) {
        for (uint32_t x = SIDE_PX / 2u - reach_px; x < SIDE_PX / 2u + reach_px; x++) {
            const size_t at = 3u * ((size_t)y * SIDE_PX + x);
            count += memcmp(empty + at, pixels + at, 3) != 0;
        }
    }
    return count;
}

/* Returns the mean red, green and blue value in the rows from `from` to `to`, within `reach_px` of
 * the middle column. */
static float mean_light(const uint8_t *rgb, uint32_t reach_px, float from, float to)
{
    uint32_t sum = 0, count = 0;
    for (uint32_t y = (uint32_t)from; y < (uint32_t)to; y++) {
        const uint8_t *const row = rgb + 3u * ((size_t)y * SIDE_PX + SIDE_PX / 2u - reach_px);
        for (uint32_t i = 0; i < 6u * reach_px; i++) {
            sum += row[i];
            count++;
        }
    }
    return (float)sum / (float)count;
}

/* Ticks at which the gill covers of a fish with the look 0 are closed and open (fish_pass.c). */
#define CLOSED_TICK 63u
#define OPEN_TICK 21u

static void test_a_gill_cover_moves_while_the_fish_rests(void **state)
{
    (void)state;
    GLsizei counts[SPECIES_LOD_COUNT];
    const struct outline still = drawn(0.0f, 0.0f, 0.0f);
    const float length_px = still.bottom - still.top;
    remove_fins(FISH_FINS, counts);
    const uint32_t tick = scene.tick;
    scene.tick = CLOSED_TICK;
    picture(empty);
    scene.tick = OPEN_TICK;
    picture(pixels);
    scene.tick = tick;
    restore_fins(FISH_FINS, counts);
    /* Without the motion of the pattern, the shadow alone would change 264 pixels. */
    const uint32_t at_gill =
        count_changes(30, still.top + 0.15f * length_px, still.top + 0.32f * length_px);
    const uint32_t behind =
        count_changes(10, still.top + 0.42f * length_px, still.top + 0.60f * length_px);
    print_message("a breath changes %u pixels at the gill covers, %u behind\n", at_gill, behind);
    assert_true(at_gill > 600u && behind == 0);
    /* The edge of an open cover casts a stronger shadow. Without the shadow, the motion of the
     * pattern would make these rows brighter by 0.430. */
    const float from = still.top + 0.18f * length_px, to = still.top + 0.22f * length_px;
    const float change = mean_light(pixels, 30, from, to) - mean_light(empty, 30, from, to);
    print_message("the shadow of the gill covers changes the mean light by %.3f\n", (double)change);
    assert_true(change < -0.3f);
}

/* Height of the camera above the fish, in metres, at which a pixel is as wide as in the middle of
 * the festival's tank in a picture of 720 lines, 0.9 mm. */
#define STALL_EYE_M 1.08f
#define STALL_LENGTH_M 0.035f
/* Part of the fish's length, from the snout, in which the dorsal fin is measured. */
#define DORSAL_START 0.41f
#define DORSAL_END 0.66f

static void test_a_dorsal_fin_seen_from_above_has_a_pixel_in_each_row(void **state)
{
    (void)state;
    GLsizei counts[SPECIES_LOD_COUNT];
    stage(0.0f, 0.0f, 0.0f);
    scene.view.eye_m.y = STALL_EYE_M;
    scene.fish[0].length_m = STALL_LENGTH_M;
    scene.fish[0].place = SCENE_IN_TANK;
    scene.fish[0].position_m.y = -0.01f;
    scene.fish_count = 1;
    picture(pixels);
    remove_fins(FISH_SMALL_FINS, counts);
    picture(empty);
    restore_fins(FISH_SMALL_FINS, counts);
    const float length_px = STALL_LENGTH_M * (float)SIDE_PX / (2.0f * 0.25f * STALL_EYE_M);
    const float top = 0.5f * ((float)SIDE_PX - length_px);
    const uint32_t start = (uint32_t)(top + DORSAL_START * length_px);
    const uint32_t end = (uint32_t)(top + DORSAL_END * length_px);
    uint32_t fewest = SIDE_PX, changed = 0, body = 0, fin = 0;
    for (uint32_t y = start; y < end; y++) {
        const uint32_t count = count_changes(3, (float)y, (float)y + 1.0f);
        fewest = count < fewest ? count : fewest;
        changed += count;
        for (uint32_t x = SIDE_PX / 2u - 3u; x < SIDE_PX / 2u + 3u; x++) {
            const size_t at = 3u * ((size_t)y * SIDE_PX + x);
            const bool is_changed = memcmp(empty + at, pixels + at, 3) != 0;
            body += is_changed ? empty[at] : 0u;
            fin += is_changed ? pixels[at] : 0u;
        }
    }
    print_message(
        "a dorsal fin from above: at least %u pixels in a row, red %u beside %u of the back\n",
        fewest, fin, body);
    assert_true(end > start + 5u && fewest > 0 && changed > 5u * (end - start) / 2u);
    /* The fin has the colour of the back, and is no dark line on it. */
    assert_true(100u * fin > 97u * body);
}

/* Returns the number of pixels of the row `y` that belong to the gloss: those whose blue is nearer
 * to the largest value of the row than to the mean of the fish. Skin is red, so that blue shows the
 * light of a lamp. Writes the largest value to `peak`. */
static uint32_t gloss_width(uint32_t y, uint32_t *peak)
{
    const uint8_t *const row = pixels + 3u * (size_t)y * SIDE_PX;
    uint32_t sum = 0, count = 0, width = 0;
    *peak = 0;
    for (uint32_t x = 0; x < SIDE_PX; x++) {
        const uint32_t blue = is_fish(x, y) ? row[3u * x + 2u] : 0u;
        *peak = blue > *peak ? blue : *peak;
        sum += blue;
        count += is_fish(x, y);
    }
    assert_true(count > 0);
    for (uint32_t x = 0; x < SIDE_PX; x++) {
        width += is_fish(x, y) && 2u * row[3u * x + 2u] > *peak + sum / count;
    }
    return width;
}

static void test_wet_skin_of_a_near_fish_has_a_narrow_gloss(void **state)
{
    (void)state;
    const struct outline fish = drawn(0.0f, 0.0f, 0.0f);
    for (uint32_t percent = 25; percent <= 30u; percent += 5u) {
        uint32_t peak;
        const float along = 0.01f * (float)percent * (fish.bottom - fish.top);
        const uint32_t width = gloss_width((uint32_t)(fish.top + along), &peak);
        print_message("the gloss on the back has a blue of %u and is %u pixels wide\n", peak,
                      width);
        assert_true(peak > 90u && width > 0 && width <= 9u);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_a_full_tail_beat_spans_a_fifth_of_the_length),
        cmocka_unit_test(test_a_startle_bends_the_whole_fish_into_a_c),
        cmocka_unit_test(test_a_gill_cover_moves_while_the_fish_rests),
        cmocka_unit_test(test_a_dorsal_fin_seen_from_above_has_a_pixel_in_each_row),
        cmocka_unit_test(test_wet_skin_of_a_near_fish_has_a_narrow_gloss),
    };
    return cmocka_run_group_tests(tests, open_display, close_display);
}
