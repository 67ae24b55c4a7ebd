/* motor.h -- controls a vibration motor on a PWM channel and a light on an LED, through files of
 * sysfs. */
#ifndef KINGYO_BOARD_POI_GADGET_MOTOR_H
#define KINGYO_BOARD_POI_GADGET_MOTOR_H

#include "board/poi-gadget/feel_mix.h"
#include "board/poi-gadget/poi_config.h"
#include "board/poi-gadget/run.h"

struct motor {
    struct feel_mix mix;
    /* File descriptors of the PWM duty file and of the LED brightness file. -1 means that the part
     * is absent. */
    int duty_fd, light_fd;
    uint32_t period_ns;
    float least; /* Lowest duty at which the motor turns, in [0, 1). */
    uint32_t light_most;
    uint32_t duty_ns, light_value; /* Duty in ns and brightness that were written last. */
};

#define MOTOR_WHY_SIZE 160u

/* Exports the PWM channel and enables the channel with a duty of 0. Returns 1 if all configured
 * parts are present. Otherwise writes one line to `why` and returns 0, and the parts that are
 * present can still be used. */
int motor_open(struct motor *motor, const struct poi_config *config, const char *root,
               char why[MOTOR_WHY_SIZE]);

/* Returns a receiver of force feedback that drives the motor and the light. The receiver's stop()
 * sets the motor and the light to 0. */
struct feel_sink motor_sink(struct motor *motor);

/* Sets the outputs of the motor and the light immediately. */
void motor_set(struct motor *motor, struct feel_levels levels);

#endif
