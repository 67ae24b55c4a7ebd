/* test_shade.c -- shadows: how they age, how they draw (2013 thesis, section 3.5), how they
 * frighten. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include <cmocka.h>

#include "core/core.h"
#include "core/tank/tank.h"

#define DT CORE_TICK_S

static struct tank tank;

static const struct law *law_of(enum tank_preset_id preset)
{
    return &tank_preset((uint8_t)preset)->law;
}

static struct shade_cast fan_at(float x_m, float z_m)
{
    return (struct shade_cast){ 1, x_m, z_m, 0.10f, SHADE_FAN_DARK };
}

/* A fan that has been held still for `still_s`. */
static struct shade still_fan(float still_s)
{
    const struct shade_cast cast = fan_at(0.0f, 0.0f);
    struct shade shade = { 0 };
    for (float t = 0.0f; t < still_s + 1.5f * DT; t += DT) {
        shade_tick(&shade, &cast, DT);
    }
    return shade;
}

static float pull_cm_s(const struct shade *shade, enum tank_preset_id preset, float distance_cm)
{
    return 100.0f * shade_pull_m_s(shade, law_of(preset), 0.01f * distance_cm);
}

static int near(float a, float b, float tolerance)
{
    return f_abs(a - b) <= tolerance;
}

/* ---- The pull ------------------------------------------------------------------------------- */

/* Eq. 3.5 with S = 0.01 a frame and the 60 frames a second of table 4.2 for 200 fish. */
static void test_the_pull_is_equation_3_5_per_second(void **state)
{
    (void)state;
    const struct shade shade = still_fan(0.0f);
    for (float r_cm = 5.0f; r_cm <= 20.0f; r_cm += 0.5f) {
        const float pull = pull_cm_s(&shade, TANK_PRESET_THESIS, r_cm);
        assert_true(near(pull, 0.6f * (20.0f - r_cm), 1e-4f));
    }
}

/* Figure 3.7: the field ends at twice the radius; beyond, the formula would push away. */
static void test_beyond_twice_its_radius_nothing_pulls_or_pushes(void **state)
{
    (void)state;
    const struct shade shade = still_fan(9.0f);
    for (float r_cm = 20.001f; r_cm < 200.0f; r_cm += 3.0f) {
        assert_true(pull_cm_s(&shade, TANK_PRESET_THESIS, r_cm) == 0.0f);
        assert_true(pull_cm_s(&shade, TANK_PRESET_FESTIVAL, r_cm) == 0.0f);
    }
}

/* Area A of figure 3.7, reached by a fade instead of a step. */
static void test_the_pull_fades_to_none_between_5_and_3_cm(void **state)
{
    (void)state;
    const struct shade shade = still_fan(0.0f);
    assert_true(near(pull_cm_s(&shade, TANK_PRESET_THESIS, 4.0f), 0.5f * 0.6f * 16.0f, 1e-4f));
    for (float r_cm = 0.0f; r_cm <= 3.0f; r_cm += 0.25f) {
        assert_true(pull_cm_s(&shade, TANK_PRESET_THESIS, r_cm) <= 1e-5f);
    }
}

/* By the formula in space a fish 18 cm straight below the fan would be pulled up. */
static void test_depth_does_not_count(void **state)
{
    (void)state;
    const struct shade shade = still_fan(0.0f);
    assert_true(near(shade_distance_m(&shade.cast, v3(0.06f, -0.18f, 0.08f)), 0.10f, 1e-6f));
    assert_true(shade_covers(&shade.cast, v3(0.0f, -0.19f, 0.099f)));
    assert_false(shade_covers(&shade.cast, v3(0.0f, -0.01f, 0.101f)));
}

