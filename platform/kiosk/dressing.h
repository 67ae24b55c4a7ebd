/* dressing.h -- fills the operator's view with device names and texts that the core does not
 * have. */
#ifndef KINGYO_PLATFORM_KIOSK_DRESSING_H
#define KINGYO_PLATFORM_KIOSK_DRESSING_H

#include "platform/hal.h"
#include "platform/kiosk/file_notes.h"
#include "platform/kiosk/hands.h"

/* Returns the number of rows on the page of files: the store's row, then the notes. `notes` may be
 * null. */
uint8_t dressing_file_count(const struct file_notes *notes);

/* Every button and coin line, with its counts since the start. */
struct line_book {
    uint32_t raw, missing; /* As in the last button_sample. */
    struct line_sample line[HAL_LINE_COUNT];
    uint32_t coins[COIN_LINE_COUNT];
};

/* Adds the counts of one sample. */
void line_book_note(struct line_book *book, const struct button_sample *sample);

/* Sources of the operator's view in the frame loop. */
struct dressing {
    const struct file_notes *notes; /* May be null. */
    const struct input *input;      /* Input of the last tick. */
    const struct poi_hand *hands;   /* Array of POI_MAX controllers. */
    const struct line_book *lines;
    uint32_t button_faults;
    const struct scene_machine *machine;
    uint64_t frame_ns; /* Median frame time; 0: unknown. */
};

/* Marks the scores whose replay is stored. Fills scene->devices while the operator's menu is shown,
 * and otherwise leaves it unchanged. */
void dressing_put(struct scene *scene, const struct hal *hal, const struct dressing *dressing);

#endif
