/* dressing.h -- what the core knows by rows and bits has names on the operator's screen. */
#ifndef KINGYO_PLATFORM_KIOSK_DRESSING_H
#define KINGYO_PLATFORM_KIOSK_DRESSING_H

#include "platform/hal.h"
#include "platform/kiosk/file_notes.h"

/* Rows of the files' page: the store's, then the notes'. `notes` may be null. */
uint8_t dressing_file_count(const struct file_notes *notes);

/* Fills scene->devices while the operator's menu is shown; else leaves it as it is. */
void dressing_put(struct scene *scene, const struct hal *hal, const struct file_notes *notes,
                  uint32_t button_faults, uint32_t buttons_missing);

#endif