static void test_thesis_fish_are_drawn_at_once_and_others_after_the_dwell(void **state)
{
    (void)state;
    const struct shade fresh = still_fan(0.0f);
    assert_true(pull_cm_s(&fresh, TANK_PRESET_THESIS, 10.0f) > 5.9f);
    for (int preset = TANK_PRESET_FESTIVAL; preset < TANK_PRESET_COUNT; preset++) {
        const float dwell_s = law_of((enum tank_preset_id)preset)->shade_dwell_s;
        const struct shade early = still_fan(dwell_s - 0.1f);
        const struct shade late = still_fan(dwell_s + 0.1f);
        assert_true(preset == TANK_PRESET_THESIS ? dwell_s == 0.0f
                                                 : dwell_s >= 2.0f && dwell_s <= 3.0f);
        assert_true(preset == TANK_PRESET_THESIS ||
                    pull_cm_s(&early, (enum tank_preset_id)preset, 10.0f) == 0.0f);
        assert_true(pull_cm_s(&late, (enum tank_preset_id)preset, 10.0f) > 5.9f);
    }
}

/* ---- Course --------------------------------------------------------------------------------- */

static int draw(struct shade_course *course, vec3 at_m, float yaw_rad)
{
    const struct shade shade = still_fan(0.0f);
    const struct fish fish = { .position_m = at_m, .angles = { .yaw_rad = yaw_rad },
                               .length_m = 0.05f, .stamina = 1.0f };
    return shade_draw(&shade, 1, law_of(TANK_PRESET_THESIS), &fish, course);
}

/* Section 3.3: forces added to swimming may not exceed 7.5 cm/s. */
static void test_with_the_pull_a_fish_keeps_to_7_5_cm_s(void **state)
{
    (void)state;
    for (float r_m = 0.03f; r_m < 0.2f; r_m += 0.005f) {
        for (float yaw_rad = -3.0f; yaw_rad < 3.0f; yaw_rad += 0.2f) {
            struct shade_course course = { .heading_rad = yaw_rad, .speed_m_s = 0.0525f };
            draw(&course, v3(r_m, -0.1f, 0.0f), course.heading_rad);
            assert_true(course.speed_m_s <= 0.0750001f);
        }
    }
    struct shade_course inward = { .heading_rad = 0.5f * F_PI, .speed_m_s = 0.0525f };
    assert_true(draw(&inward, v3(0.10f, -0.1f, 0.0f), 0.5f * F_PI)); /* 5.25 + 6 = 11.25 cm/s */
    assert_true(near(inward.speed_m_s, 0.075f, 1e-5f));
}

static void test_course_and_pull_add_up_as_velocities(void **state)
{
    (void)state;
    /* At r = 13 cm it pulls by 4.2 cm/s to -x, while the fish swims 3 cm/s to -z. */
    const float want_rad = f_atan2(0.042f, 0.03f);
    struct shade_course course = { .heading_rad = 0.0f, .speed_m_s = 0.03f };
    assert_true(draw(&course, v3(0.13f, -0.1f, 0.0f), want_rad));
    assert_true(near(course.heading_rad, want_rad, 1e-3f));
    assert_true(near(course.speed_m_s, f_sqrt(0.03f * 0.03f + 0.042f * 0.042f), 1e-4f));
}

static void test_a_fish_turns_to_the_shade_before_it_swims_there(void **state)
{
    (void)state;
    struct shade_course course = { .heading_rad = 0.0f, .speed_m_s = 0.0f };
    assert_true(draw(&course, v3(0.10f, -0.1f, 0.0f), -0.5f * F_PI)); /* Its tail to the shade. */
    assert_true(near(course.heading_rad, 0.5f * F_PI, 1e-3f));
    assert_true(course.speed_m_s == 0.0f);
}

static void test_out_of_the_field_a_course_stays_as_it_is(void **state)
{
    (void)state;
    struct shade_course course = { .heading_rad = 1.25f, .speed_m_s = 0.04f };
    assert_false(draw(&course, v3(0.21f, -0.1f, 0.0f), 0.0f));
    assert_false(draw(&course, v3(0.02f, -0.1f, 0.0f), 0.0f));
    assert_true(course.heading_rad == 1.25f && course.speed_m_s == 0.04f);
}

/* ---- Age ------------------------------------------------------------------------------------ */

