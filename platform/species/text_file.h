/* text_file.h -- opens untrusted text files and reads them line by line. Rejects all files except
 * regular files. */
#ifndef KINGYO_PLATFORM_SPECIES_TEXT_FILE_H
#define KINGYO_PLATFORM_SPECIES_TEXT_FILE_H

#include <stdint.h>
#include <stdio.h>

#define TEXT_FILE_WHY_SIZE 96u

enum text_file_open {
    TEXT_FILE_OPEN,
    TEXT_FILE_NONE,  /* The file does not exist, is not readable, or is not a regular file. */
    TEXT_FILE_LARGE, /* The file has more than `size_max` bytes. */
};

/* Opens a regular file of at most `size_max` bytes. Never blocks on a pipe or a device, and never
 * reads from one. On failure, sets `*out` to null and writes the reason without the path to `why`.
 * The caller closes the file. */
enum text_file_open text_file_open(const char *path, uint32_t size_max, FILE **out,
                                   char why[TEXT_FILE_WHY_SIZE]);

enum text_file_line {
    TEXT_FILE_LINE,
    TEXT_FILE_END,  /* No line is left, or a read failed. ferror() distinguishes a read error from
                       the end of the file. */
    TEXT_FILE_LONG, /* The line has more than `size` - 2 characters. */
    TEXT_FILE_ZERO, /* The line contains a zero byte. */
};

/* Reads the next line into `text`, a buffer of `size` bytes, without the line end. */
enum text_file_line text_file_line(FILE *file, char *text, size_t size);
#endif
