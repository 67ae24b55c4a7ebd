/* test_catch.c -- checks which fish are caught on the paper, and which fish the paper only
 * pushes. */
#include "core/poi/poi_fields.h"
#include "core/tank/collision/obstacle.h"
#include "core/tank/tank_fields.h"
#include "tests/unit/support/poi_fixture.h"

#define FISH_M 0.045f

static struct poi_fixture fixture;

static uint32_t lifted(uint8_t grade, uint32_t seed, float off_x_m)
{
    return fixture_lift(&fixture, grade, seed, off_x_m, 0.0f);
}

static float height_over_paper(uint32_t fish)
{
    const struct basis axes = vec_basis_from_angles(fixture.poi.angles);
    return v3_dot(axes.up, v3_sub(fixture.tank.fish[fish].position_m, fixture.poi.position_m));
}

static void test_a_rising_poi_lifts_the_fish_above_it_out_of_the_water(void **state)
{
    (void)state;
    const uint32_t fish = lifted(5, 1, 0.01f);
    assert_int_equal(fixture.poi.carried_count, 1);
    assert_int_equal(fixture.tank.fish[fish].gait, GAIT_HELD);
    assert_int_equal(fixture.tank.fish[fish].holder, 0);
    assert_true(fixture.tank.fish[fish].position_m.y > 0.04f);
}

static void test_a_fish_on_the_paper_lies_on_its_side(void **state)
{
    (void)state;
    const uint32_t fish = lifted(5, 1, 0.01f);
    fixture_wait(&fixture, 0.5f);
    const struct basis axes = vec_basis_from_angles(fixture.tank.fish[fish].angles);
    assert_float_equal(f_acos(axes.up.y), 80.0f * F_DEG, 3.0f * F_DEG);
    assert_float_equal(height_over_paper(fish), 0.5f * 0.20f * FISH_M, 0.002f);
}

static void test_a_carried_fish_moves_with_the_poi(void **state)
{
    (void)state;
    const uint32_t fish = lifted(5, 1, 0.0f);
    fixture_move(&fixture, v3(0.25f, 0.08f, -0.1f), 0.3f);
    fixture_wait(&fixture, 0.2f);
    assert_int_equal(fixture.poi.carried_count, 1);
    assert_float_equal(fixture.tank.fish[fish].position_m.x, 0.25f, 0.04f);
    assert_float_equal(fixture.tank.fish[fish].position_m.z, -0.1f, 0.04f);
    assert_true(height_over_paper(fish) > 0.0f);
}

static void test_a_fish_on_rising_paper_moves_sideways_with_it(void **state)
{
    (void)state;
    fixture_init(&fixture, 4, 1);
    fixture_move(&fixture, v3(0.0f, -0.06f, 0.0f), 0.3f);
    fixture_wait(&fixture, 0.5f);
    const uint32_t fish = fixture_add_fish(&fixture, v3(0.0f, -0.05f, 0.0f), FISH_M);
    fixture_move(&fixture, v3(0.07f, 0.06f, 0.0f), 0.35f);
    fixture_wait(&fixture, 0.2f);
    assert_int_equal(fixture.tank.fish[fish].gait, GAIT_HELD);
    assert_true(fixture.tank.fish[fish].position_m.x > 0.03f);
}

static void test_a_fish_below_is_pushed_down_and_never_passes_the_paper(void **state)
{
    (void)state;
    for (uint32_t i = 0; i < 5; i++) {
        const float speed_m_s = 0.05f + 0.4f * (float)i;
        fixture_init(&fixture, 4, i);
        const uint32_t fish = fixture_add_fish(&fixture, v3(0.01f, -0.05f, 0.0f), FISH_M);
        fixture_move(&fixture, v3(0.0f, -0.30f, 0.0f), speed_m_s);
        for (uint32_t tick = 0; tick < 2u * CORE_TICK_HZ; tick++) {
            fixture_tick(&fixture);
            const vec3 away = v3_sub(fixture.tank.fish[fish].position_m, fixture.poi.position_m);
            if (away.x * away.x + away.z * away.z < POI_RADIUS_M * POI_RADIUS_M) {
                assert_true(height_over_paper(fish) < 0.0f);
            }
            assert_true(fixture.tank.fish[fish].position_m.y > -0.15f);
        }
    }
}

