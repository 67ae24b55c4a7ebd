/* test_calibrate.c -- a twin of a poi that sees the tank from a frame of its own, and what an
 * operator makes of it: within a millimetre over all of the water, refused where it is nonsense,
 * undone where it was wrong, and worth a catch. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

#include <cmocka.h>

#include "bot_stall.h"
#include "core/base/rng.h"
#include "core/game/menu_pages.h"

#define FRAMES 400u
#define WITHIN_M 0.001f
#define WITHIN_RAD 0.002f

static const vec3 tank_m = { 1.36f, 0.20f, 0.65f };

/* Where a twin's sensors see what is truly there. */
struct twin {
    float xx, xz, zx, zz;
    vec3 shift_m;
    float pitch_rad, roll_rad;
};

static float draw(uint32_t frame, uint32_t what, float from, float to)
{
    return rng_range((struct rng_key){ 11, frame, what, RNG_TEST }, from, to);
}

/* Turned by any angle, stretched to a third or to three times, skewed, shifted by metres, leant. */
static struct twin twin_of(uint32_t frame)
{
    const float turn = draw(frame, 0, -F_PI, F_PI), c = f_cos(turn), s = f_sin(turn);
    const float wide = draw(frame, 1, 0.34f, 3.0f), deep = draw(frame, 2, 0.34f, 3.0f);
    const float skew = draw(frame, 3, -0.5f, 0.5f);
    return (struct twin){
        .xx = wide * c, .xz = deep * (s + skew * c),
        .zx = -wide * s, .zz = deep * (c - skew * s),
        .shift_m = v3(draw(frame, 4, -2.0f, 2.0f), draw(frame, 5, -1.0f, 1.0f),
                      draw(frame, 6, -2.0f, 2.0f)),
        .pitch_rad = draw(frame, 7, -0.7f, 0.7f), .roll_rad = draw(frame, 8, -0.7f, 0.7f),
    };
}

static vec3 seen_point(const struct twin *twin, vec3 at_m)
{
    return v3(twin->xx * at_m.x + twin->xz * at_m.z + twin->shift_m.x, at_m.y + twin->shift_m.y,
              twin->zx * at_m.x + twin->zz * at_m.z + twin->shift_m.z);
}

static struct poi_target seen(const struct twin *twin, struct poi_target at)
{
    const float x = -f_sin(at.angles.yaw_rad), z = -f_cos(at.angles.yaw_rad);
    return (struct poi_target){
        .position_m = seen_point(twin, at.position_m),
        .angles = { f_atan2(-(twin->xx * x + twin->xz * z), -(twin->zx * x + twin->zz * z)),
                    at.angles.pitch_rad + twin->pitch_rad, at.angles.roll_rad + twin->roll_rad },
    };
}

static struct calibration_said said_by(const struct twin *twin)
{
    struct calibration_said said = { .has_wrist = 1 };
    for (uint32_t i = 0; i < CALIBRATE_CORNERS; i++) {
        said.corner_m[i] = seen_point(twin, calibration_mark(tank_m, i));
    }
    said.water = seen(twin, (struct poi_target){ 0 });
    return said;
}

static void set_values(struct settings *settings, uint32_t seat, const int32_t *value)
{
    memcpy(&settings->value[calibration_setting(seat)], value,
           CALIBRATION_VALUES * sizeof *value);
    settings->value[calibration_check_setting(seat)] = calibration_check(value);
}

/* ---- The map -------------------------------------------------------------------------------- */