static void glide(struct shade *shade, float speed_m_s, float seconds)
{
    struct shade_cast cast = shade->cast;
    for (float t = 0.0f; t < seconds; t += DT) {
        cast.x_m += speed_m_s * DT;
        shade_tick(shade, &cast, DT);
    }
}

static void test_a_shadow_that_moves_has_to_be_still_anew(void **state)
{
    (void)state;
    struct shade shade = still_fan(4.0f);
    assert_true(near(shade.still_s, 4.0f, 2.0f * DT));
    glide(&shade, 0.08f, 0.5f);
    assert_true(shade.still_s == 0.0f);
    assert_true(near(shade.edge_m_s, 0.08f, 0.002f));
    assert_true(pull_cm_s(&shade, TANK_PRESET_FESTIVAL, 10.0f) == 0.0f);
}

static void test_a_shadow_may_be_drawn_along_slowly_with_its_fish(void **state)
{
    (void)state;
    struct shade shade = still_fan(4.0f);
    glide(&shade, 0.035f, 2.0f);
    assert_true(near(shade.still_s, 4.0f, 0.1f));
    assert_true(pull_cm_s(&shade, TANK_PRESET_FESTIVAL, 10.0f) > 5.9f);
    assert_true(shade_alarm(&shade, law_of(TANK_PRESET_FESTIVAL), v3(shade.cast.x_m, -0.05f, 0),
                            DT) == 0.0f);
}

/* A mouse steps by a pixel, 0.85 mm, each 60th of a second at 5 cm/s, and rests between. */
static void test_the_steps_of_a_slow_mouse_are_no_movement(void **state)
{
    (void)state;
    struct shade shade = still_fan(1.0f);
    struct shade_cast cast = shade.cast;
    for (int i = 0; i < 240; i++) {
        cast.x_m += i % 30 == 0 ? 0.00085f : 0.0f; /* 3.4 mm/s */
        shade_tick(&shade, &cast, DT);
        assert_true(shade.edge_m_s < SHADE_MOVES_M_S);
    }
    assert_true(shade.still_s > 2.0f);
}

static void test_a_shadow_that_grows_has_a_moving_edge(void **state)
{
    (void)state;
    struct shade shade = still_fan(3.0f);
    struct shade_cast cast = shade.cast;
    for (int i = 0; i < 60; i++) {
        cast.radius_m += 0.10f * DT;
        shade_tick(&shade, &cast, DT);
    }
    assert_true(near(shade.edge_m_s, 0.10f, 0.005f));
    assert_true(shade.still_s == 0.0f);
}

static void test_a_shadow_that_goes_is_forgotten(void **state)
{
    (void)state;
    struct shade shade = still_fan(5.0f);
    const struct shade_cast none = { 0 };
    const struct shade zero = { 0 };
    shade_tick(&shade, &none, DT);
    assert_memory_equal(&shade, &zero, sizeof zero);
}

static void test_a_shadow_that_is_nowhere_is_a_bug(void **state)
{
    (void)state;
    struct shade shade = { 0 };
    struct shade_cast lost = fan_at(0.0f, 0.0f);
    lost.x_m = 1.0f / 0.0f;
    expect_assert_failure(shade_tick(&shade, &lost, DT));
    lost = fan_at(0.0f, f_sqrt(-1.0f));
    expect_assert_failure(shade_tick(&shade, &lost, DT));
    lost = fan_at(0.0f, 0.0f);
    lost.radius_m = 0.0f;
    expect_assert_failure(shade_tick(&shade, &lost, DT));
}

/* ---- Fright --------------------------------------------------------------------------------- */

static float alarm(const struct shade *shade, enum tank_preset_id preset, float r_m)
{
    return shade_alarm(shade, law_of(preset), v3(shade->cast.x_m, -0.05f, r_m), DT);
}

static void test_a_new_shadow_frightens_whom_it_covers(void **state)
{
    (void)state;
    const struct shade fresh = still_fan(0.0f);
    const struct shade old = still_fan(0.5f);
    assert_true(alarm(&fresh, TANK_PRESET_FESTIVAL, 0.05f) > 0.0f);
    assert_true(alarm(&fresh, TANK_PRESET_OFFICIAL, 0.05f) > 0.0f);
    assert_true(alarm(&fresh, TANK_PRESET_FESTIVAL, 0.15f) == 0.0f);
    assert_true(alarm(&old, TANK_PRESET_FESTIVAL, 0.05f) == 0.0f);
}

