/* test_config_file.c -- Tests the reader of kingyo.conf: valid lines are used, and invalid lines
 * are reported and skipped. */
#include <errno.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cmocka.h>

#include "core/base/rng.h"
#include "core/scene.h"
#include "core/tank/preset.h"
#include "platform/config/config_file.h"
#include "platform/setting_text.h"

static struct options options;

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

static int read_bytes(const char *text, size_t size)
{
    char path[] = "/tmp/kingyo-conf-XXXXXX";
    const int fd = mkstemp(path);
    assert_true(fd >= 0);
    assert_int_equal(write(fd, text, size), size);
    close(fd);
    memset(&options, 0, sizeof options);
    warning_count = 0;
    const int result = config_file_read(&options, path, keep_warning);
    unlink(path);
    return result;
}

static int read_text(const char *text)
{
    return read_bytes(text, strlen(text));
}

static int32_t asked(uint32_t id)
{
    assert_int_equal(options.file.is_set[id], 1);
    assert_int_equal(options.words.is_set[id], 0);
    return options.file.value[id];
}

static void test_control_characters_of_a_file_are_removed_from_warnings(void **state)
{
    (void)state;
    read_text("[money]\nplay = pa\x1b[2Jid\rx\x7f\n\x01key = 1\n");
    assert_int_equal(warning_count, 2);
    for (int i = 0; i < warning_count; i++) {
        for (const char *c = warnings[i]; *c; c++) {
            assert_true((unsigned char)*c >= 0x20 && *c != 0x7F);
        }
    }
    assert_non_null(strstr(warnings[0], "pa?[2Jid?x?"));
}

static void test_each_section_accepts_its_own_keys(void **state)
{
    (void)state;
    assert_int_equal(read_text("# the stall at the station\n\n[money]\nplay = paid\nprice=2\n"
                               "coin-3 = 5   # 500 yen\n\n [game]\nmodes = festival, lab\n"
                               "grade = own\ntank = official\n[sound]\nvolume = 35\n"
                               "[picture]\nrotation = 270\nnight-from = 23:00\nnight-to=8:30\n"
                               "window = 800x600\n[operator]\npin = 0042\n[devices]\n"
                               "poi = usb\nusb = 057e:2009\nline = coin=COIN\n[files]\n"
                               "data = /srv/stall\n"),
                     0);
    assert_int_equal(warning_count, 0);
    assert_int_equal(asked(SET_PLAY), PLAY_PAID);
    assert_int_equal(asked(SET_PRICE), 2);
    assert_int_equal(asked(SET_COIN_3), 5);
    assert_int_equal(asked(SET_MODES), 1 << MODE_FESTIVAL | 1 << CHOICE_LAB);
    assert_int_equal(asked(SET_GRADE), 0);
    assert_int_equal(options.tank, TANK_PRESET_OFFICIAL);
    assert_int_equal(asked(SET_VOLUME), 35);
    assert_int_equal(asked(SET_ROTATION), 3);
    assert_int_equal(asked(SET_NIGHT_FROM_MIN), 23 * 60);
    assert_int_equal(asked(SET_NIGHT_TO_MIN), 8 * 60 + 30);
    assert_int_equal(options.width, 800);
    assert_int_equal(asked(SET_PIN), 42);
    assert_int_equal(options.usb_count, 1);
    assert_int_equal(options.line_count, 1);
    assert_string_equal(options.data, "/srv/stall");
    assert_int_equal(options.is_file, 0);
}

/* In configuration files of older versions, the settings `dip` and `reach` are in the section
 * [devices]. */
static void test_dip_and_reach_are_read_from_both_of_their_sections(void **state)
{
    (void)state;
    static const char *const sections[] = { "[devices]", "[game]" };
    for (size_t i = 0; i < sizeof sections / sizeof *sections; i++) {
        char text[80];
        snprintf(text, sizeof text, "%s\ndip = click\nreach = 63\n", sections[i]);
        assert_int_equal(read_text(text), 0);
        assert_int_equal(warning_count, 0);
        assert_int_equal(asked(SET_DIP), 1);
        assert_int_equal(asked(SET_REACH), 63);
    }
    read_text("[devices]\nside = left\n");
    assert_int_equal(warning_count, 1);
    assert_int_equal(options.file.is_set[SET_SIDE], 0);
}

