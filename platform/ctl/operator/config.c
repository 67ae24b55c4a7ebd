/* config.c -- the command `kingyoctl config`.
 *
 * The command validates a configuration file kingyo.conf with the kiosk's parser, or prints a
 * template of the file. */
#include "platform/config/config_file.h"

#include <errno.h>
#include <string.h>

#include "platform/ctl/lib/ctl.h"
#include "platform/os/print.h"
#include "platform/os/file.h"

static const char name[] = "config";
static uint32_t warning_count;

static void config_warn(const char *line)
{
    print_error("%s", line); /* `line` has the form FILE:LINE: MESSAGE, which editors recognize. */
    warning_count++;
}

static enum exit_code config_check_file(const char *path)
{
    /* The variable is static, because the paths and the GPIO lines in the structure are too large
     * for the stack. */
    static struct options options;
    options = (struct options){ 0 };
    warning_count = 0;
    const int failed = config_file_read(&options, path, config_warn);
    if (failed) {
        print_error("kingyoctl config: %s: %s", path, file_error(-failed));
        return failed == -EFBIG ? EXIT_BAD_DATA : EXIT_IO;
    }
    if (warning_count > 0) {
        return EXIT_NOT_SO;
    }
    print_line(stdout, "%s: every line is used", path);
    return EXIT_OK;
}

static enum exit_code config_run(int argc, const char *const *argv)
{
    if (argc >= 1 && argc <= 2 && strcmp(argv[0], "check") == 0) {
        return config_check_file(argc == 2 ? argv[1] : CONFIG_FILE_DEFAULT);
    }
    if (argc == 1 && strcmp(argv[0], "defaults") == 0) {
        config_file_print_defaults(stdout);
        return EXIT_OK;
    }
    return ctl_usage(name, "expected check [FILE] or defaults; --help explains them");
}

const struct ctl_command ctl_config = {
    .name = name,
    .summary = "validates the configuration file, or prints an example file",
    .usage = "  kingyoctl config check [FILE]   reads FILE (" CONFIG_FILE_DEFAULT ") as the kiosk\n"
             "                                  does; prints FILE:LINE: reason, with the valid\n"
             "                                  range, for each line that the kiosk skips; then\n"
             "                                  the exit code is 1\n"
             "  kingyoctl config defaults       prints every key with its purpose, its range and\n"
             "                                  its default, all in comments\n",
    .run = config_run,
};