static void test_an_edge_faster_than_5_cm_s_frightens(void **state)
{
    (void)state;
    struct shade slow = still_fan(2.0f), fast = slow;
    glide(&slow, 0.045f, 1.0f);
    glide(&fast, 0.055f, 1.0f);
    assert_true(alarm(&slow, TANK_PRESET_FESTIVAL, 0.05f) == 0.0f);
    assert_true(alarm(&fast, TANK_PRESET_FESTIVAL, 0.05f) > 0.0f);
}

/* Section 3.5 models the still shadow alone. */
static void test_thesis_fish_know_no_fright_by_shadows(void **state)
{
    (void)state;
    struct shade shade = still_fan(0.0f);
    assert_true(alarm(&shade, TANK_PRESET_THESIS, 0.0f) == 0.0f);
    glide(&shade, 1.0f, 0.3f);
    assert_true(alarm(&shade, TANK_PRESET_THESIS, 0.0f) == 0.0f);
    assert_true(pull_cm_s(&shade, TANK_PRESET_THESIS, 10.0f) > 5.9f);
}

/* A weak contrast makes uneasy; it takes seconds where a fan takes a tenth of one. */
static void test_thin_paper_alarms_a_tenth_as_much_as_a_fan(void **state)
{
    (void)state;
    struct shade fan = still_fan(0.0f), paper = fan;
    paper.cast.dark = 0.34f;
    const float ratio = alarm(&paper, TANK_PRESET_FESTIVAL, 0.0f) /
                        alarm(&fan, TANK_PRESET_FESTIVAL, 0.0f);
    assert_true(ratio > 0.05f && ratio < 0.2f);
    paper.cast.dark = SHADE_SUDDEN_DARK;
    assert_true(alarm(&paper, TANK_PRESET_FESTIVAL, 0.0f) == 0.0f);
}

/* ---- Whole tanks ---------------------------------------------------------------------------- */

static void hold_fan(uint32_t *tick, const struct shade_cast *cast, uint32_t seconds)
{
    struct shade_cast casts[TANK_SHADE_MAX] = { [0] = *cast };
    for (uint32_t i = 0; i < seconds * CORE_TICK_HZ; i++) {
        tank_cast(&tank, casts);
        tank_tick(&tank, (*tick)++, NULL, 0);
    }
}

struct gathering {
    uint32_t at_0, at_1, at_6, at_10, at_30;
};

static struct gathering gather(uint32_t seed)
{
    const struct shade_cast fan = fan_at(0.0f, 0.0f);
    struct gathering count = { 0 };
    uint32_t tick = 0;
    tank_init(&tank, TANK_PRESET_THESIS, 200, seed);
    count.at_0 = tank_shade_count(&tank, &fan);
    hold_fan(&tick, &fan, 1);
    count.at_1 = tank_shade_count(&tank, &fan);
    hold_fan(&tick, &fan, 5);
    count.at_6 = tank_shade_count(&tank, &fan);
    hold_fan(&tick, &fan, 4);
    count.at_10 = tank_shade_count(&tank, &fan);
    hold_fan(&tick, &fan, 20);
    count.at_30 = tank_shade_count(&tank, &fan);
    return count;
}

/* Figures 4.17 to 4.20: 200 fish; more of them in the shade after 1, 6 and 10 s, and those who came
 * stay. One fish that bursts away or gives way makes a single tank's count falter by a few. */
