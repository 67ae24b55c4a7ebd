/* say.h -- one line on standard error, "kingyo: ...", with its priority where a journal listens.
 *
 * Under systemd each line begins with "<4>" or so, as sd-daemon(3) has it; on a terminal and in a
 * file it does not. */
#ifndef KINGYO_PLATFORM_SAY_H
#define KINGYO_PLATFORM_SAY_H

#include <stddef.h>

/* Of a line: longer ones are cut. A path, a reason, and room. */
#define SAY_LINE_MAX 1536u

/* As syslog(3) numbers them. */
enum say_level {
    SAY_CRITICAL = 2, /* The program ends here. */
    SAY_ERROR = 3,    /* Something that was asked for did not come about. */
    SAY_WARNING = 4,  /* Passed over, or went on without. */
};

/* Whether `journal`, as $JOURNAL_STREAM has it ("DEVICE:INODE"; may be null), is the file that `fd`
 * leads to: then lines get priorities. */
int say_is_journal(const char *journal, int fd);

/* At the start: finds out whether a journal listens to standard error. */
void say_prepare(void);

/* One line without its end; "kingyo: " is put before it. Any thread. */
__attribute__((format(printf, 2, 3)))
void say(enum say_level level, const char *format, ...);

/* The same words without a format, by async-signal-safe calls alone. */
void say_plain(enum say_level level, const char *words);

#endif
