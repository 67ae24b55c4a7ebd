/* test_core_wild.c -- whatever controllers do, the core goes on: no panic, no number that is none.
 *
 * Four players' worth of links that come and go, hands anywhere a float reaches, and random
 * presses; fans too. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "core/base/rng.h"
#include "core/core.h"

#define TICKS 3000u
#define FISH 60u

static struct core core;
static struct output output;
static uint32_t drawn;

static uint32_t draw(uint32_t below)
{
    return rng_u32((struct rng_key){ 20130213u, drawn++, 0, RNG_TEST }) % below;
}

static float pick_m(void)
{
    static const float wild[] = { 0.0f, -0.0f, 1e-40f, 1e9f, -1e9f, 3.4e38f, -3.4e38f, 1000.0f };
    const uint32_t kind = draw(40);
    return kind < 8 ? wild[kind] : ((float)draw(2001) - 1000.0f) * 0.0004f;
}

static float pick_rad(void)
{
    const float angle_rad = 8.0f * pick_m();
    return f_is_finite(angle_rad) ? angle_rad : 3e38f;
}

static struct poi_target pick_target(void)
{
    const vec3 at = v3(pick_m(), 0.3f * pick_m(), pick_m());
    return (struct poi_target){ .position_m = at,
                                .angles = { pick_rad(), pick_rad(), pick_rad() } };
}

/* A hand keeps what it does for a while: a jump in every tick would never get to the fish. */
static void stir(struct input *input)
{
    input->pressed = draw(200) == 0 ? draw(INPUT_BUTTON_ALL + 1u) : 0;
    input->held = draw(INPUT_BUTTON_ALL + 1u);
    input->coin_count = draw(3);
    input->record_saved_id = draw(50) == 0 ? draw(4) : input->record_saved_id;
    for (uint32_t i = 0; i < POI_MAX; i++) {
        struct poi_input *poi = &input->poi[i];
        if (draw(90) == 0) {
            poi->link = (uint8_t)draw(4);
            poi->has_wrist = (uint8_t)draw(2);
        }
        if (draw(12) == 0) {
            poi->target = pick_target();
        }
    }
    for (uint32_t i = 0; i < SHADE_MAX; i++) {
        if (draw(60) == 0) {
            input->shade[i] =
                (struct shade_input){ (uint8_t)draw(2), pick_m(), pick_m(), pick_m() };
        }
    }
}

/* Nor in the water without swimming, for longer than half a second. */
static void check_loose(const struct fish *fish, uint32_t index)
{
    static uint32_t loose_ticks[FISH];
    const int is_loose = fish->gait == GAIT_HELD && fish->holder == FISH_HOLDER_WATER;
    loose_ticks[index] = is_loose ? loose_ticks[index] + 1u : 0u;
    assert_true(loose_ticks[index] <= CORE_TICK_HZ / 2u);
}

static void check_fish(const struct fish *fish)
{
    assert_true(v3_is_finite(fish->position_m));
    assert_true(v3_is_finite(fish->velocity_m_s));
    assert_true(f_is_finite(fish->angles.yaw_rad + fish->angles.pitch_rad + fish->angles.roll_rad));
    assert_true(f_is_finite(fish->tail_phase_rad + fish->bend_rad + fish->alarm));
    assert_true(v3_length(fish->position_m) < 3.0f);
    /* Nobody hangs in the air without a poi. */
    if (fish->gait == GAIT_HELD && fish->holder != FISH_HOLDER_WATER) {
        const struct poi *poi = &core.poi[fish->holder];
        uint32_t found = 0;
        for (uint32_t i = 0; i < poi->rider_count; i++) {
            found += &core.tank.fish[poi->riders[i].fish] == fish;
        }
        assert_int_equal(found, core.game.phase == PHASE_ROUND ? 1 : found);
    }
}

static void check_poi(const struct poi *poi)
{
    assert_true(v3_is_finite(poi->position_m));
    assert_true(v3_is_finite(poi->velocity_m_s));
    assert_true(f_is_finite(poi->angles.yaw_rad + poi->angles.pitch_rad + poi->angles.roll_rad));
    assert_true(f_is_finite(poi->water_kg + poi->pressure_pa + poi->sheet.sag_m));
    assert_true(poi->rider_count <= POI_RIDER_MAX);
    assert_true(v3_length(poi->position_m) < 3.0f);
}

static void play(uint32_t seed, uint32_t player_count)
{
    const struct core_config config = { .seed = seed, .fish_count = FISH, .round_s = 10 };
    struct input input = { 0 };
    assert_int_equal(core_init(&core, &config), CORE_OK);
    for (uint32_t i = 1; i < player_count; i++) {
        bowl_init(&core.bowl[i], v3(-0.33f + 0.2f * (float)i, 0.012f, -0.18f));
    }
    for (uint32_t tick = 0; tick < TICKS; tick++) {
        stir(&input);
        core_tick(&core, &input, &output);
        output.sound_count = 0;
        for (uint32_t i = 0; i < FISH; i++) {
            check_fish(&core.tank.fish[i]);
            check_loose(&core.tank.fish[i], i);
        }
        for (uint32_t i = 0; i < POI_MAX; i++) {
            check_poi(&core.poi[i]);
        }
    }
    assert_true(core.game.round_count > 0);
}

static void test_four_wild_players_break_nothing(void **state)
{
    (void)state;
    play(1, POI_MAX);
}

static void test_wild_controllers_beside_one_player_break_nothing(void **state)
{
    (void)state;
    play(2, 1);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_four_wild_players_break_nothing),
        cmocka_unit_test(test_wild_controllers_beside_one_player_break_nothing),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
