/* poi_config.h -- the configuration of a poi: the names of its sensors, the positions of its
 * spools, and its dimensions.
 *
 * The file has lines of the form `name = value`, and # starts a comment. poi.conf is an example
 * that describes each line. The functions are pure, except for poi_config_load(). */
#ifndef KINGYO_BOARD_POI_GADGET_POI_CONFIG_H
#define KINGYO_BOARD_POI_GADGET_POI_CONFIG_H

#include <stdint.h>

#include "board/poi-gadget/draw_wires.h"

#define POI_CONFIG_NAME_SIZE 32u
#define POI_CONFIG_LINE_SIZE 160u
#define POI_CONFIG_SIZE_MAX (1u << 16) /* Maximum file size in bytes. poi.conf is 1 KiB. */
/* Maximum number of marks. Three wires need fewer marks, and a sheet of paper has room for
 * eight. */
#define POI_CONFIG_MARK_MAX 8u
#define POI_CONFIG_CHANNEL_MAX 31u

struct poi_config {
    char adc[POI_CONFIG_NAME_SIZE]; /* Kernel name of the IIO device. */
    char imu[POI_CONFIG_NAME_SIZE];
    char light[POI_CONFIG_NAME_SIZE]; /* Name of the LED in /sys/class/leds, or "" for no light. */
    uint32_t channel[DRAW_WIRE_COUNT];
    vec3 spool_m[DRAW_WIRE_COUNT]; /* World positions at which the wires leave their spools. */
    float zero_m[DRAW_WIRE_COUNT]; /* Length of each wire at converter step 0. */
    /* Length of one converter step for each wire. A value of 0 means that the wire is not
     * calibrated. */
    float step_m[DRAW_WIRE_COUNT];
    /* Offset from the wires' eye to the ring, in the axes of the poi. */
    vec3 ring_m;
    /* Directions right, up and back of the poi, in the chip's axes. */
    vec3 imu_row[3];
    vec3 gyro_bias_rad_s; /* Bias of the gyroscope, in the axes of the poi. */
    /* Time constant of the heading's decay (see attitude_angles()). */
    float ahead_s;
    int32_t pwm_chip; /* Number of the chip in /sys/class/pwm, or -1 for no motor. */
    uint32_t pwm_channel;
    uint32_t motor_hz; /* Frequency of the PWM pulses, not of the motor. */
    float motor_least; /* Lowest duty at which the motor turns, in [0, 1). */
    uint32_t mark_count;
    vec3 mark_m[POI_CONFIG_MARK_MAX]; /* Positions at which the eye is held for the calibration. */
};

/* Sets the values of poi.conf. The wires are not calibrated. */
void poi_config_init(struct poi_config *config);

/* Parses one line. Returns 1, or 0 for an empty line. Returns -1 and sets `why` to a static phrase
 * for a line that is not valid. */
int poi_config_line(struct poi_config *config, const char *line, const char **why);

/* Returns whether the configuration is valid for play, and sets `why` to a phrase otherwise. The
 * calibration is checked separately by poi_config_is_calibrated(). */
int poi_config_is_sound(const struct poi_config *config, const char **why);

/* Returns whether all wires are calibrated. */
int poi_config_is_calibrated(const struct poi_config *config);

/* Reads the file. Returns 1. Returns 0 and prints one line to standard error if the file is not
 * readable or not valid. */
int poi_config_load(struct poi_config *config, const char *path);

#endif
