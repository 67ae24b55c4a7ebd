/* doctor.h -- what `kingyoctl doctor` finds: one line each of what a thing is, how it is, and what
 * to do about it. Looks and never touches: no device is claimed, no line taken, no file made. */
#ifndef KINGYO_PLATFORM_CTL_DOCTOR_H
#define KINGYO_PLATFORM_CTL_DOCTOR_H

#include <stdbool.h>
#include <stdint.h>
#include <sys/types.h>

#include "platform/folder.h"
#include "platform/kiosk/options.h"

#define DOCTOR_FINDINGS_MAX 256u /* A machine with more is told that there is more. */
#define DOCTOR_TEXT 256u
#define DOCTOR_PATH 512u
#define DOCTOR_GROUPS_MAX 64u

enum doctor_level {
    DOCTOR_FINE = 0,
    DOCTOR_LOOK,  /* It works, or need not; but look at it. */
    DOCTOR_WRONG, /* Something that was asked for, or that no stall is without, will not work. */
};

struct doctor_finding {
    const char *part;        /* "controller", "line", ...; static. */
    uint8_t level;           /* enum doctor_level */
    char what[DOCTOR_TEXT];  /* Which one. */
    char state[DOCTOR_TEXT]; /* How it is. */
    char todo[2u * DOCTOR_TEXT]; /* What to do; "": nothing. */
};

/* Whose kiosk it is. */
struct doctor_user {
    char name[64];
    uid_t id;
    char data[FOLDER_PATH_MAX]; /* Where his kiosk keeps its things unless told; "": nowhere. */
    uint32_t group_count;
    gid_t groups[DOCTOR_GROUPS_MAX];
};

struct doctor {
    const char *root; /* "": this machine; else a folder that looks like one. */
    struct options options;
    struct doctor_user user;
    uint32_t count, more; /* Findings, and those that there was no room for. */
    struct doctor_finding finding[DOCTOR_FINDINGS_MAX];
};

/* A new finding, to be filled in; never null. */
__attribute__((format(printf, 4, 5)))
struct doctor_finding *doctor_find(struct doctor *doctor, const char *part,
                                   enum doctor_level level, const char *what, ...);

/* As printf into its state, or into what to do. */
__attribute__((format(printf, 2, 3)))
void doctor_state(struct doctor_finding *finding, const char *format, ...);
__attribute__((format(printf, 2, 3)))
void doctor_todo(struct doctor_finding *finding, const char *format, ...);

/* ---- What it looks at; a file each ---------------------------------------------------------- */

void doctor_usb(struct doctor *doctor);    /* Controllers on USB ... */
void doctor_nodes(struct doctor *doctor);  /* ... and HID devices on anything else. */
void doctor_input(struct doctor *doctor);  /* What SDL plays with: pads, mice, screens, keys. */
void doctor_gpio(struct doctor *doctor);   /* Chips, and the lines that are wired. */
/* Whether a desktop stands between the kiosk and the devices. */
bool doctor_under_a_desktop(const struct doctor *doctor);
void doctor_screen(struct doctor *doctor); /* Graphics cards, what is plugged into them. */
void doctor_sound(struct doctor *doctor);
void doctor_store(struct doctor *doctor);  /* Data folder, database, learned controllers. */

/* ---- Permissions ---------------------------------------------------------------------------- */

/* Whether the user may read and write a path under the root: 0, or ENOENT, EACCES, ... */
int doctor_may_use(const struct doctor *doctor, const char *path);

/* What to do about a node that he may not use: its group, if that may. `otherwise` is for one that
 * is root's alone. */
void doctor_todo_access(const struct doctor *doctor, struct doctor_finding *finding,
                        const char *path, const char *otherwise);

/* Whether a `kingyo` runs now: what is held may be held by it. */
bool doctor_kiosk_runs(const struct doctor *doctor);

/* ---- Small files of /sys -------------------------------------------------------------------- */

/* The first line of a file under the root, printable; "" where there is none. */
__attribute__((format(printf, 4, 5)))
void doctor_line(const struct doctor *doctor, char *out, size_t size, const char *path, ...);

/* Names in a folder under the root that begin so, in their order. */
#define DOCTOR_NAMES_MAX 64u /* Of a kind: sockets, outputs, event nodes. More are left out. */
struct doctor_names {
    uint32_t count;
    char name[DOCTOR_NAMES_MAX][64];
};
void doctor_list(const struct doctor *doctor, const char *path, const char *prefix,
                 struct doctor_names *out);

/* ---- What is told --------------------------------------------------------------------------- */

void doctor_report_text(const struct doctor *doctor);
void doctor_report_json(const struct doctor *doctor);

uint32_t doctor_count(const struct doctor *doctor, enum doctor_level level);

#endif
