/* plain.c -- opening, lines and quoting of files that somebody else wrote. */
#include "platform/species/plain.h"

#include <errno.h>
#include <fcntl.h>
#include <stdbool.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

/* PLAIN_OPEN where `fd` is what is wanted. */
static enum plain_open judge(int fd, uint32_t size_max, char why[PLAIN_WHY_SIZE])
{
    struct stat status;
    if (fstat(fd, &status) != 0 || S_ISDIR(status.st_mode)) {
        snprintf(why, PLAIN_WHY_SIZE, "%s", strerror(errno ? errno : EISDIR));
        return PLAIN_NONE;
    }
    if (!S_ISREG(status.st_mode)) {
        snprintf(why, PLAIN_WHY_SIZE, "no plain file");
        return PLAIN_NONE;
    }
    if (status.st_size > (off_t)size_max) {
        const bool fine = size_max % (1u << 20) != 0;
        snprintf(why, PLAIN_WHY_SIZE, "larger than %u %s", size_max >> (fine ? 10 : 20),
                 fine ? "KiB" : "MiB");
        return PLAIN_LARGE;
    }
    return PLAIN_OPEN;
}

enum plain_open plain_open(const char *path, uint32_t size_max, FILE **out,
                           char why[PLAIN_WHY_SIZE])
{
    /* A pipe would make us wait for a writer who never comes. */
    const int fd = open(path, O_RDONLY | O_NONBLOCK | O_CLOEXEC);
    *out = NULL;
    if (fd < 0) {
        snprintf(why, PLAIN_WHY_SIZE, "%s", strerror(errno));
        return PLAIN_NONE;
    }
    errno = 0;
    const enum plain_open result = judge(fd, size_max, why);
    *out = result == PLAIN_OPEN ? fdopen(fd, "rb") : NULL;
    if (!*out) {
        close(fd);
    }
    return result == PLAIN_OPEN && !*out ? PLAIN_NONE : result;
}

enum plain_line plain_line(FILE *file, char *text, size_t size)
{
    size_t length = 0;
    int c = getc(file);
    if (c == EOF) {
        return PLAIN_END;
    }
    for (; c != EOF && c != '\n'; c = getc(file)) {
        if (c == '\0') {
            return PLAIN_ZERO;
        }
        if (length == size - 2) {
            return PLAIN_LONG;
        }
        text[length++] = (char)c;
    }
    text[length] = '\0';
    return PLAIN_LINE;
}

void plain_quote(char *text)
{
    for (char *c = text; *c; c++) {
        *c = *c >= ' ' && *c <= '~' ? *c : '?';
    }
}
