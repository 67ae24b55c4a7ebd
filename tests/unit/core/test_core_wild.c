/* test_core_wild.c -- checks that arbitrary controller input leaves the core in a valid state,
 * without a failed assertion or a NaN.
 *
 * The controllers of four players are connected and disconnected at random. Their poses move
 * between random targets, slowly or fast, and some members contain random bits. Buttons are pressed
 * at random, and fans move over the water. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include <cmocka.h>

#include "core/base/rng.h"
#include "core/core.h"
#include "core/game/control/controller.h"
#include "core/game/menu/menu_pages.h"

#define MINUTES(n) ((n) * 60u * CORE_TICK_HZ)
#define FISH 60u
#define VISIT_TICKS (5u * CORE_TICK_HZ)

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

/* ---- Controllers ---------------------------------------------------------------------------- */

/* State of a simulated player. The valid motion of the player leads to random targets, slowly or as
 * fast as an arm. */
static struct wild_hand {
    struct poi_target at, goal;
    float pace_m_s, turn_rad_s;
    /* Number of ticks for which the controller still sends faulty reports. */
    uint32_t broken_ticks;
    uint32_t breaks; /* Kind of fault in the faulty reports. */
    struct poi_target stuck;
} hands[POI_MAX];

static float reach_m(float half_m)
{
    return ((float)draw(2001) - 1000.0f) * 0.001f * half_m;
}

static float toward(float from, float to, float step)
{
    return from + f_clamp(to - from, -step, step);
}

static void wander(struct wild_hand *hand)
{
    if (draw(60) == 0) {
        /* Draws each value in its own statement, because the evaluation order of function arguments
         * is unspecified. */
        hand->goal.position_m.x = reach_m(0.6f);
        hand->goal.position_m.y = reach_m(0.2f);
        hand->goal.position_m.z = reach_m(0.4f);
        hand->goal.angles.yaw_rad = reach_m(3.0f);
        hand->goal.angles.pitch_rad = reach_m(2.0f);
        hand->goal.angles.roll_rad = reach_m(3.0f);
        hand->pace_m_s = draw(3) == 0 ? 3.9f : 0.3f;
        hand->turn_rad_s = draw(3) == 0 ? 15.0f : 2.0f;
    }
    const vec3 way_m = v3_sub(hand->goal.position_m, hand->at.position_m);
    const float turn_rad = hand->turn_rad_s * CORE_TICK_S;
    struct angles *angles = &hand->at.angles;
    hand->at.position_m =
        v3_add(hand->at.position_m, v3_limit(way_m, hand->pace_m_s * CORE_TICK_S));
    angles->yaw_rad = toward(angles->yaw_rad, hand->goal.angles.yaw_rad, turn_rad);
    angles->pitch_rad = toward(angles->pitch_rad, hand->goal.angles.pitch_rad, turn_rad);
    angles->roll_rad = toward(angles->roll_rad, hand->goal.angles.roll_rad, turn_rad);
}

static void spoil_field(struct poi_target *target, uint32_t bits)
{
    uint8_t *bytes = (uint8_t *)target;
    memcpy(bytes + draw(6) * sizeof(float), &bits, sizeof bits);
}

/* Writes the current fault into the poi's input: random bits in a member, or a smaller error. */
static void spoil(struct poi_input *poi, struct wild_hand *hand)
{
    static const uint32_t none[] = { 0x7fc00000u, 0xffc00000u, 0x7f800000u, 0xff800000u,
                                     0x7f7fffffu, 0x7f800001u, 0x00000001u, 0x80000000u };
    hand->broken_ticks--;
    switch (hand->breaks) {
    case 0:
        spoil_field(&poi->target, none[draw(8)]);
        break;
    case 1:
        for (uint32_t i = 0; i < 6; i++) {
            spoil_field(&poi->target, rng_u32((struct rng_key){ 9, drawn, i, RNG_TEST }));
        }
        break;
    case 2:
        poi->target.position_m.x = pick_m();
        poi->target.position_m.y = pick_m();
        poi->target.position_m.z = pick_m();
        break;
    case 3:
        poi->age_ticks = (uint16_t)draw(65536);
        break;
    case 4:
        poi->target = hand->stuck;
        break;
    case 5:
        poi->link = (uint8_t)draw(4);
        break;
    case 6:
        poi->age_ticks = (uint16_t)draw(80);
        poi->target.angles.roll_rad += draw(2) ? F_PI : 0.0f;
        break;
    default:
        poi->has_wrist = (uint8_t)draw(256);
        poi->trembles = (uint8_t)draw(256);
        break;
    }
}

