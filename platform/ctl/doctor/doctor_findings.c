/* doctor_findings.c -- stores and prints the findings, checks the access of the kiosk's user to a
 * path, and reads the small files of /sys. */
#include "platform/ctl/doctor/doctor.h"

#include <dirent.h>
#include <errno.h>
#include <grp.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "core/base/panic.h"
#include "core/base/printable.h"
#include "platform/os/json.h"
#include "platform/os/print.h"
#include "platform/os/file.h"

static const char *const level_words[] = { "fine", "check", "WRONG" };

struct doctor_finding *doctor_find(struct doctor *doctor, const char *part, enum doctor_level level,
                                   const char *what, ...)
{
    /* Returned in place of a finding when the list is full. Its content is never printed. */
    static struct doctor_finding spare;
    const bool has_room = doctor->count < DOCTOR_FINDINGS_MAX;
    CORE_ASSERT(part && level <= DOCTOR_WRONG);
    struct doctor_finding *finding = has_room ? &doctor->finding[doctor->count++] : &spare;
    doctor->more += !has_room;
    *finding = (struct doctor_finding){ .part = part, .level = (uint8_t)level };
    va_list arguments;
    va_start(arguments, what);
    vsnprintf(finding->what, sizeof finding->what, what, arguments);
    va_end(arguments);
    return finding;
}

void doctor_state(struct doctor_finding *finding, const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(finding->state, sizeof finding->state, format, arguments);
    va_end(arguments);
}

void doctor_todo(struct doctor_finding *finding, const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(finding->todo, sizeof finding->todo, format, arguments);
    va_end(arguments);
}

uint32_t doctor_count(const struct doctor *doctor, enum doctor_level level)
{
    uint32_t count = 0;
    CORE_ASSERT(doctor->count <= DOCTOR_FINDINGS_MAX);
    for (uint32_t i = 0; i < doctor->count; i++) {
        count += doctor->finding[i].level == level;
    }
    return count;
}

/* ---- Output as text -------------------------------------------------------------------------- */

void doctor_report_text(const struct doctor *doctor)
{
    for (uint32_t i = 0; i < doctor->count; i++) {
        const struct doctor_finding *finding = &doctor->finding[i];
        print_line(stdout, "%-5s  %-10s  %s: %s", level_words[finding->level], finding->part,
                   finding->what, finding->state);
        if (finding->todo[0]) {
            print_line(stdout, "       %-10s  -> %s", "", finding->todo);
        }
    }
    if (doctor->more > 0) {
        printf("%u further findings were dropped because the list is full\n", doctor->more);
    }
    printf("%u fine, %u to check, %u wrong\n", doctor_count(doctor, DOCTOR_FINE),
           doctor_count(doctor, DOCTOR_CHECK), doctor_count(doctor, DOCTOR_WRONG));
}

/* ---- Output as JSON -------------------------------------------------------------------------- */

void doctor_report_json(const struct doctor *doctor)
{
    static const char *const keys[] = { "fine", "check", "wrong" };
    struct json json = { .file = stdout };
    json_print(&json, "{findings: [");
    for (uint32_t i = 0; i < doctor->count; i++) {
        const struct doctor_finding *finding = &doctor->finding[i];
        json_print(&json, "\n{part: %s, level: %s, what: %s, state: %s, todo: %s}", finding->part,
                   keys[finding->level], finding->what, finding->state, finding->todo);
    }
    json_print(&json, "\n], more: %u", doctor->more);
    for (enum doctor_level level = DOCTOR_FINE; level <= DOCTOR_WRONG; level++) {
        json_value(&json, keys[level], "%u", doctor_count(doctor, level));
    }
    json_close(&json, '}');
    json_end(&json);
}

/* Returns the path `path` below the root in a static buffer, which the next call overwrites. */
static const char *below_root(const struct doctor *doctor, const char *path)
{
    static char whole[DOCTOR_PATH + OPTIONS_PATH_MAX];
    snprintf(whole, sizeof whole, "%s%s", doctor->root, path);
    return whole;
}

