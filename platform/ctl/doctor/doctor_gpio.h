/* doctor_gpio.h -- a census of GPIO lines, and the finding for each configured line.
 *
 * The functions are pure. */
#ifndef KINGYO_PLATFORM_CTL_DOCTOR_DOCTOR_GPIO_H
#define KINGYO_PLATFORM_CTL_DOCTOR_DOCTOR_GPIO_H

#include "drivers/gpio/gpio_lines.h"
#include "platform/ctl/doctor/doctor.h"

/* Most lines in the census. A Raspberry Pi 5 has 130 lines on 14 chips. */
#define GPIO_CENSUS_MAX 1024u

/* State of one GPIO line. */
struct gpio_seen {
    char chip[GPIO_TEXT_SIZE]; /* Label of the chip. */
    char name[GPIO_TEXT_SIZE];
    char consumer[GPIO_TEXT_SIZE];
    uint32_t offset;
    bool is_used;
};

/* List of the GPIO lines of all chips. `more` counts the lines that did not fit. */
struct gpio_census {
    uint32_t count, more;
    struct gpio_seen line[GPIO_CENSUS_MAX];
};

/* Adds a finding for a configured line: whether the line exists, is free and is unique. */
void doctor_gpio_wire(struct doctor *doctor, enum gpio_role role, const struct gpio_wire *wire,
                      const struct gpio_census *census);

#endif
