/* out_file.h -- a file that is whole or not there. */
#ifndef KINGYO_PLATFORM_OUT_FILE_H
#define KINGYO_PLATFORM_OUT_FILE_H

#include <stdio.h>

struct out_file {
    FILE *file;
    const char *path;
};

/* Opens `path` for writing, emptied. 0 or a negative errno. `path` must outlive `out`. */
int out_open(struct out_file *out, const char *path);

/* Closes it. 0, or the negative errno of the first thing that could not be written since it was
 * opened: then what there is of a regular file is removed. */
int out_close(struct out_file *out);

#endif
