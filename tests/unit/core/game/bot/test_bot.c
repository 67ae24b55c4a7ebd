/* test_bot.c -- checks that the bot does not react or move faster than a person, and that each
 * parameter of its technique has an effect. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include <cmocka.h>

#include "core/game/game_fields.h"
#include "core/base/hash.h"
#include "core/game/bot/bot.h"
#include "core/game/bot/vision.h"
#include "tests/unit/support/bot_fixture.h"

static struct bot_fixture fixture;

static void open_with(const struct technique *technique, uint32_t seed)
{
    const struct core_config config = { .seed = seed };
    bot_fixture_open(&fixture, &config, technique);
}

static void begin_with(const struct technique *technique, uint32_t seed)
{
    open_with(technique, seed);
    bot_fixture_begin(&fixture);
}

/* ---- Limits of a person --------------------------------------------------------------------- */

/* Checks that the speed and the acceleration of the bot's poi do not exceed those of an arm. The
 * margins of 0.15 m/s and 6 m/s^2 are for the tremor, which is at most 1.5 mm at 9 Hz. */
static void holds_arm_limits(const struct technique *technique)
{
    begin_with(technique, 5);
    vec3 last = fixture.input.poi[0].target.position_m;
    vec3 last_step = v3(0.0f, 0.0f, 0.0f);
    const float lift_m_s = (technique->lift == LIFT_FAST ? 2.5f : 1.0f) * technique->lift_m_s;
    const float fastest_m_s = f_max(technique->arm_m_s, lift_m_s);
    for (uint32_t i = 0; i < 20u * CORE_TICK_HZ; i++) {
        bot_fixture_tick(&fixture);
        const vec3 now = fixture.input.poi[0].target.position_m;
        const vec3 way = v3_sub(now, last);
        const float gain_m_s2 = v3_length(v3_sub(way, last_step)) / (CORE_TICK_S * CORE_TICK_S);
        assert_true(v3_length(way) < (fastest_m_s + 0.15f) * CORE_TICK_S);
        assert_true(i == 0 || gain_m_s2 < BOT_HAND_M_S2_MAX + 6.0f);
        last = now;
        last_step = way;
    }
}

static void test_the_bot_moves_no_faster_than_an_arm(void **state)
{
    (void)state;
    holds_arm_limits(&technique_expert);
    holds_arm_limits(&technique_novice);
}

static void test_the_bot_updates_its_vision_no_oftener_than_a_person(void **state)
{
    (void)state;
    begin_with(&technique_expert, 5);
    uint32_t last = fixture.bot.act_tick;
    for (uint32_t i = 0; i < 20u * CORE_TICK_HZ; i++) {
        const uint32_t taken = fixture.bot.seen.tick;
        bot_fixture_tick(&fixture);
        if (fixture.bot.act_tick != last) {
            /* The snapshot on which the bot acts must be 18 to 30 ticks old (150 to 250 ms), which
             * is the reaction time of a person. */
            assert_in_range(fixture.bot.seen.tick - taken, 18, 30);
            last = fixture.bot.act_tick;
        }
    }
}

/* The bot acts on a snapshot of the scene. This snapshot must be at least as old as the reaction
 * time (18 ticks). */
static void test_the_bot_acts_on_a_delayed_snapshot(void **state)
{
    (void)state;
    begin_with(&technique_expert, 6);
    for (uint32_t i = 0; i < 20u * CORE_TICK_HZ; i++) {
        bot_fixture_tick(&fixture);
        assert_in_range(fixture.core.game.tick - 1u - fixture.bot.known.tick, 18, 60);
    }
}

/* Plays two copies of a game and removes the bot's target fish in one of them. For at least 150 ms
 * (the reaction time) both bots must move identically. Soon afterwards they must move
 * differently. */
static void test_the_bot_reacts_to_a_vanished_fish_after_its_reaction_time(void **state)
{
    (void)state;
    static struct bot_fixture other;
    uint32_t answers = 0;
    for (uint32_t seed = 1; seed <= 10; seed++) {
        begin_with(&technique_expert, seed);
        assert_true(bot_fixture_until(&fixture, BOT_APPROACH, 30));
        other = fixture;
        other.core.world.tank.fish[fixture.bot.prey].gait = GAIT_BOWL;
        uint32_t same_ticks = 0;
        int same = 1;
        while (same && same_ticks < 2u * CORE_TICK_HZ) {
            bot_fixture_tick(&fixture);
            bot_fixture_tick(&other);
            same = memcmp(&fixture.input.poi[0].target, &other.input.poi[0].target,
                          sizeof fixture.input.poi[0].target) == 0;
            same_ticks += (uint32_t)same;
        }
        assert_true(same_ticks >= 18);
        answers += same_ticks <= 60;
    }
    /* Most of the games must have shown a reaction. In the others, the bot had chosen another fish
     * just before its target disappeared. */
    assert_in_range(answers, 8, 10);
}

