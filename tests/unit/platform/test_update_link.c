/* test_update_link.c -- checks the requests of the kiosk to the update service and its reports, in
 * temporary folders. */
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

#include "platform/os/clock.h"
#include "platform/update_link.h"

static char folder[64], status[80];
static struct update_link link_;
static uint64_t now_ns;

static void report(const char *line)
{
    FILE *file = fopen(status, "w");
    assert_non_null(file);
    fprintf(file, "%s\n", line);
    fclose(file);
}

static bool exists(const char *name)
{
    char path[128];
    struct stat about;
    snprintf(path, sizeof path, "%s/%s", folder, name);
    return lstat(path, &about) == 0;
}

static int set_up(void **state)
{
    (void)state;
    strcpy(folder, "/tmp/kingyo-update-XXXXXX");
    if (!mkdtemp(folder)) {
        return -1;
    }
    snprintf(status, sizeof status, "%s/status", folder);
    report("closed 0");
    now_ns = NS_PER_S;
    update_link_begin(&link_, folder, status);
    return 0;
}

static int tear_down(void **state)
{
    char command[128];
    (void)state;
    update_link_end(&link_);
    snprintf(command, sizeof command, "rm -r %s", folder);
    return system(command);
}

/* Runs a frame half a second later, so that the status is read. */
static void frame(bool is_page_open)
{
    now_ns += NS_PER_S / 2u;
    update_link_step(&link_, is_page_open, now_ns);
}

static void test_each_line_of_the_service_is_parsed(void **state)
{
    (void)state;
    static const struct {
        const char *line;
        uint8_t step, percent, fault;
        const char *name;
    } rows[] = {
        { "no-stick 0 ", UPDATE_STEP_NO_STICK, 0, UPDATE_FAULT_NONE, "" },
        { "no-stick 0 fell-back", UPDATE_STEP_NO_STICK, 0, UPDATE_FAULT_FELL_BACK, "" },
        { "found 0 Kingyo 0.2 (2026-12-01)", UPDATE_STEP_FOUND, 0, 0, "Kingyo 0.2 (2026-12-01)" },
        { "checking 7 Kingyo", UPDATE_STEP_CHECKING, 7, 0, "Kingyo" },
        { "writing 100 Kingyo", UPDATE_STEP_WRITING, 100, 0, "Kingyo" },
        { "done 100 Kingyo", UPDATE_STEP_DONE, 100, 0, "Kingyo" },
        { "failed 0 no-filesystem", UPDATE_STEP_FAILED, 0, UPDATE_FAULT_NO_FILESYSTEM, "" },
        { "failed 0 no-folder", UPDATE_STEP_FAILED, 0, UPDATE_FAULT_NO_FOLDER, "" },
        { "failed 0 unsigned", UPDATE_STEP_FAILED, 0, UPDATE_FAULT_UNSIGNED, "" },
        { "failed 0 wrong-key", UPDATE_STEP_FAILED, 0, UPDATE_FAULT_WRONG_KEY, "" },
        { "failed 0 wrong-board", UPDATE_STEP_FAILED, 0, UPDATE_FAULT_WRONG_BOARD, "" },
        { "failed 0 older", UPDATE_STEP_FAILED, 0, UPDATE_FAULT_OLDER, "" },
        { "failed 0 same-version", UPDATE_STEP_FAILED, 0, UPDATE_FAULT_SAME_VERSION, "" },
        { "failed 0 too-large", UPDATE_STEP_FAILED, 0, UPDATE_FAULT_TOO_LARGE, "" },
        { "failed 0 damaged", UPDATE_STEP_FAILED, 0, UPDATE_FAULT_DAMAGED, "" },
        { "failed 0 pulled", UPDATE_STEP_FAILED, 0, UPDATE_FAULT_PULLED, "" },
        { "failed 0 canceled", UPDATE_STEP_FAILED, 0, UPDATE_FAULT_CANCELED, "" },
        { "failed 0 card", UPDATE_STEP_FAILED, 0, UPDATE_FAULT_CARD, "" },
        { "failed 0 on-trial", UPDATE_STEP_FAILED, 0, UPDATE_FAULT_ON_TRIAL, "" },
        { "failed 0 what is this", UPDATE_STEP_FAILED, 0, UPDATE_FAULT_DAMAGED, "" },
        { "closed 0", UPDATE_STEP_WAIT, 0, 0, "" },
        { "found 101 Kingyo", UPDATE_STEP_WAIT, 0, 0, "" },
        { "found -1 Kingyo", UPDATE_STEP_WAIT, 0, 0, "" },
        { "found", UPDATE_STEP_WAIT, 0, 0, "" },
        { "", UPDATE_STEP_WAIT, 0, 0, "" },
        { "unknown 0 Kingyo", UPDATE_STEP_WAIT, 0, 0, "" },
    };
    for (size_t i = 0; i < sizeof rows / sizeof rows[0]; i++) {
        struct scene_update out;
        memset(&out, 0xff, sizeof out);
        update_link_parse(rows[i].line, &out);
        assert_int_equal(out.step, rows[i].step);
        assert_int_equal(out.percent, rows[i].percent);
        assert_int_equal(out.fault, rows[i].fault);
        assert_string_equal(out.name, rows[i].name);
    }
}

