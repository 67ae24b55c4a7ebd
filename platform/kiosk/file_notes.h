/* file_notes.h -- collects messages about the files that were read at program start. Pure
 * functions.
 *
 * The operator's menu shows one row for each file. Rejected and quarantined files come first.
 * Within each group, rows have the order in which the files were read. */
#ifndef KINGYO_PLATFORM_KIOSK_FILE_NOTES_H
#define KINGYO_PLATFORM_KIOSK_FILE_NOTES_H

#include <stdint.h>

#include "core/scene.h"

/* Maximum number of notes: enough for every species and graph, 64 controllers and one page of other
 * notes. The operator's menu counts its rows in one byte, and needs one row for the store and one
 * last row. Notes beyond the maximum are only counted, and the last row shows their number. */
#define FILE_NOTES_MAX 253u

struct file_notes {
    uint32_t count;
    uint32_t first_count;   /* Number of notes about files that were not used. These notes come
                               first in `note`. */
    uint32_t refused_count; /* Number of notes with the state FILE_REFUSED. */
    uint32_t beyond;        /* Number of notes that did not fit into `note`. */
    struct scene_file note[FILE_NOTES_MAX];
};

/* Adds a note about a rejected file. `line` is "FILE: reason" or "FILE:LINE: reason". If `line` has
 * no reason, the whole line is the text and the name is empty. If the name starts with the folder
 * `data`, this prefix is removed; `data` may be "". A name that is too long is cut at its
 * beginning. */
void file_notes_refused(struct file_notes *notes, const char *data, const char *line);
/* Adds a note about the file `name` with the text `words`. */
void file_notes_add(struct file_notes *notes, enum scene_file_state state, const char *name,
                    const char *words);

/* file_notes_rows() returns the number of rows. file_notes_row() returns one row; its state is
 * FILE_UNKNOWN if `row` is beyond the end. */
uint32_t file_notes_rows(const struct file_notes *notes);
struct scene_file file_notes_row(const struct file_notes *notes, uint32_t row);

#endif
