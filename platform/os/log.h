/* log.h -- writes log lines to standard error in the form "kingyo: ...".
 *
 * If systemd's journal reads standard error, each line begins with a priority such as "<4>" (see
 * sd-daemon(3)). On a terminal and in a file there is no priority. */
#pragma once

/* Maximum size of a log line in bytes, enough for a path and a reason. Longer lines are cut. */
#define LOG_LINE_MAX 1536u

/* Priorities with the numbers of syslog(3). */
enum log_level {
    LOG_LEVEL_CRITICAL = 2, /* Priority of an error that ends the program. */
    LOG_LEVEL_ERROR = 3,    /* Priority of a requested action that failed. */
    /* Priority of a skipped input, or of an error after which the program continues with fewer
     * functions. */
    LOG_LEVEL_WARNING = 4,
};

/* Detects whether the systemd journal reads standard error: $JOURNAL_STREAM then has the device and
 * the inode of standard error. The program calls log_open() once at program start. */
void log_open(void);

/* Formats `format` as printf() does and writes one line after "kingyo: ". `format` has no line end.
 * May be called on any thread. */
__attribute__((format(printf, 2, 3))) void log_print(enum log_level level, const char *format, ...);

/* Writes one line as log_print() does. The value of the expression is `code`, the exit code that
 * the caller returns. */
#define log_fail(code, ...) (log_print(__VA_ARGS__), (code))

/* Writes the text `words` as one line, without formatting. Async-signal-safe. */
void log_print_raw(enum log_level level, const char *words);
