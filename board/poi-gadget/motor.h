/* motor.h -- a small motor on a PWM channel and a light on an LED, through sysfs. */
#ifndef KINGYO_POI_GADGET_MOTOR_H
#define KINGYO_POI_GADGET_MOTOR_H

#include "board/poi-gadget/feel_mix.h"
#include "board/poi-gadget/poi_config.h"
#include "board/poi-gadget/run.h"

struct motor {
    struct feel_mix mix;
    int duty_fd, light_fd; /* -1: none. */
    uint32_t period_ns;
    float least;           /* Duty that just turns it. */
    uint32_t light_most;
    uint32_t duty_ns, light_value; /* Last written. */
};

#define MOTOR_WHY_SIZE 160u

/* Exports the channel and enables it at rest. 0, and one line in `why`, where config names what is
 * not there; whatever is there works all the same. */
int motor_open(struct motor *motor, const struct poi_config *config, const char *root,
               char why[MOTOR_WHY_SIZE]);

/* What run() plays on. stop() leaves both at rest. */
struct feel_sink motor_sink(struct motor *motor);

/* [0, 1] each, at once. */
void motor_set(struct motor *motor, struct feel_levels levels);

#endif
