/* log.c -- writes each log line with one system call, so that lines of several threads do not mix;
 * see log.h. */
#include "platform/os/log.h"

#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "core/base/panic.h"
#include "platform/os/file.h"
#include "platform/os/panic.h"

static bool has_journal; /* True if the systemd journal reads standard error. Set once, before other
                            threads start. */

void log_open(void)
{
    /* JOURNAL_STREAM has the text "DEVICE:INODE" of the stream that the journal reads. Null means
     * that there is no journal. */
    const char *journal = getenv("JOURNAL_STREAM");
    char here[64];
    struct stat about;
    has_journal = false;
    if (journal && fstat(STDERR_FILENO, &about) == 0) {
        snprintf(here, sizeof here, "%llu:%llu", (unsigned long long)about.st_dev,
                 (unsigned long long)about.st_ino);
        has_journal = strcmp(here, journal) == 0;
    }
}

void log_print_raw(enum log_level level, const char *words)
{
    struct panic_text line = { 0 };
    if (has_journal) {
        panic_put(&line, "<");
        panic_put_number(&line, (uint32_t)level);
        panic_put(&line, ">");
    }
    panic_put(&line, "kingyo: ");
    panic_put(&line, words);
    panic_put_end(&line);
    file_write(STDERR_FILENO, line.out, line.used);
}

void log_print(enum log_level level, const char *format, ...)
{
    CORE_ASSERT(format);
    char words[LOG_LINE_MAX - 32u];
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(words, sizeof words, format, arguments);
    va_end(arguments);
    log_print_raw(level, words);
}
