/* test_options.c -- what may be asked of `kingyo`, and what is said when it is asked wrongly. */
#include <errno.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include <cmocka.h>

#include "core/scene.h"
#include "core/tank/preset.h"
#include "platform/board.h"
#include "platform/kiosk/options.h"

#define COUNT(array) ((int)(sizeof array / sizeof array[0]))

static struct options options;
static char error[OPTIONS_ERROR_MAX];

static int parse(int argc, const char *const *argv)
{
    memset(&options, 0, sizeof options);
    memset(error, 0, sizeof error);
    return options_parse(&options, argc, argv, error);
}

static void test_every_option_is_understood(void **state)
{
    static const char *const argv[] = {
        "kingyo",        "--window", "800x600", "--poi",  "bot",   "--record", "a.kgr",
        "--shots",       "pics",     "--data=scores",     "--config", "c.conf",
        "--lang",        "en",       "--seed",  "0255",   "--fish", "50",
        "--mode",        "championship", "--grade", "4",  "--players", "3",
        "--demo",        "30",
    };
    (void)state;
    assert_int_equal(parse(COUNT(argv), argv), 0);
    assert_int_equal(options.width, 800);
    assert_int_equal(options.height, 600);
    assert_int_equal(options.poi, BOARD_POI_BOT);
    assert_string_equal(options.record, "a.kgr");
    assert_string_equal(options.shots, "pics");
    assert_string_equal(options.data, "scores");
    assert_string_equal(options.config, "c.conf");
    assert_int_equal(options.language, LANGUAGE_EN);
    assert_int_equal(options.seed, 255);
    assert_int_equal(options.has_seed, 1);
    assert_int_equal(options.fish_count, 50);
    assert_int_equal(options.modes, 1u << MODE_CHAMPIONSHIP);
    assert_int_equal(options.grade, 4);
    assert_int_equal(options.players, 3);
    assert_int_equal(options.demo, 1);
    assert_int_equal(options.demo_s, 30);
}

