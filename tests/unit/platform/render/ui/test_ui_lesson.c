/* test_ui_lesson.c -- tests where the lessons are drawn: the ring around a fish, and the arrow to
 * the bowl. */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "core/tank/preset.h"
#include "platform/render/ui/ui_primitives.h"
#include "tests/unit/support/ui_fixture.h"

/* Sets up a round in the festival tank, with the poi of each player at the left and the bowls at
 * the right. */
static void set_round(uint32_t players)
{
    set_scene(PHASE_ROUND, LANGUAGE_EN, HINT_NONE, 20.0f);
    set_match(MODE_FESTIVAL, players, 0);
    scene.view = tank_preset(TANK_PRESET_FESTIVAL)->view;
    scene.fish_count = 4;
    for (uint32_t i = 0; i < POI_MAX; i++) {
        scene.player[i].lost = scene.player[i].out = 0;
        scene.player[i].foul_s = 60.0f;
        scene.poi[i].position_m = v3(-0.25f, 0.035f, 0.05f * (float)i);
        scene.poi[i].ring_radius_m = 0.04f;
        scene.bowl[i] = (struct scene_bowl){ .present = i < players,
                                             .position_m = v3(0.25f, 0.01f, 0.0f),
                                             .radius_m = 0.08f };
        scene.fish[i].position_m = v3(-0.1f + 0.05f * (float)i, -0.02f, 0.05f);
        scene.fish[i].length_m = 0.045f;
    }
}

static struct ui_point project(struct size size, vec3 at_m)
{
    const struct ui_frame frame = { .scene = &scene, .width = size.width, .height = size.height };
    return ui_project(&frame, at_m);
}

/* Returns the number of rings whose centre is at most 1 px from `at`. */
static uint32_t rings_at(struct ui_point at)
{
    uint32_t count = 0;
    for (uint32_t i = 0; i < batch.quad_count; i++) {
        const struct bounds b = bounds_of(i);
        const float x = 0.5f * (b.left + b.right) - at.x, y = 0.5f * (b.top + b.bottom) - at.y;
        count += batch.kinds[i] == UI_RING && x * x + y * y < 1.0f;
    }
    return count;
}

static void test_the_ring_is_around_the_marked_fish(void **state)
{
    (void)state;
    set_round(1);
    for (uint32_t i = 0; i < SIZE_COUNT; i++) {
        const struct ui_point at = project(sizes[i], scene.fish[2].position_m);
        scene.lesson[0] = (struct scene_lesson){ 0 };
        lay_out(sizes[i]);
        assert_int_equal(rings_at(at), 0);
        scene.lesson[0] = (struct scene_lesson){ .marks_fish = 1, .fish = 2, .mark_s = 1.0f };
        lay_out(sizes[i]);
        assert_int_equal(rings_at(at), 2); /* The ring is drawn with a shadow, which is a second
                                              ring. */
    }
}

static void test_the_rings_of_several_players_have_their_numbers(void **state)
{
    (void)state;
    uint32_t glyphs[2];
    set_round(4);
    lay_out(sizes[0]);
    glyphs[0] = glyph_quads();
    for (uint32_t i = 0; i < POI_MAX; i++) {
        scene.lesson[i] =
            (struct scene_lesson){ .marks_fish = 1, .fish = (uint16_t)i, .mark_s = 1.0f };
    }
    lay_out(sizes[0]);
    glyphs[1] = glyph_quads();
    assert_int_equal(glyphs[1] - glyphs[0], POI_MAX);
    assert_int_equal(batch.dropped_count, 0);
}

