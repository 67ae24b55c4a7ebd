/* gpio_dev.c -- finds /dev/gpiochip*, and writes error messages. */
#include "drivers/gpio/gpio_backend.h"

#include <errno.h>
#include <fcntl.h>
#include <stdio.h>
#include <string.h>
#include <sys/stat.h>

#include "core/base/panic.h"
#include "drivers/gpio/gpio_config.h"

static bool is_chip(DIR *folder, const char *name)
{
    static const char prefix[] = "gpiochip";
    const int fd = dirfd(folder);
    struct stat status;
    return fd >= 0 && strncmp(name, prefix, sizeof prefix - 1u) == 0 &&
           fstatat(fd, name, &status, AT_SYMLINK_NOFOLLOW) == 0 && !S_ISLNK(status.st_mode);
}

bool gpio_dev_next(struct gpio_dev_walk *walk)
{
    if (!walk->folder) {
        char path[1024];
        const int length = snprintf(path, sizeof path, "%s/dev", walk->root ? walk->root : "");
        CORE_ASSERT(length > 0 && walk->count == 0);
        walk->folder = length < (int)sizeof path ? opendir(path) : NULL;
    }
    const struct dirent *entry;
    while (walk->folder && (entry = readdir(walk->folder)) != NULL) {
        if (is_chip(walk->folder, entry->d_name)) {
            snprintf(walk->path, sizeof walk->path, "/dev/%s", entry->d_name);
            walk->count++;
            return true;
        }
    }
    gpio_dev_end(walk);
    return false;
}

void gpio_dev_end(struct gpio_dev_walk *walk)
{
    if (walk->folder) {
        closedir(walk->folder);
        walk->folder = NULL;
    }
}

void gpio_dev_text(char out[GPIO_TEXT_SIZE], const char *text)
{
    CORE_ASSERT(out);
    snprintf(out, GPIO_TEXT_SIZE, "%s", text ? text : "");
}

void gpio_dev_why_refused(char why[HAL_TEXT_SIZE], const struct gpio_wire *wire, int error,
                          const char *consumer)
{
    char line[GPIO_WIRE_TEXT_SIZE];
    CORE_ASSERT(wire->wired && wire->name[GPIO_TEXT_SIZE - 1u] == '\0');
    gpio_wire_text(wire, line);
    if (error == EBUSY) {
        snprintf(why, HAL_TEXT_SIZE, "%s is in use by '%.31s': stop that program or driver", line,
                 consumer && consumer[0] ? consumer : "another program");
    } else if (error == EACCES || error == EPERM) {
        snprintf(why, HAL_TEXT_SIZE, "%s may not be used: put the kiosk's user into its group",
                 line);
    } else {
        snprintf(why, HAL_TEXT_SIZE, "%s: %s", line, strerror(error));
    }
}

void gpio_dev_why_missing(char why[HAL_TEXT_SIZE], const struct gpio_wire *wire, const char *denied,
                          uint32_t chip_count)
{
    CORE_ASSERT(wire->wired);
    char line[GPIO_WIRE_TEXT_SIZE];
    gpio_wire_text(wire, line);
    if (denied[0]) {
        snprintf(why, HAL_TEXT_SIZE,
                 "%s: %.20s: access denied: put the kiosk's user "
                 "into its group",
                 line, denied);
    } else if (chip_count == 0) {
        snprintf(why, HAL_TEXT_SIZE, "%s: there is no GPIO chip in /dev", line);
    } else {
        snprintf(why, HAL_TEXT_SIZE, "%s: no chip has that line; kingyoctl lines list shows them",
                 line);
    }
}
