/* doctor_peripherals.c -- checks the devices that SDL uses: gamepads, mice, touch screens and
 * keyboards, graphics cards, video connectors, sound cards and sound outputs.
 *
 * Without a desktop session, SDL reads input devices directly from the kernel's event nodes
 * /dev/input/eventN. */
#include "platform/ctl/doctor/doctor.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "core/base/panic.h"
#include "platform/board.h"
#include "platform/os/file.h"

/* Adds a finding for a device node. `what` is the text of the finding. If the kiosk's user has no
 * access, the finding contains the command that gives access through the group `group`. `is_needed`
 * is false if a desktop session opens the node for the kiosk. */
static void check_node(struct doctor *doctor, const char *part, const char *what, const char *path,
                       const char *group, bool is_needed)
{
    CORE_ASSERT(part && what && path && group);
    char join[DOCTOR_TEXT];
    const int error = doctor_access_error(doctor, path);
    struct doctor_finding *finding = doctor_find(doctor, part,
                                                 !error      ? DOCTOR_FINE
                                                 : is_needed ? DOCTOR_WRONG
                                                             : DOCTOR_CHECK,
                                                 "%s", what);
    const char *verb = strcmp(group, "input") == 0 ? "read" : "use";
    if (!error) {
        doctor_state(finding, "%s may %s it", doctor->user.name, verb);
        return;
    }
    doctor_state(finding, "%s may not %s it: %s%s", doctor->user.name, verb, strerror(error),
                 is_needed ? "" : ", but the desktop does");
    if (is_needed) {
        snprintf(join, sizeof join,
                 "sudo usermod -aG %s %s, then log in again or restart the kiosk", group,
                 doctor->user.name);
        doctor_todo_access(doctor, finding, path, join);
    }
}

/* Returns true if a desktop session controls the input devices and the screen. */
static bool is_under_a_desktop(const struct doctor *doctor)
{
    return !doctor->root[0] && (getenv("DISPLAY") || getenv("WAYLAND_DISPLAY"));
}

void doctor_input(struct doctor *doctor)
{
    static struct doctor_names events;
    char name[DOCTOR_TEXT], path[DOCTOR_PATH], what[2u * DOCTOR_PATH];
    doctor_list(doctor, "/sys/class/input", "event", &events);
    for (uint32_t i = 0; i < events.count; i++) {
        snprintf(path, sizeof path, "/dev/input/%s", events.name[i]);
        doctor_line(doctor, name, sizeof name, "/sys/class/input/%s/device/name", events.name[i]);
        snprintf(what, sizeof what, "%s, %s", name[0] ? name : "without a name", path);
        check_node(doctor, "input", what, path, "input", !is_under_a_desktop(doctor));
    }
}

static void check_nodes(struct doctor *doctor, const char *part, const char *folder,
                        const char *prefix, const char *group)
{
    static struct doctor_names nodes;
    char path[DOCTOR_PATH];
    doctor_list(doctor, folder, prefix, &nodes);
    for (uint32_t i = 0; i < nodes.count; i++) {
        snprintf(path, sizeof path, "%s/%s", folder, nodes.name[i]);
        check_node(doctor, part, path, path, group, true);
    }
}

/* ---- Screens --------------------------------------------------------------------------------- */

void doctor_screen(struct doctor *doctor)
{
    static struct doctor_names sockets; /* Video connectors, for example "card1-HDMI-A-1". */
    uint32_t connected = 0;             /* Number of connectors to which a screen is connected. */
    doctor_list(doctor, "/sys/class/drm", "card", &sockets);
    for (uint32_t i = 0; i < sockets.count; i++) {
        char status[32], mode[32];
        doctor_line(doctor, status, sizeof status, "/sys/class/drm/%s/status", sockets.name[i]);
        doctor_line(doctor, mode, sizeof mode, "/sys/class/drm/%s/modes", sockets.name[i]);
        if (status[0]) {
            doctor_state(doctor_find(doctor, "display", DOCTOR_FINE, "%s", sockets.name[i]),
                         "%s%s%s", status, mode[0] ? ", " : "", mode);
            connected += strcmp(status, "connected") == 0;
        }
    }
    if (is_under_a_desktop(doctor)) {
        doctor_state(doctor_find(doctor, "display", DOCTOR_FINE, "desktop"), "%s",
                     getenv("WAYLAND_DISPLAY") ? getenv("WAYLAND_DISPLAY") : getenv("DISPLAY"));
    } else {
        check_nodes(doctor, "display", "/dev/dri", "card", "video");
        check_nodes(doctor, "display", "/dev/dri", "renderD", "render");
    }
    if (!doctor->root[0]) { /* The display is checked only on the real machine (an empty root). A
                               test folder cannot open windows. */
        char why[HAL_TEXT_SIZE] = "";
        const bool has_screen = board_has_screen(why, sizeof why) != 0;
        struct doctor_finding *finding =
            doctor_find(doctor, "display", has_screen ? DOCTOR_FINE : DOCTOR_WRONG, "the kiosk's");
        doctor_state(finding, "%s", has_screen ? "can be opened" : why);
        if (!has_screen) {
            doctor_todo(finding,
                        "connect a screen, or start from a desktop; without a screen the kiosk "
                        "only writes pictures");
        }
    } else if (connected == 0) {
        struct doctor_finding *none = doctor_find(doctor, "display", DOCTOR_WRONG, "screens");
        doctor_state(none, "no screen is plugged in");
        doctor_todo(none, "connect a screen and switch it on");
    }
}

/* ---- Sound ----------------------------------------------------------------------------------- */

/* Two lines of /proc/asound/cards describe a card. The first line is for example
 * " 0 [PCH ]: HDA-Intel - HDA Intel PCH", and the second line contains the card's location. */
void doctor_sound(struct doctor *doctor)
{
    char path[OPTIONS_PATH_MAX + 64u], line[DOCTOR_TEXT];
    uint32_t count = 0;
    snprintf(path, sizeof path, "%s/proc/asound/cards", doctor->root);
    FILE *file = file_open(path, FILE_KERNEL_SIZE_MAX);
    while (file && file_read_line(file, line, sizeof line) != FILE_LINE_END) {
        unsigned number;
        const char *name = strstr(line, "]: ");
        if (sscanf(line, " %9u [", &number) == 1 && name) {
            doctor_state(doctor_find(doctor, "sound", DOCTOR_FINE, "card %u", number), "%s",
                         name + 3);
            count++;
        }
    }
    if (file) {
        fclose(file);
    }
    if (count == 0) {
        struct doctor_finding *none = doctor_find(doctor, "sound", DOCTOR_CHECK, "cards");
        doctor_state(none, "this machine has no sound card: the kiosk is silent");
        doctor_todo(none, "connect a sound card, or enable the board's sound (on a Raspberry Pi: "
                          "dtparam=audio=on)");
        return;
    }
    check_nodes(doctor, "sound", "/dev/snd", "pcm", "audio");
}
