/* hid_mapping_store_file.h -- reads the files of the mapping store and replaces them atomically.
 *
 * All functions may block on the memory card, so only the program start and the writer thread
 * call them. All functions except hid_mapping_store_file_open() return 0, or an errno value on
 * an error. */
#ifndef KINGYO_DRIVERS_HID_HID_MAPPING_STORE_FILE_H
#define KINGYO_DRIVERS_HID_HID_MAPPING_STORE_FILE_H

#include "drivers/hid/hid_mapping_store.h"

/* Opens a regular file for reading, without blocking. Returns the file descriptor, or -1 with errno
 * set: ELOOP for a symbolic link, ENOTSUP for anything else that is not a regular file. */
int hid_mapping_store_file_open(const char *path);

/* Reads a whole file into `text` and appends a terminating 0. Returns EFBIG if the file has
 * HID_MAPPING_STORE_TEXT_SIZE bytes or more. Does not block if `path` is a pipe. */
int hid_mapping_store_file_read(const char *path, char text[HID_MAPPING_STORE_TEXT_SIZE]);

/* Replaces the file `path` by writing PATH.new, flushing it and renaming it. A reader finds either
 * the old or the new content. */
int hid_mapping_store_file_replace(const char *path, const char *text);

/* Flushes the folder itself, so that a created, renamed or deleted file name survives a power
 * loss. */
int hid_mapping_store_file_sync(const char *folder);

#endif