static void test_fish_gather_as_in_figures_4_17_to_4_20(void **state)
{
    (void)state;
    struct gathering all = { 0 };
    for (uint32_t seed = 1; seed <= 5; seed++) {
        const struct gathering one = gather(seed);
        print_message("seed %u: %u, %u, %u, %u, %u in the shade after 0, 1, 6, 10, 30 s\n", seed,
                      one.at_0, one.at_1, one.at_6, one.at_10, one.at_30);
        assert_true(one.at_1 > one.at_0);
        assert_true(2u * one.at_6 >= 3u * one.at_1);
        assert_true(one.at_10 + 3u >= one.at_6);
        assert_true(one.at_30 + 3u >= one.at_10);
        all.at_6 += one.at_6;
        all.at_10 += one.at_10;
    }
    assert_true(all.at_10 * 100u > all.at_6 * 105u);
}

static void test_no_swimmer_in_a_tank_wants_more_than_7_5_cm_s(void **state)
{
    const struct shade_cast casts[TANK_SHADE_MAX] = { [0] = fan_at(0.0f, 0.0f) };
    uint32_t drawn = 0;
    (void)state;
    tank_init(&tank, TANK_PRESET_THESIS, 200, 2);
    for (uint32_t tick = 0; tick < 3u * CORE_TICK_HZ; tick++) {
        tank_cast(&tank, casts);
        tank_tick(&tank, tick, NULL, 0);
        for (uint32_t i = 0; i < tank.fish_count; i++) {
            const struct fish *fish = &tank.fish[i];
            if (fish->gait == GAIT_REST || fish->gait == GAIT_SWIM) {
                assert_true(fish->speed_goal_m_s <= 0.0750001f);
                drawn += fish->gait == GAIT_REST && fish->speed_goal_m_s > 0.04f;
            }
        }
    }
    assert_true(drawn > 100u); /* Resting fish are drawn, too. */
}

/* Noses that turn this way and that: reversals of turns faster than 20 degrees a second, for each
 * fish in the shade and each second. Free fish make 0.2 to 0.5, by how many they are. */
static void test_gathered_fish_do_not_jitter(void **state)
{
    static float turning[TANK_FISH_MAX];
    const struct shade_cast casts[TANK_SHADE_MAX] = { [0] = fan_at(0.0f, 0.0f) };
    uint32_t reversals = 0, fish_ticks = 0;
    (void)state;
    tank_init(&tank, TANK_PRESET_THESIS, 600, 1);
    for (uint32_t tick = 0; tick < 14u * CORE_TICK_HZ; tick++) {
        tank_cast(&tank, casts);
        tank_tick(&tank, tick, NULL, 0);
        for (uint32_t i = 0; tick > 6u * CORE_TICK_HZ && i < tank.fish_count; i++) {
            const struct fish *fish = &tank.fish[i];
            const float rate = fish->yaw_rate_rad_s;
            if (!shade_covers(&casts[0], fish->position_m) || f_abs(rate) < 20.0f * F_DEG) {
                fish_ticks += (uint32_t)shade_covers(&casts[0], fish->position_m);
                continue;
            }
            fish_ticks++;
            reversals += rate * turning[i] < 0.0f;
            turning[i] = rate;
        }
    }
    const float per_s = (float)(reversals * CORE_TICK_HZ) / (float)fish_ticks;
    print_message("%.2f reversals a second by each of %.0f fish in the shade\n", (double)per_s,
                  (double)fish_ticks / (8.0 * CORE_TICK_HZ));
    assert_true(fish_ticks > 8u * CORE_TICK_HZ * 40u);
    assert_true(per_s < 1.3f);
}

/* Where fish know fright, a fan that drops in empties its place; held still, it fills it. */
static void test_in_the_stall_a_new_fan_scatters_and_a_still_one_gathers(void **state)
{
    const struct shade_cast fan = fan_at(0.0f, 0.0f);
    const struct shade_cast none = { 0 };
    (void)state;
    for (uint32_t seed = 1; seed <= 3; seed++) {
        uint32_t tick = 0;
        tank_init(&tank, TANK_PRESET_FESTIVAL, 300, seed);
        hold_fan(&tick, &none, 3);
        const uint32_t before = tank_shade_count(&tank, &fan);
        hold_fan(&tick, &fan, 1);
        const uint32_t scattered = tank_shade_count(&tank, &fan);
        hold_fan(&tick, &fan, 1);
        assert_true(2u * tank_shade_count(&tank, &fan) < before); /* They flee for a while. */
        hold_fan(&tick, &fan, 8);
        const uint32_t gathered = tank_shade_count(&tank, &fan);
        print_message("seed %u: %u before, %u after 1 s, %u after 10 s\n", seed, before, scattered,
                      gathered);
        assert_true(2u * scattered < before);
        assert_true(gathered > before + before / 2u);
    }
}

