/* operator_view.h -- fills the operator's view with device names and texts that the core does not
 * have. */
#ifndef KINGYO_PLATFORM_KIOSK_OPERATOR_VIEW_H
#define KINGYO_PLATFORM_KIOSK_OPERATOR_VIEW_H

#include "platform/hal.h"
#include "platform/kiosk/file_notes.h"
#include "platform/kiosk/poi_sampler.h"

/* Returns the number of rows on the page of files: the store's row, then the notes. `notes` may be
 * null. */
uint8_t operator_view_file_count(const struct file_notes *notes);

/* Every button and coin line, with its counts since the start. */
struct operator_view_lines {
    uint32_t raw, missing; /* As in the last button_sample. */
    struct line_sample line[HAL_LINE_COUNT];
    uint32_t coins[COIN_LINE_COUNT];
};

/* Adds the counts of one sample. */
void operator_view_lines_add(struct operator_view_lines *book, const struct button_sample *sample);

/* Sources of the operator's view in the frame loop. */
struct operator_view {
    const struct file_notes *notes;  /* May be null. */
    const struct input *input;       /* Input of the last tick. */
    const struct poi_sampler *hands; /* Array of POI_MAX controllers. */
    const struct operator_view_lines *lines;
    uint32_t button_faults;
    const struct scene_machine *machine;
    uint64_t frame_ns; /* Median frame time; 0: unknown. */
};

/* Marks the scores whose replay is stored. Fills scene->devices while the operator's menu is shown,
 * and otherwise leaves it unchanged. */
void operator_view_fill(struct scene *scene, const struct hal *hal,
                        const struct operator_view *operator_view);

#endif