static void test_any_frame_is_set_right_within_a_millimetre(void **state)
{
    (void)state;
    float worst_m = 0.0f, worst_rad = 0.0f;
    for (uint32_t frame = 0; frame < FRAMES; frame++) {
        const struct twin twin = twin_of(frame);
        const struct calibration_said said = said_by(&twin);
        int32_t value[CALIBRATION_VALUES];
        struct settings settings = { { 0 } };
        assert_int_equal(calibration_solve(&said, tank_m, value), CALIBRATION_GOOD);
        for (uint32_t i = 0; i < CALIBRATION_VALUES; i++) {
            assert_true(setting_allows(calibration_setting(2) + i, value[i]));
        }
        set_values(&settings, 2, value);
        for (uint32_t i = 0; i < 25u; i++) {
            const struct poi_target at = {
                { 0.34f * ((float)(i % 5u) - 2.0f), 0.01f * (float)i,
                  0.16f * ((float)(i / 5u) - 2.0f) },
                { 0.5f * ((float)(i % 11u) - 5.0f), 0.1f * (float)(i % 3u), -0.05f * (float)i },
            };
            struct poi_input poi = { .link = POI_LINK_LIVE, .has_wrist = 1,
                                     .target = seen(&twin, at) };
            calibration_apply(&settings, 2, &poi);
            worst_m = f_max(worst_m, v3_length(v3_sub(poi.target.position_m, at.position_m)));
            worst_rad = f_max(worst_rad, trust_turn(poi.target.angles, at.angles));
        }
    }
    print_message("over %u frames: %.3f mm, %.4f rad at worst\n", FRAMES,
                  (double)worst_m * 1000.0, (double)worst_rad);
    assert_true(worst_m < WITHIN_M);
    assert_true(worst_rad < WITHIN_RAD);
}

/* A hand misses each mark by up to 5 mm each way: what it made is off by half as much again at
 * most. */
static void test_a_hand_that_misses_a_little_is_averaged(void **state)
{
    (void)state;
    for (uint32_t frame = 0; frame < FRAMES; frame++) {
        const struct twin twin = twin_of(frame);
        struct calibration_said said = said_by(&twin);
        int32_t value[CALIBRATION_VALUES];
        struct settings settings = { { 0 } };
        for (uint32_t i = 0; i < CALIBRATE_CORNERS; i++) {
            const vec3 off_m = v3(draw(frame, 20u + i, -0.005f, 0.005f), 0.0f,
                                  draw(frame, 30u + i, -0.005f, 0.005f));
            said.corner_m[i] = seen_point(&twin, v3_add(calibration_mark(tank_m, i), off_m));
        }
        assert_int_equal(calibration_solve(&said, tank_m, value), CALIBRATION_GOOD);
        set_values(&settings, 0, value);
        for (uint32_t i = 0; i < CALIBRATE_CORNERS; i++) {
            const vec3 mark_m = calibration_mark(tank_m, i);
            struct poi_input poi = { .link = POI_LINK_LIVE,
                                     .target.position_m = seen_point(&twin, mark_m) };
            calibration_apply(&settings, 0, &poi);
            const vec3 off_m = v3_sub(poi.target.position_m, mark_m);
            assert_true(f_sqrt(off_m.x * off_m.x + off_m.z * off_m.z) < 0.0107f);
        }
    }
}

static void test_who_is_not_calibrated_is_believed_to_the_bit(void **state)
{
    (void)state;
    static const struct settings none = { { 0 } };
    struct settings other = { { 0 } };
    set_values(&other, 1, (int32_t[CALIBRATION_VALUES]){ [CALIBRATION_X0] = 100000 });
    struct poi_input poi = { .link = POI_LINK_LIVE, .has_wrist = 1,
                             .target = { { 0.1f, -0.0f, 3e-9f }, { 900.1f, -0.2f, 0.3f } } };
    const struct poi_input before = poi;
    calibration_apply(&none, 0, &poi);
    calibration_apply(&other, 0, &poi);
    assert_memory_equal(&poi, &before, sizeof poi);
    poi.target.position_m.x = 0.0f / (poi.target.position_m.y * 0.0f); /* What cannot be read. */
    const struct poi_input broken = poi;
    calibration_apply(&other, 1, &poi);
    assert_memory_equal(&poi, &broken, sizeof poi);
}

/* ---- What is refused ------------------------------------------------------------------------ */

static enum calibration_fault judge(const struct calibration_said *said)
{
    int32_t value[CALIBRATION_VALUES] = { 7, 7, 7, 7, 7, 7, 7, 7, 7 };
    const enum calibration_fault fault = calibration_solve(said, tank_m, value);
    for (uint32_t i = 0; i < CALIBRATION_VALUES && fault != CALIBRATION_GOOD; i++) {
        assert_int_equal(value[i], 7);
    }
    return fault;
}

static void swap_corners(struct calibration_said *said, uint32_t a, uint32_t b)
{
    const vec3 kept_m = said->corner_m[a];
    said->corner_m[a] = said->corner_m[b];
    said->corner_m[b] = kept_m;
}