static void test_the_arrow_runs_from_the_poi_to_the_bowl(void **state)
{
    (void)state;
    set_round(1);
    for (uint32_t i = 0; i < SIZE_COUNT; i++) {
        const struct ui_point poi = project(sizes[i], scene.poi[0].position_m);
        const struct ui_point bowl = project(sizes[i], scene.bowl[0].position_m);
        scene.lesson[0].points_to_bowl = 0;
        lay_out(sizes[i]);
        const uint32_t without = batch.quad_count;
        assert_int_equal(rings_at(bowl), 0);
        scene.lesson[0].points_to_bowl = 1;
        lay_out(sizes[i]);
        assert_true(batch.quad_count >= without + 9u); /* The arrow has at least two chevrons of 4
                                                          quads each, and the ring is another
                                                          quad. */
        assert_int_equal(rings_at(bowl), 1);
        /* Counts the panels between the poi and the bowl, where only the arrow is drawn. A chevron
         * is at most 32 units wide to each side. */
        const float unit = fminf(sizes[i].height / 720.0f, sizes[i].width / 860.0f);
        uint32_t between = 0;
        for (uint32_t k = 0; k < batch.quad_count; k++) {
            const struct bounds b = bounds_of(k);
            between += batch.kinds[k] == UI_PANEL && b.left > poi.x && b.right < bowl.x &&
                       b.top > fminf(poi.y, bowl.y) - 32.0f * unit &&
                       b.bottom < fmaxf(poi.y, bowl.y) + 32.0f * unit;
        }
        assert_true(between >= 8u);
    }
}

/* A window manager may ignore the smallest size of the window. The camera then stands so far from
 * the tank that the line of a lesson's ring is wider than the ring. Such a ring must become a disc.
 */
static void test_a_ring_that_is_far_away_becomes_a_disc(void **state)
{
    (void)state;
    set_round(1);
    scene.lesson[0] =
        (struct scene_lesson){ .marks_fish = 1, .fish = 2, .mark_s = 1.0f, .points_to_bowl = 1 };
    scene.fish[2].position_m = scene.bowl[0].position_m = v3(0.0f, 0.0f, -20.0f);
    for (uint32_t i = 0; i < SIZE_COUNT; i++) {
        uint32_t discs = 0;
        lay_out(sizes[i]);
        for (uint32_t k = 0; k < batch.quad_count; k++) {
            const float *const shape = batch.vertices[4u * k].shape;
            assert_true(batch.kinds[k] != UI_RING || shape[0] >= shape[1]);
            discs += batch.kinds[k] == UI_RING && shape[0] == shape[1];
        }
        assert_in_range(discs, 1, 3);
    }
}

static void test_the_lessons_of_four_players_fit_the_batch(void **state)
{
    (void)state;
    for (uint32_t i = 0; i < SIZE_COUNT; i++) {
        set_round(4);
        for (uint32_t k = 0; k < POI_MAX; k++) {
            scene.lesson[k].points_to_bowl = 1;
        }
        lay_out(sizes[i]);
        assert_int_equal(batch.dropped_count, 0);
    }
}

static uint32_t quads_of(enum ui_kind kind)
{
    uint32_t count = 0;
    for (uint32_t i = 0; i < batch.quad_count; i++) {
        count += batch.kinds[i] == kind;
    }
    return count;
}

static void test_the_ghost_is_drawn_where_its_ring_is(void **state)
{
    (void)state;
    set_round(1);
    scene.lesson[0].ghost = (struct scene_ghost){ .is_present = 1,
                                                  .opacity = 1.0f,
                                                  .position_m = v3(0.1f, 0.04f, 0.05f) };
    for (uint32_t i = 0; i < SIZE_COUNT; i++) {
        const struct ui_point at = project(sizes[i], scene.lesson[0].ghost.position_m);
        lay_out(sizes[i]);
        assert_int_equal(quads_of(UI_GHOST), 1);
        for (uint32_t k = 0; k < batch.quad_count; k++) {
            if (batch.kinds[k] == UI_GHOST) {
                const float radius = batch.vertices[4u * k].shape[0];
                const struct bounds b = bounds_of(k);
                assert_float_equal(b.left + UI_GHOST_RING_X * radius, at.x, 0.5f);
                assert_float_equal(b.top + UI_GHOST_RING_Y * radius, at.y, 0.5f);
            }
        }
    }
}