static uint32_t escaping(void)
{
    uint32_t count = 0;
    for (uint32_t i = 0; i < tank.fish_count; i++) {
        count += tank.fish[i].gait == GAIT_ESCAPE;
    }
    return count;
}

static uint32_t escapes_under(uint8_t preset, float fan_m_s, float dark)
{
    struct shade_cast casts[TANK_SHADE_MAX] = { [0] = fan_at(-0.30f, 0.0f) };
    uint32_t most = 0;
    casts[0].dark = dark;
    tank_init(&tank, preset, 200, 4);
    for (uint32_t tick = 0; tick < 2u * CORE_TICK_HZ; tick++) {
        casts[0].x_m += tick > CORE_TICK_HZ ? fan_m_s * DT : 0.0f;
        tank_cast(&tank, casts);
        tank_tick(&tank, tick, NULL, 0);
        if (tick > CORE_TICK_HZ) { /* The fright of its coming is over. */
            const uint32_t now = escaping();
            most = now > most ? now : most;
        }
    }
    return most;
}

static void test_a_fan_that_sweeps_by_startles_and_a_poi_in_the_air_hardly(void **state)
{
    (void)state;
    const uint32_t swept = escapes_under(TANK_PRESET_FESTIVAL, 0.30f, SHADE_FAN_DARK);
    const uint32_t still = escapes_under(TANK_PRESET_FESTIVAL, 0.0f, SHADE_FAN_DARK);
    const uint32_t paper = escapes_under(TANK_PRESET_FESTIVAL, 0.30f, 0.34f);
    print_message("%u start under a sweeping fan, %u under a still one, %u under paper\n", swept,
                  still, paper);
    assert_true(swept >= 8u);
    assert_true(still <= 2u);
    assert_true(paper <= swept / 4u);
    assert_int_equal(escapes_under(TANK_PRESET_THESIS, 0.30f, SHADE_FAN_DARK), 0);
}

/* ---- The stall ------------------------------------------------------------------------------ */

static struct core core;
static struct output output;

static void open_stall(void)
{
    const struct core_config config = { .seed = 3, .fish_count = 60 };
    assert_int_equal(core_init(&core, &config), CORE_OK);
}

static void test_what_a_hand_holds_falls_on_the_tank_within_its_bounds(void **state)
{
    struct input input = { .shade[2] = { 1, 0.1f, -0.2f, 0.12f } };
    (void)state;
    open_stall();
    core_tick(&core, &input, &output);
    const struct shade_cast *cast = &core.tank.shade[2].cast;
    assert_true(cast->present && cast->x_m == 0.1f && cast->z_m == -0.2f);
    assert_true(cast->radius_m == 0.12f && cast->dark == SHADE_FAN_DARK);
    assert_int_equal(core.tank.shade[0].cast.present, 0);
    input.shade[2] = (struct shade_input){ 1, 3e38f, -3e38f, 3e38f };
    core_tick(&core, &input, &output);
    assert_true(cast->x_m < 2.0f && cast->z_m > -2.0f && cast->radius_m == SHADE_RADIUS_MAX_M);
    input.shade[2].radius_m = -1.0f;
    core_tick(&core, &input, &output);
    assert_true(cast->radius_m == SHADE_RADIUS_MIN_M);
    input.shade[2] = (struct shade_input){ 0, 1.0f / 0.0f, 0.0f, 0.0f }; /* Not looked at. */
    core_tick(&core, &input, &output);
    assert_int_equal(cast->present, 0);
}