static void test_nonsense_is_refused_and_named(void **state)
{
    (void)state;
    for (uint32_t frame = 0; frame < FRAMES; frame++) {
        const struct twin twin = twin_of(frame);
        const struct calibration_said good = said_by(&twin);
        struct calibration_said said = good;
        said.corner_m[2] = v3_add(said.corner_m[1], v3(0.012f, 0.3f, 0.012f));
        assert_int_equal(judge(&said), CALIBRATION_NEAR);
        said = good;
        swap_corners(&said, frame % 4u, (frame + 1u) % 4u);
        assert_int_equal(judge(&said), CALIBRATION_CROSSED);
        said = good;
        swap_corners(&said, frame % 2u, frame % 2u + 2u);
        assert_int_equal(judge(&said), CALIBRATION_MIRRORED);
        said = good;
        for (uint32_t i = 0; i < CALIBRATE_CORNERS; i++) { /* All in a line. */
            said.corner_m[i] = v3_scale(v3(1.0f, 0.0f, 0.4f), (float)i);
        }
        assert_int_equal(judge(&said), CALIBRATION_CROSSED);
        said = good;
        said.water.position_m.y = 10.5f;
        assert_int_equal(judge(&said), CALIBRATION_FAR);
        said = good;
        said.corner_m[frame % 4u] = seen_point(
            &twin, v3_scale(calibration_mark(tank_m, frame % 4u), 0.85f));
        assert_int_equal(judge(&said), CALIBRATION_UNEVEN);
        said = good;
        said.water.angles.roll_rad = frame % 2u ? 0.80f : -0.80f;
        assert_int_equal(judge(&said), CALIBRATION_TILTED);
        said.has_wrist = 0;
        assert_int_equal(judge(&said), CALIBRATION_GOOD);
    }
}

/* ---- The page ------------------------------------------------------------------------------- */

static struct bot_stall stall;
static const struct twin skewed = {
    .xx = 0.7f, .xz = 0.5f, .zx = -0.6f, .zz = 0.8f,
    .shift_m = { 0.30f, 0.09f, -0.20f }, .pitch_rad = 0.3f, .roll_rad = -0.2f,
};

static int setup(void **state)
{
    (void)state;
    struct core_config config = { .seed = 3 };
    settings_reset(&config.memory.settings);
    config.memory.settings.value[SET_MODES] = 1 << MODE_FESTIVAL;
    config.memory.settings.value[SET_ROUND_S] = 60;
    settings_apply(&config.memory.settings, &config);
    bot_stall_open(&stall, &config, &technique_expert);
    stall.input.store_well = 1;
    return 0;
}

static void step(void)
{
    stall.output.sound_count = 0;
    core_tick(&stall.core, &stall.input, &stall.output);
    stall.input.pressed = 0;
    stall.input.record_saved_id = stall.output.entry_id;
}

static void push(uint32_t button)
{
    stall.input.pressed = button;
    for (uint32_t i = 0; i <= MENU_TAKE_TICKS; i++) {
        step();
    }
}

static const struct menu *menu(void)
{
    return &stall.core.game.menu;
}

static const struct calibrate *calibrate(void)
{
    return &menu()->calibrate;
}

static void take(uint32_t tag)
{
    for (uint32_t i = 0; menu()->tag[menu()->page] != tag && i < MENU_TAG_MAX; i++) {
        push(INPUT_SERVICE);
    }
    assert_int_equal(menu()->tag[menu()->page], tag);
    push(INPUT_TEST);
}

/* The true pose, through the twin's eyes; a hand trembles by a millimetre. */
static void hold_true(struct poi_target at, uint32_t ticks)
{
    for (uint32_t i = 0; i < ticks; i++) {
        struct poi_target now = at;
        now.position_m.x += i % 2u ? 0.001f : -0.001f;
        stall.input.poi[0] = (struct poi_input){ .link = POI_LINK_LIVE, .has_wrist = 1,
                                                 .trembles = 1, .target = seen(&skewed, now) };
        step();
    }
}

static void open_page(void)
{
    hold_true((struct poi_target){ .position_m = v3(0.0f, 0.1f, 0.0f) }, 2);
    push(INPUT_TEST);
    take(menu_tag_of(MENU_DEVICES));
    take(menu_tag_of(MENU_CALIBRATION));
    assert_int_equal(menu()->page, MENU_CALIBRATION);
}

