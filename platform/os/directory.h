/* directory.h -- creates and locks the folders of scores and pictures. */
#ifndef KINGYO_PLATFORM_OS_DIRECTORY_H
#define KINGYO_PLATFORM_OS_DIRECTORY_H

#define DIRECTORY_PATH_MAX 1024u

/* Creates the folder `path` and its parents, readable for all, and checks that files can be created
 * in it. Returns 0 or a negative errno: -ENAMETOOLONG if the path has DIRECTORY_PATH_MAX bytes or
 * more, -ENOTDIR if `path` is not a folder. */
int directory_make(const char *path);

/* Locks the folder for this process. Returns a handle; the lock lasts until the caller closes the
 * handle or the process ends. Returns -EWOULDBLOCK if another process holds the lock, or another
 * negative errno. */
int directory_lock(const char *path);

/* Writes the default folder of the scores, in the user's data folder. Writes "" if there is
 * none. */
void directory_default_data(char out[DIRECTORY_PATH_MAX]);

#endif