/* Connects or disconnects a controller at random, and sometimes starts a fault. */
static void move_hand(struct poi_input *poi, struct wild_hand *hand)
{
    wander(hand);
    if (draw(700) == 0) {
        poi->link = (uint8_t)draw(4);
        poi->has_wrist = (uint8_t)draw(2);
        poi->trembles = (uint8_t)draw(2);
    } else if (poi->link != POI_SOURCE_LIVE && draw(200) == 0) {
        poi->link = POI_SOURCE_LIVE;
    }
    if (hand->broken_ticks == 0 && draw(300) == 0) {
        hand->broken_ticks = 1u + draw(draw(4) == 0 ? 200u : 8u);
        hand->breaks = draw(8);
        hand->stuck = hand->at;
    }
}

/* Presses the buttons that leave the operator's menu after the menu was open for five seconds.
 * Otherwise the random input would stay in the menu for most of the time. */
static void follow_visits(struct input *input)
{
    const uint32_t stay_ticks = core.game.tick - core.game.phase_tick;
    input->pressed &= draw(16) == 0 ? ~0u : ~(uint32_t)INPUT_TEST;
    if (core.game.phase == PHASE_MENU && stay_ticks >= VISIT_TICKS) {
        input->pressed = stay_ticks % (2u * MENU_TAKE_TICKS) == 0 ? MENU_WAY_BACK : 0u;
    }
}

static void randomize(struct input *input)
{
    input->pressed = draw(200) == 0 ? draw(INPUT_BUTTON_ALL + 1u) : 0;
    follow_visits(input);
    input->held = draw(INPUT_BUTTON_ALL + 1u);
    input->coin_count[0] = draw(3);
    input->store_well = draw(100) != 0;
    /* Acknowledges a random entry (0 to 3), which may be wrong. The core must accept any value. */
    input->record_saved_id = draw(50) == 0  ? draw(4)
                             : draw(4) == 0 ? output.entry_id
                                            : input->record_saved_id;
    for (uint32_t i = 0; i < POI_MAX; i++) {
        move_hand(&input->poi[i], &hands[i]);
    }
    for (uint32_t i = 0; i < SHADE_MAX; i++) {
        if (draw(60) == 0) {
            input->shade[i].present = (uint8_t)draw(2);
            input->shade[i].x_m = pick_m();
            input->shade[i].z_m = pick_m();
            input->shade[i].radius_m = pick_m();
        }
    }
}

/* Returns the input that the core gets in this tick, including the faults of the controllers. */
static struct input core_input(const struct input *input)
{
    struct input out = *input;
    for (uint32_t i = 0; i < POI_MAX; i++) {
        out.poi[i].target = hands[i].at;
        out.poi[i].age_ticks = 0;
        if (hands[i].broken_ticks > 0) {
            spoil(&out.poi[i], &hands[i]);
        }
    }
    return out;
}

/* ---- Invariants ----------------------------------------------------------------------------- */

/* Number of ticks for which each fish has been loose: put back into the water, but not swimming
 * yet. The limit is half a second. */
static uint32_t loose_ticks[TANK_FISH_MAX];