static void test_a_fish_above_is_never_left_below(void **state)
{
    (void)state;
    for (uint32_t i = 0; i < 6; i++) {
        /* Uses strong, dry paper, which does not tear, so that no fish can pass through a hole. */
        fixture_init(&fixture, 4, i);
        fixture.hand.position_m = fixture.poi.position_m = v3(0.0f, -0.13f, 0.0f);
        fixture.hand.angles.roll_rad = 0.15f * (float)i;
        fixture_wait(&fixture, 0.3f);
        const uint32_t fish = fixture_add_fish(&fixture, v3(0.0f, -0.09f, 0.0f), FISH_M);
        for (uint32_t tick = 0; tick < 60; tick++) {
            fixture.hand.position_m.y = -0.13f + 0.16f * (float)tick / 60.0f;
            fixture_tick(&fixture);
            const struct basis axes = vec_basis_from_angles(fixture.poi.angles);
            const vec3 place = vec_basis_to_body(
                &axes, v3_sub(fixture.tank.fish[fish].position_m, fixture.poi.position_m));
            if (place.x * place.x + place.z * place.z < POI_RADIUS_M * POI_RADIUS_M) {
                assert_true(place.y > 0.0f);
            }
        }
    }
}

static void test_a_careful_scooper_keeps_the_paper_for_many_fish(void **state)
{
    (void)state;
    uint32_t kept = 0;
    for (uint32_t seed = 0; seed < 20; seed++) {
        fixture_init(&fixture, 6, seed);
        fixture_dip(&fixture);
        for (uint32_t scoop = 0; scoop < 4; scoop++) {
            fixture_add_fish(&fixture, v3(0.012f, -0.05f, -0.008f), FISH_M);
            fixture_move(&fixture, v3(0.0f, 0.06f, 0.0f), 0.18f);
            fixture_move(&fixture, v3(0.30f, 0.08f, 0.15f), 0.30f);
            fixture_wait(&fixture, 1.0f);
            fixture_move(&fixture, v3(0.0f, 0.06f, 0.0f), 0.5f);
            fixture_move(&fixture, v3(0.0f, -0.06f, 0.0f), 0.15f);
        }
        kept += sheet_left(&fixture.poi.sheet) > 0.95f;
        assert_int_equal(fixture.landed, fixture.bowl.fish_count);
    }
    assert_in_range(kept, 19, 20);
}

static uint32_t careless_scoops(uint32_t seed)
{
    fixture_init(&fixture, 6, seed);
    fixture_dip(&fixture);
    for (uint32_t scoop = 0; scoop < 12; scoop++) {
        fixture_add_fish(&fixture, v3(0.012f, -0.05f, -0.008f), 0.05f);
        fixture_move(&fixture, v3(0.0f, 0.06f, 0.0f), 0.5f);
        fixture_move(&fixture, v3(0.30f, 0.08f, 0.15f), 0.6f);
        fixture_wait(&fixture, 1.0f);
        fixture_move(&fixture, v3(0.0f, 0.06f, 0.0f), 0.6f);
        fixture_move(&fixture, v3(0.0f, -0.06f, 0.0f), 0.4f);
        if (sheet_left(&fixture.poi.sheet) < 0.8f) {
            return scoop;
        }
    }
    return 12;
}

static void test_a_careless_scooper_loses_it_after_a_few(void **state)
{
    (void)state;
    uint32_t total = 0;
    for (uint32_t seed = 0; seed < 40; seed++) {
        total += careless_scoops(seed);
    }
    /* Visitors of real stalls catch one and a half to three fish with one poi. The careless player
     * of this test must catch as many on average. */
    assert_in_range(total, 40u * 3u / 2u, 40u * 3u);
}

static void test_a_carried_fish_lowered_into_the_water_swims_off(void **state)
{
    (void)state;
    const uint32_t fish = lifted(4, 1, 0.0f);
    fixture_move(&fixture, v3(0.0f, -0.06f, 0.0f), 0.2f);
    fixture_wait(&fixture, 0.3f);
    assert_int_equal(fixture.poi.carried_count, 0);
    assert_int_not_equal(fixture.tank.fish[fish].gait, GAIT_HELD);
    assert_true(height_over_paper(fish) > 0.0f);
}

