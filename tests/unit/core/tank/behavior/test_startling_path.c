/* test_startling_path.c -- counts how many of 300 fish are startled by a poi that moves 30 cm
 * through the tank.
 *
 * Fish respond mainly to the fast water in front of a broadside ring. Experienced players therefore
 * move the poi edge first and enter the water at a slant. */
#include <stdbool.h>

#include "tests/unit/support/poi_fixture.h"

#include "core/tank/behavior/startle.h"

#define SEEDS 4u
#define WAY_M 0.30f
#define CALM_S 1.0f

/* The fixture is static, because the struct is too large for some stacks. */
static struct poi_fixture fixture;

/* Motion of a ring: the tilt relative to its course, its speed, and the angle by which the course
 * leads downward. */
struct manner {
    float tilt_rad, speed_m_s, down_rad;
};

static void tick_on(void)
{
    const struct poi_grip grip = { fixture.hand, 1 };
    poi_tick(&fixture.poi, &grip, &fixture.tank, &fixture.bowl);
    struct obstacle ring = poi_obstacle(&fixture.poi);
    tank_tick(&fixture.tank, fixture.tick++, &ring, 1);
    poi_apply_reaction(&fixture.poi, &ring);
}

static bool is_startled(const struct fish *fish)
{
    return fish->gait == GAIT_ESCAPE || fish->startle == STARTLE_PRESSURE ||
           fish->startle == STARTLE_LOOM;
}

/* Marks the fish that are startled in this tick. Returns how many of them were not marked
 * before. */
static uint32_t count_startled(uint8_t marks[TANK_FISH_MAX])
{
    uint32_t count = 0;
    for (uint32_t i = 0; i < fixture.tank.fish_count; i++) {
        if (is_startled(&fixture.tank.fish[i]) && !marks[i]) {
            marks[i] = 1;
            count++;
        }
    }
    return count;
}

/* Dips the poi edge first, turns it to the roll angle `roll_rad` under water, and waits until the
 * fish are calm again. */
static void dip_gently(float to_m, float roll_rad)
{
    const uint32_t ticks = (uint32_t)(CALM_S * (float)CORE_TICK_HZ);
    fixture.hand.angles.roll_rad = fixture.poi.angles.roll_rad = -0.5f * F_PI;
    for (uint32_t tick = 0; tick < 4u * ticks; tick++) {
        const float down = f_clamp((float)tick / (float)ticks - 1.0f, 0.0f, 1.0f);
        const float turned = f_clamp((float)tick / (float)ticks - 2.0f, 0.0f, 1.0f);
        fixture.hand.position_m.y = f_lerp(0.06f, to_m, down);
        fixture.hand.angles.roll_rad = f_lerp(-0.5f * F_PI, roll_rad, turned);
        tick_on();
    }
}

static uint32_t startled_by(struct manner manner, uint32_t seed)
{
    static uint8_t marks[TANK_FISH_MAX];
    struct tank_config config = tank_config_of(TANK_PRESET_FESTIVAL);
    config.fish_count = 300;
    config.seed = seed;
    fixture_init(&fixture, 6, seed);
    assert_true(tank_open(&fixture.tank, &config));
    fixture.bowl.present = 0;
    const vec3 from_m = v3(-0.5f * WAY_M, manner.down_rad > 0.0f ? 0.03f : -0.05f, 0.0f);
    const vec3 way = v3(f_cos(manner.down_rad), -f_sin(manner.down_rad), 0.0f);
    const float turn_rad = manner.down_rad - manner.tilt_rad;
    fixture.hand.position_m = fixture.poi.position_m = fixture.poi.hand_m =
        v3(from_m.x, 0.06f, 0.0f);
    fixture.poi.damage_immune = 1;
    dip_gently(from_m.y, turn_rad);
    memset(marks, 0, sizeof marks);
    count_startled(marks);
    uint32_t count = 0;
    for (float gone_m = 0.0f; gone_m < WAY_M; gone_m += manner.speed_m_s * CORE_TICK_S) {
        fixture.hand.position_m = v3_muladd(from_m, way, gone_m);
        fixture.hand.position_m.y = f_max(fixture.hand.position_m.y, -0.085f);
        tick_on();
        count += count_startled(marks);
    }
    return count;
}

static float mean_startled(const char *name, struct manner manner)
{
    uint32_t sum = 0;
    for (uint32_t seed = 1; seed <= SEEDS; seed++) {
        sum += startled_by(manner, seed);
    }
    const float mean = (float)sum / (float)SEEDS;
    print_message("%s: %.1f of 300\n", name, (double)mean);
    return mean;
}

static void test_a_slow_slanted_poi_startles_few_fish_and_a_fast_broadside_poi_many(void **state)
{
    (void)state;
    const float slant_rad = 30.0f * F_DEG, broad_rad = 0.5f * F_PI;
    const float entry =
        mean_startled("slanted entry, 0.2 m/s", (struct manner){ slant_rad, 0.2f, slant_rad });
    const float slanted =
        mean_startled("slanted glide, 0.2 m/s", (struct manner){ slant_rad, 0.2f, 0.0f });
    const float edge = mean_startled("edge first, 0.3 m/s", (struct manner){ 0.0f, 0.3f, 0.0f });
    const float slow =
        mean_startled("broadside, 0.2 m/s", (struct manner){ broad_rad, 0.2f, 0.0f });
    const float fast =
        mean_startled("broadside, 0.3 m/s", (struct manner){ broad_rad, 0.3f, 0.0f });
    assert_true(entry < 5.0f);
    assert_true(slanted < 5.0f);
    assert_true(edge < 2.0f);
    assert_true(slow > 1.5f * slanted);
    assert_true(fast > 12.0f);
    assert_true(fast > 1.4f * slow);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_a_slow_slanted_poi_startles_few_fish_and_a_fast_broadside_poi_many),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
