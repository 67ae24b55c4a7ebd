/* directory.c -- creates folders as `mkdir -p` does, and checks that each new folder is
 * writable. */
#include "platform/os/directory.h"

#include <errno.h>
#include <fcntl.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

static int make_one(const char *path)
{
    return mkdir(path, 0755) != 0 && errno != EEXIST ? -errno : 0;
}

/* Creates all folders of `path`. `path` is changed during the call and restored before the
 * return. */
static int make_all(char *path)
{
    int error = 0;
    for (char *slash = strchr(path + 1, '/'); slash && !error; slash = strchr(slash + 1, '/')) {
        *slash = '\0';
        error = make_one(path);
        *slash = '/';
    }
    return error ? error : make_one(path);
}

int file_make_folder(const char *path)
{
    char copy[FILE_FOLDER_MAX];
    struct stat status;
    const size_t length = strlen(path);
    if (length == 0 || length >= sizeof copy) {
        return length == 0 ? -ENOENT : -ENAMETOOLONG;
    }
    memcpy(copy, path, length + 1);
    const int error = make_all(copy);
    if (error) {
        return error;
    }
    if (stat(path, &status) == 0 && !S_ISDIR(status.st_mode)) {
        return -ENOTDIR;
    }
    return access(path, W_OK | X_OK) != 0 ? -errno : 0;
}

int file_lock_folder(const char *path)
{
    const int handle = open(path, O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (handle >= 0 && flock(handle, LOCK_EX | LOCK_NB) != 0) {
        const int error = errno;
        close(handle);
        return -error;
    }
    return handle >= 0 ? handle : -errno;
}

void file_default_data(char out[FILE_FOLDER_MAX])
{
    const char *data = getenv("XDG_DATA_HOME");
    const char *home = getenv("HOME");
    out[0] = '\0';
    if (data && data[0] == '/') {
        snprintf(out, FILE_FOLDER_MAX, "%s/kingyo", data);
    } else if (home && home[0] == '/') {
        snprintf(out, FILE_FOLDER_MAX, "%s/.local/share/kingyo", home);
    }
}
