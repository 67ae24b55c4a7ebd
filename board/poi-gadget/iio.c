/* iio.c -- reads sensor attributes. Each attribute is a text file that is read again from its
 * start. */
#include "board/poi-gadget/iio.h"

#include <fcntl.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

/* Maximum number of IIO devices that are searched. A board has only a few devices. */
#define DEVICES_MAX 32

/* Writes the path `folder`/`leaf` to `out`. Returns 1, or 0 if the path is too long. */
static int join(char out[IIO_PATH_SIZE], const char *folder, const char *leaf)
{
    return snprintf(out, IIO_PATH_SIZE, "%s/%s", folder, leaf) < (int)IIO_PATH_SIZE;
}

static int read_text(int fd, char *text, size_t size)
{
    const ssize_t got = pread(fd, text, size - 1, 0);
    text[got > 0 ? got : 0] = '\0';
    return got > 0;
}

int iio_open(const char *device_path, const char *attribute)
{
    char path[IIO_PATH_SIZE];
    return join(path, device_path, attribute) ? open(path, O_RDONLY | O_CLOEXEC) : -1;
}

static int is_called(const char *device_path, const char *name)
{
    char text[64];
    const int fd = iio_open(device_path, "name");
    if (fd < 0) {
        return 0;
    }
    const int got = read_text(fd, text, sizeof text);
    close(fd);
    text[strcspn(text, "\n")] = '\0';
    return got && strcmp(text, name) == 0;
}

int iio_find(char path[IIO_PATH_SIZE], const char *root, const char *name)
{
    for (int i = 0; i < DEVICES_MAX; i++) {
        if (snprintf(path, IIO_PATH_SIZE, "%s/sys/bus/iio/devices/iio:device%d", root, i) <
                (int)IIO_PATH_SIZE &&
            is_called(path, name)) {
            return 1;
        }
    }
    return 0;
}

int iio_read(int fd, uint32_t count, float *out)
{
    char text[96];
    if (fd < 0 || !read_text(fd, text, sizeof text)) {
        return 0;
    }
    const char *at = text;
    for (uint32_t i = 0; i < count; i++) {
        char *end;
        out[i] = strtof(at, &end);
        if (end == at) {
            return 0;
        }
        at = end;
    }
    return at[strspn(at, " \n")] == '\0';
}

int iio_read_once(const char *device_path, const char *attribute, uint32_t count, float *out)
{
    const int fd = iio_open(device_path, attribute);
    const int got = iio_read(fd, count, out);
    if (fd >= 0) {
        close(fd);
    }
    return got;
}
