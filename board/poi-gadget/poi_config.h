/* poi_config.h -- the configuration of a poi (a paper scoop with sensors): the names of its
 * sensors, the positions of its spools, and its dimensions.
 *
 * The configuration file has lines of the form `name = value`, and # starts a comment. poi.conf is
 * an example that describes each line. The functions are pure, except poi_config_load(). */
#pragma once

#include <stdbool.h>
#include <stdint.h>

#include "board/poi-gadget/draw_wires.h"

#define POI_CONFIG_NAME_SIZE 32u
#define POI_CONFIG_LINE_SIZE 160u
/* Maximum size of a configuration file in bytes. The example poi.conf has 1 KiB. */
#define POI_CONFIG_SIZE_MAX (1u << 16)
/* Maximum number of calibration marks. Eight marks fit on the printed sheet, and three wires need
 * fewer. */
#define POI_CONFIG_MARK_MAX 8u
#define POI_CONFIG_CHANNEL_MAX 31u

struct poi_config {
    /* Kernel name of the IIO device of the analog-to-digital converter. */
    char adc[POI_CONFIG_NAME_SIZE];
    char imu[POI_CONFIG_NAME_SIZE];
    /* Name of the LED in /sys/class/leds. "" means that there is no light. */
    char light[POI_CONFIG_NAME_SIZE];
    uint32_t channel[DRAW_WIRE_COUNT];
    /* World positions in metres at which the wires leave their spools. */
    vec3 spool_m[DRAW_WIRE_COUNT];
    float zero_m[DRAW_WIRE_COUNT]; /* Length of each wire in metres at converter step 0. */
    /* Change of each wire's length in metres for one converter step. 0 means that the wire is not
     * calibrated. */
    float step_m[DRAW_WIRE_COUNT];
    /* Offset in metres from the eye, where the wires meet, to the ring's centre, in the axes of the
     * poi. */
    vec3 ring_m;
    /* Directions right, up and back of the poi, each as a unit vector in the axes of the inertial
     * chip. */
    vec3 imu_row[3];
    vec3 gyro_bias_rad_s; /* Bias of the gyroscope in rad/s, in the axes of the poi. */
    /* Time constant in seconds of the heading's decay to straight ahead (see attitude_angles()). 0
     * disables the decay. */
    float ahead_s;
    /* Number N of the PWM chip /sys/class/pwm/pwmchipN. -1 means that there is no motor. */
    int32_t pwm_chip;
    uint32_t pwm_channel;
    /* Frequency of the PWM pulses in Hz. The frequency is independent of the motor's speed. */
    uint32_t motor_hz;
    float motor_least; /* Lowest PWM duty at which the motor turns, in [0, 1). */
    uint32_t mark_count;
    /* World positions in metres at which the user holds the eye during the calibration. */
    vec3 mark_m[POI_CONFIG_MARK_MAX];
};

/* Sets all fields to the values of the example poi.conf. The wires are not calibrated. */
void poi_config_init(struct poi_config *config);

/* Parses one line of a configuration file. Returns 1, or 0 for a line without a setting. If the
 * line is invalid, sets `why` to a static text and returns -1. */
int poi_config_line(struct poi_config *config, const char *line, const char **why);

/* Returns true if the configuration is valid. Otherwise sets `why` to a static text and returns
 * false.
 * poi_config_is_calibrated() checks the calibration separately. */
bool poi_config_is_sound(const struct poi_config *config, const char **why);

/* Returns true if all wires are calibrated. */
bool poi_config_is_calibrated(const struct poi_config *config);

/* Converts a vector from the axes of the inertial chip to the axes of the poi. */
vec3 poi_config_from_chip(const struct poi_config *config, vec3 chip);

/* Reads the configuration file at `path`. Returns true. If the file is not readable or invalid,
 * prints one line to standard error and returns false. */
bool poi_config_load(struct poi_config *config, const char *path);
