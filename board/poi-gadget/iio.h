/* iio.h -- reads sensors of Linux's industrial I/O by name. The sysfs files stay open. */
#ifndef KINGYO_BOARD_POI_GADGET_IIO_H
#define KINGYO_BOARD_POI_GADGET_IIO_H

#include <stddef.h>
#include <stdint.h>

#define IIO_PATH_SIZE 256u

/* Finds the folder of the device with the kernel's name `name` under `root` ("", or the tree of a
 * test). The lowest device number is used if several devices match. Returns 1, or 0 if there is no
 * such device. */
int iio_find(char path[IIO_PATH_SIZE], const char *root, const char *name);

/* Opens an attribute for repeated reads. Returns the file descriptor, or -1. */
int iio_open(const char *device_path, const char *attribute);

/* Reads the attribute's present numbers. Returns 1 if the attribute has exactly `count` <= 4
 * numbers, and 0 otherwise. */
int iio_read(int fd, uint32_t count, float *out);

/* Opens, reads and closes one attribute. The results are those of iio_read(). */
int iio_read_once(const char *device_path, const char *attribute, uint32_t count, float *out);

#endif
