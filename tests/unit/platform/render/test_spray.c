/* test_spray.c -- Tests the causes of splashes in the core, and the paths of the drops and of the
 * scraps of torn paper, that the renderer draws. */
#include <string.h>

#include "platform/render/pass/quad_pass.h"
#include "tests/unit/support/core_fixture.h"

static struct scene shown;
static struct splashes splashes;
static struct quad_drop drops[QUAD_SPRAY_MAX];

static int open_round(void **state)
{
    (void)state;
    const struct core_config config = { .seed = 3, .fish_count = 300, .round_s = 60, .players = 2 };
    open_core(&config);
    return 0;
}

static void test_each_fish_that_falls_and_fast_escapes_splash(void **state)
{
    (void)state;
    uint32_t falls = 0, escapes = 0;
    input.poi[0].link = input.poi[1].link = POI_SOURCE_BOT;
    press(INPUT_START);
    for (uint32_t i = 0; i < 30u * CORE_TICK_HZ; i++) {
        const uint32_t before = core.world.splashes.next;
        tick();
        bool fell = false, fled = false;
        for (uint32_t k = 0; k < output.sound_count; k++) {
            fell |= output.sounds[k].sound == SOUND_CATCH || output.sounds[k].sound == SOUND_PLOP;
            fled |= output.sounds[k].sound == SOUND_ESCAPE;
        }
        falls += fell;
        /* A slow fish escapes without drops. */
        escapes += fled && !fell && core.world.splashes.next != before;
        if (fell) {
            assert_int_not_equal(core.world.splashes.next, before);
        }
    }
    assert_true(falls > 3 && escapes > 3);
}

static void test_a_fast_poi_throws_more_drops_than_a_slow_one(void **state)
{
    (void)state;
    static const float speeds_m_s[] = { 0.03f, 0.2f, 0.45f, 1.5f };
    uint8_t last = 0;
    memset(&splashes, 0, sizeof splashes);
    for (uint32_t i = 0; i < 4u; i++) {
        const struct poi poi = { .splash_m_s = speeds_m_s[i],
                                 .velocity_m_s = v3(0.0f, -speeds_m_s[i], 0.0f),
                                 .position_m = v3(0.1f, 0.003f, 0.0f) };
        surface_splash_poi(&splashes, &poi, 100u + i);
        surface_splash_show(&splashes, 101u + i, &shown);
        assert_int_equal(shown.splash_count, i);
        if (i > 0) {
            assert_true(shown.splash[0].drops > last);
            assert_float_equal(shown.splash[0].position_m.y, 0.0f, 0.0f);
            last = shown.splash[0].drops;
        }
    }
    /* A poi that moves in the water or in the air does not splash. */
    const struct poi inside = { .velocity_m_s = v3(1.0f, 0.0f, 0.0f) };
    surface_splash_poi(&splashes, &inside, 105u);
    surface_splash_show(&splashes, 105u, &shown);
    assert_int_equal(shown.splash_count, 3);
}

static void test_a_splash_ends_and_the_newest_splashes_are_kept(void **state)
{
    (void)state;
    const uint32_t last_tick = 100u + 2u * SCENE_SPLASH_MAX;
    memset(&splashes, 0, sizeof splashes);
    for (uint32_t tick = 100; tick <= last_tick; tick++) {
        surface_splash(&splashes, v3(0.0f, 0.0f, 0.0f), false, v3(0.0f, -1.0f, 0.0f), 0.01f, 20,
                       tick);
    }
    surface_splash_show(&splashes, last_tick, &shown);
    assert_int_equal(shown.splash_count, SCENE_SPLASH_MAX);
    for (uint32_t i = 0; i < SCENE_SPLASH_MAX; i++) {
        assert_float_equal(shown.splash[i].age_s, (float)i * CORE_TICK_S, 1e-6f);
    }
    surface_splash_show(&splashes, last_tick + 2u * CORE_TICK_HZ, &shown);
    assert_int_equal(shown.splash_count, 0);
}

/* Puts one splash of 40 drops at the middle of the tank into the scene. */
static void splash_at(float age_s, float height_m)
{
    memset(&shown, 0, sizeof shown);
    shown.tank_size_m = v3(0.9f, 0.2f, 0.6f);
    shown.splash_count = 1;
    shown.splash[0] = (struct scene_splash){ .position_m = v3(0.0f, height_m, 0.0f),
                                             .in_bowl = height_m > 0.0f,
                                             .push_m_s = v3(0.3f, -0.8f, 0.0f),
                                             .radius_m = 0.04f,
                                             .age_s = age_s,
                                             .seed = 7,
                                             .drops = 40 };
}

