/* hid_mapping_store_file.h -- the files of the mapping store, read whole and replaced atomically.
 *
 * All functions may block on the card. Only the start and the writer thread call them. The
 * functions except hid_mapping_store_file_open() return 0 or an errno value. */
#ifndef KINGYO_DRIVERS_HID_HID_MAPPING_STORE_FILE_H
#define KINGYO_DRIVERS_HID_HID_MAPPING_STORE_FILE_H

#include "drivers/hid/hid_mapping_store.h"

/* Opens a file in the data folder for reading, without blocking. Returns the descriptor, or -1 and
 * sets errno: ELOOP for a symbolic link, ENOTSUP for anything else that is not a regular file. */
int hid_mapping_store_file_open(const char *path);

/* Reads a whole file into `text` and terminates the text. Returns EFBIG if the file has
 * HID_MAPPING_STORE_TEXT_SIZE bytes or more. Does not block on a pipe of that name. */
int hid_mapping_store_file_read(const char *path, char text[HID_MAPPING_STORE_TEXT_SIZE]);

/* Writes PATH.new, flushes it and renames it to `path`, so that a reader finds either the old or
 * the new content. */
int hid_mapping_store_file_replace(const char *path, const char *text);

/* Flushes the folder itself, so that a new, renamed or deleted name survives a power loss. */
int hid_mapping_store_file_sync(const char *folder);

#endif
