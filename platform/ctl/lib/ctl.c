/* ctl.c -- the parser of options, the error messages and the opening of files that all commands
 * share. */
#include "platform/ctl/lib/ctl.h"

#include <errno.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stdio.h>
#include <string.h>

#include "core/base/panic.h"
#include "platform/cpu.h"
#include "platform/os/clock.h"
#include "platform/os/file.h"
#include "platform/os/print.h"

enum exit_code ctl_usage(const char *command, const char *format, ...)
{
    char words[PRINT_LINE_MAX];
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(words, sizeof words, format, arguments);
    va_end(arguments);
    return print_fail(EXIT_USAGE, "kingyoctl %s: %s", command, words);
}

bool ctl_is_help(const char *word)
{
    return strcmp(word, "--help") == 0 || strcmp(word, "-h") == 0;
}

enum exit_code ctl_options(const char *command, const struct option_table *table, uint32_t groups,
                           void *target, int argc, const char *const *argv)
{
    char error[OPTIONS_ERROR_MAX];
    CORE_ASSERT(command && table);
    return option_table_parse(table, groups, target, argc, argv, error)
               ? ctl_usage(command, "%s", error)
               : EXIT_OK;
}

static volatile sig_atomic_t *stop_flag;

static void set_stop_flag(int signal_number)
{
    (void)signal_number;
    *stop_flag = 1;
}

void ctl_stop_at_signals(volatile sig_atomic_t *flag)
{
    const struct sigaction action = { .sa_handler = set_stop_flag };
    CORE_ASSERT(flag);
    stop_flag = flag;
    sigaction(SIGINT, &action, NULL);
    sigaction(SIGTERM, &action, NULL);
    sigaction(SIGHUP, &action, NULL);
}

uint64_t ctl_now_ns(void)
{
    const struct hal_clock clock = clock_device();
    return clock.ops->now_ns(clock.self);
}

enum exit_code ctl_float(const char *command)
{
    return print_fail(EXIT_NOT_SO, "kingyoctl %s: " CPU_FLOAT_WRONG, command);
}

void ctl_list_word(char *list, size_t size, const char *word)
{
    const size_t used = strlen(list);
    CORE_ASSERT(used < size);
    snprintf(list + used, size - used, "%s%s", used ? ", " : "", word);
}

enum exit_code ctl_file_error(const char *prefix, const char *path, uint32_t size_max, int error)
{
    if (error == EFBIG) {
        const bool in_kib = size_max < 1u << 20;
        return print_fail(EXIT_BAD_DATA, "%s: %s: is larger than %u %s", prefix, path,
                          size_max >> (in_kib ? 10 : 20), in_kib ? "KiB" : "MiB");
    }
    return print_fail(EXIT_IO, "%s: %s: %s", prefix, path, file_error(error));
}

enum exit_code ctl_file_open(const char *prefix, const char *path, uint32_t size_max, FILE **out)
{
    CORE_ASSERT(size_max > 0);
    *out = file_open(path, size_max);
    return *out ? EXIT_OK : ctl_file_error(prefix, path, size_max, errno);
}

enum exit_code ctl_file_read(const char *prefix, const char *path, void *bytes, uint32_t size_max,
                             size_t *size)
{
    FILE *file;
    enum exit_code code = ctl_file_open(prefix, path, size_max, &file);
    if (code == EXIT_OK) {
        *size = fread(bytes, 1, size_max, file);
        code = ferror(file) ? ctl_file_error(prefix, path, size_max, errno) : EXIT_OK;
        fclose(file);
    }
    return code;
}
