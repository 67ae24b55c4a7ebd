/* motor.h -- converts the host's force feedback to the levels of one vibration motor and one light.
 * Controls a motor on a PWM channel and a light on an LED through files of sysfs.
 *
 * A vibration motor cannot push or turn the hand. Only the levels of the force feedback report are
 * used, and the force and the torque are ignored. Drag in the water gives a hum. A slap of a fish's
 * tail gives a pulse that decays. A tear of the paper gives a rattle. The motor stops if the host
 * sends no more reports. */
#pragma once

#include <stdbool.h>

#include "board/poi-gadget/poi_config.h"
#include "board/poi-gadget/run.h"
#include "core/output.h"

/* Time in seconds without a report after which the motor stops. A kiosk sends one report in each
 * video frame. */
#define FEEL_SILENT_S 0.25f
/* Level of the motor at full drag. The remaining range is used for slaps and tears. */
#define FEEL_DRAG_SHARE 0.5f
#define FEEL_SLAP_S 0.060f /* Time constant in seconds with which the pulse of a slap decays. */
#define FEEL_TEAR_S 0.150f
/* Frequency of the rattle of a tear in Hz. A higher frequency feels like an engine and not like
 * tearing paper. */
#define FEEL_RATTLE_HZ 25.0f

struct motor_mix {
    /* Present levels of drag, slap and tear, in [0, 1]. The levels decay. */
    float drag, slap, tear;
    float silent_s, rattle_s;
};

struct feel_levels {
    float motor, light; /* Levels of the motor and of the light, in [0, 1]. */
};

/* Advances the levels by `seconds` and returns the outputs. `newest` is the newest report from the
 * host, or null if no report has arrived since the last call. */
struct feel_levels motor_mix_step(struct motor_mix *mix, const struct poi_force *newest,
                                  float seconds);

struct motor {
    struct motor_mix mix;
    /* File descriptors of the PWM duty file and of the LED brightness file. -1 means that the motor
     * or the light is absent. */
    int duty_fd, light_fd;
    uint32_t period_ns;
    float least; /* Lowest PWM duty at which the motor turns, in [0, 1). */
    uint32_t light_most;
    uint32_t duty_ns, light_value; /* PWM duty in ns and light brightness that were written last. */
};

#define MOTOR_WHY_SIZE 160u

/* Exports the PWM channel and enables the channel with a duty of 0. Returns true if all
 * configured parts are present. Otherwise writes one line to `why` and returns false, and the parts
 * that are present can still be used. */
bool motor_open(struct motor *motor, const struct poi_config *config, const char *root,
                char why[MOTOR_WHY_SIZE]);

/* Returns a receiver of force feedback that drives the motor and the light. The receiver's stop()
 * sets the motor and the light to 0. */
struct force_sink motor_sink(struct motor *motor);

/* Sets the outputs of the motor and the light immediately. */
void motor_set(struct motor *motor, struct feel_levels levels);