/* With the poi alone: no button is pressed from mark to mark. */
static void lead_through(struct poi_target water)
{
    for (uint32_t i = 0; i < CALIBRATE_CORNERS; i++) {
        assert_int_equal(calibrate()->step, CALIBRATE_CORNER + (int)i);
        const vec3 mark_m = calibration_mark(stall.core.tank.size_m, i);
        hold_true((struct poi_target){ .position_m = mark_m }, CALIBRATE_STILL_TICKS + 4u);
    }
    assert_int_equal(calibrate()->step, CALIBRATE_WATER);
    hold_true(water, CALIBRATE_STILL_TICKS + 4u);
}

static int is_set(void)
{
    return calibration_is_set(&stall.core.config.memory.settings, 0);
}

static void calibrate_all(void)
{
    open_page();
    take(CALIBRATE_BEGIN);
    lead_through((struct poi_target){ 0 });
    assert_int_equal(calibrate()->step, CALIBRATE_DONE);
}

static void test_a_poi_is_led_from_mark_to_mark_and_counts_at_once(void **state)
{
    (void)state;
    calibrate_all();
    assert_true(is_set());
    const struct poi_target at = { .position_m = v3(0.21f, 0.05f, -0.11f) };
    hold_true(at, 60);
    const vec3 off_m = v3_sub(stall.core.game.trust[0].newest.position_m, at.position_m);
    assert_true(v3_length(off_m) < 0.004f); /* The hand's own millimetre is in it. */
}

static void test_each_value_is_an_entry_of_the_ledger(void **state)
{
    (void)state;
    open_page();
    const uint32_t before = stall.output.entry_id;
    take(CALIBRATE_BEGIN);
    lead_through((struct poi_target){ 0 });
    hold_true((struct poi_target){ .position_m = v3(0.2f, 0.1f, 0.0f) }, CORE_TICK_HZ);
    assert_int_equal(stall.output.entry_id, before + CALIBRATION_VALUES + 1u);
    for (uint32_t i = 0; i < CALIBRATION_VALUES; i++) {
        const struct ledger_entry *entry = &stall.output.entries[(before + 1u + i) % LEDGER_RING];
        assert_int_equal(entry->kind, LEDGER_SETTING);
        assert_int_equal(entry->detail | entry->count << 8, calibration_setting(0) + i);
        assert_int_equal(entry->value,
                         stall.core.config.memory.settings.value[calibration_setting(0) + i]);
    }
    const struct ledger_entry *check =
        &stall.output.entries[stall.output.entry_id % LEDGER_RING]; /* After all of them. */
    assert_int_equal(check->detail | check->count << 8, calibration_check_setting(0));
    assert_true(adjust_is_saved(&stall.core));
}

/* What is on disk after so many of the entries from `before` on. */
static struct settings settings_cut_after(const struct settings *before, uint32_t before_id,
                                          uint32_t count)
{
    struct settings left = *before;
    for (uint32_t i = 1; i <= count; i++) {
        const struct ledger_entry *entry = &stall.output.entries[(before_id + i) % LEDGER_RING];
        assert_int_equal(entry->kind, LEDGER_SETTING);
        left.value[entry->detail | entry->count << 8] = entry->value;
    }
    settings_mend(&left);
    return left;
}

/* With the plug pulled before the first entry, after the last and between each two: all of the old
 * map, all of the new one, or none. */
static void expect_no_patchwork(const struct settings *before, uint32_t before_id)
{
    const struct settings now = stall.core.config.memory.settings;
    const uint32_t count = stall.output.entry_id - before_id;
    uint32_t torn = 0;
    assert_true(count >= 2u && count < LEDGER_RING);
    for (uint32_t i = 0; i <= count; i++) {
        const struct settings left = settings_cut_after(before, before_id, i);
        const struct settings *whole = i < count ? before : &now;
        const struct poi_input said = { .link = POI_LINK_LIVE, .has_wrist = 1,
                                        .target = { { 0.1f, 0.2f, 0.3f }, { 0.4f, 0.5f, 0.6f } } };
        struct poi_input poi = said, wanted = said;
        calibration_apply(&left, 0, &poi);
        if (i == 0 || i == count) {
            calibration_apply(whole, 0, &wanted);
        }
        assert_memory_equal(&poi, &wanted, sizeof poi);
        torn += (uint32_t)calibration_is_torn(&left, 0);
        assert_false(calibration_is_torn(&left, 0) && (i == 0 || i == count));
    }
    assert_true(torn >= count - 2u); /* All in between, save where no value is left. */
}

