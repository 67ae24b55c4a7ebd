/* doctor_gpio.c -- checks the GPIO chips and the configured lines.
 *
 * The check reports whether each configured line exists, is unused and has a unique name. The check
 * does not request a line. It only reads the kernel's information about the lines (linux/gpio.h),
 * which names the consumer of each used line. */
#include "platform/ctl/doctor/doctor.h"

#include <errno.h>
#include <fcntl.h>
#include <linux/gpio.h>
#include <stdio.h>
#include <string.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include "core/base/panic.h"
#include "drivers/gpio/gpio_config.h"
#include "drivers/gpio/gpio_backend.h"

/* ---- Reading all GPIO lines ------------------------------------------------------------------ */

/* Adds a finding for a chip, and adds the lines of the chip to `census`. */
static void check_chip(struct doctor *doctor, const char *path, struct gpio_census *census)
{
    char whole[OPTIONS_PATH_MAX + 64u];
    struct gpiochip_info chip = { .lines = 0 };
    const int refused = doctor_access_error(doctor, path);
    if (refused) {
        const bool is_needed = doctor->options.line_count > 0;
        struct doctor_finding *finding =
            doctor_find(doctor, "gpio", is_needed ? DOCTOR_WRONG : DOCTOR_CHECK, "%s", path);
        doctor_state(finding, "%s may not open it: %s", doctor->user.name, strerror(refused));
        doctor_todo_access(doctor, finding, path,
                           "sudo cp board/udev/*.rules /etc/udev/rules.d/, then sudo udevadm "
                           "control --reload && sudo udevadm trigger");
        return;
    }
    snprintf(whole, sizeof whole, "%s%s", doctor->root, path);
    const int file = open(whole, O_RDWR | O_CLOEXEC);
    const int error = file < 0 ? errno : ioctl(file, GPIO_GET_CHIPINFO_IOCTL, &chip) ? errno : 0;
    if (error) {
        doctor_state(doctor_find(doctor, "gpio", DOCTOR_CHECK, "%s", path), "%s", strerror(error));
    } else {
        for (uint32_t offset = 0; offset < chip.lines; offset++) {
            struct gpio_v2_line_info line = { .offset = offset };
            if (ioctl(file, GPIO_V2_GET_LINEINFO_IOCTL, &line)) {
                continue;
            }
            if (census->count == GPIO_CENSUS_MAX) {
                census->more++;
                continue;
            }
            struct gpio_seen *seen = &census->line[census->count++];
            *seen = (struct gpio_seen){
                .offset = offset,
                .is_used = (line.flags & GPIO_V2_LINE_FLAG_USED) != 0,
            };
            snprintf(seen->chip, sizeof seen->chip, "%.31s", chip.label);
            snprintf(seen->name, sizeof seen->name, "%.31s", line.name);
            snprintf(seen->consumer, sizeof seen->consumer, "%.31s", line.consumer);
        }
        doctor_state(doctor_find(doctor, "gpio", DOCTOR_FINE, "%s", path), "%s, %u lines",
                     chip.label, chip.lines);
    }
    if (file >= 0) {
        close(file);
    }
}

/* ---- Checks of the configured lines ---------------------------------------------------------- */

void doctor_wires(const struct doctor *doctor, struct gpio_wire wires[GPIO_ROLE_COUNT])
{
    char why[HAL_TEXT_SIZE];
    memset(wires, 0, GPIO_ROLE_COUNT * sizeof wires[0]);
    for (uint32_t i = 0; i < doctor->options.line_count; i++) {
        /* The result needs no check, because the option parser has already validated the text. */
        (void)gpio_wire_read(doctor->options.line[i], wires, why);
    }
}

/* If two chips have the same label, only the names of their lines distinguish the chips. */
void doctor_gpio_wire(struct doctor *doctor, enum gpio_role role, const struct gpio_wire *wire,
                      const struct gpio_census *census)
{
    char line[GPIO_WIRE_TEXT_SIZE];
    const struct gpio_seen *found = NULL;
    uint32_t places = 0;
    CORE_ASSERT(role < GPIO_ROLE_COUNT && census->count <= GPIO_CENSUS_MAX);
    for (uint32_t i = 0; i < census->count; i++) {
        const struct gpio_seen *seen = &census->line[i];
        if (wire->name[0] ? strcmp(wire->name, seen->name) == 0
                          : strcmp(wire->chip, seen->chip) == 0 && wire->offset == seen->offset) {
            found = found ? found : seen;
            places++;
        }
    }
    gpio_wire_text(wire, line);
    struct doctor_finding *finding =
        doctor_find(doctor, "line", DOCTOR_FINE, "%s on %s", gpio_role_name(role), line);
    if (!found) {
        finding->level = DOCTOR_WRONG;
        doctor_state(finding, "no chip that may be opened has this line");
        doctor_todo(finding, "correct --line %s=...; kingyoctl lines list prints all lines",
                    gpio_role_name(role));
    } else if (places > 1u && !wire->name[0]) {
        finding->level = DOCTOR_WRONG;
        doctor_state(finding, "%u chips have this label", places);
        doctor_todo(finding,
                    "use the name of the line, if the line has a name: kingyoctl lines list");
    } else if (places > 1u) {
        finding->level = DOCTOR_WRONG;
        doctor_state(finding, "%u lines have this name", places);
        doctor_todo(finding, "use the chip and the offset: %s:%u", found->chip, found->offset);
    } else if (found->is_used && strcmp(found->consumer, "kingyo") != 0) {
        finding->level = DOCTOR_WRONG;
        doctor_state(finding, "held by '%s'", found->consumer);
        doctor_todo(finding, "end the program, or remove the overlay or driver of this name");
    } else {
        doctor_state(finding, "on %s, line %u%s", found->chip, found->offset,
                     found->is_used ? ", held by the running kiosk" : ", free");
    }
}

void doctor_gpio(struct doctor *doctor)
{
    static struct gpio_census census;
    struct gpio_wire wires[GPIO_ROLE_COUNT];
    census.count = census.more = 0;
    struct gpio_dev_walk walk = { .root = doctor->root };
    while (gpio_dev_next(&walk)) {
        check_chip(doctor, walk.path, &census);
    }
    if (walk.count == 0) {
        const bool is_needed = doctor->options.line_count > 0;
        struct doctor_finding *none =
            doctor_find(doctor, "gpio", is_needed ? DOCTOR_WRONG : DOCTOR_FINE, "chips");
        doctor_state(none,
                     "this machine has no GPIO: use keys as buttons, and the key '5' as a coin");
        if (is_needed) {
            doctor_todo(none, "enable the GPIO driver, or remove the --line options");
        }
    }
    doctor_wires(doctor, wires);
    for (uint32_t role = 0; role < GPIO_ROLE_COUNT; role++) {
        if (wires[role].wired) {
            doctor_gpio_wire(doctor, (enum gpio_role)role, &wires[role], &census);
        }
    }
}
