/* as.c -- runs a command as another user, with only the groups that /etc/group lists for that user.
 *
 * Usage: as USER COMMAND [WORD...]
 *
 * In the guest, the program does what systemd does for a unit with User= and LimitRTPRIO=1, which
 * the USB thread needs (drivers/README.md). Exit code 126 means that the program could not change
 * to the user, and 127 that the command does not exist. Otherwise the exit code is that of the
 * command. */
#include <grp.h>
#include <pwd.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>
#include <unistd.h>

#define GROUPS_MAX 32

/* Reads /etc/passwd itself, because getpwnam() does not work in a statically linked program. */
static struct passwd *find_user(const char *name)
{
    FILE *file = fopen("/etc/passwd", "r");
    struct passwd *user = NULL;
    while (file && (user = fgetpwent(file)) && strcmp(user->pw_name, name) != 0) {
    }
    return user; /* The file stays open, because this process executes the command soon. */
}

static int find_groups(const struct passwd *user, gid_t groups[GROUPS_MAX])
{
    FILE *file = fopen("/etc/group", "r");
    const struct group *group;
    int count = 0;
    groups[count++] = user->pw_gid;
    while (file && (group = fgetgrent(file))) {
        for (char **member = group->gr_mem; *member && count < GROUPS_MAX; member++) {
            if (strcmp(*member, user->pw_name) == 0) {
                groups[count++] = group->gr_gid;
            }
        }
    }
    if (file) {
        fclose(file);
    }
    return count;
}

int main(int argc, char **argv)
{
    gid_t groups[GROUPS_MAX];
    if (argc < 3) {
        fprintf(stderr, "usage: as USER COMMAND [WORD...]\n");
        return 2;
    }
    const struct passwd *user = find_user(argv[1]);
    if (!user) {
        fprintf(stderr, "as: no user %s\n", argv[1]);
        return 126;
    }
    const struct rlimit first = { .rlim_cur = 1, .rlim_max = 1 };
    setrlimit(RLIMIT_RTPRIO, &first);
    setenv("HOME", user->pw_dir, 1);
    setenv("USER", user->pw_name, 1);
    if (setgroups((size_t)find_groups(user, groups), groups) != 0 || setgid(user->pw_gid) != 0 ||
        setuid(user->pw_uid) != 0) {
        perror(argv[1]);
        return 126;
    }
    execvp(argv[2], argv + 2);
    perror(argv[2]);
    return 127;
}
