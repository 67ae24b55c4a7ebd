/* doctor.h -- the list of findings of `kingyoctl doctor`, and the checks that add findings to the
 * list.
 *
 * Each finding names a component, its state and the action that the operator should take. The
 * checks are passive. No check claims a device, requests a GPIO line or creates a file. */
#pragma once

#include <stdbool.h>
#include <stdint.h>
#include <sys/types.h>

#include "drivers/gpio/gpio_lines.h"
#include "platform/config/options.h"
#include "platform/os/file.h"

/* Maximum number of stored findings. The report prints how many further findings were dropped. */
#define DOCTOR_FINDINGS_MAX 256u
#define DOCTOR_TEXT 256u
#define DOCTOR_PATH 512u
#define DOCTOR_GROUPS_MAX 64u

/* Severity of a finding. DOCTOR_FINE means that the component works. */
enum doctor_level {
    DOCTOR_FINE = 0,
    /* The component works or is optional, but the operator should check the component. */
    DOCTOR_CHECK,
    DOCTOR_WRONG, /* A requested or mandatory component does not work for the kiosk. */
};

/* One finding: a component, its state and the action to take. */
struct doctor_finding {
    /* Kind of the component, for example "controller" or "line". A static string. */
    const char *part;
    uint8_t level;           /* Severity of the finding (enum doctor_level). */
    char what[DOCTOR_TEXT];  /* Name of the component, for example a device name or a path. */
    char state[DOCTOR_TEXT]; /* State of the component as one sentence or phrase. */
    /* Action that the operator should take. "" means that no action is needed. */
    char todo[2u * DOCTOR_TEXT];
};

/* User account under which the kiosk runs. */
struct doctor_user {
    char name[64];
    uid_t id;
    /* Path of the data folder that a kiosk under this account uses by default. "" means that the
     * account has no default data folder, because it has no home folder. */
    char data[FILE_FOLDER_MAX];
    uint32_t group_count;
    gid_t groups[DOCTOR_GROUPS_MAX];
};

/* State of one run of `kingyoctl doctor`. */
struct doctor {
    /* Prefix of all paths: "" for this machine, or a test folder with the same layout. */
    const char *root;
    struct options options;
    struct doctor_user user;
    /* `count` is the number of stored findings. `more` is the number of findings that were dropped
     * because the list was full. */
    uint32_t count, more;
    struct doctor_finding finding[DOCTOR_FINDINGS_MAX];
};

/* Adds a finding to the list and returns the finding, so that the caller can fill in the state and
 * the action. Never returns null. If the list is full, increments `more` and returns a scratch
 * finding. */
__attribute__((format(printf, 4, 5))) struct doctor_finding *doctor_find(struct doctor *doctor,
                                                                         const char *part,
                                                                         enum doctor_level level,
                                                                         const char *what, ...);

/* Sets the state of a finding to a text that is formatted as by printf(). */
__attribute__((format(printf, 2, 3))) void doctor_state(struct doctor_finding *finding,
                                                        const char *format, ...);

/* Sets the action of a finding to a text that is formatted as by printf(). */
__attribute__((format(printf, 2, 3))) void doctor_todo(struct doctor_finding *finding,
                                                       const char *format, ...);

/* ---- Checks, each in its own source file ----------------------------------------------------- */

/* Checks every USB device except hubs, and every controller that the options name. */
void doctor_usb(struct doctor *doctor);

/* Checks the HID devices on all buses other than USB. */
void doctor_nodes(struct doctor *doctor);

/* Checks the devices that SDL reads: gamepads, mice, touch screens and keyboards. */
void doctor_input(struct doctor *doctor);

/* Checks the GPIO chips and the GPIO lines that the kiosk's options configure. */
void doctor_gpio(struct doctor *doctor);

/* Checks the memory card. On a Raspberry Pi, also checks throttling, the supply voltage, the HDMI
 * socket and the names of the header's lines. */
void doctor_board(struct doctor *doctor);

/* Checks the graphics cards, and the screens that are connected to the graphics cards. */
void doctor_screen(struct doctor *doctor);

/* Checks the sound cards and their sound outputs. */
void doctor_sound(struct doctor *doctor);

/* Checks the data folder, the database and the stored controller mappings. */
void doctor_store(struct doctor *doctor);

/* ---- GPIO lines ------------------------------------------------------------------------------ */

/* Maximum number of lines in the list. A Raspberry Pi 5 has 130 lines on 14 chips. */
#define GPIO_CENSUS_MAX 1024u

/* State of one GPIO line, as the kernel reports it. */
struct gpio_seen {
    char chip[GPIO_TEXT_SIZE]; /* Label of the GPIO chip to which the line belongs. */
    char name[GPIO_TEXT_SIZE];
    char consumer[GPIO_TEXT_SIZE];
    uint32_t offset;
    bool is_used;
};

/* List of the GPIO lines of all chips. `more` is the number of lines that were dropped because the
 * list was full. */
struct gpio_census {
    uint32_t count, more;
    struct gpio_seen line[GPIO_CENSUS_MAX];
};

/* Fills `wires` with the lines that the kiosk's options configure. A role without a line is not
 * wired. */
void doctor_wires(const struct doctor *doctor, struct gpio_wire wires[GPIO_ROLE_COUNT]);

/* Adds a finding for the GPIO line that `wire` configures for `role`. The finding reports whether
 * the line exists in `census`, is unused, and is the only line with its name. */
void doctor_gpio_wire(struct doctor *doctor, enum gpio_role role, const struct gpio_wire *wire,
                      const struct gpio_census *census);

/* ---- Access permissions ---------------------------------------------------------------------- */

/* Checks whether the kiosk's user may read and write `path`, which is relative to the root. Returns
 * 0 if the user may. Otherwise returns ENOENT, EACCES or another errno. */
int doctor_access_error(const struct doctor *doctor, const char *path);

/* Sets the action of a finding for a device node that the kiosk's user may not access. If the group
 * of the node has access, the action is to join the group. Otherwise, for example if only root has
 * access, the action is the text `otherwise`. */
void doctor_todo_access(const struct doctor *doctor, struct doctor_finding *finding,
                        const char *path, const char *otherwise);

/* Returns true if a process named `kingyo` is running. The caller then reports that a busy device
 * may be in use by the kiosk. */
bool doctor_kiosk_is_running(const struct doctor *doctor);

/* ---- Reading the small files of /sys --------------------------------------------------------- */

/* Copies the first line of a file to `out` and replaces unprintable characters. The path is
 * relative to the root. Writes "" if the file does not exist. */
__attribute__((format(printf, 4, 5))) void doctor_line(const struct doctor *doctor, char *out,
                                                       size_t size, const char *path, ...);

/* Capacity of struct doctor_names, which is a sorted list of the names in a folder. Further names
 * are dropped. */
#define DOCTOR_NAMES_MAX 256u
struct doctor_names {
    uint32_t count;
    char name[DOCTOR_NAMES_MAX][256];
};

/* Fills `out` with the names in the folder `path` that begin with `prefix`, in the order of
 * strverscmp(). The path is relative to the root. */
void doctor_list(const struct doctor *doctor, const char *path, const char *prefix,
                 struct doctor_names *out);

/* ---- Output of the findings ------------------------------------------------------------------ */

/* Prints the findings as text on standard output. */
void doctor_report_text(const struct doctor *doctor);

/* Prints the findings as JSON on standard output. */
void doctor_report_json(const struct doctor *doctor);

/* Returns the number of stored findings whose severity is `level`. */
uint32_t doctor_count(const struct doctor *doctor, enum doctor_level level);
