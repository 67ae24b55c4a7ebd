/* log.h -- the log: one line on standard error, "kingyo: ...", with a priority if a journal reads
 * it.
 *
 * Under systemd each line begins with a priority such as "<4>", see sd-daemon(3). On a terminal and
 * in a file there is no priority. */
#ifndef KINGYO_PLATFORM_OS_LOG_H
#define KINGYO_PLATFORM_OS_LOG_H

#include <stddef.h>

/* Size of a line; longer lines are cut. Enough for a path and a reason. */
#define LOG_LINE_MAX 1536u

/* Priorities, numbered as in syslog(3). */
enum log_level {
    LOG_LEVEL_CRITICAL = 2, /* The program ends. */
    LOG_LEVEL_ERROR = 3,    /* A requested action failed. */
    LOG_LEVEL_WARNING = 4,  /* An input was skipped, or the program continues without a part. */
};

/* Returns 1 if `journal`, the value of $JOURNAL_STREAM ("DEVICE:INODE"; may be null), is the file
 * of `fd`. Log lines then get priorities. */
int log_is_journal(const char *journal, int fd);

/* Detects at program start whether standard error is a journal. */
void log_open(void);

/* Writes one line, given without its end, after "kingyo: ". May be called on any thread. */
__attribute__((format(printf, 2, 3))) void log_print(enum log_level level, const char *format, ...);

/* Writes one line without formatting. Async-signal-safe. */
void log_print_raw(enum log_level level, const char *words);

#endif