static void test_a_map_that_was_cut_off_between_two_entries_is_none(void **state)
{
    (void)state;
    struct settings before = stall.core.config.memory.settings;
    const struct poi_target aside = { .position_m = v3(0.2f, 0.1f, 0.0f) };
    open_page();
    uint32_t before_id = stall.output.entry_id;
    take(CALIBRATE_BEGIN);
    lead_through((struct poi_target){ 0 });
    hold_true(aside, CORE_TICK_HZ);
    expect_no_patchwork(&before, before_id); /* The first one, */

    before = stall.core.config.memory.settings;
    before_id = stall.output.entry_id;
    take(CALIBRATE_BEGIN);
    lead_through((struct poi_target){ .position_m.y = 0.01f, .angles = { 0.0f, 0.1f, 0.05f } });
    hold_true(aside, CORE_TICK_HZ);
    expect_no_patchwork(&before, before_id); /* another after it, */

    before = stall.core.config.memory.settings;
    before_id = stall.output.entry_id;
    take(CALIBRATE_NONE);
    hold_true(aside, CORE_TICK_HZ);
    expect_no_patchwork(&before, before_id); /* and none any more. */
}

/* The page tells of it, and offers to take it away; undone is what was whole. */
static void test_a_torn_map_is_told_and_taken_away(void **state)
{
    (void)state;
    static struct scene scene;
    calibrate_all();
    stall.core.config.memory.settings.value[calibration_setting(0) + CALIBRATION_Z0] += 1;
    step();
    core_scene(&stall.core, &scene);
    assert_true(calibration_is_torn(&scene.menu.settings, 0));
    assert_false(is_set());
    assert_true(menu_offers(menu()) >> CALIBRATE_NONE & 1u);
    take(CALIBRATE_NONE);
    assert_false(calibration_is_torn(&stall.core.config.memory.settings, 0));
    take(CALIBRATE_UNDO);
    assert_false(calibration_is_torn(&stall.core.config.memory.settings, 0));
    assert_false(is_set());
}

static void test_it_is_undone_redone_and_taken_away(void **state)
{
    (void)state;
    calibrate_all();
    const struct settings set = stall.core.config.memory.settings;
    take(CALIBRATE_UNDO);
    assert_false(is_set());
    take(CALIBRATE_UNDO);
    assert_memory_equal(&stall.core.config.memory.settings, &set, sizeof set);
    take(CALIBRATE_NONE);
    assert_false(is_set());
    assert_false(menu_offers(menu()) >> CALIBRATE_NONE & 1u);
    take(CALIBRATE_UNDO);
    assert_memory_equal(&stall.core.config.memory.settings, &set, sizeof set);
}

static void test_a_refused_one_changes_nothing(void **state)
{
    (void)state;
    open_page();
    take(CALIBRATE_BEGIN);
    lead_through((struct poi_target){ .angles.pitch_rad = 0.6f });
    assert_int_equal(calibrate()->step, CALIBRATE_REFUSED);
    assert_int_equal(calibrate()->fault, CALIBRATION_TILTED);
    assert_false(is_set());
    assert_false(menu_offers(menu()) >> CALIBRATE_UNDO & 1u);
}