static void test_a_replaced_poi_releases_its_fish(void **state)
{
    (void)state;
    const uint32_t fish = lifted(4, 1, 0.0f);
    poi_init(&fixture.poi, 6, fixture.poi.position_m, 9);
    fixture_tick(&fixture);
    assert_int_equal(fixture.tank.fish[fish].holder, FISH_HOLDER_WATER);
    /* After 0.2 s, the fish must have left the ring and swim. */
    fixture_wait(&fixture, 0.2f);
    assert_int_not_equal(fixture.tank.fish[fish].gait, GAIT_HELD);
    assert_true(fixture.tank.fish[fish].position_m.y < 0.0f);
}

static uint8_t rides(uint32_t fish)
{
    return fixture.tank.fish[fish].gait == GAIT_HELD &&
           fixture.tank.fish[fish].holder != FISH_HOLDER_WATER;
}

static void fill_paper(uint32_t seed)
{
    fixture_init(&fixture, 4, seed);
    fixture_dip(&fixture);
    for (uint32_t i = 0; i < POI_CARRIED_MAX + 8u; i++) {
        const vec3 place = v3(0.0065f * (float)(i % 10u) - 0.029f, i < 20u ? -0.052f : -0.040f,
                              i / 10u % 2u == 0 ? -0.0155f : 0.0155f);
        fixture_add_fish(&fixture, place, 0.03f);
    }
}

/* Returns 1 for a fish above the paper, and -1 for a fish below it. Returns 0 for a fish that is
 * beside the paper or at a hole. */
static int side_of_paper(const struct fish *fish)
{
    const struct basis axes = vec_basis_from_angles(fixture.poi.angles);
    const vec3 q = vec_basis_to_body(&axes, v3_sub(fish->position_m, fixture.poi.position_m));
    return !sheet_holds(&fixture.poi.sheet, q.x, q.z) ? 0 : q.y > 0.0f ? 1 : -1;
}

static void test_fish_for_which_the_paper_has_no_room_do_not_pass_through_it(void **state)
{
    (void)state;
    const float lifts_m_s[] = { 0.10f, 0.15f, 0.22f, 0.40f, 0.60f };
    uint32_t full = 0;
    for (uint32_t i = 0; i < 5; i++) {
        int8_t side[POI_CARRIED_MAX + 8u] = { 0 };
        uint32_t most = 0;
        fill_paper(i);
        for (uint32_t tick = 0; tick < 3u * CORE_TICK_HZ / 2u; tick++) {
            vec3 *const hand_m = &fixture.hand.position_m;
            hand_m->y = f_min(hand_m->y + lifts_m_s[i] * CORE_TICK_S, 0.06f);
            fixture_tick(&fixture);
            most = fixture.poi.carried_count > most ? fixture.poi.carried_count : most;
            for (uint32_t k = 0; k < fixture.tank.fish_count; k++) {
                const int now = side_of_paper(&fixture.tank.fish[k]);
                assert_false(side[k] == 1 && now == -1);
                side[k] = (int8_t)now;
            }
        }
        assert_true(most >= POI_CARRIED_MAX - 1u || sheet_left(&fixture.poi.sheet) < 1.0f);
        full += most == POI_CARRIED_MAX;
        /* Each fish that is not carried must be under water, and must not lie on the ring. */
        for (uint32_t k = 0; k < fixture.tank.fish_count; k++) {
            const struct fish *fish = &fixture.tank.fish[k];
            assert_true(rides(k) || fish->position_m.y < 0.0f);
        }
    }
    assert_true(full >= 4u);
}

static void test_more_fish_than_the_poi_can_carry_spill_over_the_ring(void **state)
{
    (void)state;
    fill_paper(1);
    fixture_move(&fixture, v3(0.0f, 0.06f, 0.0f), 0.15f);
    fixture_wait(&fixture, 0.5f);
    assert_true(fixture.poi.carried_count <= POI_CARRIED_MAX);
    print_message("%u ride\n", fixture.poi.carried_count);
    assert_true(fixture.poi.carried_count > 4);
    assert_true(fixture.poi.load_count <= SHEET_LOAD_MAX);
    uint8_t rode[POI_CARRIED_MAX + 8u], swam[POI_CARRIED_MAX + 8u] = { 0 };
    for (uint32_t i = 0; i < fixture.tank.fish_count; i++) {
        rode[i] = rides(i);
        /* Each fish that is not carried must be under water. Such a fish must neither lie on the
         * ring nor stay in the air. */
        if (!rode[i]) {
            assert_true(fixture.tank.fish[i].position_m.y < 0.0f);
        }
    }
    for (uint32_t tick = 0; tick < CORE_TICK_HZ / 2u; tick++) {
        fixture_tick(&fixture);
        for (uint32_t i = 0; i < fixture.tank.fish_count; i++) {
            swam[i] |= fixture.tank.fish[i].gait < GAIT_HELD;
        }
    }
    for (uint32_t i = 0; i < fixture.tank.fish_count; i++) {
        /* After half a second, each fish must be carried or swim. */
        assert_true(rode[i] || swam[i]);
    }
}

