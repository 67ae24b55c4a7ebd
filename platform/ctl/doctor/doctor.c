/* doctor.c -- the command `kingyoctl doctor`.
 *
 * The command checks devices, permissions, interfering drivers, the display, sound and the
 * database. Each finding is printed on one line with the action that solves the problem. */
#include "platform/ctl/doctor/doctor.h"

#include <errno.h>
#include <grp.h>
#include <pwd.h>
#include <stdio.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "platform/config/config_file.h"
#include "platform/ctl/lib/ctl.h"
#include "platform/os/directory.h"
#include "platform/os/print.h"
#include "platform/os/regular_file.h"

/* Maximum number of words on the command line. The kiosk accepts fewer GPIO lines and controllers
 * than this limit. */
#define WORDS_MAX 160

static const char name[] = "doctor";
static struct doctor doctor;

struct doctor_words {
    const char *root, *user;
    int as_json;
};

/* ---- User account of the kiosk --------------------------------------------------------------- */

/* Sets the default data folder of the kiosk, which is below the home folder `home`. */
static void take_home(struct doctor_user *user, const char *home)
{
    if (home && home[0] == '/' && home[1]) {
        snprintf(user->data, sizeof user->data, "%.900s/.local/share/kingyo", home);
    }
}

static enum exit_code take_user(struct doctor_user *user, const char *wanted)
{
    const struct passwd *entry = wanted ? getpwnam(wanted) : getpwuid(geteuid());
    int count = DOCTOR_GROUPS_MAX;
    if (!entry && wanted) {
        print_error("kingyoctl doctor: --user %s: there is no such user; board/sysusers makes "
                    "'kingyo'",
                    wanted);
        return EXIT_BAD_DATA;
    }
    user->id = entry ? entry->pw_uid : geteuid();
    user->data[0] = '\0';
    if (!wanted || user->id == geteuid()) {
        directory_default_data(user->data);
    } else {
        take_home(user, entry->pw_dir);
    }
    snprintf(user->name, sizeof user->name, "%s", entry ? entry->pw_name : "this user");
    if (entry && getgrouplist(entry->pw_name, entry->pw_gid, user->groups, &count) < 0) {
        count = DOCTOR_GROUPS_MAX; /* The account has more groups than the array. Only the first
                                      DOCTOR_GROUPS_MAX groups are checked. */
    }
    user->group_count = entry ? (uint32_t)count : 0;
    return EXIT_OK;
}

/* ---- Options of the kiosk -------------------------------------------------------------------- */

static void doctor_warn(const char *line)
{
    struct doctor_finding *finding =
        doctor_find(&doctor, "config", DOCTOR_WRONG, "%s", doctor.options.config);
    doctor_state(finding, "%s", line);
    doctor_todo(finding, "mend that line: the kiosk passes it over; 'kingyoctl config defaults' "
                         "lists the keys");
}

/* Reads the options of the kiosk as the kiosk's main() does. The configuration file is read first,
 * and the command line overrides the file. Returns EXIT_OK. After an error, prints one line and
 * returns another exit code. */
static enum exit_code read_config(int argc, const char *const *argv)
{
    char path[OPTIONS_PATH_MAX], error[OPTIONS_ERROR_MAX];
    memcpy(path, doctor.options.config, sizeof path);
    doctor.options = (struct options){ 0 };
    memcpy(doctor.options.config, path, sizeof path);
    const int failed = config_file_read(&doctor.options, path, doctor_warn);
    if (failed) {
        print_error("kingyoctl doctor: %s: %s", path, regular_file_error(-failed));
        return failed == -EFBIG ? EXIT_BAD_DATA : EXIT_IO;
    }
    if (options_parse(&doctor.options, argc, argv, error)) {
        return ctl_usage(name, "%s", error);
    }
    if (doctor_count(&doctor, DOCTOR_WRONG) == 0) {
        doctor_state(doctor_find(&doctor, "config", DOCTOR_FINE, "%s", path), "every line is used");
    }
    return EXIT_OK;
}

/* Selects the default configuration file if the command line names no file, as the kiosk does. */
static void take_default_config(void)
{
    char path[OPTIONS_PATH_MAX];
    snprintf(path, sizeof path, "%.900s" CONFIG_FILE_DEFAULT, doctor.root);
    if (!doctor.options.config[0] && access(path, F_OK) == 0) {
        memcpy(doctor.options.config, path, sizeof path);
    }
}

