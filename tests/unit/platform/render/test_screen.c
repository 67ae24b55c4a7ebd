/* test_screen.c -- Tests how the graphics card that has a monitor is selected. The numbers of the
 * cards differ from machine to machine. */
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

/* Creates an entry of a simulated /sys/class/drm. If `status` is not NULL, the entry gets a file
 * with this connection status. */
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

/* Creates the two cards of a Raspberry Pi 4: one for computation, which has no connectors, and one
 * with two connectors. */
static void put_raspberry(const char *compute, const char *first, const char *first_status,
                          const char *second, const char *second_status)
{
    put("version", NULL);
    put(compute, NULL);
    put("renderD128", NULL);
    put(first, first_status);
    put(second, second_status);
}

static void test_the_graphics_card_with_the_monitor_is_selected(void **state)
{
    (void)state;
    put_raspberry("card0", "card1-HDMI-A-1", "disconnected", "card1-HDMI-A-2", "connected");
    assert_int_equal(screen_card_find(root), 1);
}

static void test_the_card_with_the_monitor_is_selected_at_either_number(void **state)
{
    (void)state;
    put_raspberry("card1", "card0-HDMI-A-1", "connected", "card0-HDMI-A-2", "disconnected");
    assert_int_equal(screen_card_find(root), 0);
}

static void test_without_a_monitor_the_card_with_connectors_is_selected(void **state)
{
    (void)state;
    put_raspberry("card0", "card1-HDMI-A-1", "disconnected", "card1-HDMI-A-2", "unknown");
    assert_int_equal(screen_card_find(root), 1);
}

static void test_the_connected_card_of_two_is_selected(void **state)
{
    (void)state;
    put("card0-VGA-1", "disconnected");
    put("card12-DP-1", "connected");
    assert_int_equal(screen_card_find(root), 12);
}

static void test_the_first_card_with_a_monitor_is_selected(void **state)
{
    (void)state;
    put("card2-DP-1", "connected");
    put("card1-DP-1", "connected");
    assert_int_equal(screen_card_find(root), 1);
}

static void test_a_writeback_connector_is_not_a_monitor(void **state)
{
    (void)state;
    put("card0-Writeback-1", "connected");
    put("card1-HDMI-A-1", "disconnected");
    assert_int_equal(screen_card_find(root), 1);
}

static void test_without_connectors_no_card_is_selected(void **state)
{
    (void)state;
    assert_int_equal(screen_card_find(root), -1);
    put("card0", NULL);
    put("card0-HDMI-A-1", NULL); /* This connector has no file with its status. */
    put("card-HDMI-A-1", "connected");
    put("card64-HDMI-A-1", "connected");
    put("renderD128", "connected");
    assert_int_equal(screen_card_find(root), -1);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(test_the_graphics_card_with_the_monitor_is_selected, set_up,
                                        tear_down),
        cmocka_unit_test_setup_teardown(test_the_card_with_the_monitor_is_selected_at_either_number,
                                        set_up, tear_down),
        cmocka_unit_test_setup_teardown(test_without_a_monitor_the_card_with_connectors_is_selected,
                                        set_up, tear_down),
        cmocka_unit_test_setup_teardown(test_the_connected_card_of_two_is_selected, set_up,
                                        tear_down),
        cmocka_unit_test_setup_teardown(test_the_first_card_with_a_monitor_is_selected, set_up,
                                        tear_down),
        cmocka_unit_test_setup_teardown(test_a_writeback_connector_is_not_a_monitor, set_up,
                                        tear_down),
        cmocka_unit_test_setup_teardown(test_without_connectors_no_card_is_selected, set_up,
                                        tear_down),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