static void test_who_holds_the_poi_has_a_name(void **state)
{
    static const struct { const char *name; uint8_t poi; } kinds[] = {
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

static void test_controllers_and_lines_are_named_one_after_the_other(void **state)
{
    static const char *const argv[] = {
        "kingyo", "--usb", "057e:2009", "--usb=054c:09cc:A1:B2", "--line", "start=BTN_START",
        "--line=coin=pinctrl-bcm2711:17,low,up", "--line", "start=BTN_A",
    };
    (void)state;
    assert_int_equal(parse(COUNT(argv), argv), 0);
    assert_int_equal(options.usb_count, 2);
    assert_string_equal(options.usb[0], "057e:2009");
    assert_string_equal(options.usb[1], "054c:09cc:A1:B2");
    assert_int_equal(options.line_count, 3);
    assert_string_equal(options.line[1], "coin=pinctrl-bcm2711:17,low,up");
}

static void test_no_more_controllers_or_lines_than_there_is_room_for(void **state)
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

static void test_a_wrong_wire_is_told_with_what_is_wrong_about_it(void **state)
{
    static const char *const no_role[] = { "kingyo", "--line", "jump=BTN" };
    static const char *const clash[] = { "kingyo", "--line", "start=A", "--line", "left=A" };
    (void)state;
    assert_int_equal(parse(COUNT(no_role), no_role), -1);
    assert_non_null(strstr(error, "--line: 'jump=BTN': "));
    assert_int_equal(parse(COUNT(clash), clash), -1);
    assert_non_null(strstr(error, "start and left are both on A"));
}

static void test_demo_needs_no_seconds(void **state)
{
    static const char *const last[] = { "kingyo", "--demo" };
    static const char *const middle[] = { "kingyo", "--demo", "--lang", "ja" };
    (void)state;
    assert_int_equal(parse(COUNT(last), last), 0);
    assert_int_equal(options.demo_s, OPTIONS_DEMO_S);
    assert_int_equal(parse(COUNT(middle), middle), 0);
    assert_int_equal(options.demo_s, OPTIONS_DEMO_S);
    assert_int_equal(options.has_language, 1);
}

static const char *const wrong[][4] = {
    { "kingyo", "--fly", NULL },
    { "kingyo", "fish", NULL },
    { "kingyo", "-", NULL },
    { "kingyo", "", NULL },
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

static void test_a_wrong_option_is_one_line_that_names_it(void **state)
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
    assert_int_equal(options.fish_count, max);
    assert_int_equal(options.tank, preset);
    assert_int_equal(parse(COUNT(tank_first), tank_first), 0);
    memcpy(most, count, sizeof most);
    snprintf(count, sizeof count, "%u", max + 1u);
    assert_int_equal(parse(COUNT(fish_first), fish_first), -1);
    assert_non_null(strstr(error, most)); /* It says how many would be right. */
    assert_int_equal(parse(COUNT(tank_first), tank_first), -1);
}

static void test_as_many_fish_as_the_tank_holds_and_not_one_more(void **state)
{
    (void)state;
    check_most("festival", TANK_PRESET_FESTIVAL);
    check_most("thesis", TANK_PRESET_THESIS);
    check_most("official", TANK_PRESET_OFFICIAL);
}

static void test_the_stall_opens_the_festival_tank_and_no_unknown_one(void **state)
{
    static const char *const none[] = { "kingyo" };
    static const char *const unknown[] = { "kingyo", "--tank", "pond" };
    (void)state;
    assert_int_equal(parse(COUNT(none), none), 0);
    assert_int_equal(options.tank, TANK_PRESET_FESTIVAL);
    assert_int_equal(parse(COUNT(unknown), unknown), -1);
    assert_non_null(strstr(error, "festival, thesis or official"));
}

static void test_a_mode_is_one_of_three_or_asked_for(void **state)
{
    static const char *const modes[] = { "festival", "championship", "practice" };
    (void)state;
    for (uint32_t mode = 0; mode < MODE_COUNT; mode++) {
        const char *const argv[] = { "kingyo", "--mode", modes[mode] };
        assert_int_equal(parse(COUNT(argv), argv), 0);
        assert_int_equal(options.modes, 1u << mode);
    }
    const char *const argv[] = { "kingyo", "--mode=choose" };
    assert_int_equal(parse(COUNT(argv), argv), 0);
    assert_int_equal(options.modes, OPTIONS_MODES_ALL);
}

static void test_what_is_asked_reaches_the_stall(void **state)
{
    static const char *const none[] = { "kingyo" };
    static const char *const all[] = { "kingyo", "--mode", "practice", "--grade", "7", "--players",
                                       "4", "--tank", "thesis", "--fish", "50", "--lang", "en",
                                       "--coins", "3", "--tickets", "10" };
    struct core_config core = { .seed = 9, .round_s = 30, .best_today = { 4 } };
    (void)state;
    assert_int_equal(parse(COUNT(none), none), 0);
    options_stall(&options, OPTIONS_MODES_ALL, &core);
    assert_int_equal(core.modes, OPTIONS_MODES_ALL); /* Of the screen; the demo says otherwise. */
    assert_int_equal(core.grade, 0);
    assert_int_equal(core.credit_coins, 0);
    assert_int_equal(core.ticket_fish, 0);
    assert_int_equal(core.players, 0);
    assert_int_equal(options_players(&options), 1);
    assert_int_equal(core.preset, TANK_PRESET_FESTIVAL);
    assert_int_equal(parse(COUNT(all), all), 0);
    options_stall(&options, OPTIONS_MODES_ALL, &core);
    assert_int_equal(core.modes, 1u << MODE_PRACTICE);
    assert_int_equal(core.grade, 7);
    assert_int_equal(core.players, 4);
    assert_int_equal(options_players(&options), 4);
    assert_int_equal(core.preset, TANK_PRESET_THESIS);
    assert_int_equal(core.fish_count, 50);
    assert_int_equal(core.credit_coins, 3);
    assert_int_equal(core.ticket_fish, 10);
    assert_int_equal(core.language, LANGUAGE_EN);
    assert_int_equal(core.seed, 9);
    assert_int_equal(core.round_s, 30);
    assert_int_equal(core.best_today[0], 4);
}

static void test_recording_a_replay_is_refused(void **state)
{
    static const char *const argv[] = { "kingyo", "--record", "a", "--replay", "b" };
    (void)state;
    assert_int_equal(parse(COUNT(argv), argv), -1);
}

static void test_a_path_longer_than_any_is_refused(void **state)
{
    static char path[OPTIONS_PATH_MAX + 1];
    const char *const argv[] = { "kingyo", "--data", path };
    (void)state;
    memset(path, 'a', OPTIONS_PATH_MAX);
    assert_int_equal(parse(COUNT(argv), argv), -1);
    path[OPTIONS_PATH_MAX - 1] = '\0';
    assert_int_equal(parse(COUNT(argv), argv), 0);
}

/* ---- The file ------------------------------------------------------------------------------- */

static char warnings[8][512];
static char last_warning[512];
static int warning_count;

static void keep_warning(const char *line)
{
    snprintf(last_warning, sizeof last_warning, "%s", line);
    if (warning_count < 8) {
        snprintf(warnings[warning_count], sizeof warnings[0], "%s", line);
    }
    warning_count++;
}

static int read_text(const char *text)
{
    char path[] = "/tmp/kingyo-conf-XXXXXX";
    const int fd = mkstemp(path);
    assert_true(fd >= 0);
    assert_int_equal(write(fd, text, strlen(text)), strlen(text));
    close(fd);
    memset(&options, 0, sizeof options);
    warning_count = 0;
    const int result = options_read_config(&options, path, keep_warning);
    unlink(path);
    return result;
}

static void test_a_configuration_file_sets_the_same_things(void **state)
{
    (void)state;
    assert_int_equal(read_text("# the stall at the station\n\n lang = en   # for visitors\n"
                               "window=1920x1080\nfish = 400\n"
                               "mode = championship\ngrade = 4\nplayers = 2"),
                     0);
    assert_int_equal(warning_count, 0);
    assert_int_equal(options.language, LANGUAGE_EN);
    assert_int_equal(options.width, 1920);
    assert_int_equal(options.fish_count, 400);
    assert_int_equal(options.modes, 1u << MODE_CHAMPIONSHIP);
    assert_int_equal(options.grade, 4);
    assert_int_equal(options.players, 2);
}

static void test_a_file_that_is_none_is_not_told_line_by_line(void **state)
{
    (void)state;
    char text[OPTIONS_WARNINGS_MAX * 4u + 16u] = "";
    for (uint32_t i = 0; i < OPTIONS_WARNINGS_MAX + 3u; i++) {
        strcat(text, "no\n");
    }
    assert_int_equal(read_text(text), 0);
    assert_int_equal(warning_count, OPTIONS_WARNINGS_MAX + 1u);
    assert_non_null(strstr(last_warning, ": and 3 more"));
}

/* A stall opens although a wire of its file is wrong, and with those that are right. */
static void test_a_file_wires_lines_and_says_which_it_cannot(void **state)
{
    (void)state;
    assert_int_equal(read_text("usb = 057e:2009\nline = start=BTN_START\nline = jump=X\n"
                               "line = left=BTN_START\nline = coin=chip:4,low # the slot\n"),
                     0);
    assert_int_equal(options.usb_count, 1);
    assert_int_equal(options.line_count, 2);
    assert_string_equal(options.line[1], "coin=chip:4,low");
    assert_int_equal(warning_count, 2);
    assert_non_null(strstr(warnings[0], ":3: "));
    assert_null(strstr(warnings[0], "expected"));
    assert_non_null(strstr(warnings[1], ":4: start and left are both on BTN_START"));
}

static void test_a_number_is_decimal_whatever_it_begins_with(void **state)
{
    static const char *const argv[] = { "kingyo", "--seed", "010" };
    (void)state;
    assert_int_equal(parse(COUNT(argv), argv), 0);
    assert_int_equal(options.seed, 10);
}

static void test_a_path_may_hold_what_begins_a_comment(void **state)
{
    (void)state;
    assert_int_equal(read_text("data = /srv/stall#1 # the first\n#shots = pics\n"), 0);
    assert_int_equal(warning_count, 0);
    assert_string_equal(options.data, "/srv/stall#1");
    assert_string_equal(options.shots, "");
}

static void test_a_typing_mistake_is_told_with_its_line_and_the_rest_counts(void **state)
{
    (void)state;
    assert_int_equal(read_text("colour = red\nfish = many\nlang\nwindow = 1x1\nseed = 9\n"), 0);
    assert_int_equal(warning_count, 4);
    assert_non_null(strstr(warnings[0], ":1: unknown key"));
    assert_non_null(strstr(warnings[1], ":2: wrong value; expected 1 to 6"));
    assert_non_null(strstr(warnings[2], ":3: no '='"));
    assert_int_equal(options.fish_count, 0);
    assert_int_equal(options.width, 0);
    assert_int_equal(options.seed, 9);
}

static void test_a_file_names_the_tank_and_not_more_fish_than_it_holds(void **state)
{
    (void)state;
    assert_int_equal(read_text("fish = 1000\ntank = official\n"), 0);
    assert_int_equal(warning_count, 0);
    assert_int_equal(options.tank, TANK_PRESET_OFFICIAL);
    assert_int_equal(options.fish_count, 1000);
    assert_int_equal(read_text("fish = 1000\n"), 0);
    assert_int_equal(warning_count, 1);
    assert_non_null(strstr(warnings[0], "1000 is too many; the festival tank holds 1 to "));
    assert_int_equal(options.fish_count, 0); /* The stall opens with its own. */
}

static void test_a_file_may_not_start_a_demonstration(void **state)
{
    (void)state;
    assert_int_equal(read_text("demo = 20\nhelp =\nconfig = other\nreplay = x\n"), 0);
    assert_int_equal(warning_count, 4);
    assert_int_equal(options.demo, 0);
}

static void test_a_file_that_cannot_be_read_is_an_error(void **state)
{
    (void)state;
    assert_int_equal(options_read_config(&options, "/nowhere/at/all", NULL), -ENOENT);
    assert_int_equal(options_read_config(&options, "/tmp", NULL), -EISDIR);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_every_option_is_understood),
        cmocka_unit_test(test_who_holds_the_poi_has_a_name),
        cmocka_unit_test(test_controllers_and_lines_are_named_one_after_the_other),
        cmocka_unit_test(test_no_more_controllers_or_lines_than_there_is_room_for),
        cmocka_unit_test(test_a_wrong_wire_is_told_with_what_is_wrong_about_it),
        cmocka_unit_test(test_a_file_wires_lines_and_says_which_it_cannot),
        cmocka_unit_test(test_demo_needs_no_seconds),
        cmocka_unit_test(test_a_wrong_option_is_one_line_that_names_it),
        cmocka_unit_test(test_as_many_fish_as_the_tank_holds_and_not_one_more),
        cmocka_unit_test(test_the_stall_opens_the_festival_tank_and_no_unknown_one),
        cmocka_unit_test(test_a_mode_is_one_of_three_or_asked_for),
        cmocka_unit_test(test_what_is_asked_reaches_the_stall),
        cmocka_unit_test(test_recording_a_replay_is_refused),
        cmocka_unit_test(test_a_path_longer_than_any_is_refused),
        cmocka_unit_test(test_a_configuration_file_sets_the_same_things),
        cmocka_unit_test(test_a_number_is_decimal_whatever_it_begins_with),
        cmocka_unit_test(test_a_path_may_hold_what_begins_a_comment),
        cmocka_unit_test(test_a_typing_mistake_is_told_with_its_line_and_the_rest_counts),
        cmocka_unit_test(test_a_file_names_the_tank_and_not_more_fish_than_it_holds),
        cmocka_unit_test(test_a_file_may_not_start_a_demonstration),
        cmocka_unit_test(test_a_file_that_is_none_is_not_told_line_by_line),
        cmocka_unit_test(test_a_file_that_cannot_be_read_is_an_error),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