static void test_a_file_without_sections_is_read(void **state)
{
    (void)state;
    assert_int_equal(read_text(" lang = en   # for visitors\nwindow=1920x1080\nfish = 400\n"
                               "mode = championship\ngrade = 4\nplayers = 2\ncoins = 3\n"
                               "tickets = 10\nvolume = 50"),
                     0);
    assert_int_equal(warning_count, 0);
    assert_int_equal(asked(SET_LANGUAGE), LANGUAGE_EN);
    assert_int_equal(options.width, 1920);
    assert_int_equal(asked(SET_FISH), 400);
    assert_int_equal(asked(SET_MODES), 1 << MODE_CHAMPIONSHIP);
    assert_int_equal(asked(SET_GRADE), 4);
    assert_int_equal(asked(SET_PLAYERS), 2);
    assert_int_equal(asked(SET_PLAY), PLAY_PAID);
    assert_int_equal(asked(SET_PRICE), 3);
    assert_int_equal(asked(SET_TICKET_FISH), 10);
    assert_int_equal(asked(SET_VOLUME), 50);
}

static void test_a_key_in_the_wrong_section_is_reported(void **state)
{
    (void)state;
    assert_int_equal(read_text("[sound]\nprice = 2\nusb = 057e:2009\nlang = en\nvolume = 5\n"), 0);
    assert_int_equal(warning_count, 3);
    assert_non_null(strstr(warnings[0], ":2: 'price' belongs to [money]"));
    assert_non_null(strstr(warnings[1], ":3: 'usb' belongs to [devices]"));
    assert_non_null(strstr(warnings[2], ":4: 'lang' is an option of the command line"));
    assert_int_equal(asked(SET_VOLUME), 5);
    assert_int_equal(options.file.is_set[SET_PRICE], 0);
    assert_int_equal(options.usb_count, 0);
}

static void test_an_unknown_section_is_reported_once_and_skipped(void **state)
{
    (void)state;
    assert_int_equal(read_text("[mony]\nprice = 2\nnonsense\n[game\nfish = 5\n[ sound ]\n"
                               "volume = 5\n[]\nvolume = 10\n"),
                     0);
    assert_int_equal(warning_count, 3);
    assert_non_null(strstr(warnings[0], ":1: unknown section [mony]; expected money, game, "));
    assert_non_null(strstr(warnings[1], ":4: a section line must be [NAME]"));
    assert_non_null(strstr(warnings[2], ":8: unknown section []"));
    assert_int_equal(options.file.is_set[SET_PRICE], 0);
    assert_int_equal(options.file.is_set[SET_FISH], 0);
    assert_int_equal(asked(SET_VOLUME), 5);
}

static void test_every_out_of_range_value_is_reported_with_its_range(void **state)
{
    char text[256], range[SETTING_RANGE_MAX];
    (void)state;
    for (uint32_t id = 0; id < SETTING_COUNT; id++) {
        const struct setting *setting = settings_entry(id);
        const char *section = setting_section(setting->group);
        if (section) {
            snprintf(text, sizeof text, "[%s]\n%s = 99999\n", section, setting->name);
            assert_int_equal(read_text(text), 0);
            assert_int_equal(warning_count, 1);
            setting_range(id, range);
            assert_non_null(strstr(warnings[0], ":2: "));
            assert_non_null(strstr(warnings[0], setting->name));
            assert_non_null(strstr(warnings[0], range));
            assert_int_equal(options.file.is_set[id], 0);
        }
    }
}

static void test_the_calibration_cannot_be_set_in_the_file(void **state)
{
    (void)state;
    assert_int_equal(read_text("seat1-xx = 5\n"), 0);
    assert_int_equal(warning_count, 1);
    assert_non_null(strstr(warnings[0], "unknown key"));
}

static void test_a_byte_order_mark_and_crlf_are_accepted(void **state)
{
    (void)state;
    assert_int_equal(read_text("\xEF\xBB\xBF[money]\r\nprice = 4\r\n"), 0);
    assert_int_equal(warning_count, 0);
    assert_int_equal(asked(SET_PRICE), 4);
}

