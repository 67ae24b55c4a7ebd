/* print.c -- writes each line with one system call, so that lines of several threads do not mix;
 * see print.h. */
#include "platform/os/print.h"

#include <errno.h>
#include <fcntl.h>
#include <stdarg.h>
#include <string.h>
#include <unistd.h>

#include "core/base/panic.h"
#include "core/base/printable.h"

__attribute__((format(printf, 3, 0))) static void print_put(FILE *file, const char *end,
                                                            const char *format, va_list arguments)
{
    char line[PRINT_LINE_MAX];
    vsnprintf(line, sizeof line - 1u, format, arguments);
    printable(line);
    CORE_ASSERT(strlen(end) <= 1);
    memcpy(line + strlen(line), end, strlen(end) + 1u); /* `line` has space for one more byte. */
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

/* ---- Standard streams ----------------------------------------------------------------------- */

int print_open_streams(void)
{
    for (int fd = STDIN_FILENO; fd <= STDERR_FILENO; fd++) {
        if (fcntl(fd, F_GETFD) >= 0) {
            continue;
        }
        /* Opens /dev/null for writing as standard input, and for reading as standard output or
         * standard error. Each read or write on the descriptor therefore fails. open() returns the
         * lowest free descriptor, which is `fd`. */
        const int opened = open("/dev/null", fd == STDIN_FILENO ? O_WRONLY : O_RDONLY);
        if (opened != fd) {
            return opened < 0 ? -errno : -EIO;
        }
    }
    return 0;
}

static int flush_error; /* errno of the first failed print_flush(), or 0 if no call
                           failed. */

int print_flush(FILE *out)
{
    const int error = fflush(out) == 0 ? 0 : errno;
    if (error == 0 && !ferror(out)) {
        return 0;
    }
    flush_error = flush_error ? flush_error : error;
    return -1;
}

int print_finish(void)
{
    const int has_failed = ferror(stdout) != 0;
    /* After a failed write the C library keeps the bytes in its buffer, so that fflush() fails
     * again for the same reason. */
    const int error = fflush(stdout) == 0 ? 0 : errno;
    if (error == 0 && !has_failed) {
        return 0;
    }
    return flush_error != 0 ? -flush_error : error != 0 ? -error : -EIO;
}