static void test_drops_rise_fall_and_make_rings(void **state)
{
    (void)state;
    float top_m = 0.0f;
    bool was_ring = false;
    for (uint32_t i = 0; i <= 120u; i++) {
        splash_at((float)i / 100.0f, 0.0f);
        const uint32_t count = quad_spray_of(&shown, drops);
        assert_true(count <= 67u); /* 40 drops, 26 drops of a poi, and one wave. */
        for (uint32_t k = 0; k < count; k++) {
            const struct quad_drop *const drop = &drops[k];
            const bool is_ring = drop->stretch == 0.0f;
            top_m = f_max(top_m, drop->place[1]);
            was_ring |= is_ring;
            assert_true(drop->place[1] >= 0.0f && (!is_ring || drop->place[1] < 0.001f));
            assert_true(drop->opacity >= 0.0f && drop->opacity <= 1.0f);
        }
    }
    /* The last frame is SCENE_SPLASH_S after the splash: every ring has faded. */
    assert_int_equal(quad_spray_of(&shown, drops), 0);
    assert_true(was_ring && top_m > 0.03f && top_m < 0.2f);
}

static void test_equal_scenes_have_equal_drops_and_never_more_than_the_pool(void **state)
{
    (void)state;
    static struct quad_drop again[QUAD_SPRAY_MAX];
    splash_at(0.2f, 0.0f);
    for (uint32_t i = 1; i < SCENE_SPLASH_MAX; i++) {
        shown.splash[i] = shown.splash[0];
        shown.splash[i].seed += i;
    }
    shown.splash_count = SCENE_SPLASH_MAX;
    const uint32_t count = quad_spray_of(&shown, drops);
    assert_int_equal(count, QUAD_SPRAY_MAX);
    assert_int_equal(quad_spray_of(&shown, again), count);
    assert_memory_equal(drops, again, sizeof drops);
}

static void test_rings_lie_on_the_water_of_tank_or_bowl(void **state)
{
    (void)state;
    uint32_t rings = 0;
    splash_at(0.45f, 0.0f);
    shown.splash[0].position_m.x = 0.5f * shown.tank_size_m.x;
    const uint32_t count = quad_spray_of(&shown, drops);
    for (uint32_t i = 0; i < count; i++) {
        rings += drops[i].stretch == 0.0f;
        assert_true(drops[i].stretch > 0.0f ||
                    f_abs(drops[i].place[0]) <= 0.5f * shown.tank_size_m.x);
    }
    assert_true(rings > 0);
    /* In a bowl, whose water is higher than that of the tank, a fall makes rings and a wave. */
    bool has_wave = false;
    rings = 0;
    for (uint32_t k = 0; k < 30u; k++) {
        splash_at((float)k / 60.0f, 0.0015f);
        shown.splash[0].radius_m = 0.01f;
        const uint32_t in_bowl = quad_spray_of(&shown, drops);
        for (uint32_t i = 0; i < in_bowl; i++) {
            const bool is_ring = drops[i].stretch == 0.0f;
            rings += is_ring;
            has_wave |= is_ring && drops[i].place[3] > 0.03f;
            assert_true(!is_ring ||
                        (drops[i].place[1] > 0.001f && f_abs(drops[i].place[0]) < 0.05f));
        }
    }
    assert_true(rings > 30u && has_wave);
}

/* Returns the radius of the largest ring of the scene, or 0 without a ring. */
static float widest_ring_m(void)
{
    const uint32_t count = quad_spray_of(&shown, drops);
    float widest_m = 0.0f;
    for (uint32_t i = 0; i < count; i++) {
        widest_m = drops[i].stretch == 0.0f ? f_max(widest_m, drops[i].place[3]) : widest_m;
    }
    return widest_m;
}

static void test_a_poi_makes_a_wave_that_grows_and_ends_at_a_wall(void **state)
{
    (void)state;
    splash_at(0.1f, 0.0f);
    const float early_m = widest_ring_m();
    splash_at(0.4f, 0.0f);
    const float late_m = widest_ring_m();
    assert_true(early_m > 0.04f && late_m > early_m + 0.03f);
    shown.splash[0].position_m.z = 0.5f * shown.tank_size_m.z - 0.5f * late_m;
    assert_true(widest_ring_m() < 0.04f);
    shown.splash[0].position_m.z = 0.0f;
    shown.splash[0].radius_m = 0.01f; /* A splash of a fish. */
    assert_true(widest_ring_m() < 0.04f);
}

/* Returns the number of rings of drops. */
static uint32_t drop_rings(void)
{
    const uint32_t count = quad_spray_of(&shown, drops);
    uint32_t rings = 0;
    for (uint32_t i = 0; i < count; i++) {
        rings += drops[i].stretch == 0.0f && drops[i].place[3] < 0.03f;
    }
    return rings;
}

static void test_drops_make_no_ring_where_a_poi_is_seen_in_the_water(void **state)
{
    (void)state;
    splash_at(0.45f, 0.0f);
    const uint32_t rings = drop_rings();
    shown.poi[1] = (struct scene_poi){ .present = 1, .ring_radius_m = 0.04f };
    shown.poi[1].position_m = v3(0.06f, 0.01f, 0.0f);
    const uint32_t left = drop_rings();
    assert_true(left < rings);
    /* A poi at a depth of 4 cm is seen through a place of the surface that is nearer to the
     * camera. */
    shown.view.eye_m = v3(0.06f, 0.5f, 0.5f);
    shown.poi[1].position_m.y = -0.04f;
    const uint32_t behind = drop_rings();
    shown.poi[1].position_m.z = -0.04f;
    assert_true(behind < rings && drop_rings() != behind);
    shown.poi[1].position_m.z = 0.0f;
    shown.poi[1].position_m.y = 0.1f; /* The poi is in the air, far above the rings. */
    assert_int_equal(drop_rings(), rings);
}