/* A pipe without a writer would block a normal open() forever. */
static void test_a_path_that_is_not_a_regular_file_is_rejected_without_blocking(void **state)
{
    (void)state;
    char folder[] = "/tmp/kingyo-conf-XXXXXX", pipe_path[64];
    assert_non_null(mkdtemp(folder));
    snprintf(pipe_path, sizeof pipe_path, "%s/pipe", folder);
    assert_int_equal(mkfifo(pipe_path, 0600), 0);
    alarm(10);
    assert_int_equal(config_file_read(&options, pipe_path, keep_warning), -ENOTSUP);
    alarm(0);
    assert_int_equal(config_file_read(&options, folder, keep_warning), -EISDIR);
    unlink(pipe_path);
    rmdir(folder);
}

static void test_a_too_long_line_gives_one_warning(void **state)
{
    static char text[3u * CONFIG_LINE_MAX];
    (void)state;
    memset(text, 'x', sizeof text - 1u);
    memcpy(text, "price = ", 8);
    strcpy(text + sizeof text - 16u, "\nprice = 2\n");
    assert_int_equal(read_text(text), 0);
    assert_int_equal(warning_count, 1);
    assert_non_null(strstr(warnings[0], ":1: the line is too long"));
    assert_int_equal(asked(SET_PRICE), 2);
}

/* Whatever bytes the file contains, each setting that is read must be in its range. */
static void test_random_bytes_never_set_an_invalid_value(void **state)
{
    static const char bits[] = "[money]game=pricevolume,fish:0123456789\n\n  #=\0\xff";
    char text[400];
    (void)state;
    for (uint32_t run = 0; run < 2000; run++) {
        for (uint32_t i = 0; i < sizeof text; i++) {
            const struct rng_key key = { .seed = 7, .tick = run, .who = i };
            text[i] = bits[rng_u32(key) % (sizeof bits - 1u)];
        }
        assert_int_equal(read_bytes(text, sizeof text), 0);
        for (uint32_t id = 0; id < SETTING_COUNT; id++) {
            assert_true(!options.file.is_set[id] || settings_allows(id, options.file.value[id]));
        }
    }
}

/* Reads the example file of `kingyoctl config defaults` twice: unchanged, and without the '#'
 * before each key. In both cases there must be no warning, and every setting must have its
 * default. */
static void test_the_example_file_contains_the_defaults(void **state)
{
    static char text[32768], open[32768];
    FILE *file = fmemopen(text, sizeof text, "w");
    (void)state;
    config_file_print_defaults(file);
    fclose(file);
    assert_int_equal(read_text(text), 0);
    assert_int_equal(warning_count, 0);
    for (uint32_t id = 0; id < SETTING_COUNT; id++) {
        assert_int_equal(options.file.is_set[id], 0);
    }
    for (char *line = strtok(text, "\n"); line; line = strtok(NULL, "\n")) {
        const int is_option = line[strlen(line) - 1] == '=';
        const int is_key = line[0] == '#' && line[1] != ' ' && line[1] != '\0' && !is_option;
        strcat(open, line + is_key);
        strcat(open, "\n");
    }
    assert_int_equal(read_text(open), 0);
    assert_int_equal(warning_count, 0);
    for (uint32_t id = 0; id < SETTING_COUNT; id++) {
        if (setting_section(settings_entry(id)->group)) {
            assert_int_equal(asked(id), settings_entry(id)->standard);
        }
    }
}

static void test_a_file_with_many_invalid_lines_reports_the_count_of_the_rest(void **state)
{
    (void)state;
    char text[CONFIG_WARNINGS_MAX * 4u + 16u] = "";
    for (uint32_t i = 0; i < CONFIG_WARNINGS_MAX + 3u; i++) {
        strcat(text, "no\n");
    }
    assert_int_equal(read_text(text), 0);
    assert_int_equal(warning_count, CONFIG_WARNINGS_MAX + 1u);
    assert_non_null(strstr(last_warning, ": 3 more invalid lines"));
}

/* Two of the GPIO lines are invalid. The valid lines must be used. */
static void test_valid_gpio_lines_are_used_and_invalid_ones_reported(void **state)
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
    assert_non_null(strstr(warnings[0], "'jump' is not a role; expected"));
    assert_non_null(strstr(warnings[1], ":4: start and left are both on BTN_START"));
}

