/* usb_choice_file.h -- the operator's controller choices on disk, replaced atomically. */
#ifndef KINGYO_DRIVERS_USB_USB_CHOICE_FILE_H
#define KINGYO_DRIVERS_USB_USB_CHOICE_FILE_H

#include "drivers/usb/usb_choice.h"
#include "platform/hal.h"

/* Adds the rules of the file; a missing file adds none. Returns the number of invalid lines, or
 * a negative errno if the file cannot be read completely. In both cases `why` gets one sentence,
 * with FILE:LINE for the last invalid line. After a negative result the file must not be
 * overwritten. */
int usb_choice_load(struct usb_choice *choice, const char *path, char why[HAL_TEXT_SIZE]);

/* Writes the rules that are to be stored and waits for the disk. Returns 0, or a negative errno;
 * the old file is then unchanged unless only the folder's flush failed. `path` "" stores nothing
 * and is not an error. */
int usb_choice_save(const struct usb_choice *choice, const char *path);

#endif
