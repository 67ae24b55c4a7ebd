/* usb_choice_file.h -- the operator's choices on disk: whole, or as they were before. */
#ifndef KINGYO_DRIVERS_USB_CHOICE_FILE_H
#define KINGYO_DRIVERS_USB_CHOICE_FILE_H

#include "drivers/usb_choice.h"
#include "platform/hal.h"

/* Adds what the file says. A file that is not there says nothing; of a line that cannot be used
 * `why` says the last, as FILE:LINE, and the others count. How many lines could not be used; or a
 * negative errno, and `why`: it cannot be read to its end, and must not be written over. */
int usb_choice_load(struct usb_choice *choice, const char *path, char why[HAL_TEXT_SIZE]);

/* Writes the wishes that are to be kept; waits for the disk. 0, or a negative errno: then the file
 * is as it was. "": nowhere, which is no error. */
int usb_choice_save(const struct usb_choice *choice, const char *path);

#endif