static void test_a_tilted_poi_splashes_at_its_lowest_part(void **state)
{
    (void)state;
    struct poi poi = { .splash_m_s = 0.5f, .velocity_m_s = v3(0.0f, -0.5f, 0.0f) };
    poi.sheet.radius_m = 0.04f;
    poi.angles.roll_rad = 30.0f * F_DEG;
    const vec3 up = vec_basis_from_angles(poi.angles).up;
    memset(&splashes, 0, sizeof splashes);
    surface_splash_poi(&splashes, &poi, 100u);
    surface_splash_show(&splashes, 101u, &shown);
    assert_int_equal(shown.splash_count, 1);
    /* The plane of the ring falls toward the horizontal part of its normal. */
    assert_true(shown.splash[0].position_m.x * up.x > 0.0f);
    assert_true(shown.splash[0].radius_m < poi_outer_radius_m(&poi));
}

static void test_torn_paper_loses_few_scraps_at_its_holes(void **state)
{
    (void)state;
    static struct poi poi;
    memset(&splashes, 0, sizeof splashes);
    memset(&poi, 0, sizeof poi);
    poi.sheet.radius_m = 0.04f;
    poi.position_m = v3(0.1f, -0.02f, 0.05f);
    const uint32_t hole = 20u * SHEET_SIDE + 8u;
    poi.sheet.state[hole] = CELL_HOLE;
    surface_splash_scrap(&splashes, &poi, 100);
    surface_splash_show(&splashes, 100, &shown);
    assert_int_equal(shown.scrap_count, 0); /* An old hole loses no scrap. */
    poi.strain.cells_torn = 1;
    for (uint32_t tick = 100; tick < 100 + 4u * SPLASH_SCRAP_TICKS; tick++) {
        surface_splash_scrap(&splashes, &poi, tick);
    }
    surface_splash_show(&splashes, 100 + 4u * SPLASH_SCRAP_TICKS, &shown);
    assert_int_equal(shown.scrap_count, 4);
    for (uint32_t i = 0; i < shown.scrap_count; i++) {
        const vec3 at = shown.scrap[i].position_m;
        assert_float_equal(at.x, 0.1f + sheet_line_m(&poi.sheet, 8), 1e-6f);
        assert_float_equal(at.y, -0.02f, 1e-6f);
        assert_float_equal(at.z, 0.05f + sheet_line_m(&poi.sheet, 20), 1e-6f);
    }
    surface_splash_show(&splashes, 100 + 15u * CORE_TICK_HZ, &shown);
    assert_int_equal(shown.scrap_count, 0);
}

static void test_a_scrap_falls_into_the_water_and_sinks_to_the_floor(void **state)
{
    (void)state;
    memset(&shown, 0, sizeof shown);
    shown.tank_size_m = v3(0.9f, 0.1f, 0.6f);
    shown.scrap_count = 1;
    shown.scrap[0] = (struct scene_scrap){ .position_m = v3(0.1f, 0.04f, 0.0f),
                                           .push_m_s = v3(0.5f, 0.2f, 0.0f),
                                           .seed = 9 };
    assert_int_equal(quad_scraps_of(&shown, drops), 0); /* In the air. */
    float last_m = 0.0f;
    for (uint32_t i = 1; i < 28u; i++) {
        shown.scrap[0].age_s = 0.5f * (float)i;
        assert_int_equal(quad_scraps_of(&shown, drops), 1);
        assert_true(drops[0].place[1] <= last_m);
        assert_true(drops[0].place[0] > 0.05f && drops[0].place[0] < 0.4f);
        last_m = drops[0].place[1];
    }
    assert_float_equal(last_m, 0.003f - 0.1f, 1e-6f);
    shown.scrap[0].position_m.x = 1.0f; /* Torn beyond the wall, so not in the water. */
    assert_int_equal(quad_scraps_of(&shown, drops), 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup(test_each_fish_that_falls_and_fast_escapes_splash, open_round),
        cmocka_unit_test(test_a_fast_poi_throws_more_drops_than_a_slow_one),
        cmocka_unit_test(test_a_splash_ends_and_the_newest_splashes_are_kept),
        cmocka_unit_test(test_drops_rise_fall_and_make_rings),
        cmocka_unit_test(test_equal_scenes_have_equal_drops_and_never_more_than_the_pool),
        cmocka_unit_test(test_a_poi_makes_a_wave_that_grows_and_ends_at_a_wall),
        cmocka_unit_test(test_drops_make_no_ring_where_a_poi_is_seen_in_the_water),
        cmocka_unit_test(test_a_tilted_poi_splashes_at_its_lowest_part),
        cmocka_unit_test(test_torn_paper_loses_few_scraps_at_its_holes),
        cmocka_unit_test(test_a_scrap_falls_into_the_water_and_sinks_to_the_floor),
        cmocka_unit_test(test_rings_lie_on_the_water_of_tank_or_bowl),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
