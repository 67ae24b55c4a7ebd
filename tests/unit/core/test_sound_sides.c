/* test_sound_sides.c -- checks that each sound comes from the side of the player's view on which
 * its cause is, on a wide screen and on a portrait screen, which shows the tank from its short
 * side. */
#include "tests/unit/support/core_fixture.h"

#include "core/game/phases.h"

/* One place for each player, one in each quarter of the tank. */
static const vec3 places_m[POI_MAX] = {
    { 0.20f, ABOVE_M, 0.12f },
    { -0.20f, ABOVE_M, 0.12f },
    { 0.20f, ABOVE_M, -0.12f },
    { -0.20f, ABOVE_M, -0.12f },
};

/* Starts a championship of four players, of whom only player `index` has a controller. */
static void play(uint32_t index, bool is_turned)
{
    const struct core_config config = {
        .seed = 7,
        .fish_count = 12,
        .players = POI_MAX,
        .modes = (uint8_t)(1u << MODE_CHAMPIONSHIP),
    };
    open_core(&config);
    input.is_turned = is_turned;
    hold(index, places_m[index]);
    press(INPUT_START);
    wait_for_phase(PHASE_ROUND, 10u * CORE_TICK_HZ);
    ticks(60);
}

/* Returns how far the place `at_m` is to the right of the middle of the picture, as a share of half
 * of the tank's side that the player sees. The player at a portrait screen looks along -x. */
static float right_of_middle(vec3 at_m)
{
    const vec3 size_m = core.world.tank.size_m;
    return input.is_turned ? -2.0f * at_m.z / size_m.z : 2.0f * at_m.x / size_m.x;
}

/* Asserts that the present output contains the sound `sound`, and that the sound comes from the
 * place `at_m`. */
static void assert_comes_from(enum sound sound, vec3 at_m)
{
    uint32_t count = 0;
    for (uint32_t i = 0; i < output.sound_count; i++) {
        const struct sound_event *const event = &output.sounds[i];
        if (event->sound == sound) {
            assert_float_equal(event->pan, right_of_middle(at_m), 0.02f);
            assert_true(f_abs(event->pan) > 0.03f);
            count++;
        }
    }
    assert_int_equal(count, 1);
}

/* Runs ticks until the output contains the sound `sound`. The poi of player `index` moves up or
 * down with `speed_m_s`. */
static void wait_for_sound(enum sound sound, uint32_t index, float speed_m_s, uint32_t ticks_max)
{
    const uint32_t before = sounds[sound];
    for (uint32_t i = 0; i < ticks_max && sounds[sound] == before; i++) {
        input.poi[index].target.position_m.y += speed_m_s * CORE_TICK_S;
        tick();
    }
    assert_int_equal(sounds[sound], before + 1u);
}

/* Lets fish number 0 fall from the poi of player `index` at the place `at_m`. */
static void drop(uint32_t index, vec3 at_m)
{
    struct fish *const fish = &core.world.tank.fish[0];
    struct poi *const poi = &core.world.poi[index];
    fish->gait = GAIT_HELD;
    fish->holder = (uint8_t)index;
    fish->position_m = at_m;
    poi->carried_fish[poi->carried_count++] = (struct carried_fish){
        .state = CARRIED_FALLING,
        .clear_ticks = CARRIED_CLEAR_TICKS,
    };
}

/* Plays the sounds of player `index` one after the other. Players 0 and 3 are on opposite sides of
 * the tank in both views. */
static void check_sides(uint32_t index, bool is_turned)
{
    struct poi *const poi = &core.world.poi[index];
    const struct bowl *const bowl = &core.world.bowl[index];
    play(index, is_turned);
    wait_for_sound(SOUND_DIP, index, -0.3f, CORE_TICK_HZ);
    assert_comes_from(SOUND_DIP, poi->position_m);
    wait_for_sound(SOUND_LIFT, index, 0.3f, CORE_TICK_HZ);
    assert_comes_from(SOUND_LIFT, poi->position_m);
    lead(index, places_m[index]);
    /* A fish that slips from a lifted poi is a near miss too. */
    const vec3 beside_m = v3(0.7f * places_m[index].x, 0.01f, 0.7f * places_m[index].z);
    drop(index, beside_m);
    wait_for_sound(SOUND_PLOP, index, 0.0f, CORE_TICK_HZ);
    assert_comes_from(SOUND_PLOP, beside_m);
    assert_comes_from(SOUND_MISS, poi->position_m);
    drop(index, v3_add(bowl->position_m, v3(0.0f, 0.03f, 0.0f)));
    wait_for_sound(SOUND_CATCH, index, 0.0f, CORE_TICK_HZ);
    assert_comes_from(SOUND_CATCH, bowl->position_m);
    tear_all(index);
    tick();
    assert_comes_from(SOUND_GONE, poi->position_m);
    struct catch_result caught[POI_MAX] = { 0 };
    caught[index].poured = 1;
    game_score(core.game.player, &core.game.album, &core.game, &core.world, caught, is_turned,
               &output);
    assert_comes_from(SOUND_FOUL, bowl->position_m);
}

static void test_sounds_come_from_their_side_on_a_wide_screen(void **state)
{
    (void)state;
    check_sides(0, false);
    check_sides(3, false);
}

static void test_sounds_come_from_their_side_on_a_portrait_screen(void **state)
{
    (void)state;
    check_sides(0, true);
    check_sides(3, true);
}

static void test_the_whistle_for_a_shadow_comes_from_the_bowl(void **state)
{
    (void)state;
    const struct core_config config = {
        .seed = 7, .fish_count = 200, .players = 1, .modes = (uint8_t)(1u << MODE_CHAMPIONSHIP)
    };
    for (uint32_t is_turned = 0; is_turned < 2; is_turned++) {
        open_core(&config);
        input.is_turned = (uint8_t)is_turned;
        hold(0, places_m[0]);
        press(INPUT_START);
        wait_for_phase(PHASE_READY, CORE_TICK_HZ);
        input.shade[0] = (struct shade_input){ .present = 1, .radius_m = 0.2f };
        wait_for_sound(SOUND_FOUL, 0, 0.0f, 5u * CORE_TICK_HZ);
        assert_comes_from(SOUND_FOUL, core.world.bowl[0].position_m);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_sounds_come_from_their_side_on_a_wide_screen),
        cmocka_unit_test(test_sounds_come_from_their_side_on_a_portrait_screen),
        cmocka_unit_test(test_the_whistle_for_a_shadow_comes_from_the_bowl),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
