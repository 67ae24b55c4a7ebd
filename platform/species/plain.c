/* plain.c -- opens untrusted text files and reads their lines. */
#include "platform/species/plain.h"

#include <errno.h>
#include <stdbool.h>

#include "platform/plain_file.h"

enum plain_open plain_open(const char *path, uint32_t size_max, FILE **out,
                           char why[PLAIN_WHY_SIZE])
{
    const bool fine = size_max % (1u << 20) != 0;
    *out = plain_file_open(path, size_max);
    if (*out) {
        return PLAIN_OPEN;
    }
    if (errno == EFBIG) {
        snprintf(why, PLAIN_WHY_SIZE, "larger than %u %s", size_max >> (fine ? 10 : 20),
                 fine ? "KiB" : "MiB");
        return PLAIN_LARGE;
    }
    snprintf(why, PLAIN_WHY_SIZE, "%s", plain_file_error(errno));
    return PLAIN_NONE;
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