/* In its holder when it began, on its way, away for a while: none of that is a mark. */
static void test_only_stillness_after_a_way_is_a_mark(void **state)
{
    (void)state;
    open_page();
    take(CALIBRATE_BEGIN);
    const struct poi_target holder = { .position_m = v3(0.0f, 0.1f, 0.0f) };
    hold_true(holder, 4u * CALIBRATE_STILL_TICKS);
    assert_int_equal(calibrate()->step, CALIBRATE_CORNER);
    for (uint32_t i = 0; i < 5u * CALIBRATE_STILL_TICKS; i++) { /* 10 cm/s. */
        const float x = 0.001f * (float)(i % 600u) - 0.3f;
        hold_true((struct poi_target){ .position_m = v3(x, 0.1f, 0.0f) }, 1);
    }
    assert_int_equal(calibrate()->step, CALIBRATE_CORNER);
    const struct poi_target mark = { .position_m = calibration_mark(stall.core.tank.size_m, 0) };
    hold_true(mark, CALIBRATE_STILL_TICKS / 2u);
    stall.input.poi[0].link = POI_LINK_LOST;
    step();
    hold_true(mark, CALIBRATE_STILL_TICKS / 2u + 2u);
    assert_int_equal(calibrate()->step, CALIBRATE_CORNER);
    hold_true(mark, CALIBRATE_STILL_TICKS / 2u + 2u);
    assert_int_equal(calibrate()->step, CALIBRATE_CORNER + 1);
    hold_true(mark, 4u * CALIBRATE_STILL_TICKS); /* Nobody goes on: it is one mark, not two. */
    assert_int_equal(calibrate()->step, CALIBRATE_CORNER + 1);
}

static void test_a_poi_on_its_way_takes_no_tag(void **state)
{
    (void)state;
    open_page();
    take(CALIBRATE_BEGIN);
    for (uint32_t i = 0; i < 600u; i++) { /* Over and through all of the screen. */
        const vec3 at_m = v3(0.002f * (float)(i % 300u) - 0.3f, i % 40u < 20u ? 0.06f : -0.05f,
                             0.001f * (float)i - 0.3f);
        hold_true((struct poi_target){ .position_m = at_m }, 1);
        assert_int_equal(menu()->page, MENU_CALIBRATION);
        assert_int_equal(calibrate()->step, CALIBRATE_CORNER);
    }
}

/* ---- A round -------------------------------------------------------------------------------- */

/* The bot's hand truly moves so; the core is told what the twin sees. */
static uint32_t play_a_round(void)
{
    uint32_t ticks = 0;
    bot_init(&stall.bot, &technique_expert, 3);
    stall.bot.hand.pose = (struct poi_target){ .position_m = v3(0.0f, 0.10f, 0.0f) };
    while (stall.core.game.phase != PHASE_RESULT && ticks++ < 120u * CORE_TICK_HZ) {
        const uint8_t phase = stall.core.game.phase;
        const struct sight sight = bot_stall_sight(&stall);
        stall.input.pressed = phase == PHASE_ATTRACT && ticks % CORE_TICK_HZ == 0 ? INPUT_START : 0;
        hold_true(bot_tick(&stall.bot, &sight), 1);
    }
    assert_int_equal(stall.core.game.phase, PHASE_RESULT);
    return stall.output.record.caught;
}

static void test_a_skewed_poi_catches_fish_only_once_it_is_calibrated(void **state)
{
    assert_int_equal(play_a_round(), 0);
    setup(state);
    calibrate_all();
    take(CALIBRATE_BACK);
    take(menu_tag_count(MENU_DEVICES) - 1u);
    take(menu_tag_count(MENU_TOP) - 1u);
    assert_int_equal(stall.core.game.phase, PHASE_ATTRACT);
    const uint32_t caught = play_a_round();
    print_message("calibrated it caught %u\n", caught);
    assert_true(caught > 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_any_frame_is_set_right_within_a_millimetre),
        cmocka_unit_test(test_a_hand_that_misses_a_little_is_averaged),
        cmocka_unit_test(test_who_is_not_calibrated_is_believed_to_the_bit),
        cmocka_unit_test(test_nonsense_is_refused_and_named),
        cmocka_unit_test_setup(test_a_poi_is_led_from_mark_to_mark_and_counts_at_once, setup),
        cmocka_unit_test_setup(test_each_value_is_an_entry_of_the_ledger, setup),
        cmocka_unit_test_setup(test_a_map_that_was_cut_off_between_two_entries_is_none, setup),
        cmocka_unit_test_setup(test_a_torn_map_is_told_and_taken_away, setup),
        cmocka_unit_test_setup(test_it_is_undone_redone_and_taken_away, setup),
        cmocka_unit_test_setup(test_a_refused_one_changes_nothing, setup),
        cmocka_unit_test_setup(test_only_stillness_after_a_way_is_a_mark, setup),
        cmocka_unit_test_setup(test_a_poi_on_its_way_takes_no_tag, setup),
        cmocka_unit_test_setup(test_a_skewed_poi_catches_fish_only_once_it_is_calibrated, setup),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
