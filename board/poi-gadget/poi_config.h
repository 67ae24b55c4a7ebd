/* poi_config.h -- how a poi was built: its sensors by name, where its spools hang, its measures.
 *
 * A text of lines `name = value`; what follows a # is not read. poi.conf is one, and says what each
 * line means. Pure. */
#ifndef KINGYO_POI_GADGET_POI_CONFIG_H
#define KINGYO_POI_GADGET_POI_CONFIG_H

#include <stdint.h>

#include "board/poi-gadget/draw_wires.h"

#define POI_CONFIG_NAME_SIZE 32u
#define POI_CONFIG_LINE_SIZE 160u
#define POI_CONFIG_SIZE_MAX (1u << 16) /* Bytes; poi.conf is 1 KiB. */
#define POI_CONFIG_MARK_MAX 8u /* More marks than three wires need; a sheet of paper holds them. */
#define POI_CONFIG_CHANNEL_MAX 31u

struct poi_config {
    char adc[POI_CONFIG_NAME_SIZE]; /* As the kernel names the IIO device. */
    char imu[POI_CONFIG_NAME_SIZE];
    char light[POI_CONFIG_NAME_SIZE]; /* In /sys/class/leds; "": none. */
    uint32_t channel[DRAW_WIRE_COUNT];
    vec3 spool_m[DRAW_WIRE_COUNT];   /* World: where each wire leaves its spool. */
    float zero_m[DRAW_WIRE_COUNT];   /* Length where the converter says 0 ... */
    float step_m[DRAW_WIRE_COUNT];   /* ... and for each of its steps; 0: not calibrated. */
    vec3 ring_m;                     /* From the wires' eye to the ring, in the poi's axes. */
    vec3 imu_row[3];                 /* The poi's right, up and back, in the chip's axes. */
    vec3 gyro_bias_rad_s;            /* In the poi's axes. */
    float ahead_s;                   /* See attitude_angles(). */
    int32_t pwm_chip;                /* Of /sys/class/pwm; -1: no motor. */
    uint32_t pwm_channel;
    uint32_t motor_hz;               /* Of the pulses, not of the motor. */
    float motor_least;               /* [0, 1) duty that just turns it. */
    uint32_t mark_count;
    vec3 mark_m[POI_CONFIG_MARK_MAX]; /* Where the eye is held to calibrate. */
};

/* What poi.conf says; wires are not calibrated. */
void poi_config_init(struct poi_config *config);

/* Reads one line: 1, 0 for a blank one, or -1 and one phrase in `why`; static. */
int poi_config_line(struct poi_config *config, const char *line, const char **why);

/* Whether the whole can be played with; else `why`. Calibration is asked apart. */
int poi_config_is_sound(const struct poi_config *config, const char **why);
int poi_config_is_calibrated(const struct poi_config *config);

/* Reads the file: 1; 0 and a line on standard error where it cannot be read or is wrong. */
int poi_config_load(struct poi_config *config, const char *path);

#endif
