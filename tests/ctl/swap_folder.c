/* swap_folder.c -- a library that is loaded before libc into kingyoctl (LD_PRELOAD). At the first
 * fchmod() call it renames the folder SWAP_FOLDER to SWAP_FOLDER.moved, and puts a symbolic link to
 * SWAP_TARGET in its place. */
#include <stdio.h>
#include <stdlib.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

int fchmod(int fd, mode_t mode)
{
    static int is_done;
    const char *folder = getenv("SWAP_FOLDER"), *target = getenv("SWAP_TARGET");
    char moved[4096];
    if (!is_done && folder && target) {
        is_done = 1;
        snprintf(moved, sizeof moved, "%s.moved", folder);
        if (rename(folder, moved) != 0 || symlink(target, folder) != 0) {
            abort();
        }
    }
    return (int)syscall(SYS_fchmod, fd, mode);
}
