/* test_poi_sensors.c -- tests the sensors, keys, motor and light of a poi board. A folder with
 * simulated device files replaces /sys and /dev. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include <cmocka.h>

#include <fcntl.h>
#include <linux/input.h>
#include <stdio.h>
#include <stdlib.h>
#include <sys/stat.h>
#include <unistd.h>

#include "board/poi-gadget/motor.h"
#include "board/poi-gadget/sensor_twin.h"
#include "board/poi-gadget/sensors.h"

#define IIO "sys/bus/iio/devices/iio:device"

static char root[64];
static struct poi_config config;

static void path_of(char path[256], const char *leaf)
{
    snprintf(path, 256, "%s/%s", root, leaf);
}

/* Writes a file below the simulated root folder, and creates its parent folders. */
static void put(const char *leaf, const char *text)
{
    char path[256];
    path_of(path, leaf);
    for (char *slash = path + strlen(root) + 1; (slash = strchr(slash, '/')) != NULL; slash++) {
        *slash = '\0';
        mkdir(path, 0755);
        *slash = '/';
    }
    FILE *file = fopen(path, "w");
    assert_non_null(file);
    assert_true(fputs(text, file) >= 0);
    assert_int_equal(fclose(file), 0);
}

static long number_in(const char *leaf)
{
    char path[256], text[32] = "";
    path_of(path, leaf);
    FILE *file = fopen(path, "r");
    assert_non_null(file);
    assert_non_null(fgets(text, sizeof text, file));
    fclose(file);
    return strtol(text, NULL, 10);
}

/* Creates device files of an analog converter, an IMU with sensor fusion, an IMU without sensor
 * fusion, two input devices, and a thermometer that the driver must ignore. */
static int build_board(void **state)
{
    (void)state;
    snprintf(root, sizeof root, "/tmp/kingyo-board-XXXXXX");
    assert_non_null(mkdtemp(root));
    put(IIO "0/name", "cpu_thermal\n");
    put(IIO "1/name", "mcp3208\n");
    put(IIO "1/in_voltage0_raw", "1000\n");
    put(IIO "1/in_voltage1_raw", "2000\n");
    put(IIO "1/in_voltage2_raw", "3000\n");
    put(IIO "3/name", "bno055\n");
    put(IIO "3/in_rot_quaternion_raw", "16384 1 2 3\n");
    put(IIO "4/name", "mpu6050\n");
    put(IIO "4/in_anglvel_scale", "0.001\n");
    put(IIO "4/in_accel_scale", "0.000598\n");
    static const char axes[] = "xyz";
    for (int i = 0; i < 3; i++) {
        char leaf[64];
        snprintf(leaf, sizeof leaf, IIO "4/in_anglvel_%c_raw", axes[i]);
        put(leaf, i == 0 ? "-500\n" : "7\n");
        snprintf(leaf, sizeof leaf, IIO "4/in_accel_%c_raw", axes[i]);
        put(leaf, i == 1 ? "16384\n" : "0\n");
    }
    put("sys/class/input/event0/device/phys", "usb-1/input0\n");
    put("sys/class/input/event1/device/phys", "gpio-keys/input0\n");
    put("dev/input/event0", "");
    put("dev/input/event1", "");
    poi_config_init(&config);
    sensor_twin_calibrate(&config);
    return 0;
}

static int remove_board(void **state)
{
    (void)state;
    char command[128];
    snprintf(command, sizeof command, "rm -r '%s'", root);
    return system(command);
}

static void test_sensors_are_found_by_name_and_scaled_to_their_units(void **state)
{
    (void)state;
    struct sensors sensors;
    struct readings readings = { 0 };
    char why[SENSORS_WHY_SIZE];
    strcpy(config.imu, "mpu6050");
    assert_true(sensors_open(&sensors, &config, root, why));
    assert_true(sensors_read(&sensors, &readings));
    assert_float_equal(readings.wire[0], 1000.0f, 0.0f);
    assert_float_equal(readings.wire[2], 3000.0f, 0.0f);
    assert_false(readings.fuses);
    assert_float_equal(readings.gyro_rad_s.x, -0.5f, 1e-6f);
    assert_float_equal(readings.accel_m_s2.y, 9.7976f, 1e-3f);
    /* Changes the value while the sensor's file is open. The next read must return the new
     * value. */
    put(IIO "1/in_voltage0_raw", "1234\n");
    assert_true(sensors_read(&sensors, &readings));
    assert_float_equal(readings.wire[0], 1234.0f, 0.0f);
    sensors_close(&sensors);
}