/* ---- Before the start of a round ------------------------------------------------------------ */

static void test_poi_and_shadow_stay_off_the_water_before_the_start(void **state)
{
    (void)state;
    open_with(&technique_expert, 5);
    while (fixture.core.game.phase != PHASE_READY) {
        bot_fixture_tick(&fixture);
    }
    const struct core *core = &fixture.core;
    for (uint32_t i = 0; fixture.core.game.phase == PHASE_READY; i++) {
        bot_fixture_tick(&fixture);
        /* Skips the first 1.5 s, in which the bot moves away from the middle of the tank. */
        if (i > 3u * CORE_TICK_HZ / 2u) {
            const float edge_m = core->world.poi[0].position_m.z - POI_OUTER_RADIUS_M;
            assert_true(edge_m > 0.5f * core->world.tank.size_m.z);
        }
        assert_true(core->world.poi[0].immersed <= 0.0f);
    }
}

static void test_the_bot_only_hovers_without_fish(void **state)
{
    (void)state;
    begin_with(&technique_expert, 5);
    assert_true(bot_fixture_until(&fixture, BOT_CHOOSE, 30));
    for (uint32_t i = 0; i < fixture.core.world.tank.fish_count; i++) {
        fixture.core.world.tank.fish[i].gait = GAIT_BOWL;
    }
    const struct vision vision = bot_fixture_sight(&fixture);
    for (uint32_t i = 0; i < 600; i++) {
        const struct poi_target hand = bot_tick(&fixture.bot, &vision);
        assert_true(i < 300 || hand.position_m.y > 0.03f);
        fixture.core.game.tick++;
    }
    assert_int_equal(fixture.bot.stage, BOT_CHOOSE);
}

static void test_the_bots_pose_is_always_valid(void **state)
{
    (void)state;
    begin_with(&technique_expert, 9);
    for (uint32_t i = 0; i < 12u * CORE_TICK_HZ; i++) {
        struct core *core = &fixture.core;
        core->world.bowl[0].present = i % 700u < 500u;
        core->game.phase = i % 1000u < 800u ? PHASE_ROUND : PHASE_RESULT;
        const struct vision vision = bot_fixture_sight(&fixture);
        const struct poi_target hand = bot_tick(&fixture.bot, &vision);
        assert_true(v3_is_finite(hand.position_m));
        assert_true(v3_length(hand.position_m) < 2.0f);
        assert_true(f_is_finite(hand.angles.yaw_rad) && f_abs(hand.angles.yaw_rad) <= F_PI);
        assert_true(f_is_finite(hand.angles.pitch_rad) && f_abs(hand.angles.pitch_rad) <= F_PI);
        assert_true(f_is_finite(hand.angles.roll_rad) && f_abs(hand.angles.roll_rad) <= F_PI);
        core->game.tick++;
    }
}

static uint64_t play(uint32_t seed, uint32_t seconds)
{
    begin_with(&technique_expert, seed);
    for (uint32_t i = 0; i < seconds * CORE_TICK_HZ; i++) {
        bot_fixture_tick(&fixture);
    }
    return hash_u64(field_hash(HASH_START, &bot_fields, &fixture.bot), core_hash(&fixture.core));
}

static void test_a_bots_round_is_the_same_each_time(void **state)
{
    (void)state;
    const uint64_t hash = play(31, 12);
    assert_true(play(31, 12) == hash);
    assert_true(play(32, 12) != hash);
}

/* ---- Techniques ----------------------------------------------------------------------------- */

static float wet_share(void)
{
    const struct sheet *sheet = &fixture.core.world.poi[0].sheet;
    float wet = 0.0f;
    for (uint32_t i = 0; i < SHEET_CELL_COUNT; i++) {
        wet += sheet->state[i] == CELL_PAPER ? sheet->wetness[i] : 0.0f;
    }
    return wet / (float)sheet->paper_cells;
}