static void test_a_fan_that_is_no_number_is_a_bug(void **state)
{
    static const float broken[] = { 1.0f / 0.0f, -1.0f / 0.0f };
    (void)state;
    open_stall();
    for (size_t i = 0; i < 2; i++) {
        struct input input = { .shade[0] = { 1, broken[i], 0.0f, 0.1f } };
        expect_assert_failure(core_tick(&core, &input, &output));
        input.shade[0] = (struct shade_input){ 1, 0.0f, broken[i], 0.1f };
        expect_assert_failure(core_tick(&core, &input, &output));
        input.shade[0] = (struct shade_input){ 1, 0.0f, 0.0f, broken[i] };
        expect_assert_failure(core_tick(&core, &input, &output));
    }
}

static void test_a_dry_poi_casts_its_paper_and_a_dipped_one_nothing(void **state)
{
    struct poi poi;
    (void)state;
    poi_init(&poi, 6, v3(0.1f, 0.05f, -0.1f), 1);
    const struct shade_cast level = poi_shade(&poi);
    assert_true(level.present && level.x_m == 0.1f && level.z_m == -0.1f);
    assert_true(near(level.radius_m, POI_OUTER_RADIUS_M, 1e-4f));
    assert_true(near(level.dark, POI_PAPER_DARK, 1e-4f));
    poi.angles.pitch_rad = 60.0f * F_DEG; /* An ellipse of half the area. */
    assert_true(near(poi_shade(&poi).radius_m, 0.7071f * POI_OUTER_RADIUS_M, 1e-4f));
    poi.immersed = 0.01f;
    assert_int_equal(poi_shade(&poi).present, 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_the_pull_is_equation_3_5_per_second),
        cmocka_unit_test(test_beyond_twice_its_radius_nothing_pulls_or_pushes),
        cmocka_unit_test(test_the_pull_fades_to_none_between_5_and_3_cm),
        cmocka_unit_test(test_depth_does_not_count),
        cmocka_unit_test(test_thesis_fish_are_drawn_at_once_and_others_after_the_dwell),
        cmocka_unit_test(test_with_the_pull_a_fish_keeps_to_7_5_cm_s),
        cmocka_unit_test(test_course_and_pull_add_up_as_velocities),
        cmocka_unit_test(test_a_fish_turns_to_the_shade_before_it_swims_there),
        cmocka_unit_test(test_out_of_the_field_a_course_stays_as_it_is),
        cmocka_unit_test(test_a_shadow_that_moves_has_to_be_still_anew),
        cmocka_unit_test(test_a_shadow_may_be_drawn_along_slowly_with_its_fish),
        cmocka_unit_test(test_the_steps_of_a_slow_mouse_are_no_movement),
        cmocka_unit_test(test_a_shadow_that_grows_has_a_moving_edge),
        cmocka_unit_test(test_a_shadow_that_goes_is_forgotten),
        cmocka_unit_test(test_a_shadow_that_is_nowhere_is_a_bug),
        cmocka_unit_test(test_a_new_shadow_frightens_whom_it_covers),
        cmocka_unit_test(test_an_edge_faster_than_5_cm_s_frightens),
        cmocka_unit_test(test_thesis_fish_know_no_fright_by_shadows),
        cmocka_unit_test(test_thin_paper_alarms_a_tenth_as_much_as_a_fan),
        cmocka_unit_test(test_fish_gather_as_in_figures_4_17_to_4_20),
        cmocka_unit_test(test_no_swimmer_in_a_tank_wants_more_than_7_5_cm_s),
        cmocka_unit_test(test_gathered_fish_do_not_jitter),
        cmocka_unit_test(test_in_the_stall_a_new_fan_scatters_and_a_still_one_gathers),
        cmocka_unit_test(test_a_fan_that_sweeps_by_startles_and_a_poi_in_the_air_hardly),
        cmocka_unit_test(test_what_a_hand_holds_falls_on_the_tank_within_its_bounds),
        cmocka_unit_test(test_a_fan_that_is_no_number_is_a_bug),
        cmocka_unit_test(test_a_dry_poi_casts_its_paper_and_a_dipped_one_nothing),
    };
    cmocka_set_message_output(CM_OUTPUT_TAP);
    return cmocka_run_group_tests(tests, NULL, NULL);
}
