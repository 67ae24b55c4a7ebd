/* hid_book_file.h -- the book's files: read whole, and written whole or not at all. All of it may
 * wait for a card, so it is for the start and for the book's thread. Each gives 0 or errno. */
#ifndef KINGYO_DRIVERS_HID_BOOK_FILE_H
#define KINGYO_DRIVERS_HID_BOOK_FILE_H

#include "drivers/hid_book.h"

/* Opens a file in the data folder for reading, without blocking. Returns the descriptor, or -1 and
 * sets errno: ELOOP for a symbolic link, ENOTSUP for anything else that is not a regular file. */
int hid_book_file_open(const char *path);

/* EFBIG: longer than any file of ours. A pipe that has such a name is not waited for. */
int hid_book_file_read(const char *path, char text[HID_BOOK_TEXT_SIZE]);

/* Written beside the file and put in its place, so that it is the old one or the new one. */
int hid_book_file_replace(const char *path, const char *text);

/* A name in a folder lasts once the folder is on the card. */
int hid_book_file_sync(const char *folder);

#endif