static void test_the_hint_of_a_single_player_has_words_inside_the_screen(void **state)
{
    (void)state;
    static const float places_m[] = { -0.6f, -0.3f, 0.0f, 0.3f, 0.6f };
    for (uint32_t n = 0; n < SIZE_COUNT * LANGUAGE_COUNT * HINT_COUNT * 5u; n++) {
        const struct size size = sizes[n % SIZE_COUNT];
        const uint8_t hint = (uint8_t)(n / SIZE_COUNT % HINT_COUNT);
        set_round(1);
        scene.language = (uint8_t)(n / SIZE_COUNT / HINT_COUNT % LANGUAGE_COUNT);
        scene.poi[0].position_m.x = places_m[n / SIZE_COUNT / HINT_COUNT / LANGUAGE_COUNT];
        scene.poi[0].position_m.z = 0.4f * scene.poi[0].position_m.x;
        lay_out(size);
        const uint32_t first = batch.quad_count, glyphs = glyph_quads();
        scene.lesson[0].hint = hint;
        scene.lesson[0].hint_s = 5.0f;
        lay_out(size);
        assert_true(hint == HINT_NONE ? batch.quad_count == first : glyph_quads() > glyphs);
        for (uint32_t i = 0; i < batch.quad_count; i++) {
            const struct bounds b = bounds_of(i);
            if (b.left < -1.0f || b.right > size.width + 1.0f || b.top < -1.0f ||
                b.bottom > size.height + 1.0f) {
                fail_msg("hint %d on %gx%g: quad %u of kind %d is at (%g, %g) to (%g, %g)", hint,
                         (double)size.width, (double)size.height, i, batch.kinds[i], (double)b.left,
                         (double)b.top, (double)b.right, (double)b.bottom);
            }
        }
    }
}

static void test_the_hint_does_not_cover_its_ring(void **state)
{
    (void)state;
    for (int tenth = -3; tenth <= 3; tenth++) {
        const float z_m = 0.1f * (float)tenth;
        set_round(1);
        scene.poi[0].position_m = v3(0.0f, 0.035f, z_m);
        lay_out(sizes[0]);
        const uint32_t first = batch.quad_count;
        scene.lesson[0] = (struct scene_lesson){ .hint = HINT_TORN, .hint_s = 5.0f };
        lay_out(sizes[0]);
        assert_true(batch.quad_count > first);
        const struct ui_point at = project(sizes[0], scene.poi[0].position_m);
        uint32_t panels = 0;
        for (uint32_t i = 0; i < batch.quad_count; i++) {
            const struct bounds b = bounds_of(i);
            const bool is_hint = batch.kinds[i] == UI_PANEL && b.bottom - b.top == 76.0f;
            panels += is_hint;
            assert_true(!is_hint || b.bottom < at.y - 0.04f * at.px_per_m ||
                        b.top > at.y + 0.04f * at.px_per_m);
        }
        assert_int_equal(panels, 1);
    }
}

static void test_the_word_for_a_near_miss_replaces_the_hint(void **state)
{
    (void)state;
    uint32_t quads[2];
    set_round(1);
    scene.player[0].miss_s = 0.5f;
    for (uint32_t i = 0; i < 2u; i++) {
        scene.lesson[0] =
            (struct scene_lesson){ .hint = i == 0 ? HINT_NONE : HINT_GLIDE, .hint_s = 5.0f };
        lay_out(sizes[0]);
        quads[i] = batch.quad_count;
    }
    assert_int_equal(quads[0], quads[1]);
    scene.player[0].miss_s = 5.0f;
    lay_out(sizes[0]);
    assert_true(batch.quad_count > quads[0]);
}

static void test_the_hints_of_several_players_have_pictures_and_numbers_only(void **state)
{
    (void)state;
    set_round(4);
    lay_out(sizes[0]);
    const uint32_t glyphs = glyph_quads();
    for (uint32_t i = 0; i < POI_MAX; i++) {
        scene.lesson[i] = (struct scene_lesson){ .hint = HINT_GLIDE, .hint_s = 5.0f };
    }
    lay_out(sizes[0]);
    assert_int_equal(glyph_quads() - glyphs, POI_MAX);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_the_ring_is_around_the_marked_fish),
        cmocka_unit_test(test_the_rings_of_several_players_have_their_numbers),
        cmocka_unit_test(test_the_arrow_runs_from_the_poi_to_the_bowl),
        cmocka_unit_test(test_a_ring_that_is_far_away_becomes_a_disc),
        cmocka_unit_test(test_the_lessons_of_four_players_fit_the_batch),
        cmocka_unit_test(test_the_ghost_is_drawn_where_its_ring_is),
        cmocka_unit_test(test_the_hint_of_a_single_player_has_words_inside_the_screen),
        cmocka_unit_test(test_the_hint_does_not_cover_its_ring),
        cmocka_unit_test(test_the_word_for_a_near_miss_replaces_the_hint),
        cmocka_unit_test(test_the_hints_of_several_players_have_pictures_and_numbers_only),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
