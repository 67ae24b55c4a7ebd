/* test_options.c -- Tests the command-line options of `kingyo` and the messages for invalid
 * options. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

#include <cmocka.h>

#include "core/scene.h"
#include "core/tank/preset.h"
#include "platform/board.h"
#include "platform/config/options.h"

#define COUNT(array) ((int)(sizeof array / sizeof array[0]))

static struct options options;
static char error[OPTIONS_ERROR_MAX];

static int parse(int argc, const char *const *argv)
{
    memset(&options, 0, sizeof options);
    memset(error, 0, sizeof error);
    return options_parse(&options, argc, argv, error);
}

static int32_t asked(uint32_t id)
{
    assert_int_equal(options.words.is_set[id], 1);
    return options.words.value[id];
}

static void test_every_option_is_parsed(void **state)
{
    static const char *const argv[] = {
        "kingyo",   "--window", "800x600",   "--poi",  "bot",
        "--record", "a.kgr",    "--shots",   "pics",   "--data=scores",
        "--config", "c.conf",   "--lang",    "en",     "--seed",
        "0255",     "--fish",   "50",        "--mode", "championship",
        "--grade",  "4",        "--players", "3",      "--demo",
        "30",       "--detail", "75",        "--time", "day",
    };
    (void)state;
    assert_int_equal(parse(COUNT(argv), argv), 0);
    assert_int_equal(options.detail, 75);
    assert_int_equal(asked(SET_TIME), 1);
    assert_int_equal(options.width, 800);
    assert_int_equal(options.height, 600);
    assert_int_equal(options.poi, BOARD_POI_BOT);
    assert_string_equal(options.record, "a.kgr");
    assert_string_equal(options.shots, "pics");
    assert_string_equal(options.data, "scores");
    assert_string_equal(options.config, "c.conf");
    assert_int_equal(asked(SET_LANGUAGE), LANGUAGE_EN);
    assert_int_equal(options.seed, 255);
    assert_int_equal(options.has_seed, 1);
    assert_int_equal(asked(SET_FISH), 50);
    assert_int_equal(asked(SET_MODES), 1 << MODE_CHAMPIONSHIP);
    assert_int_equal(asked(SET_GRADE), 4);
    assert_int_equal(asked(SET_PLAYERS), 3);
    assert_int_equal(options.demo, 1);
    assert_int_equal(options.demo_s, 30);
}

static void test_the_poi_option_accepts_each_controller_name(void **state)
{
    static const struct {
        const char *name;
        uint8_t poi;
    } kinds[] = {
        { "auto", BOARD_POI_AUTO }, { "mouse", BOARD_POI_MOUSE }, { "touch", BOARD_POI_TOUCH },
        { "pad", BOARD_POI_PAD },   { "usb", BOARD_POI_USB },     { "bot", BOARD_POI_BOT },
    };
    (void)state;
    for (size_t i = 0; i < sizeof kinds / sizeof kinds[0]; i++) {
        const char *const argv[] = { "kingyo", "--poi", kinds[i].name };
        assert_int_equal(parse(COUNT(argv), argv), 0);
        assert_int_equal(options.poi, kinds[i].poi);
    }
}

static void test_the_keyboard_option_enables_or_disables_the_keyboard(void **state)
{
    static const char *const on[] = { "kingyo", "--keyboard", "on" };
    static const char *const off[] = { "kingyo", "--keyboard=off" };
    static const char *const perhaps[] = { "kingyo", "--keyboard", "perhaps" };
    (void)state;
    assert_int_equal(parse(COUNT(on), on), 0);
    assert_int_equal(options.keyboard, BOARD_KEYBOARD_ON);
    assert_int_equal(parse(COUNT(off), off), 0);
    assert_int_equal(options.keyboard, BOARD_KEYBOARD_OFF);
    assert_int_equal(parse(COUNT(perhaps), perhaps), -1);
}

static void test_dips_by_click_reach_side_and_text_are_options(void **state)
{
    (void)state;
    static const char *const all[] = { "kingyo", "--dip", "click",  "--reach", "60",
                                       "--side", "left",  "--text", "largest" };
    assert_int_equal(parse(9, all), 0);
    assert_int_equal(asked(SET_DIP), 1);
    assert_int_equal(asked(SET_REACH), 60);
    assert_int_equal(asked(SET_SIDE), BOWL_LEFT);
    assert_int_equal(asked(SET_TEXT), 2);
    static const char *const wrong[][2] = { { "--dip", "push" },    { "--reach", "39" },
                                            { "--reach", "101" },   { "--reach", "0" },
                                            { "--side", "middle" }, { "--text", "small" } };
    for (size_t i = 0; i < sizeof wrong / sizeof *wrong; i++) {
        const char *const words[] = { "kingyo", wrong[i][0], wrong[i][1] };
        assert_int_not_equal(parse(3, words), 0);
        assert_non_null(strstr(error, wrong[i][0]));
    }
}

static void test_repeated_controller_and_line_options_are_appended(void **state)
{
    /* clang-format off */
    static const char *const argv[] = {
        "kingyo", "--usb", "057e:2009", "--usb=054c:09cc:A1:B2", "--line", "start=BTN_START",
        "--line=coin=pinctrl-bcm2711:17,low,up", "--line", "start=BTN_A",
    };
    /* clang-format on */
    (void)state;
    assert_int_equal(parse(COUNT(argv), argv), 0);
    assert_int_equal(options.usb_count, 2);
    assert_string_equal(options.usb[0], "057e:2009");
    assert_string_equal(options.usb[1], "054c:09cc:A1:B2");
    assert_int_equal(options.line_count, 3);
    assert_string_equal(options.line[1], "coin=pinctrl-bcm2711:17,low,up");
}