static float wet_share_at_the_first_dip(float wet)
{
    struct technique technique = technique_expert;
    technique.wet = wet;
    begin_with(&technique, 5);
    assert_true(bot_fixture_until(&fixture, BOT_DIP, 30));
    return wet_share();
}

static void test_wet_sets_the_wet_share_before_the_first_scoop(void **state)
{
    (void)state;
    const float all = wet_share_at_the_first_dip(1.0f);
    const float half = wet_share_at_the_first_dip(0.5f);
    print_message("wet before the first scoop: %.2f and %.2f\n", (double)all, (double)half);
    assert_true(all > 0.80f);
    assert_true(half > 0.35f && half < 0.60f);
    assert_true(wet_share_at_the_first_dip(0.0f) < 0.02f);
}

/* Returns the pitch of the poi in degrees when the poi enters the water in the first scoop. */
static float entry_pitch_deg(float entry_deg)
{
    struct technique technique = technique_expert;
    technique.entry_deg = entry_deg;
    begin_with(&technique, 5);
    assert_true(bot_fixture_until(&fixture, BOT_DIP, 30));
    while (fixture.core.world.poi[0].immersed <= 0.0f) {
        bot_fixture_tick(&fixture);
    }
    return fixture.core.world.poi[0].angles.pitch_rad / F_DEG;
}

static void test_entry_sets_the_angle_of_entry(void **state)
{
    (void)state;
    assert_true(f_abs(entry_pitch_deg(40.0f) + 40.0f) < 6.0f);
    assert_true(f_abs(entry_pitch_deg(20.0f) + 20.0f) < 6.0f);
    assert_true(f_abs(entry_pitch_deg(0.0f)) < 6.0f);
}

static void test_glide_sets_the_angle_between_paper_and_path(void **state)
{
    (void)state;
    for (float glide_deg = 5.0f; glide_deg <= 65.0f; glide_deg += 60.0f) {
        struct technique technique = technique_expert;
        technique.glide_deg = glide_deg;
        begin_with(&technique, 5);
        assert_true(bot_fixture_until(&fixture, BOT_GLIDE, 30));
        bot_fixture_tick(&fixture);
        assert_true(f_abs(fixture.bot.goal.angles.pitch_rad + glide_deg * F_DEG) < 1e-3f);
    }
}

/* Returns the greatest speed of the poi in m/s while it rises during the first scoops. */
static float rise_m_s(uint8_t lift)
{
    struct technique technique = technique_expert;
    technique.lift = lift;
    begin_with(&technique, 5);
    float fastest_m_s = 0.0f;
    for (uint32_t i = 0; i < 12u * CORE_TICK_HZ; i++) {
        bot_fixture_tick(&fixture);
        if (fixture.bot.stage == BOT_LIFT) {
            fastest_m_s = f_max(fastest_m_s, fixture.bot.hand.velocity_m_s.y);
        }
    }
    return fastest_m_s;
}

static void test_a_fast_lift_is_faster_than_a_drained_one(void **state)
{
    (void)state;
    const float drained_m_s = rise_m_s(LIFT_DRAINED), fast_m_s = rise_m_s(LIFT_FAST);
    print_message("lift: %.2f and %.2f m/s\n", (double)drained_m_s, (double)fast_m_s);
    assert_true(drained_m_s < 1.15f * technique_expert.lift_m_s);
    assert_true(fast_m_s > 1.7f * drained_m_s);
}

static void test_a_chasing_bot_never_waits(void **state)
{
    (void)state;
    struct technique technique = technique_expert;
    technique.hunt = HUNT_CHASE;
    begin_with(&technique, 5);
    assert_false(bot_fixture_until(&fixture, BOT_WATCH, 20));
    assert_true(bot_fixture_until(&fixture, BOT_DIP, 20));
    begin_with(&technique_expert, 5);
    assert_true(bot_fixture_until(&fixture, BOT_WATCH, 20));
}

/* ---- Results of bots ------------------------------------------------------------------------ */

/* The 2013 thesis criticizes an arcade game in which each scoop costs one paper. In this game,
 * careful scoops must preserve the paper. */
