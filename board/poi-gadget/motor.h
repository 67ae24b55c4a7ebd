/* motor.h -- drives a small motor on a PWM channel and a light on an LED through sysfs. */
#ifndef KINGYO_BOARD_POI_GADGET_MOTOR_H
#define KINGYO_BOARD_POI_GADGET_MOTOR_H

#include "board/poi-gadget/feel_mix.h"
#include "board/poi-gadget/poi_config.h"
#include "board/poi-gadget/run.h"

struct motor {
    struct feel_mix mix;
    /* File descriptors of the duty and the light, or -1 if the part is absent. */
    int duty_fd, light_fd;
    uint32_t period_ns;
    float least; /* Lowest duty at which the motor turns. */
    uint32_t light_most;
    uint32_t duty_ns, light_value; /* Values of the duty and the light that were written last. */
};

#define MOTOR_WHY_SIZE 160u

/* Exports the PWM channel and enables it at level 0. Returns 1. Returns 0 and writes one line to
 * `why` if a configured part is missing. Parts that are present still work. */
int motor_open(struct motor *motor, const struct poi_config *config, const char *root,
               char why[MOTOR_WHY_SIZE]);

/* Returns the force feedback sink for run(). Its stop() sets both outputs to 0. */
struct feel_sink motor_sink(struct motor *motor);

/* Sets the motor and the light immediately. Both levels are in [0, 1]. */
void motor_set(struct motor *motor, struct feel_levels levels);

#endif
