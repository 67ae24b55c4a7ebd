/* doctor.h -- the findings of `kingyoctl doctor`.
 *
 * Each finding names a component, its state and the action to take. The checks are
 * passive. No check claims a device, requests a GPIO line or creates a file. */
#ifndef KINGYO_PLATFORM_CTL_DOCTOR_DOCTOR_H
#define KINGYO_PLATFORM_CTL_DOCTOR_DOCTOR_H

#include <stdbool.h>
#include <stdint.h>
#include <sys/types.h>

#include "platform/config/options.h"
#include "platform/os/directory.h"

/* Most findings of one run. The report states how many further findings were dropped. */
#define DOCTOR_FINDINGS_MAX 256u
#define DOCTOR_TEXT 256u
#define DOCTOR_PATH 512u
#define DOCTOR_GROUPS_MAX 64u

/* Severity of a finding. */
enum doctor_level {
    DOCTOR_FINE = 0,
    DOCTOR_LOOK,  /* The component works or is optional, but the operator should check it. */
    DOCTOR_WRONG, /* A requested or mandatory component will not work. */
};

/* One finding: a component, its state and the action to take. */
struct doctor_finding {
    const char *part;        /* Kind of component ("controller", "line", ...), a static string. */
    uint8_t level;           /* Severity of the finding (enum doctor_level). */
    char what[DOCTOR_TEXT];  /* Name of the component. */
    char state[DOCTOR_TEXT]; /* State of the component. */
    char todo[2u * DOCTOR_TEXT]; /* Action that the operator should take. "" means no action. */
};

/* User account that runs the kiosk. */
struct doctor_user {
    char name[64];
    uid_t id;
    char data[DIRECTORY_PATH_MAX]; /* Default data folder of the user's kiosk. "" means that
                                      there is none. */
    uint32_t group_count;
    gid_t groups[DOCTOR_GROUPS_MAX];
};

/* State of one run of doctor. */
struct doctor {
    const char *root; /* Prefix of all paths. "" means this machine; tests use a folder with the
                         same layout. */
    struct options options;
    struct doctor_user user;
    uint32_t count, more; /* Number of stored findings (`count`) and of findings dropped because the
                             list was full (`more`). */
    struct doctor_finding finding[DOCTOR_FINDINGS_MAX];
};

/* Adds a finding and returns it, so that the caller fills in the texts. Never returns null. A
 * finding beyond DOCTOR_FINDINGS_MAX is counted in `more` and dropped. */
__attribute__((format(printf, 4, 5))) struct doctor_finding *doctor_find(struct doctor *doctor,
                                                                         const char *part,
                                                                         enum doctor_level level,
                                                                         const char *what, ...);

/* Formats the state of a finding as printf() does. */
__attribute__((format(printf, 2, 3))) void doctor_state(struct doctor_finding *finding,
                                                        const char *format, ...);

/* Formats the action of a finding as printf() does. */
__attribute__((format(printf, 2, 3))) void doctor_todo(struct doctor_finding *finding,
                                                       const char *format, ...);

/* ---- Checks, one source file each ------------------------------------------------------------ */

/* Checks the controllers on USB. */
void doctor_usb(struct doctor *doctor);

/* Checks the HID devices on all other buses. */
void doctor_nodes(struct doctor *doctor);

/* Checks the devices that SDL reads: gamepads, mice, touch screens and keyboards. */
void doctor_input(struct doctor *doctor);

/* Checks the GPIO chips and the configured GPIO lines. */
void doctor_gpio(struct doctor *doctor);

/* Returns whether a desktop session controls the input devices and the screen. */
bool doctor_under_a_desktop(const struct doctor *doctor);

/* Checks the graphics cards and the screens connected to them. */
void doctor_screen(struct doctor *doctor);

/* Checks the sound cards and their outputs. */
void doctor_sound(struct doctor *doctor);

/* Checks the data folder, the database and the stored controller mappings. */
void doctor_store(struct doctor *doctor);

/* ---- Permissions ----------------------------------------------------------------------------- */

/* Returns 0 if the user may read and write a path under the root. Otherwise returns ENOENT, EACCES
 * or another errno. */
int doctor_may_use(const struct doctor *doctor, const char *path);

/* Sets the action for a device node that the user may not access. The action is to join the node's
 * group if that group has access. Otherwise, for example if only root has access, the action is
 * `otherwise`. */
void doctor_todo_access(const struct doctor *doctor, struct doctor_finding *finding,
                        const char *path, const char *otherwise);

/* Returns whether a process named `kingyo` runs now. A device that is in use may then be in use by
 * the kiosk. */
bool doctor_kiosk_is_running(const struct doctor *doctor);

/* ---- Small files of /sys --------------------------------------------------------------------- */

/* Copies the first line of a file under the root to `out`, with unprintable characters replaced.
 * Writes "" if there is no such file. */
__attribute__((format(printf, 4, 5))) void doctor_line(const struct doctor *doctor, char *out,
                                                       size_t size, const char *path, ...);

/* Sorted list of names in a folder. */
/* Most names of one kind (video connectors, sound outputs, event nodes). Further names are
 * dropped. */
#define DOCTOR_NAMES_MAX 64u
struct doctor_names {
    uint32_t count;
    char name[DOCTOR_NAMES_MAX][64];
};

/* Fills `out` with the names in the folder `path` that begin with `prefix`. `path` is relative
 * to the root. */
void doctor_list(const struct doctor *doctor, const char *path, const char *prefix,
                 struct doctor_names *out);

/* ---- Reports --------------------------------------------------------------------------------- */

/* Prints the findings as text on standard output. */
void doctor_report_text(const struct doctor *doctor);

/* Prints the findings as JSON on standard output. */
void doctor_report_json(const struct doctor *doctor);

/* Returns the number of stored findings with the severity `level`. */
uint32_t doctor_count(const struct doctor *doctor, enum doctor_level level);

#endif
