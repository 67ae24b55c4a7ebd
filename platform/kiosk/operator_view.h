/* operator_view.h -- fills the operator's menu with device names and texts, and with messages about
 * the files that were read at program start. The core does not have these data. */
#pragma once

#include <stdint.h>

#include "core/scene.h"
#include "platform/hal.h"
#include "platform/kiosk/sampler.h"

/* ---- Messages about files ------------------------------------------------------------------ */

/* Collects messages about the files that were read at program start. Pure functions.
 *
 * The operator's menu shows one row for each file. Rejected and quarantined files come first.
 * Within each group, rows have the order in which the files were read. */

/* Maximum number of notes: enough for every species and graph, 64 controllers and one page of other
 * notes. The operator's menu counts its rows in one byte, and needs one row for the store and one
 * last row. Notes beyond the maximum are only counted, and the last row shows their number. */
#define OPERATOR_NOTES_MAX 253u

struct operator_notes {
    uint32_t count;
    /* Number of notes about files that were not used. These notes come first in `note`. */
    uint32_t first_count;
    uint32_t refused_count; /* Number of notes with the state FILE_REFUSED. */
    uint32_t beyond;        /* Number of notes that did not fit into `note`. */
    struct scene_file note[OPERATOR_NOTES_MAX];
};

/* Adds a note about a rejected file. `line` is "FILE: reason" or "FILE:LINE: reason". If `line` has
 * no reason, the whole line is the text and the name is empty. If the name starts with the folder
 * `data`, the folder's path is removed from the name; `data` may be "". A name that is too long is
 * cut at its beginning. */
void operator_notes_refused(struct operator_notes *notes, const char *data, const char *line);
/* Adds a note about the file `name` with the text `words`. */
void operator_notes_add(struct operator_notes *notes, enum scene_file_state state, const char *name,
                        const char *words);

/* Returns the menu row of `notes` with the number `row`, or a row with the state FILE_UNKNOWN if
 * `row` is beyond the end. */
struct scene_file operator_notes_row(const struct operator_notes *notes, uint32_t row);

/* ---- Names and texts of the devices -------------------------------------------------------- */

/* Returns the number of rows on the operator's menu page about files: one row for the store, and
 * the rows of `notes`. `notes` may be null. */
uint8_t operator_view_file_count(const struct operator_notes *notes);

/* State of all button and coin lines, with counts since program start. */
struct operator_view_lines {
    /* Values of the newest button sample, one bit for each line: level before debouncing (`raw`),
     * and missing GPIO line (`missing`). See struct button_sample. */
    uint32_t raw, missing;
    struct line_sample line[HAL_LINE_COUNT];
    uint32_t coins[COIN_LINE_COUNT];
};

/* Adds the counts of the button sample to the totals in `book`. */
void operator_view_lines_add(struct operator_view_lines *book, const struct button_sample *sample);

/* Data from which operator_view_fill() fills the operator's menu. */
struct operator_view {
    /* Messages about files that the operator's menu shows. Null means no messages. */
    const struct operator_notes *notes;
    const struct input *input;          /* Input of the newest tick. */
    const struct poi_sampler *samplers; /* Array of POI_MAX poi samplers. */
    const struct operator_view_lines *lines;
    uint32_t button_faults;
    const struct scene_machine *machine;
    const struct scene_update *update; /* State of the update. Null means none. */
    uint64_t frame_ns;                 /* Median frame time in nanoseconds. 0 means unknown. */
};

/* Marks in `scene` the scores whose replay is stored. While the operator's menu is shown, also
 * fills scene->devices. Otherwise leaves scene->devices unchanged. */
void operator_view_fill(struct scene *scene, const struct hal *hal,
                        const struct operator_view *operator_view);
