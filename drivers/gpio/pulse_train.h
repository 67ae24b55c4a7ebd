/* pulse_train.h -- generates a sequence of pulses for a coin meter or a ticket dispenser.
 *
 * A pulse and the pause after it have at least their nominal length. If the caller is late, a pulse
 * becomes longer, but pulses are never lost or merged. Pure: uses no device and no clock. */
#ifndef KINGYO_DRIVERS_GPIO_PULSE_TRAIN_H
#define KINGYO_DRIVERS_GPIO_PULSE_TRAIN_H

#include <stdbool.h>
#include <stdint.h>

struct pulse_train {
    uint64_t on_ns, off_ns; /* Nominal length of a pulse, and of the pause after it. */
    uint64_t until_ns;      /* Time at which the current pulse or pause ends. */
    uint32_t left;          /* Number of pulses that have not started yet. */
    bool on;                /* True during a pulse. */
};

/* Adds `count` pulses. The sum saturates at UINT32_MAX. */
void pulse_train_add(struct pulse_train *train, uint32_t count);

/* Returns the level of the output at `now_ns`; true means that a pulse is active. `now_ns` must not
 * decrease. */
bool pulse_train_at(struct pulse_train *train, uint64_t now_ns);

/* Returns the time at which the level changes next, or UINT64_MAX if no pulse is left. */
uint64_t pulse_train_due_ns(const struct pulse_train *train);

#endif