static void test_too_many_controllers_or_lines_are_an_error(void **state)
{
    const char *argv[2 * (BOARD_LINE_MAX + 2)] = { "kingyo" };
    (void)state;
    for (uint32_t i = 0; i <= BOARD_USB_MAX; i++) {
        argv[1 + 2 * i] = "--usb";
        argv[2 + 2 * i] = "1209:0001";
    }
    assert_int_equal(parse(1 + 2 * (int)BOARD_USB_MAX, argv), 0);
    assert_int_equal(parse(3 + 2 * (int)BOARD_USB_MAX, argv), -1);
    for (uint32_t i = 0; i <= BOARD_LINE_MAX; i++) {
        argv[1 + 2 * i] = "--line";
        argv[2 + 2 * i] = "tilt=T";
    }
    assert_int_equal(parse(1 + 2 * (int)BOARD_LINE_MAX, argv), 0);
    assert_int_equal(parse(3 + 2 * (int)BOARD_LINE_MAX, argv), -1);
}

static void test_a_wrong_gpio_line_is_reported_with_its_error(void **state)
{
    static const char *const no_role[] = { "kingyo", "--line", "jump=BTN" };
    static const char *const clash[] = { "kingyo", "--line", "start=A", "--line", "left=A" };
    (void)state;
    assert_int_equal(parse(COUNT(no_role), no_role), -1);
    assert_non_null(strstr(error, "--line: 'jump=BTN': "));
    assert_int_equal(parse(COUNT(clash), clash), -1);
    assert_non_null(strstr(error, "start and left are both on A"));
}

static void test_the_demo_option_needs_no_duration(void **state)
{
    static const char *const last[] = { "kingyo", "--demo" };
    static const char *const middle[] = { "kingyo", "--demo", "--lang", "ja" };
    (void)state;
    assert_int_equal(parse(COUNT(last), last), 0);
    assert_int_equal(options.demo_s, OPTIONS_DEMO_S);
    assert_int_equal(parse(COUNT(middle), middle), 0);
    assert_int_equal(options.demo_s, OPTIONS_DEMO_S);
    assert_int_equal(asked(SET_LANGUAGE), LANGUAGE_JA);
}