static enum exit_code read_options(int argc, const char *const *argv)
{
    char error[OPTIONS_ERROR_MAX];
    if (options_parse(&doctor.options, argc, argv, error)) {
        return ctl_usage(name, "%s", error);
    }
    take_default_config();
    const enum exit_code code = doctor.options.config[0] ? read_config(argc, argv) : EXIT_OK;
    if (code == EXIT_OK && !doctor.options.data[0]) {
        memcpy(doctor.options.data, doctor.user.data, sizeof doctor.user.data);
    }
    return code;
}

/* Separates the options of `kingyoctl doctor` from the options of the kiosk. `rest` receives the
 * kiosk's options after a program name, as main() expects its arguments. */
static enum exit_code take_words(struct doctor_words *words, int argc, const char *const *argv,
                                 const char **rest, int *rest_count)
{
    *rest_count = 0;
    rest[(*rest_count)++] = "kingyo";
    for (int i = 0; i < argc; i++) {
        const char **value = strcmp(argv[i], "--root") == 0   ? &words->root
                             : strcmp(argv[i], "--user") == 0 ? &words->user
                                                              : NULL;
        if (strcmp(argv[i], "--json") == 0) {
            words->as_json = 1;
        } else if (value && i + 1 < argc) {
            *value = argv[++i];
        } else if (value) {
            return ctl_usage(name, "%s needs a value", argv[i]);
        } else if (*rest_count < WORDS_MAX) {
            rest[(*rest_count)++] = argv[i];
        } else {
            return ctl_usage(name, "too many words");
        }
    }
    return EXIT_OK;
}

/* ---- Running the checks ---------------------------------------------------------------------- */

/* Sets the root folder, which is the prefix of all paths. A root folder that does not exist is an
 * error. Otherwise a mistyped folder would produce the findings of a machine without devices.
 * Returns EXIT_OK. After an error, prints one line and returns EXIT_IO. */
static enum exit_code take_root(const char *root)
{
    struct stat about;
    const int failed = !root                    ? 0
                       : stat(root, &about)     ? errno
                       : S_ISDIR(about.st_mode) ? 0
                                                : ENOTDIR;
    if (failed) {
        print_error("kingyoctl doctor: --root %s: %s", root, strerror(failed));
        return EXIT_IO;
    }
    doctor.root = root ? root : "";
    return EXIT_OK;
}

static void doctor_run_checks(void)
{
    doctor_usb(&doctor);
    doctor_nodes(&doctor);
    doctor_input(&doctor);
    doctor_gpio(&doctor);
    doctor_screen(&doctor);
    doctor_sound(&doctor);
    doctor_store(&doctor);
}

static enum exit_code doctor_run(int argc, const char *const *argv)
{
    struct doctor_words words = { .root = NULL };
    const char *rest[WORDS_MAX];
    int rest_count;
    enum exit_code code = take_words(&words, argc, argv, rest, &rest_count);
    code = code == EXIT_OK ? take_root(words.root) : code;
    code = code == EXIT_OK ? take_user(&doctor.user, words.user) : code;
    code = code == EXIT_OK ? read_options(rest_count, rest) : code;
    if (code != EXIT_OK) {
        return code;
    }
    doctor_run_checks();
    (words.as_json ? doctor_report_json : doctor_report_text)(&doctor);
    return doctor_count(&doctor, DOCTOR_WRONG) > 0 ? EXIT_NOT_SO : EXIT_OK;
}

const struct ctl_command ctl_doctor = {
    .name = name,
    .summary = "what is plugged in, what is in the way, and what to do about it",
    .usage = "  kingyoctl doctor [--json] [--user NAME] [--root FOLDER] [KIOSK OPTION...]\n\n"
             "Looks at controllers, GPIO lines, permissions, drivers, display, sound, data\n"
             "folder and database, and touches nothing. Each finding is a line: fine, look (it\n"
             "works, but look at it) or WRONG, with what to do below it.\n\n"
             "  --user NAME     for whom: the kiosk's user (kingyo) may do less than you, and has\n"
             "                  a data folder of its own\n"
             "  --root FOLDER   looks at the /sys, /dev, /proc and data folder in FOLDER\n"
             "  --json          for programs: {findings: [{part, level, what, state, todo}],\n"
             "                  more, fine, look, wrong}\n\n"
             "Options of the kiosk count as they would for it: --config FILE, --data FOLDER,\n"
             "--usb VVVV:PPPP, --line ROLE=WIRE. Exit code 1: something is wrong.\n",
    .run = doctor_run,
};