/* Returns by how many metres the body of a fish is outside the tank's walls. The result is negative
 * if the body is inside. */
static float out_of_walls_m(const struct fish *fish)
{
    const struct box box = fish_box(fish);
    const vec3 extent = box_extent_m(&box);
    return f_max(f_abs(fish->position_m.x) + extent.x - 0.5f * fixture.tank.size_m.x,
                 f_abs(fish->position_m.z) + extent.z - 0.5f * fixture.tank.size_m.z);
}

static void sweep_and_check(vec3 to_m, float speed_m_s)
{
    const vec3 from = fixture.hand.position_m, way = v3_sub(to_m, from);
    const uint32_t ticks = (uint32_t)(v3_length(way) / speed_m_s * (float)CORE_TICK_HZ) + 60u;
    for (uint32_t i = 1; i <= ticks; i++) {
        fixture.hand.position_m = v3_muladd(from, way, (float)i / (float)ticks);
        fixture_tick(&fixture);
        for (uint32_t fish = 0; fish < fixture.tank.fish_count; fish++) {
            if (fixture.tank.fish[fish].gait < GAIT_HELD) {
                assert_true(out_of_walls_m(&fixture.tank.fish[fish]) < 1e-5f);
            }
        }
    }
}

static void test_a_poi_that_sweeps_along_walls_pushes_no_fish_through_them(void **state)
{
    (void)state;
    for (uint32_t i = 0; i < 12; i++) {
        fixture_init(&fixture, 4, i);
        fixture_move(&fixture, v3(0.20f, 0.06f, 0.0f), 0.5f);
        fixture_dip(&fixture);
        fixture_turn(&fixture, i % 2u ? 0.9f : 0.0f, 0.5f * F_PI - 0.5f * (float)(i % 3u), 0.3f);
        for (uint32_t k = 0; k < 60; k++) {
            const uint32_t fish =
                fixture_add_fish(&fixture,
                                 v3(0.30f + 0.012f * (float)(k % 10u),
                                    -0.03f - 0.03f * (float)(k % 3u), -0.24f + 0.008f * (float)k),
                                 FISH_M);
            fixture.tank.fish[fish].angles.yaw_rad = 0.7f * (float)k;
        }
        sweep_and_check(v3(0.45f, -0.07f, 0.0f), 0.3f);
        sweep_and_check(v3(0.45f, -0.07f, -0.30f), 0.4f);
        sweep_and_check(v3(0.30f, -0.03f, 0.30f), 0.6f);
        sweep_and_check(v3(0.50f, -0.06f, 0.30f), 0.3f);
        sweep_and_check(v3(0.50f, 0.04f, 0.20f), 0.15f);
    }
}

static void test_a_fish_over_the_edge_of_the_ring_stays_on_its_side(void **state)
{
    (void)state;
    fixture_init(&fixture, 4, 1);
    fixture_dip(&fixture);
    const float far = 0.99f * POI_RADIUS_M;
    const vec3 place = v3_add(fixture.poi.position_m, v3(far, 0.05f, 0.0f));
    const uint32_t fish = fixture_add_fish(&fixture, place, 0.03f);
    struct obstacle ring = poi_obstacle(&fixture.poi);
    const struct box box = fish_box(&fixture.tank.fish[fish]);
    struct body body = body_of(&box, 0.0f);
    const vec3 before_m = body.centre_m;
    /* Moves the fish by 6 cm in one tick, from above the paper to below it. The paper must still
     * push the fish upward. */
    body.centre_m.y -= 0.06f;
    assert_true(obstacle_paper_push(&ring, &body, before_m).y > 0.01f);
}