static void test_a_wrong_duration_has_one_message_for_words_and_numbers(void **state)
{
    static const char *const values[] = { "abc", "0", "-3", "601", "" };
    (void)state;
    for (int i = 0; i < COUNT(values); i++) {
        const char *const argv[] = { "kingyo", "--selftest-board", values[i] };
        char expected[OPTIONS_ERROR_MAX];
        snprintf(expected, sizeof expected,
                 "--selftest-board: '%s' is wrong; expected 5 to 600 seconds", values[i]);
        assert_int_equal(parse(COUNT(argv), argv), -1);
        assert_string_equal(error, expected);
    }
}

static const char *const wrong[][4] = {
    { "kingyo", "--fly", NULL },
    { "kingyo", "fish", NULL },
    { "kingyo", "-", NULL },
    { "kingyo", "", NULL },
    { "kingyo", "--detail", "24", NULL },
    { "kingyo", "--detail", "101", NULL },
    { "kingyo", "--window", "800", NULL },
    { "kingyo", "--window", "x600", NULL },
    { "kingyo", "--window", "800x", NULL },
    { "kingyo", "--window", "800x600x2", NULL },
    { "kingyo", "--window", "319x600", NULL },
    { "kingyo", "--window", "99999999999999999999999x600", NULL },
    { "kingyo", "--poi", "net", NULL },
    { "kingyo", "--usb", "057e", NULL },
    { "kingyo", "--usb", "057e:200", NULL },
    { "kingyo", "--usb", "057e:20090", NULL },
    { "kingyo", "--usb", "057g:2009", NULL },
    { "kingyo", "--usb", "057e-2009", NULL },
    { "kingyo", "--usb", NULL },
    { "kingyo", "--line", "start", NULL },
    { "kingyo", "--line", "=A", NULL },
    { "kingyo", "--lang", "fr", NULL },
    { "kingyo", "--seed", "-1", NULL },
    { "kingyo", "--seed", "4294967296", NULL },
    { "kingyo", "--seed", "12a", NULL },
    { "kingyo", "--seed", "0x10", NULL },
    { "kingyo", "--seed", " 1", NULL },
    { "kingyo", "--fish", "0", NULL },
    { "kingyo", "--fish", "2048", NULL },
    { "kingyo", "--mode", "tournament", NULL },
    { "kingyo", "--mode", "", NULL },
    { "kingyo", "--mode", NULL },
    { "kingyo", "--grade", "3", NULL },
    { "kingyo", "--grade", "8", NULL },
    { "kingyo", "--grade", "5.5", NULL },
    { "kingyo", "--players", "0", NULL },
    { "kingyo", "--players", "5", NULL },
    { "kingyo", "--players", "two", NULL },
    { "kingyo", "--demo", "4", NULL },
    { "kingyo", "--demo", "601", NULL },
    { "kingyo", "--demo=", NULL },
    { "kingyo", "--record", NULL },
    { "kingyo", "--record", "--demo", NULL },
    { "kingyo", "--record=", NULL },
    { "kingyo", "--help=yes", NULL },
};

static void test_a_wrong_option_gives_one_message_that_names_the_option(void **state)
{
    (void)state;
    for (size_t i = 0; i < sizeof wrong / sizeof wrong[0]; i++) {
        int argc = 0;
        while (argc < 4 && wrong[i][argc]) {
            argc++;
        }
        assert_int_equal(parse(argc, wrong[i]), -1);
        assert_true(strlen(error) > 10);
        assert_null(strchr(error, '\n'));
    }
}

