/* doctor_gpio.h -- a list of all GPIO lines of the machine, and the check of each line that the
 * kiosk's options configure.
 *
 * The functions are pure. */
#ifndef KINGYO_PLATFORM_CTL_DOCTOR_DOCTOR_GPIO_H
#define KINGYO_PLATFORM_CTL_DOCTOR_DOCTOR_GPIO_H

#include "drivers/gpio/gpio_lines.h"
#include "platform/ctl/doctor/doctor.h"

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

/* Adds a finding for the GPIO line that `wire` configures for `role`. The finding reports whether
 * the line exists in `census`, is unused, and is the only line with its name. */
void doctor_gpio_wire(struct doctor *doctor, enum gpio_role role, const struct gpio_wire *wire,
                      const struct gpio_census *census);

#endif
