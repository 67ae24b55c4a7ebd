/* operator_view.h -- fills the operator's menu with device names and texts. The core does not have
 * these data. */
#ifndef KINGYO_PLATFORM_KIOSK_OPERATOR_VIEW_H
#define KINGYO_PLATFORM_KIOSK_OPERATOR_VIEW_H

#include "platform/hal.h"
#include "platform/kiosk/file_notes.h"
#include "platform/kiosk/poi_sampler.h"

/* Returns the number of rows on the menu page of files: one row for the store, and the rows of
 * `notes`. `notes` may be null. */
uint8_t operator_view_file_count(const struct file_notes *notes);

/* State of all button and coin lines, with counts since program start. */
struct operator_view_lines {
    uint32_t raw, missing; /* Values of the newest struct button_sample. */
    struct line_sample line[HAL_LINE_COUNT];
    uint32_t coins[COIN_LINE_COUNT];
};

/* Adds the counts of one sample to the totals in `book`. */
void operator_view_lines_add(struct operator_view_lines *book, const struct button_sample *sample);

/* Input data of operator_view_fill(). */
struct operator_view {
    const struct file_notes *notes;  /* Messages about files that the operator's menu shows. May be
                                        null. */
    const struct input *input;       /* Input of the newest tick. */
    const struct poi_sampler *hands; /* Array of POI_MAX poi samplers. */
    const struct operator_view_lines *lines;
    uint32_t button_faults;
    const struct scene_machine *machine;
    uint64_t frame_ns; /* Median frame time in nanoseconds. 0 means unknown. */
};

/* Marks the scores whose replay is stored. While the operator's menu is shown, fills
 * scene->devices; otherwise leaves scene->devices unchanged. */
void operator_view_fill(struct scene *scene, const struct hal *hal,
                        const struct operator_view *operator_view);

#endif
