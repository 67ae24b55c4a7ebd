/* file_notes.h -- what the kiosk thought of the files that it found as it began. Pure.
 *
 * A line each for the operator's screen: those that were refused or set aside first, for they are
 * what he looks for, and both kinds in the order in which they were met. */
#ifndef KINGYO_PLATFORM_KIOSK_FILE_NOTES_H
#define KINGYO_PLATFORM_KIOSK_FILE_NOTES_H

#include <stdint.h>

#include "core/scene.h"

/* Every species and graph that there can be, 64 controllers, and a page of other lines: as many as
 * a byte counts, with the store's row and the last one's. When full, further ones are only
 * counted, and a row behind the last says how many. */
#define FILE_NOTES_MAX 253u

struct file_notes {
    uint32_t count;
    uint32_t first_count;   /* Of them, those that were not used: they come first. */
    uint32_t refused_count; /* Of these, those that are FILE_REFUSED. */
    uint32_t beyond;        /* Had no room. */
    struct scene_file note[FILE_NOTES_MAX];
};

/* `line` is "FILE: why" or "FILE:LINE: what"; one without a reason names no file. Of files below
 * the folder `data` (may be "") the folder is left away; of a name too long its end is kept. */
void file_notes_refused(struct file_notes *notes, const char *data, const char *line);
/* The same in two parts. */
void file_notes_add(struct file_notes *notes, enum scene_file_state state, const char *name,
                    const char *words);

/* How many rows that are, and one of them: `row` beyond them is FILE_UNKNOWN. */
uint32_t file_notes_rows(const struct file_notes *notes);
struct scene_file file_notes_row(const struct file_notes *notes, uint32_t row);

#endif
