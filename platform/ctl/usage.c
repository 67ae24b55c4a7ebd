/* usage.c -- the one line that a wrong command line is answered with. */
#include <stdarg.h>
#include <stdio.h>

#include "platform/ctl/ctl.h"

enum exit_code ctl_usage(const char *command, const char *format, ...)
{
    va_list arguments;
    fprintf(stderr, "kingyoctl %s: ", command);
    va_start(arguments, format);
    vfprintf(stderr, format, arguments);
    va_end(arguments);
    fputc('\n', stderr);
    return EXIT_USAGE;
}
