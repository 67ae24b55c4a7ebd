/* text_file.c -- opens untrusted text files and reads their lines. */
#include "platform/species/text_file.h"

#include <errno.h>
#include <stdbool.h>

#include "platform/os/file.h"

enum text_file_open text_file_open(const char *path, uint32_t size_max, FILE **out,
                                   char why[TEXT_FILE_WHY_SIZE])
{
    const bool fine = size_max % (1u << 20) != 0;
    *out = file_open(path, size_max);
    if (*out) {
        return TEXT_FILE_OPEN;
    }
    if (errno == EFBIG) {
        snprintf(why, TEXT_FILE_WHY_SIZE, "larger than %u %s", size_max >> (fine ? 10 : 20),
                 fine ? "KiB" : "MiB");
        return TEXT_FILE_LARGE;
    }
    snprintf(why, TEXT_FILE_WHY_SIZE, "%s", file_error(errno));
    return TEXT_FILE_NONE;
}

enum text_file_line text_file_line(FILE *file, char *text, size_t size)
{
    size_t length = 0;
    int c = getc(file);
    if (c == EOF) {
        return TEXT_FILE_END;
    }
    for (; c != EOF && c != '\n'; c = getc(file)) {
        if (c == '\0') {
            return TEXT_FILE_ZERO;
        }
        if (length == size - 2) {
            return TEXT_FILE_LONG;
        }
        text[length++] = (char)c;
    }
    text[length] = '\0';
    return TEXT_FILE_LINE;
}