int doctor_access_error(const struct doctor *doctor, const char *path)
{
    const char *whole = below_root(doctor, path);
    struct stat about;
    if (stat(whole, &about)) {
        return errno;
    }
    if (doctor->user.id == geteuid() && access(whole, R_OK | W_OK) == 0) {
        /* The user has access, even if the mode bits allow no access. The reason is an access
         * control list: for example, a user who is logged in at the machine gets access to many
         * devices by such lists. */
        return 0;
    }
    /* The check uses the mode bits of one class only, as the kernel does: of the owner, otherwise
     * of the group, otherwise of others. */
    bool is_member = false;
    CORE_ASSERT(doctor->user.group_count <= DOCTOR_GROUPS_MAX);
    for (uint32_t i = 0; i < doctor->user.group_count; i++) {
        is_member |= doctor->user.groups[i] == about.st_gid;
    }
    const mode_t both = S_IROTH | S_IWOTH;
    const mode_t bits = doctor->user.id == about.st_uid ? about.st_mode >> 6
                        : is_member                     ? about.st_mode >> 3
                                                        : about.st_mode;
    return doctor->user.id == 0 || (bits & both) == both ? 0 : EACCES;
}

void doctor_todo_access(const struct doctor *doctor, struct doctor_finding *finding,
                        const char *path, const char *otherwise)
{
    struct stat about;
    const mode_t group_may = S_IRGRP | S_IWGRP;
    if (stat(below_root(doctor, path), &about)) {
        doctor_todo(finding, "%s does not exist: mount /dev with devtmpfs and start udev", path);
        return;
    }
    const struct group *group = getgrgid(about.st_gid);
    if (about.st_gid != 0 && (about.st_mode & group_may) == group_may && group) {
        doctor_todo(finding, "sudo usermod -aG %s %s, then log in again or restart the kiosk",
                    group->gr_name, doctor->user.name);
    } else {
        doctor_todo(finding, "%s", otherwise);
    }
}

void doctor_line(const struct doctor *doctor, char *out, size_t size, const char *path, ...)
{
    char whole[DOCTOR_PATH + OPTIONS_PATH_MAX];
    CORE_ASSERT(size > 0);
    const int used = snprintf(whole, sizeof whole, "%s", doctor->root);
    va_list arguments;
    va_start(arguments, path);
    vsnprintf(whole + used, sizeof whole - (size_t)used, path, arguments);
    va_end(arguments);
    file_first_line(whole, out, size);
    printable(out);
}

bool doctor_kiosk_is_running(const struct doctor *doctor)
{
    char name[32];
    bool runs = false;
    DIR *folder = opendir(below_root(doctor, "/proc"));
    const struct dirent *entry;
    while (folder && !runs && (entry = readdir(folder))) {
        doctor_line(doctor, name, sizeof name, "/proc/%.32s/comm", entry->d_name);
        runs = entry->d_name[0] >= '0' && entry->d_name[0] <= '9' && strcmp(name, "kingyo") == 0;
    }
    if (folder) {
        closedir(folder);
    }
    return runs;
}

static int by_name(const void *left, const void *right)
{
    return strverscmp(left, right);
}

void doctor_list(const struct doctor *doctor, const char *path, const char *prefix,
                 struct doctor_names *out)
{
    DIR *folder = opendir(below_root(doctor, path));
    const struct dirent *entry;
    out->count = 0;
    while (folder && out->count < DOCTOR_NAMES_MAX && (entry = readdir(folder))) {
        if (strncmp(entry->d_name, prefix, strlen(prefix)) == 0) {
            snprintf(out->name[out->count++], sizeof out->name[0], "%s", entry->d_name);
        }
    }
    if (folder) {
        closedir(folder);
    }
    qsort(out->name, out->count, sizeof out->name[0], by_name);
}