static void test_sounds_follow_the_events_without_repetition(void **state)
{
    (void)state;
    uint32_t heard[SOUND_COUNT] = { 0 };
    fixture_init(&fixture, 4, 1);
    fixture_add_fish(&fixture, v3(0.0f, -0.10f, 0.0f), FISH_M);
    for (uint32_t tick = 0; tick < 8u * CORE_TICK_HZ; tick++) {
        fixture.hand.position_m.y = tick < 2u * CORE_TICK_HZ ? -0.13f : 0.06f;
        /* During the first second the poi is in the water 20 cm beside the fish. Afterwards it
         * moves under the fish. */
        fixture.hand.position_m.x = tick < CORE_TICK_HZ ? 0.2f : 0.0f;
        fixture_tick(&fixture);
        for (uint32_t i = 0; i < fixture.output.sound_count; i++) {
            assert_true(fixture.output.sounds[i].gain > 0.0f);
            assert_true(fixture.output.sounds[i].gain <= 1.0f);
            heard[fixture.output.sounds[i].sound]++;
        }
    }
    assert_int_equal(heard[SOUND_DIP], 1);
    assert_int_equal(heard[SOUND_LIFT], 1);
    /* The paper was dry before its first dip, and the lifted poi drips. */
    assert_int_equal(heard[SOUND_WET], 1);
    assert_true(heard[SOUND_DRIP] > 0);
}

/* Returns how often the paper creaks in two seconds. One cell of the paper has the damage
 * `damage`. */
static uint32_t creaks(float damage, bool damage_immune)
{
    uint32_t count = 0;
    fixture_init(&fixture, 4, 1);
    fixture.poi.sheet.damage[SHEET_CELL_COUNT / 2u + SHEET_SIDE / 2u] = damage;
    fixture.poi.damage_immune = damage_immune;
    for (uint32_t tick = 0; tick < 2u * CORE_TICK_HZ; tick++) {
        fixture_tick(&fixture);
        for (uint32_t i = 0; i < fixture.output.sound_count; i++) {
            count += fixture.output.sounds[i].sound == SOUND_CREAK;
        }
    }
    return count;
}

static void test_paper_creaks_before_it_tears_and_faster_at_the_end(void **state)
{
    (void)state;
    assert_int_equal(creaks(0.0f, false), 0);
    assert_int_equal(creaks(0.5f, false), 5);
    assert_int_equal(creaks(0.9f, false), 10);
    assert_int_equal(creaks(0.9f, true), 0);
}

static uint64_t played(void)
{
    fixture_init(&fixture, 7, 11);
    fixture_dip(&fixture);
    for (uint32_t i = 0; i < 6; i++) {
        fixture_add_fish(&fixture, v3(0.01f * (float)i - 0.025f, -0.05f, 0.0f), 0.04f);
    }
    fixture_move(&fixture, v3(0.1f, 0.06f, 0.0f), 0.5f);
    fixture_wait(&fixture, 2.0f);
    const uint64_t hash = field_hash(HASH_START, &poi_fields, &fixture.poi);
    return field_hash(hash, &tank_quick_fields, &fixture.tank);
}

static void test_the_same_scoop_ends_the_same_way(void **state)
{
    (void)state;
    const uint64_t first = played();
    assert_true(first == played());
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_a_rising_poi_lifts_the_fish_above_it_out_of_the_water),
        cmocka_unit_test(test_a_fish_on_the_paper_lies_on_its_side),
        cmocka_unit_test(test_a_carried_fish_moves_with_the_poi),
        cmocka_unit_test(test_a_fish_on_rising_paper_moves_sideways_with_it),
        cmocka_unit_test(test_a_fish_below_is_pushed_down_and_never_passes_the_paper),
        cmocka_unit_test(test_a_fish_above_is_never_left_below),
        cmocka_unit_test(test_a_careful_scooper_keeps_the_paper_for_many_fish),
        cmocka_unit_test(test_a_careless_scooper_loses_it_after_a_few),
        cmocka_unit_test(test_a_carried_fish_lowered_into_the_water_swims_off),
        cmocka_unit_test(test_a_replaced_poi_releases_its_fish),
        cmocka_unit_test(test_more_fish_than_the_poi_can_carry_spill_over_the_ring),
        cmocka_unit_test(test_fish_for_which_the_paper_has_no_room_do_not_pass_through_it),
        cmocka_unit_test(test_a_poi_that_sweeps_along_walls_pushes_no_fish_through_them),
        cmocka_unit_test(test_a_fish_over_the_edge_of_the_ring_stays_on_its_side),
        cmocka_unit_test(test_sounds_follow_the_events_without_repetition),
        cmocka_unit_test(test_paper_creaks_before_it_tears_and_faster_at_the_end),
        cmocka_unit_test(test_the_same_scoop_ends_the_same_way),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
