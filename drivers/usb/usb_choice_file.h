/* usb_choice_file.h -- stores the operator's rules for USB controllers (usb_choice.h) in a file,
 * which is replaced atomically. */
#ifndef KINGYO_DRIVERS_USB_USB_CHOICE_FILE_H
#define KINGYO_DRIVERS_USB_USB_CHOICE_FILE_H

#include "drivers/usb/usb_choice.h"
#include "platform/hal.h"

/* Adds the rules of the file to `choice`; a missing file adds none. Returns the number of invalid
 * lines, or a negative errno value if the file cannot be read completely. If the result is not 0,
 * `why` has one sentence; for an invalid line it starts with FILE:LINE of the last invalid line.
 * After a negative result the file must not be overwritten. */
int usb_choice_load(struct usb_choice *choice, const char *path, char why[HAL_TEXT_SIZE]);

/* Writes the rules that are marked as kept, and waits for the disk. Returns 0 or a negative errno
 * value. After an error the old file is unchanged, unless only flushing the folder failed. If
 * `path` is "" nothing is stored and the result is 0. */
int usb_choice_save(const struct usb_choice *choice, const char *path);

#endif