static void check_loose(const struct fish *fish, uint32_t index)
{
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
    /* Only a poi can hold a fish out of the water, and the list of this poi must contain the fish
     * exactly once. */
    if (fish->gait == GAIT_HELD && fish->holder != FISH_HOLDER_WATER) {
        const struct poi *poi = &core.world.poi[fish->holder];
        uint32_t found = 0;
        for (uint32_t i = 0; i < poi->carried_count; i++) {
            found += &core.world.tank.fish[poi->carried_fish[i].fish] == fish;
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
    assert_true(poi->carried_count <= POI_CARRIED_MAX);
    assert_true(v3_length(poi->position_m) < 3.0f);
}

static void check_force(const struct poi_force *force)
{
    assert_true(v3_is_finite(force->force_n) && v3_is_finite(force->torque_n_m));
    assert_true(force->drag >= 0.0f && force->drag <= 1.0f);
    assert_true(force->slap >= 0.0f && force->slap <= 1.0f);
    assert_true(force->tear >= 0.0f && force->tear <= 1.0f);
}

/* Number of times that each event occurred. The test requires each event, because a run without
 * play would prove nothing. */
static struct tally {
    uint32_t led, lost, dips, rounds, torn, championships, menu;
} tally;

static void count(void)
{
    for (uint32_t i = 0; i < POI_MAX; i++) {
        const struct poi *poi = &core.world.poi[i];
        tally.led += core.game.phase == PHASE_ROUND && poi->link == POI_SOURCE_LIVE;
        tally.lost += (uint32_t)controller_is_lost(&core.world, i);
        tally.dips += poi->splash_m_s > 0.0f;
        tally.torn += poi->strain.cells_torn;
    }
    /* Counts a round at its first tick. */
    tally.rounds += core.game.phase == PHASE_ROUND && core.game.round_tick + 1u == core.game.tick;
    tally.menu += core.game.phase == PHASE_MENU;
    tally.championships += core.game.phase == PHASE_ROUND && core.game.mode == MODE_CHAMPIONSHIP;
}

/* Copies the configuration into the operator's settings. Otherwise the first random change of a
 * setting would reset the number of players to the default of one. */
static struct core_config settled(const struct core_config *config)
{
    struct core_config out = *config;
    int32_t *value = out.persistent.settings.value;
    settings_reset(&out.persistent.settings);
    value[SET_FISH] = (int32_t)config->fish_count;
    value[SET_ROUND_S] = (int32_t)config->round_s;
    value[SET_GRADE] = config->grade;
    value[SET_PLAYERS] = config->players > 0 ? config->players : 1;
    value[SET_MODES] = config->modes > 0 ? config->modes : 1 << MODE_FESTIVAL;
    config_apply_settings(&out, &out.persistent.settings);
    return out;
}

static uint64_t play(const struct core_config *config, uint32_t ticks)
{
    const struct core_config begin = settled(config);
    struct input input = { 0 };
    drawn = 0;
    tally = (struct tally){ 0 };
    memset(hands, 0, sizeof hands);
    memset(&output, 0, sizeof output);
    memset(loose_ticks, 0, sizeof loose_ticks);
    assert_int_equal(core_init(&core, &begin), CORE_OK);
    for (uint32_t tick = 0; tick < ticks; tick++) {
        randomize(&input);
        const struct input now = core_input(&input);
        core_tick(&core, &now, &output);
        output.sound_count = 0;
        for (uint32_t i = 0; i < core.world.tank.fish_count; i++) {
            check_fish(&core.world.tank.fish[i]);
            check_loose(&core.world.tank.fish[i], i);
        }
        for (uint32_t i = 0; i < POI_MAX; i++) {
            check_poi(&core.world.poi[i]);
            check_force(&output.poi[i]);
        }
        count();
    }
    const uint64_t hash = core_hash(&core);
    print_message(
        "%u rounds, %u dips, controlled for %u s, lost for %u s, %u cells torn, in the menu for "
        "%u s, %016llx\n",
        tally.rounds, tally.dips, tally.led / CORE_TICK_HZ, tally.lost / CORE_TICK_HZ, tally.torn,
        tally.menu / CORE_TICK_HZ, (unsigned long long)hash);
    return hash;
}

static void test_four_random_players_are_safe_and_repeatable(void **state)
{
    (void)state;
    const struct core_config config = {
        .seed = 1, .fish_count = FISH, .round_s = 20, .grade = 6, .players = POI_MAX
    };
    const uint64_t first = play(&config, MINUTES(3));
    assert_true(tally.rounds >= 3 && tally.dips >= 50 && tally.torn > 100);
    assert_true(tally.led > MINUTES(1) && tally.lost > MINUTES(1) / 4u);
    assert_true(play(&config, MINUTES(3)) == first);
}

static void test_random_controllers_beside_one_player_are_safe(void **state)
{
    (void)state;
    const struct core_config config = { .seed = 2, .fish_count = FISH, .round_s = 20 };
    play(&config, MINUTES(2));
    assert_true(tally.rounds > 1 && tally.dips > 10);
}

static void test_random_players_with_all_modes_are_safe(void **state)
{
    (void)state;
    const struct core_config config = {
        .seed = 3,
        .fish_count = FISH,
        .round_s = 10,
        .players = 2,
        .modes = (1u << MODE_COUNT) - 1u,
    };
    play(&config, MINUTES(3));
    assert_true(tally.rounds > 1 && tally.championships > 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_four_random_players_are_safe_and_repeatable),
        cmocka_unit_test(test_random_controllers_beside_one_player_are_safe),
        cmocka_unit_test(test_random_players_with_all_modes_are_safe),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
