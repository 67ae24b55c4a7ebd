/* print.c -- writes each line with one system call, so that lines of several threads do not mix;
 * see print.h. */
#include "platform/os/print.h"

#include <stdarg.h>
#include <string.h>

#include "core/base/printable.h"

__attribute__((format(printf, 3, 0))) static void print_put(FILE *file, const char *end,
                                                            const char *format, va_list arguments)
{
    char line[PRINT_LINE_MAX];
    vsnprintf(line, sizeof line - 1u, format, arguments);
    printable(line);
    strcat(line, end); /* `end` is at most one byte, for which `line` has space. */
    fputs(line, file);
}

void print_part(FILE *file, const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    print_put(file, "", format, arguments);
    va_end(arguments);
}

void print_line(FILE *file, const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    print_put(file, "\n", format, arguments);
    va_end(arguments);
}

void print_error(const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    print_put(stderr, "\n", format, arguments);
    va_end(arguments);
}