static void test_a_path_may_contain_comment_characters(void **state)
{
    (void)state;
    assert_int_equal(read_text("data = /srv/stall#1 # the first\n#shots = pics\n"), 0);
    assert_int_equal(warning_count, 0);
    assert_string_equal(options.data, "/srv/stall#1");
    assert_string_equal(options.shots, "");
}

static void test_a_typing_error_is_reported_with_its_line_and_the_rest_is_read(void **state)
{
    (void)state;
    assert_int_equal(read_text("colour = red\nfish = many\nlang\nwindow = 1x1\nseed = 9\n"), 0);
    assert_int_equal(warning_count, 4);
    assert_non_null(strstr(warnings[0], ":1: unknown key 'colour'"));
    assert_non_null(strstr(warnings[1], ":2: fish: wrong value 'many'; expected 0 to 2048"));
    assert_non_null(strstr(warnings[2], ":3: no '='"));
    assert_non_null(strstr(warnings[3], ":4: window: wrong value '1x1'; expected WIDTHxHEIGHT"));
    assert_int_equal(options.file.is_set[SET_FISH], 0);
    assert_int_equal(options.width, 0);
    assert_int_equal(options.seed, 9);
}

static void test_the_fish_count_of_a_file_is_limited_by_its_tank(void **state)
{
    (void)state;
    assert_int_equal(read_text("fish = 1000\ntank = official\n"), 0);
    assert_int_equal(warning_count, 0);
    assert_int_equal(options.tank, TANK_PRESET_OFFICIAL);
    assert_int_equal(asked(SET_FISH), 1000);
    assert_int_equal(read_text("fish = 1000\n"), 0);
    assert_int_equal(warning_count, 1);
    assert_non_null(strstr(warnings[0], ":1: fish: 1000 is too many; the festival tank holds 1 "));
    /* The line has an invalid value, so the setting must not count as set. */
    assert_int_equal(options.file.is_set[SET_FISH], 0);
}

static void test_a_file_cannot_start_the_demo(void **state)
{
    (void)state;
    assert_int_equal(read_text("demo = 20\nhelp =\nconfig = other\nreplay = x\n"), 0);
    assert_int_equal(warning_count, 4);
    assert_int_equal(options.demo, 0);
}

static void test_a_file_that_cannot_be_read_is_an_error(void **state)
{
    (void)state;
    assert_int_equal(config_file_read(&options, "/nowhere/at/all", NULL), -ENOENT);
    assert_int_equal(config_file_read(&options, "/tmp", NULL), -EISDIR);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_control_characters_of_a_file_are_removed_from_warnings),
        cmocka_unit_test(test_each_section_accepts_its_own_keys),
        cmocka_unit_test(test_dip_and_reach_are_read_from_both_of_their_sections),
        cmocka_unit_test(test_a_file_without_sections_is_read),
        cmocka_unit_test(test_a_key_in_the_wrong_section_is_reported),
        cmocka_unit_test(test_an_unknown_section_is_reported_once_and_skipped),
        cmocka_unit_test(test_every_out_of_range_value_is_reported_with_its_range),
        cmocka_unit_test(test_the_calibration_cannot_be_set_in_the_file),
        cmocka_unit_test(test_a_byte_order_mark_and_crlf_are_accepted),
        cmocka_unit_test(test_a_path_that_is_not_a_regular_file_is_rejected_without_blocking),
        cmocka_unit_test(test_a_too_long_line_gives_one_warning),
        cmocka_unit_test(test_random_bytes_never_set_an_invalid_value),
        cmocka_unit_test(test_the_example_file_contains_the_defaults),
        cmocka_unit_test(test_a_file_with_many_invalid_lines_reports_the_count_of_the_rest),
        cmocka_unit_test(test_valid_gpio_lines_are_used_and_invalid_ones_reported),
        cmocka_unit_test(test_a_path_may_contain_comment_characters),
        cmocka_unit_test(test_a_typing_error_is_reported_with_its_line_and_the_rest_is_read),
        cmocka_unit_test(test_the_fish_count_of_a_file_is_limited_by_its_tank),
        cmocka_unit_test(test_a_file_cannot_start_the_demo),
        cmocka_unit_test(test_a_file_that_cannot_be_read_is_an_error),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