static void check_most(const char *tank, uint8_t preset)
{
    char count[16], most[16];
    const char *const fish_first[] = { "kingyo", "--fish", count, "--tank", tank };
    const char *const tank_first[] = { "kingyo", "--tank", tank, "--fish", count };
    const unsigned max = tank_preset_fish_max(tank_preset(preset), 1.0f);
    snprintf(count, sizeof count, "%u", max);
    assert_int_equal(parse(COUNT(fish_first), fish_first), 0);
    assert_int_equal(asked(SET_FISH), max);
    assert_int_equal(options.tank, preset);
    assert_int_equal(parse(COUNT(tank_first), tank_first), 0);
    memcpy(most, count, sizeof most);
    snprintf(count, sizeof count, "%u", max + 1u);
    assert_int_equal(parse(COUNT(fish_first), fish_first), -1);
    assert_non_null(strstr(error, most)); /* The message must contain the largest allowed
                                             number. */
    assert_int_equal(parse(COUNT(tank_first), tank_first), -1);
}

static void test_the_fish_count_is_limited_by_the_tank(void **state)
{
    (void)state;
    check_most("festival", TANK_PRESET_FESTIVAL);
    check_most("thesis", TANK_PRESET_THESIS);
    check_most("official", TANK_PRESET_OFFICIAL);
}

static void test_the_default_tank_is_festival_and_an_unknown_tank_is_an_error(void **state)
{
    static const char *const none[] = { "kingyo" };
    static const char *const unknown[] = { "kingyo", "--tank", "pond" };
    (void)state;
    assert_int_equal(parse(COUNT(none), none), 0);
    assert_int_equal(options.tank, TANK_PRESET_FESTIVAL);
    assert_int_equal(parse(COUNT(unknown), unknown), -1);
    assert_non_null(strstr(error, "festival, thesis or official"));
}

static void test_the_mode_option_accepts_three_modes_and_ask(void **state)
{
    static const char *const modes[] = { "festival", "championship", "practice" };
    (void)state;
    for (uint32_t mode = 0; mode < MODE_COUNT; mode++) {
        const char *const argv[] = { "kingyo", "--mode", modes[mode] };
        assert_int_equal(parse(COUNT(argv), argv), 0);
        assert_int_equal(asked(SET_MODES), 1 << mode);
    }
    const char *const argv[] = { "kingyo", "--mode=choose" };
    assert_int_equal(parse(COUNT(argv), argv), 0);
    assert_int_equal(asked(SET_MODES), OPTIONS_MODES_ALL);
}

static struct settings settings;

/* Computes `settings` from all sources. If `saved_id` is a valid setting, the sources include the
 * value `saved` that was set in the menu. */
static void settle(uint32_t saved_id, int32_t saved)
{
    options_first(&options, &settings);
    if (saved_id < SETTING_COUNT) {
        settings.value[saved_id] = saved;
    }
    options_last(&options, &settings);
}

static void test_options_are_copied_to_the_kiosk_configuration(void **state)
{
    static const char *const all[] = { "kingyo",    "--mode",   "practice", "--grade",   "7",
                                       "--players", "4",        "--fish",   "50",        "--lang",
                                       "en",        "--coins",  "3",        "--tickets", "10",
                                       "--set",     "volume=35" };
    struct core_config core = { .preset = TANK_PRESET_THESIS };
    (void)state;
    assert_int_equal(parse(COUNT(all), all), 0);
    settle(SETTING_COUNT, 0);
    config_apply_settings(&core, &settings);
    assert_int_equal(core.modes, 1u << MODE_PRACTICE);
    assert_int_equal(core.grade, 7);
    assert_int_equal(core.players, 4);
    assert_int_equal(core.fish_count, 50);
    assert_int_equal(core.credit_coins, 3);
    assert_int_equal(core.ticket_fish, 10);
    assert_int_equal(core.language, LANGUAGE_EN);
    assert_int_equal(settings.value[SET_VOLUME], 35);
}

static void test_without_options_every_setting_has_its_default(void **state)
{
    static const char *const none[] = { "kingyo" };
    (void)state;
    assert_int_equal(parse(COUNT(none), none), 0);
    settle(SETTING_COUNT, 0);
    for (uint32_t id = 0; id < SETTING_COUNT; id++) {
        assert_int_equal(settings.value[id], settings_entry(id)->standard);
        assert_int_equal(options_query(&options, id), 0);
    }
}