static void test_the_longest_name_is_cut_and_terminated(void **state)
{
    (void)state;
    char line[256] = "found 0 ";
    struct scene_update out;
    memset(line + 8, 'W', sizeof line - 9u);
    update_link_parse(line, &out);
    assert_int_equal(strlen(out.name), SCENE_UPDATE_NAME_SIZE - 1u);
}

static void test_the_page_is_requested_while_it_is_open(void **state)
{
    (void)state;
    assert_int_equal(update_link_state(&link_), UPDATE_IDLE);
    frame(false);
    assert_false(exists(UPDATE_LINK_OPEN));
    frame(true);
    assert_true(exists(UPDATE_LINK_OPEN));
    report("found 0 Kingyo 9");
    frame(true);
    assert_int_equal(update_link_state(&link_), UPDATE_READY);
    assert_string_equal(link_.newest.name, "Kingyo 9");
    frame(false);
    assert_false(exists(UPDATE_LINK_OPEN));
    assert_int_equal(update_link_state(&link_), UPDATE_IDLE);
    assert_int_equal(link_.newest.step, UPDATE_STEP_WAIT);
}

static void test_an_update_is_requested_once_and_only_if_it_was_found(void **state)
{
    (void)state;
    report("no-stick 0 ");
    frame(true);
    update_link_start(&link_);
    assert_false(exists(UPDATE_LINK_START));
    report("found 0 Kingyo 9");
    frame(true);
    update_link_start(&link_);
    assert_true(exists(UPDATE_LINK_START));
    assert_int_equal(update_link_state(&link_), UPDATE_IDLE);
    report("writing 40 Kingyo 9");
    frame(true);
    assert_int_equal(update_link_state(&link_), UPDATE_BUSY);
    assert_true(exists(UPDATE_LINK_START));
    report("failed 0 damaged");
    frame(true);
    assert_false(exists(UPDATE_LINK_START));
    report("found 0 Kingyo 9");
    frame(true);
    assert_int_equal(update_link_state(&link_), UPDATE_READY);
    assert_false(exists(UPDATE_LINK_START));
}

static void test_the_status_is_read_four_times_a_second(void **state)
{
    (void)state;
    frame(true);
    report("no-stick 0 ");
    update_link_step(&link_, true, now_ns + NS_PER_S / 4u - 1u);
    assert_int_equal(link_.newest.step, UPDATE_STEP_WAIT);
    update_link_step(&link_, true, now_ns + NS_PER_S / 4u);
    assert_int_equal(link_.newest.step, UPDATE_STEP_NO_STICK);
}

static void test_requests_of_an_earlier_run_are_removed(void **state)
{
    (void)state;
    report("found 0 Kingyo 9");
    frame(true);
    update_link_start(&link_);
    struct update_link next;
    update_link_begin(&next, folder, status);
    assert_false(exists(UPDATE_LINK_OPEN));
    assert_false(exists(UPDATE_LINK_START));
    assert_int_equal(update_link_state(&next), UPDATE_IDLE);
    update_link_end(&next);
}

static void test_a_machine_without_service_or_folder_has_no_updates(void **state)
{
    (void)state;
    struct update_link none;
    update_link_begin(&none, folder, "/nonexistent/status");
    assert_int_equal(update_link_state(&none), UPDATE_NONE);
    update_link_step(&none, true, now_ns);
    update_link_start(&none);
    assert_false(exists(UPDATE_LINK_OPEN));
    update_link_end(&none);
    update_link_begin(&none, NULL, status);
    assert_int_equal(update_link_state(&none), UPDATE_NONE);
    update_link_begin(&none, "/nonexistent", status);
    assert_int_equal(update_link_state(&none), UPDATE_NONE);
}

static void test_a_status_that_disappears_or_is_no_file_blocks_nothing(void **state)
{
    (void)state;
    report("found 0 Kingyo 9");
    frame(true);
    assert_int_equal(unlink(status), 0);
    frame(true);
    assert_int_equal(link_.newest.step, UPDATE_STEP_WAIT);
    assert_int_equal(mkfifo(status, 0600), 0);
    frame(true);
    assert_int_equal(link_.newest.step, UPDATE_STEP_WAIT);
}

#define LINKED(test) cmocka_unit_test_setup_teardown(test, set_up, tear_down)

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_each_line_of_the_service_is_parsed),
        cmocka_unit_test(test_the_longest_name_is_cut_and_terminated),
        LINKED(test_the_page_is_requested_while_it_is_open),
        LINKED(test_an_update_is_requested_once_and_only_if_it_was_found),
        LINKED(test_the_status_is_read_four_times_a_second),
        LINKED(test_requests_of_an_earlier_run_are_removed),
        LINKED(test_a_machine_without_service_or_folder_has_no_updates),
        LINKED(test_a_status_that_disappears_or_is_no_file_blocks_nothing),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
