/* test_gpio_dev.c -- Tests the list of GPIO chips that are found in a device folder. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cmocka.h>

#include "drivers/gpio/gpio_backend.h"

static char root[] = "/tmp/kingyo_gpio_dev.XXXXXX";

static const char *in_dev(const char *name)
{
    static char path[sizeof root + 64];
    snprintf(path, sizeof path, "%s/dev/%s", root, name);
    return path;
}

static void put(const char *name)
{
    FILE *file = fopen(in_dev(name), "w");
    assert_non_null(file);
    fclose(file);
}

static void test_a_chip_with_several_links_is_listed_once(void **state)
{
    (void)state;
    struct gpio_dev_walk walk = { .root = root };
    uint32_t met[2] = { 0 };
    assert_non_null(mkdtemp(root));
    assert_int_equal(mkdir(in_dev(""), 0700), 0);
    put("gpiochip0");
    put("gpiochip11");
    put("gpiomem");
    assert_int_equal(symlink("gpiochip0", in_dev("gpiochip4")), 0);
    while (gpio_dev_next(&walk)) {
        met[0] += strcmp(walk.path, "/dev/gpiochip0") == 0;
        met[1] += strcmp(walk.path, "/dev/gpiochip11") == 0;
    }
    assert_int_equal(walk.count, 2);
    assert_int_equal(met[0], 1);
    assert_int_equal(met[1], 1);
    for (size_t i = 0; i < 4; i++) {
        static const char *const names[] = { "gpiochip0", "gpiochip4", "gpiochip11", "gpiomem" };
        unlink(in_dev(names[i]));
    }
    rmdir(in_dev(""));
    rmdir(root);
}

static void test_a_missing_device_folder_gives_no_chip(void **state)
{
    (void)state;
    struct gpio_dev_walk walk = { .root = "/nowhere at all" };
    assert_false(gpio_dev_next(&walk));
    assert_int_equal(walk.count, 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_a_chip_with_several_links_is_listed_once),
        cmocka_unit_test(test_a_missing_device_folder_gives_no_chip),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
