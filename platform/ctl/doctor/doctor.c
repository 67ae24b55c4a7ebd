/* doctor.c -- the command `kingyoctl doctor`.
 *
 * The command checks devices, permissions, interfering drivers, the display, sound and the
 * database. Each finding is printed on one line with the action that solves the problem. */
#include "platform/ctl/doctor/doctor.h"

#include <errno.h>
#include <grp.h>
#include <pwd.h>
#include <stddef.h>
#include <stdio.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "platform/config/config_file.h"
#include "platform/ctl/lib/ctl.h"
#include "platform/os/file.h"
#include "platform/os/print.h"

static const char name[] = "doctor";
static struct doctor doctor;

struct doctor_words {
    struct options options; /* Options with which the kiosk would run. */
    const char *root, *user;
    bool as_json;
};

/* ---- User account of the kiosk --------------------------------------------------------------- */

static enum exit_code take_user(struct doctor_user *user, const char *wanted)
{
    const struct passwd *entry = wanted ? getpwnam(wanted) : getpwuid(geteuid());
    int count = DOCTOR_GROUPS_MAX;
    if (!entry && wanted) {
        return print_fail(
            EXIT_BAD_DATA,
            "kingyoctl doctor: --user %s: there is no such user; board/sysusers makes "
            "'kingyo'",
            wanted);
    }
    user->id = entry ? entry->pw_uid : geteuid();
    user->data[0] = '\0';
    /* The home folder of the account that board/sysusers makes is the data folder of the service.
     * Other accounts have a data folder below their home folder. */
    const bool is_service =
        wanted && entry->pw_dir && strcmp(entry->pw_dir, "/var/lib/kingyo") == 0;
    if (!wanted || (user->id == geteuid() && !is_service)) {
        file_default_data(user->data);
    } else if (entry->pw_dir && entry->pw_dir[0] == '/' && entry->pw_dir[1]) {
        snprintf(user->data, sizeof user->data, "%.900s%s", entry->pw_dir,
                 is_service ? "" : "/.local/share/kingyo");
    }
    snprintf(user->name, sizeof user->name, "%s", entry ? entry->pw_name : "this user");
    if (entry && getgrouplist(entry->pw_name, entry->pw_gid, user->groups, &count) < 0) {
        /* The account has more groups than the array has elements. Only the first DOCTOR_GROUPS_MAX
         * groups are checked. */
        count = DOCTOR_GROUPS_MAX;
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
    doctor_todo(finding, "correct the line, which the kiosk skips; 'kingyoctl config defaults' "
                         "lists the keys");
}

#define AT(member) .offset = offsetof(struct doctor_words, member)

static const struct option options[] = {
    { "user", "NAME",
      "user account of the kiosk, which has its own permissions and data folder; the default is "
      "your account",
      OPTION_TEXT, AT(user), .expects = "a user name" },
    { "root", "FOLDER", "inspect /sys, /dev, /proc and the data folder below FOLDER", OPTION_TEXT,
      AT(root) },
    { "json", NULL,
      "print JSON: {findings: [{part, level, what, state, todo}], more, fine, check, "
      "wrong}",
      OPTION_FLAG, AT(as_json) },
};

static const struct option_table own_table = OPTION_TABLE(options, NULL);
static const struct option_table whole_table = OPTION_TABLE(options, &options_table);

/* Parses the options of `kingyoctl doctor` and of the kiosk. Returns EXIT_OK. After an error,
 * prints one line and returns EXIT_USAGE. */
static enum exit_code read_words(struct doctor_words *words, int argc, const char *const *argv)
{
    char error[OPTIONS_ERROR_MAX];
    const enum exit_code code = ctl_options(name, &whole_table, 0, words, argc, argv);
    return code == EXIT_OK && options_check(&words->options, error) ? ctl_usage(name, "%s", error)
                                                                    : code;
}

/* Reads the options of the kiosk as the kiosk's main() does. The configuration file is read first,
 * and the command line overrides the file. Selects the default configuration file if the command
 * line names no file. Returns EXIT_OK. After an error, prints one line and returns another exit
 * code. */
static enum exit_code read_config(struct doctor_words *words, int argc, const char *const *argv)
{
    char path[OPTIONS_PATH_MAX];
    snprintf(path, sizeof path, "%.900s" CONFIG_FILE_DEFAULT, doctor.root);
    if (words->options.config[0]) {
        memcpy(path, words->options.config, sizeof path);
    } else if (access(path, F_OK) != 0) {
        return EXIT_OK;
    }
    words->options = (struct options){ 0 };
    memcpy(words->options.config, path, sizeof path);
    /* The path of the configuration file is stored first, because doctor_warn() prints it. */
    memcpy(doctor.options.config, path, sizeof path);
    const int failed = config_file_read(&words->options, path, doctor_warn);
    if (failed) {
        print_error("kingyoctl doctor: %s: %s", path, file_error(-failed));
        return failed == -EFBIG ? EXIT_BAD_DATA : EXIT_IO;
    }
    const enum exit_code code = read_words(words, argc, argv);
    if (code == EXIT_OK && doctor_count(&doctor, DOCTOR_WRONG) == 0) {
        doctor_state(doctor_find(&doctor, "config", DOCTOR_FINE, "%s", path), "every line is used");
    }
    return code;
}

/* ---- Running the checks ---------------------------------------------------------------------- */

static void (*const checks[])(struct doctor *doctor) = {
    doctor_usb,   doctor_nodes,  doctor_input, doctor_gpio,
    doctor_board, doctor_screen, doctor_sound, doctor_store,
};

static enum exit_code doctor_run(int argc, const char *const *argv)
{
    static struct doctor_words words;
    enum exit_code code = read_words(&words, argc, argv);
    if (code == EXIT_OK && words.root) {
        /* A root folder that does not exist is an error. Otherwise a mistyped folder would produce
         * the findings of a machine without devices. */
        struct stat about;
        const int failed = stat(words.root, &about) ? errno : S_ISDIR(about.st_mode) ? 0 : ENOTDIR;
        if (failed) {
            return print_fail(EXIT_IO, "kingyoctl doctor: --root %s: %s", words.root,
                              strerror(failed));
        }
    }
    doctor.root = words.root ? words.root : "";
    code = code == EXIT_OK ? take_user(&doctor.user, words.user) : code;
    code = code == EXIT_OK ? read_config(&words, argc, argv) : code;
    if (code != EXIT_OK) {
        return code;
    }
    doctor.options = words.options;
    if (!doctor.options.data[0]) {
        memcpy(doctor.options.data, doctor.user.data, sizeof doctor.user.data);
    }
    for (size_t i = 0; i < sizeof checks / sizeof checks[0]; i++) {
        checks[i](&doctor);
    }
    (words.as_json ? doctor_report_json : doctor_report_text)(&doctor);
    return doctor_count(&doctor, DOCTOR_WRONG) > 0 ? EXIT_NOT_SO : EXIT_OK;
}

const struct ctl_command ctl_doctor = {
    .name = name,
    .summary = "checks what is connected, what interferes, and how to solve each problem",
    .usage = "  kingyoctl doctor [--json] [--user NAME] [--root FOLDER] [KIOSK OPTION...]\n\n"
             "Checks controllers, GPIO lines, permissions, drivers, board, display, sound, data\n"
             "folder and database, and changes nothing. Each finding is a line: fine, check (it\n"
             "works, but should be inspected) or WRONG, with the action to take below it.\n",
    .options = &own_table,
    .notes = "Options of the kiosk have the same effect as for the kiosk, for example\n"
             "--config FILE, --data FOLDER, --usb VVVV:PPPP, --line ROLE=LINE. Exit code 1:\n"
             "something is wrong.\n",
    .run = doctor_run,
};