static void test_no_coins_option_overrides_the_saved_price(void **state)
{
    static const char *const argv[] = { "kingyo", "--coins", "0" };
    (void)state;
    assert_int_equal(parse(COUNT(argv), argv), 0);
    settle(SET_PLAY, PLAY_PAID);
    assert_int_equal(settings.value[SET_PLAY], PLAY_FREE);
}

/* The sources of a setting are its default, the locale of the machine, kingyo.conf, the menu and
 * the command line. Each source must override the earlier ones. */
static void test_each_later_configuration_source_overrides_the_earlier_one(void **state)
{
    static const char *const none[] = { "kingyo" };
    static const char *const given[] = { "kingyo", "--set", "language=ja" };
    (void)state;
    assert_int_equal(parse(COUNT(none), none), 0);
    options.machine.is_set[SET_LANGUAGE] = 1;
    options.machine.value[SET_LANGUAGE] = LANGUAGE_EN;
    settle(SETTING_COUNT, 0);
    assert_int_equal(settings.value[SET_LANGUAGE], LANGUAGE_EN);
    options.file.is_set[SET_LANGUAGE] = 1;
    options.file.value[SET_LANGUAGE] = LANGUAGE_JA;
    settle(SETTING_COUNT, 0);
    assert_int_equal(settings.value[SET_LANGUAGE], LANGUAGE_JA);
    settle(SET_LANGUAGE, LANGUAGE_EN);
    assert_int_equal(settings.value[SET_LANGUAGE], LANGUAGE_EN);
    assert_int_equal(parse(COUNT(given), given), 0);
    settle(SET_LANGUAGE, LANGUAGE_EN);
    assert_int_equal(settings.value[SET_LANGUAGE], LANGUAGE_JA);
}

static void test_an_out_of_range_setting_is_reported_with_its_range(void **state)
{
    static const char *const price[] = { "kingyo", "--set", "price=21" };
    static const char *const none[] = { "kingyo", "--set", "colour=red" };
    static const char *const bare[] = { "kingyo", "--set", "price" };
    static const char *const secret[] = { "kingyo", "--set", "seat1-xx=5" };
    (void)state;
    assert_int_equal(parse(COUNT(price), price), -1);
    assert_non_null(strstr(error, "--set: 'price=21': expected 1 to 20"));
    assert_int_equal(parse(COUNT(none), none), -1);
    assert_non_null(strstr(error, "kingyoctl config defaults"));
    assert_int_equal(parse(COUNT(bare), bare), -1);
    assert_int_equal(parse(COUNT(secret), secret), -1);
}

static void test_saved_fish_counts_are_clamped_to_the_tank(void **state)
{
    struct core_config core = { .preset = TANK_PRESET_FESTIVAL };
    (void)state;
    settings_reset(&settings);
    settings.value[SET_FISH] = settings_entry(SET_FISH)->max;
    config_apply_settings(&core, &settings);
    assert_int_equal(core.fish_count, tank_preset_fish_max(tank_preset(core.preset), 1.0f));
}

static void test_a_kiosk_starts_at_the_normal_level_unless_the_level_is_set(void **state)
{
    static const struct {
        const char *set;
        uint8_t level;
    } cases[] = { { "language=en", LEVEL_NORMAL },
                  { "level=normal", LEVEL_NORMAL },
                  { "level=easy", LEVEL_EASY },
                  { "level=master", LEVEL_MASTER } };
    (void)state;
    for (size_t i = 0; i < COUNT(cases); i++) {
        const char *const argv[] = { "kingyo", "--set", cases[i].set };
        struct core_config core = { .level = LEVEL_COUNT };
        assert_int_equal(parse(COUNT(argv), argv), 0);
        settle(SETTING_COUNT, 0);
        config_apply_settings(&core, &settings);
        assert_int_equal(core.level, cases[i].level);
        /* Recordings with rules 8 were made before levels existed, so they replay at the level of
         * the original game, LEVEL_MASTER. */
        core.rules = 8;
        config_apply_settings(&core, &settings);
        assert_int_equal(core.level, LEVEL_MASTER);
    }
}

