/* iio.h -- reads sensors of Linux's industrial I/O subsystem (IIO) by their names. The opened sysfs
 * files stay open between readings. */
#ifndef KINGYO_BOARD_POI_GADGET_IIO_H
#define KINGYO_BOARD_POI_GADGET_IIO_H

#include <stddef.h>
#include <stdint.h>

#define IIO_PATH_SIZE 256u

/* Finds the folder of the IIO device whose kernel name is `name`, and writes the folder's path to
 * `path`. `root` is the prefix of all paths: "" for this machine, or a test folder. If several
 * devices have the name, the device with the lowest number is used. Returns 1, or 0 if there is no
 * such device. */
int iio_find(char path[IIO_PATH_SIZE], const char *root, const char *name);

/* Opens an attribute of a device for repeated reads. Returns the file descriptor, or -1 after an
 * error. */
int iio_open(const char *device_path, const char *attribute);

/* Reads the present numbers of an attribute. Returns 1 if the attribute contains exactly `count`
 * numbers, otherwise 0. `count` is at most 4. */
int iio_read(int fd, uint32_t count, float *out);

/* Opens, reads and closes an attribute. Returns 1 if the attribute contains exactly `count`
 * numbers, otherwise 0. */
int iio_read_once(const char *device_path, const char *attribute, uint32_t count, float *out);

#endif