static void test_one_paper_survives_many_careful_scoops(void **state)
{
    (void)state;
    const struct core_config config = { .seed = 3,
                                        .preset = TANK_PRESET_OFFICIAL,
                                        .modes = 1u << MODE_CHAMPIONSHIP };
    bot_fixture_open(&fixture, &config, &technique_expert);
    bot_fixture_begin(&fixture);
    for (uint32_t i = 0; i < 40u * CORE_TICK_HZ; i++) {
        bot_fixture_tick(&fixture);
    }
    print_message("40 s: %u scoops, %u fish, %.3f of the paper left\n",
                  fixture.core.world.poi[0].dips, fixture.core.game.player[0].caught,
                  (double)sheet_left(&fixture.core.world.poi[0].sheet));
    assert_true(fixture.core.world.poi[0].dips >= 8);
    assert_true(sheet_left(&fixture.core.world.poi[0].sheet) > 0.8f);
}

/* The bot plays for 20 s in each tank. Its technique depends only on the tank's size, depth and
 * number of fish. */
static void test_the_bot_plays_in_each_tank(void **state)
{
    (void)state;
    for (uint8_t preset = 0; preset < TANK_PRESET_COUNT; preset++) {
        const struct core_config config = { .seed = 1, .preset = preset };
        bot_fixture_open(&fixture, &config, &technique_expert);
        bot_fixture_begin(&fixture);
        for (uint32_t i = 0; i < 20u * CORE_TICK_HZ; i++) {
            bot_fixture_tick(&fixture);
        }
        print_message("%s: %u caught in 20 s\n", tank_preset(preset)->name,
                      fixture.core.game.player[0].caught);
        assert_true(fixture.core.game.player[0].caught > 0);
    }
}

/* Two bots play at one tank, each with its own bowl and poi. The bots should rarely choose the same
 * fish. */
static void test_two_bots_rarely_target_the_same_fish(void **state)
{
    (void)state;
    static struct bot other;
    const struct core_config config = { .seed = 4, .players = 2 };
    bot_fixture_open(&fixture, &config, &technique_expert);
    bot_init(&other, &technique_expert, 99);
    uint32_t same = 0, both = 0;
    for (uint32_t i = 0; i < 30u * CORE_TICK_HZ; i++) {
        fixture.input.poi[1] = (struct poi_input){
            .link = POI_SOURCE_LIVE,
            .has_wrist = 1,
            .trembles = 1,
            .target =
                bot_tick(&other, &(struct vision){ &fixture.core.game, &fixture.core.world, 1 }),
        };
        bot_fixture_tick(&fixture);
        const int hunts = fixture.bot.stage >= BOT_APPROACH && fixture.bot.stage <= BOT_GLIDE &&
                          other.stage >= BOT_APPROACH && other.stage <= BOT_GLIDE;
        both += (uint32_t)hunts;
        same += hunts && other.prey == fixture.bot.prey;
    }
    print_message("two hunt for %u ticks, the same fish for %u; caught %u and %u\n", both, same,
                  fixture.core.game.player[0].caught, fixture.core.game.player[1].caught);
    assert_true(both > 300);
    assert_true(same < both / 10u);
    assert_true(fixture.core.game.player[0].caught > 0 && fixture.core.game.player[1].caught > 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_the_bot_moves_no_faster_than_an_arm),
        cmocka_unit_test(test_the_bot_updates_its_vision_no_oftener_than_a_person),
        cmocka_unit_test(test_the_bot_acts_on_a_delayed_snapshot),
        cmocka_unit_test(test_the_bot_reacts_to_a_vanished_fish_after_its_reaction_time),
        cmocka_unit_test(test_poi_and_shadow_stay_off_the_water_before_the_start),
        cmocka_unit_test(test_the_bot_only_hovers_without_fish),
        cmocka_unit_test(test_the_bots_pose_is_always_valid),
        cmocka_unit_test(test_a_bots_round_is_the_same_each_time),
        cmocka_unit_test(test_wet_sets_the_wet_share_before_the_first_scoop),
        cmocka_unit_test(test_entry_sets_the_angle_of_entry),
        cmocka_unit_test(test_glide_sets_the_angle_between_paper_and_path),
        cmocka_unit_test(test_a_fast_lift_is_faster_than_a_drained_one),
        cmocka_unit_test(test_a_chasing_bot_never_waits),
        cmocka_unit_test(test_one_paper_survives_many_careful_scoops),
        cmocka_unit_test(test_the_bot_plays_in_each_tank),
        cmocka_unit_test(test_two_bots_rarely_target_the_same_fish),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