static void test_a_video_needs_a_replay_and_no_demonstration(void **state)
{
    static const char *const argv[] = { "kingyo", "--replay", "a", "--video", "b", "--demo" };
    static const char *const alone[] = { "kingyo", "--video", "b" };
    (void)state;
    assert_int_equal(parse(COUNT(argv) - 1, argv), 0);
    assert_string_equal(options.video, "b");
    assert_int_equal(parse(COUNT(argv), argv), -1);
    assert_non_null(strstr(error, "--video"));
    assert_int_equal(parse(COUNT(alone), alone), -1);
    assert_non_null(strstr(error, "--replay"));
}

static void test_recording_during_a_replay_is_an_error(void **state)
{
    static const char *const argv[] = { "kingyo", "--record", "a", "--replay", "b" };
    (void)state;
    assert_int_equal(parse(COUNT(argv), argv), -1);
}

static void test_a_too_long_path_is_an_error(void **state)
{
    static char path[OPTIONS_PATH_MAX + 1];
    const char *const argv[] = { "kingyo", "--data", path };
    (void)state;
    memset(path, 'a', OPTIONS_PATH_MAX);
    assert_int_equal(parse(COUNT(argv), argv), -1);
    path[OPTIONS_PATH_MAX - 1] = '\0';
    assert_int_equal(parse(COUNT(argv), argv), 0);
}

static void test_a_number_with_leading_zeros_is_decimal(void **state)
{
    static const char *const argv[] = { "kingyo", "--seed", "010" };
    (void)state;
    assert_int_equal(parse(COUNT(argv), argv), 0);
    assert_int_equal(options.seed, 10);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_every_option_is_parsed),
        cmocka_unit_test(test_the_poi_option_accepts_each_controller_name),
        cmocka_unit_test(test_the_keyboard_option_enables_or_disables_the_keyboard),
        cmocka_unit_test(test_dips_by_click_reach_side_and_text_are_options),
        cmocka_unit_test(test_repeated_controller_and_line_options_are_appended),
        cmocka_unit_test(test_too_many_controllers_or_lines_are_an_error),
        cmocka_unit_test(test_a_wrong_gpio_line_is_reported_with_its_error),
        cmocka_unit_test(test_the_demo_option_needs_no_duration),
        cmocka_unit_test(test_a_wrong_duration_has_one_message_for_words_and_numbers),
        cmocka_unit_test(test_a_wrong_option_gives_one_message_that_names_the_option),
        cmocka_unit_test(test_the_fish_count_is_limited_by_the_tank),
        cmocka_unit_test(test_the_default_tank_is_festival_and_an_unknown_tank_is_an_error),
        cmocka_unit_test(test_the_mode_option_accepts_three_modes_and_ask),
        cmocka_unit_test(test_options_are_copied_to_the_kiosk_configuration),
        cmocka_unit_test(test_without_options_every_setting_has_its_default),
        cmocka_unit_test(test_no_coins_option_overrides_the_saved_price),
        cmocka_unit_test(test_each_later_configuration_source_overrides_the_earlier_one),
        cmocka_unit_test(test_an_out_of_range_setting_is_reported_with_its_range),
        cmocka_unit_test(test_saved_fish_counts_are_clamped_to_the_tank),
        cmocka_unit_test(test_a_kiosk_starts_at_the_normal_level_unless_the_level_is_set),
        cmocka_unit_test(test_a_video_needs_a_replay_and_no_demonstration),
        cmocka_unit_test(test_recording_during_a_replay_is_an_error),
        cmocka_unit_test(test_a_too_long_path_is_an_error),
        cmocka_unit_test(test_a_number_with_leading_zeros_is_decimal),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
