/* out_file.h -- a file that is whole, or as it was before.
 *
 * What is written goes into PATH.part beside it, which takes its place when it is closed: whoever
 * reads finds the old file or the new one, whenever the disk is full or the power gone. A link
 * stays one, and what it leads to is written; one that leads nowhere is refused. Folders and disks
 * are refused. A terminal, /dev/null or a pipe that somebody reads takes what is written as it
 * comes, and stays what it is. */
#ifndef KINGYO_PLATFORM_OUT_FILE_H
#define KINGYO_PLATFORM_OUT_FILE_H

#include <limits.h>
#include <stdbool.h>
#include <stdio.h>

#define OUT_FILE_PART ".part"

struct out_file {
    FILE *file;
    bool is_stream;       /* What takes bytes as they come: there is no part. */
    bool lasts;
    char place[PATH_MAX]; /* What the path leads to. */
    char part[PATH_MAX];
};

/* Opens `path` for writing, empty. 0 or a negative errno. */
int out_open(struct out_file *out, const char *path);

/* The same for what must outlive a loss of power: closing waits until the disk has it. Nothing but
 * a plain file will do: -ENOTSUP otherwise. */
int out_open_lasting(struct out_file *out, const char *path);

/* Closes it. 0, or the negative errno of the first thing that could not be written since it was
 * opened: then the part is removed and what was there stays. */
int out_close(struct out_file *out);

#endif
