/* usage.c -- prints the usage errors that all commands share. */
#include <stdarg.h>
#include <stdio.h>

#include "platform/cpu.h"
#include "platform/ctl/lib/ctl.h"
#include "platform/os/print.h"

enum exit_code ctl_usage(const char *command, const char *format, ...)
{
    char words[PRINT_LINE_MAX];
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(words, sizeof words, format, arguments);
    va_end(arguments);
    print_error("kingyoctl %s: %s", command, words);
    return EXIT_USAGE;
}

enum exit_code ctl_options(const char *command, const struct option_table *table, uint32_t groups,
                           void *target, int argc, const char *const *argv)
{
    char error[OPTIONS_ERROR_MAX];
    return option_table_parse(table, groups, target, argc, argv, error)
               ? ctl_usage(command, "%s", error)
               : EXIT_OK;
}

enum exit_code ctl_float(const char *command)
{
    print_error("kingyoctl %s: " CPU_FLOAT_WRONG, command);
    return EXIT_NOT_SO;
}
