/* doctor_input.c -- checks the access to gamepads, mice, touch screens and keyboards.
 *
 * Without a desktop session, SDL reads these devices directly from the kernel's event nodes
 * /dev/input/eventN. */
#include <stdio.h>
#include <string.h>

#include "platform/ctl/doctor/doctor.h"

static void look_at_node(struct doctor *doctor, const char *event)
{
    char name[DOCTOR_TEXT], path[96], join[DOCTOR_TEXT];
    snprintf(path, sizeof path, "/dev/input/%.64s", event);
    doctor_line(doctor, name, sizeof name, "/sys/class/input/%s/device/name", event);
    const int error = doctor_may_use(doctor, path);
    const bool is_needed = !doctor_under_a_desktop(doctor);
    struct doctor_finding *finding = doctor_find(doctor, "input",
                                                 !error      ? DOCTOR_FINE
                                                 : is_needed ? DOCTOR_WRONG
                                                             : DOCTOR_LOOK,
                                                 "%s, %s", name[0] ? name : "without a name", path);
    if (!error) {
        doctor_state(finding, "%s may read it", doctor->user.name);
        return;
    }
    snprintf(join, sizeof join, "sudo usermod -aG input %s, then log in again or restart the kiosk",
             doctor->user.name);
    doctor_state(finding, "%s may not read it: %s%s", doctor->user.name, strerror(error),
                 is_needed ? "" : ", but the desktop does");
    if (is_needed) {
        doctor_todo_access(doctor, finding, path, join);
    }
}

void doctor_input(struct doctor *doctor)
{
    static struct doctor_names events;
    doctor_list(doctor, "/sys/class/input", "event", &events);
    for (uint32_t i = 0; i < events.count; i++) {
        look_at_node(doctor, events.name[i]);
    }
}