static void test_a_quaternion_is_read_in_the_order_of_its_driver(void **state)
{
    (void)state;
    struct sensors sensors;
    struct readings readings = { 0 };
    char why[SENSORS_WHY_SIZE];
    assert_true(sensors_open(&sensors, &config, root, why));
    assert_true(sensors_read(&sensors, &readings));
    assert_true(readings.fuses);
    assert_float_equal(readings.turn.w, 16384.0f, 0.0f);
    assert_float_equal(readings.turn.z, 3.0f, 0.0f);
    sensors_close(&sensors);
    /* This driver (a HID sensor hub) gives the quaternion in the order of the kernel ABI: x y z
     * w. */
    put(IIO "3/name", "dev_rotation\n");
    strcpy(config.imu, "dev_rotation");
    assert_true(sensors_open(&sensors, &config, root, why));
    assert_true(sensors_read(&sensors, &readings));
    assert_float_equal(readings.turn.w, 3.0f, 0.0f);
    assert_float_equal(readings.turn.x, 16384.0f, 0.0f);
    sensors_close(&sensors);
}

static void test_each_missing_sensor_is_named(void **state)
{
    (void)state;
    struct sensors sensors;
    char why[SENSORS_WHY_SIZE];
    config.channel[1] = 7;
    assert_false(sensors_open(&sensors, &config, root, why));
    assert_non_null(strstr(why, "in_voltage7_raw"));
    sensors_close(&sensors);
    strcpy(config.adc, "ads1115");
    assert_false(sensors_open(&sensors, &config, root, why));
    assert_non_null(strstr(why, "ads1115"));
    sensors_close(&sensors);
    poi_config_init(&config);
    strcpy(config.imu, "cpu_thermal");
    assert_false(sensors_open(&sensors, &config, root, why));
    assert_non_null(strstr(why, "in_rot_quaternion_raw"));
    sensors_close(&sensors);
}

static void test_the_position_is_lost_while_the_converter_fails(void **state)
{
    (void)state;
    static struct sensor_source own;
    char why[SENSORS_WHY_SIZE];
    struct poi_report out;
    const struct poi_report hand = { .target.position_m = { 0.0f, 0.1f, 0.0f } };
    struct sensor_twin twin = { .config = &config, .fuses = 1 };
    struct readings truth;
    sensor_twin_step(&twin, &hand, 0.004f, &truth);
    for (uint32_t i = 0; i < 3; i++) {
        char leaf[64], text[16];
        snprintf(leaf, sizeof leaf, IIO "1/in_voltage%u_raw", i);
        snprintf(text, sizeof text, "%.0f\n", (double)truth.wire[i]);
        put(leaf, text);
    }
    /* With this rotation the poi is level, because the +z axis of the sensor's world points up. */
    put(IIO "3/in_rot_quaternion_raw", "11585 11585 0 0\n");
    assert_true(sensors_open(&own.sensors, &config, root, why));
    struct pose_source source = sensors_source(&own, &config);
    for (int n = 0; n < 5; n++) {
        assert_int_equal(source.step(source.self, 0.004f, &out), POSE_NEW);
    }
    assert_true(v3_length(v3_sub(out.target.position_m, hand.target.position_m)) < 0.002f);
    put(IIO "1/in_voltage1_raw", "");
    for (uint32_t n = 0; n <= SENSOR_GONE_BEATS; n++) {
        /* While the sensor has failed only for a short time, the position stays valid. */
        assert_true(f_is_finite(out.target.position_m.x));
        source.step(source.self, 0.004f, &out);
    }
    assert_false(f_is_finite(out.target.position_m.x));
    assert_int_equal(own.sensors.failed_count, SENSOR_GONE_BEATS + 1);
    put(IIO "1/in_voltage1_raw", "2640\n");
    source.step(source.self, 0.004f, &out);
    assert_true(f_is_finite(out.target.position_m.x));
    sensors_close(&own.sensors);
}

static void press(uint16_t code, int value)
{
    char path[256];
    const struct input_event event = { .type = EV_KEY, .code = code, .value = value };
    path_of(path, "dev/input/event1");
    const int fd = open(path, O_WRONLY | O_APPEND);
    assert_int_equal(write(fd, &event, sizeof event), sizeof event);
    close(fd);
}

