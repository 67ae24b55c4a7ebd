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
#include "platform/os/file.h"

__attribute__((format(printf, 3, 0))) static void print_put(FILE *file, const char *end,
                                                            const char *format, va_list arguments)
{
    char line[PRINT_LINE_MAX];
    vsnprintf(line, sizeof line - 1u, format, arguments);
    printable(line);
    CORE_ASSERT(strlen(end) <= 1);
    /* vsnprintf() was given one byte less than the size of `line`, so that a line end of one byte
     * fits. */
    memcpy(line + strlen(line), end, strlen(end) + 1u);
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

static int output_error; /* errno of the first failed write to standard output, or 0 if no write
                            failed. */

/* Write function of `stdout`, which stores the reason of a failed write in `output_error`. The C
 * library itself does not store the reason: it writes a full buffer within any printf() call, and
 * drops the buffer if the write fails. */
static ssize_t write_output(void *cookie, const char *bytes, size_t size)
{
    (void)cookie;
    const int error = file_write(STDOUT_FILENO, bytes, size);
    output_error = output_error ? output_error : -error;
    return error == 0 ? (ssize_t)size : 0;
}

int print_open_streams(void)
{
    for (int fd = STDIN_FILENO; fd <= STDERR_FILENO; fd++) {
        if (fcntl(fd, F_GETFD) >= 0) {
            continue;
        }
        /* Standard input is opened for writing only, and standard output and standard error are
         * opened for reading only, so that each read or write on the descriptor fails. open()
         * returns the lowest free descriptor, which is `fd`. */
        const int opened = open("/dev/null", fd == STDIN_FILENO ? O_WRONLY : O_RDONLY);
        if (opened != fd) {
            return opened < 0 ? -errno : -EIO;
        }
    }
    FILE *out = fopencookie(NULL, "w", (cookie_io_functions_t){ .write = write_output });
    if (!out) {
        return -ENOMEM;
    }
    setvbuf(out, NULL, isatty(STDOUT_FILENO) ? _IOLBF : _IOFBF, BUFSIZ);
    stdout = out;
    return 0;
}

int print_flush(FILE *out)
{
    return fflush(out) == 0 && !ferror(out) ? 0 : -1;
}

int print_finish(void)
{
    return print_flush(stdout) == 0 ? 0 : output_error != 0 ? -output_error : -EIO;
}
