/* file_notes.h -- collects messages about the files that were read at start. Pure.
 *
 * One line for each file, for the operator's screen. Files that were rejected or quarantined come
 * first, and both groups are in the order of their detection. */
#ifndef KINGYO_PLATFORM_KIOSK_FILE_NOTES_H
#define KINGYO_PLATFORM_KIOSK_FILE_NOTES_H

#include <stdint.h>

#include "core/scene.h"

/* Limit of notes, enough for every species and graph, 64 controllers and a page of other lines.
 * Rows are counted in a byte, together with the store's row and the last row. Further notes are
 * only counted, and a last row shows their number. */
#define FILE_NOTES_MAX 253u

struct file_notes {
    uint32_t count;
    uint32_t first_count;   /* Notes at the beginning about files that were not used. */
    uint32_t refused_count; /* Notes among these that are FILE_REFUSED. */
    uint32_t beyond;        /* Notes that did not fit. */
    struct scene_file note[FILE_NOTES_MAX];
};

/* Adds a rejected file. `line` is "FILE: reason" or "FILE:LINE: reason"; a line without a reason
 * names no file. The folder `data` (may be "") is removed from the name. A name that is too long is
 * cut at its beginning. */
void file_notes_refused(struct file_notes *notes, const char *data, const char *line);
/* Adds a note with name and text given separately. */
void file_notes_add(struct file_notes *notes, enum scene_file_state state, const char *name,
                    const char *words);

/* Return the number of rows, and one row. A `row` beyond the end is FILE_UNKNOWN. */
uint32_t file_notes_rows(const struct file_notes *notes);
struct scene_file file_notes_row(const struct file_notes *notes, uint32_t row);

#endif
