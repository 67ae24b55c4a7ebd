/* pulse_train.h -- a meter's or a dispenser's pulses, one after the other. Pure.
 *
 * A pulse lasts at least its time and so does the rest behind it, however late anybody looks: a
 * late one is longer, never lost and never two in one. */
#ifndef KINGYO_DRIVERS_PULSE_TRAIN_H
#define KINGYO_DRIVERS_PULSE_TRAIN_H

#include <stdbool.h>
#include <stdint.h>

struct pulse_train {
    uint64_t on_ns, off_ns;
    uint64_t until_ns; /* What is now, pulse or rest, lasts until here. */
    uint32_t left;     /* Pulses that have not begun. */
    bool on;
};

/* `count` more; what is left stays at UINT32_MAX when there are more. */
void pulse_train_add(struct pulse_train *train, uint32_t count);

/* The output's level from `now_ns` on. */
bool pulse_train_at(struct pulse_train *train, uint64_t now_ns);

/* When at() will say something else; UINT64_MAX: not before more are added. */
uint64_t pulse_train_due_ns(const struct pulse_train *train);

#endif