static void test_gpio_keys_are_read_as_levels_and_other_devices_ignored(void **state)
{
    (void)state;
    struct keys keys;
    sensors_open_keys(&keys, root);
    assert_int_equal(keys.count, 1);
    assert_int_equal(sensors_held_keys(&keys), 0);
    press(BTN_START, 1);
    press(BTN_TRIGGER, 1);
    assert_int_equal(sensors_held_keys(&keys), POI_BUTTON_START | POI_BUTTON_OK);
    assert_int_equal(sensors_held_keys(&keys), POI_BUTTON_START | POI_BUTTON_OK);
    press(BTN_START, 0);
    press(KEY_Q, 1);
    assert_int_equal(sensors_held_keys(&keys), POI_BUTTON_OK);
    /* The event value 2 means that a held key is repeated. */
    press(BTN_TRIGGER, 2);
    press(BTN_DPAD_LEFT, 1);
    press(BTN_DPAD_RIGHT, 1);
    press(BTN_THUMB, 1);
    assert_int_equal(sensors_held_keys(&keys), 31 & ~POI_BUTTON_START);
    sensors_close_keys(&keys);
}

static void test_the_motor_follows_its_level_and_stops_at_zero(void **state)
{
    (void)state;
    struct motor motor;
    char why[MOTOR_WHY_SIZE];
    put("sys/class/pwm/pwmchip0/export", "");
    put("sys/class/pwm/pwmchip0/pwm1/duty_cycle", "");
    put("sys/class/pwm/pwmchip0/pwm1/period", "");
    put("sys/class/pwm/pwmchip0/pwm1/enable", "");
    put("sys/class/leds/poi/max_brightness", "255\n");
    put("sys/class/leds/poi/brightness", "");
    config.pwm_chip = 0;
    config.pwm_channel = 1;
    config.motor_least = 0.2f;
    strcpy(config.light, "poi");
    assert_true(motor_open(&motor, &config, root, why));
    assert_int_equal(number_in("sys/class/pwm/pwmchip0/pwm1/period"), 5000000);
    assert_int_equal(number_in("sys/class/pwm/pwmchip0/pwm1/enable"), 1);
    assert_int_equal(number_in("sys/class/pwm/pwmchip0/pwm1/duty_cycle"), 0);
    const struct force_sink sink = motor_sink(&motor);
    const struct poi_force blow = { .slap = 0.5f };
    sink.feel(sink.self, &blow, 0.004f);
    /* The motor turns only at a duty of 0.2 or more. The levels from 0 to 1 are therefore mapped to
     * 0.2 to 1, and the level 0.5 gives a duty of 0.6. */
    assert_in_range(number_in("sys/class/pwm/pwmchip0/pwm1/duty_cycle"), 2999990, 3000010);
    assert_int_equal(number_in("sys/class/leds/poi/brightness"), 128);
    /* Clears the files, because a shorter number that is written over a longer one would leave the
     * last digits of the old number. */
    put("sys/class/pwm/pwmchip0/pwm1/duty_cycle", "");
    put("sys/class/leds/poi/brightness", "");
    sink.stop(sink.self);
    assert_int_equal(number_in("sys/class/pwm/pwmchip0/pwm1/duty_cycle"), 0);
    assert_int_equal(number_in("sys/class/leds/poi/brightness"), 0);
    config.pwm_chip = 9;
    assert_false(motor_open(&motor, &config, root, why));
    assert_non_null(strstr(why, "pwmchip9"));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(test_sensors_are_found_by_name_and_scaled_to_their_units,
                                        build_board, remove_board),
        cmocka_unit_test_setup_teardown(test_a_quaternion_is_read_in_the_order_of_its_driver,
                                        build_board, remove_board),
        cmocka_unit_test_setup_teardown(test_each_missing_sensor_is_named, build_board,
                                        remove_board),
        cmocka_unit_test_setup_teardown(test_the_position_is_lost_while_the_converter_fails,
                                        build_board, remove_board),
        cmocka_unit_test_setup_teardown(test_gpio_keys_are_read_as_levels_and_other_devices_ignored,
                                        build_board, remove_board),
        cmocka_unit_test_setup_teardown(test_the_motor_follows_its_level_and_stops_at_zero,
                                        build_board, remove_board),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
