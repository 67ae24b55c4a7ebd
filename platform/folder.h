/* folder.h -- folders for scores and pictures. */
#ifndef KINGYO_PLATFORM_FOLDER_H
#define KINGYO_PLATFORM_FOLDER_H

#define FOLDER_PATH_MAX 1024u

/* Makes the folder `path` and those above it, readable for all, where they are not there yet,
 * and sees that files can be made in it. 0 or a negative errno; -ENAMETOOLONG from
 * FOLDER_PATH_MAX bytes on. */
int folder_make(const char *path);

/* Takes the folder for this process alone, for as long as the handle that it gives is open; whoever
 * ends, ends it. -EWOULDBLOCK: another process has it; else a negative errno. */
int folder_hold(const char *path);

/* Where scores live when nobody says: the user's data folder. "" when there is none. */
void folder_default_data(char out[FOLDER_PATH_MAX]);

#endif
