/* test_screen.c -- the card with the monitor, whatever its number. */
#include <SDL.h>
#include <ftw.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

#include <cmocka.h>

#include "platform/os/file.h"
#include "platform/render/screen.h"

static char root[] = "/tmp/kingyo-drm-XXXXXX";

static int set_up(void **state)
{
    (void)state;
    strcpy(root + sizeof root - 7, "XXXXXX");
    return mkdtemp(root) ? 0 : -1;
}

static int remove_one(const char *path, const struct stat *about, int kind, struct FTW *walk)
{
    (void)about;
    (void)kind;
    (void)walk;
    return remove(path);
}

static int tear_down(void **state)
{
    (void)state;
    return nftw(root, remove_one, 8, FTW_DEPTH | FTW_PHYS);
}

/* A folder of /sys/class/drm; with a status unless it is null. */
static void put(const char *name, const char *status)
{
    char path[256];
    snprintf(path, sizeof path, "%s/sys/class/drm/%s", root, name);
    assert_int_equal(file_make_folder(path), 0);
    if (status) {
        strcat(path, "/status");
        FILE *file = fopen(path, "w");
        assert_non_null(file);
        fprintf(file, "%s\n", status);
        fclose(file);
    }
}

/* As a Raspberry Pi 4 has them: one that computes, one with two sockets. */
static void put_raspberry(const char *compute, const char *first, const char *first_status,
                          const char *second, const char *second_status)
{
    put("version", NULL);
    put(compute, NULL);
    put("renderD128", NULL);
    put(first, first_status);
    put(second, second_status);
}

static void test_the_card_with_the_monitor_is_taken_whatever_its_number(void **state)
{
    (void)state;
    put_raspberry("card0", "card1-HDMI-A-1", "disconnected", "card1-HDMI-A-2", "connected");
    assert_int_equal(screen_card_find(root), 1);
}

static void test_and_after_a_start_that_numbered_them_the_other_way(void **state)
{
    (void)state;
    put_raspberry("card1", "card0-HDMI-A-1", "connected", "card0-HDMI-A-2", "disconnected");
    assert_int_equal(screen_card_find(root), 0);
}

static void test_a_monitor_that_is_off_leaves_the_card_with_sockets(void **state)
{
    (void)state;
    put_raspberry("card0", "card1-HDMI-A-1", "disconnected", "card1-HDMI-A-2", "unknown");
    assert_int_equal(screen_card_find(root), 1);
}

static void test_of_two_with_sockets_the_connected_one_is_taken(void **state)
{
    (void)state;
    put("card0-VGA-1", "disconnected");
    put("card12-DP-1", "connected");
    assert_int_equal(screen_card_find(root), 12);
}

static void test_of_two_monitors_the_first_cards_is_taken(void **state)
{
    (void)state;
    put("card2-DP-1", "connected");
    put("card1-DP-1", "connected");
    assert_int_equal(screen_card_find(root), 1);
}

static void test_what_leads_into_memory_is_no_monitor(void **state)
{
    (void)state;
    put("card0-Writeback-1", "connected");
    put("card1-HDMI-A-1", "disconnected");
    assert_int_equal(screen_card_find(root), 1);
}

static void test_without_sockets_there_is_none(void **state)
{
    (void)state;
    assert_int_equal(screen_card_find(root), -1);
    put("card0", NULL);
    put("card0-HDMI-A-1", NULL); /* Its status cannot be read. */
    put("card-HDMI-A-1", "connected");
    put("card64-HDMI-A-1", "connected");
    put("renderD128", "connected");
    assert_int_equal(screen_card_find(root), -1);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(test_the_card_with_the_monitor_is_taken_whatever_its_number,
                                        set_up, tear_down),
        cmocka_unit_test_setup_teardown(test_and_after_a_start_that_numbered_them_the_other_way,
                                        set_up, tear_down),
        cmocka_unit_test_setup_teardown(test_a_monitor_that_is_off_leaves_the_card_with_sockets,
                                        set_up, tear_down),
        cmocka_unit_test_setup_teardown(test_of_two_with_sockets_the_connected_one_is_taken, set_up,
                                        tear_down),
        cmocka_unit_test_setup_teardown(test_of_two_monitors_the_first_cards_is_taken, set_up,
                                        tear_down),
        cmocka_unit_test_setup_teardown(test_what_leads_into_memory_is_no_monitor, set_up,
                                        tear_down),
        cmocka_unit_test_setup_teardown(test_without_sockets_there_is_none, set_up, tear_down),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
