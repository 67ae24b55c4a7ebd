/* directory.h -- creates and locks the folders for the store and for pictures. */
#ifndef KINGYO_PLATFORM_OS_DIRECTORY_H
#define KINGYO_PLATFORM_OS_DIRECTORY_H

#define FILE_FOLDER_MAX 1024u

/* Creates the folder `path` and its parents with mode 0755, and checks that files can be created in
 * `path`. Returns 0 or a negative errno: -ENAMETOOLONG if `path` has FILE_FOLDER_MAX bytes or
 * more, -ENOTDIR if `path` is not a folder. */
int file_make_folder(const char *path);

/* Locks the folder `path` for the calling process. Returns a descriptor. The lock lasts until the
 * caller closes the descriptor or the process ends. Returns -EWOULDBLOCK if another process holds
 * the lock, or another negative errno. */
int file_lock_folder(const char *path);

/* Writes the default path of the store, which is in the user's data folder. Writes "" if the user
 * has no data folder. */
void file_default_data(char out[FILE_FOLDER_MAX]);

#endif
