/* iio.h -- sensors of Linux's industrial I/O, by name: its sysfs files, kept open. */
#ifndef KINGYO_POI_GADGET_IIO_H
#define KINGYO_POI_GADGET_IIO_H

#include <stddef.h>
#include <stdint.h>

#define IIO_PATH_SIZE 256u

/* The folder of the device that the kernel calls `name`, under `root` (""; a test's own tree): 1,
 * or 0 where there is none. Of several the first by number. */
int iio_find(char path[IIO_PATH_SIZE], const char *root, const char *name);

/* Opens an attribute to be read again and again: the file, or -1. */
int iio_open(const char *device_path, const char *attribute);

/* Its numbers now: 1 where it has exactly `count` <= 4 of them. */
int iio_read(int fd, uint32_t count, float *out);

/* One attribute, once. */
int iio_read_once(const char *device_path, const char *attribute, uint32_t count, float *out);

#endif
