/* dressing.h -- what the core knows by rows and bits has names on the operator's screen. */
#ifndef KINGYO_PLATFORM_KIOSK_DRESSING_H
#define KINGYO_PLATFORM_KIOSK_DRESSING_H

#include "platform/hal.h"
#include "platform/kiosk/file_notes.h"
#include "platform/kiosk/hands.h"

/* Rows of the files' page: the store's, then the notes'. `notes` may be null. */
uint8_t dressing_file_count(const struct file_notes *notes);

/* Every line of the buttons, and what came of it since the start. */
struct line_book {
    uint32_t raw, missing; /* As the last button_sample said. */
    struct line_sample line[HAL_LINE_COUNT];
    uint32_t coins[COIN_LINE_COUNT];
};

/* Adds what one sample says. */
void line_book_note(struct line_book *book, const struct button_sample *sample);

/* What the frame loop knows of devices beside what they say themselves. */
struct dressing {
    const struct file_notes *notes; /* May be null. */
    const struct input *input;      /* The last tick's. */
    const struct poi_hand *hands;   /* POI_MAX of them. */
    const struct line_book *lines;
    uint32_t button_faults;
    const struct scene_machine *machine;
    uint64_t frame_ns; /* The median frame's; 0: none yet. */
};

/* Seals the scores whose replay is kept. Fills scene->devices while the operator's menu is shown;
 * else leaves them as they are. */
void dressing_put(struct scene *scene, const struct hal *hal, const struct dressing *dressing);

#endif
