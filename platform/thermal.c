/* thermal.c -- reads the kernel's thermal zones on a separate thread; see thermal.h. */
#include "platform/thermal.h"

#include <dirent.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/eventfd.h>
#include <unistd.h>

#include "core/base/panic.h"
#include "platform/os/file.h"
#include "platform/os/thread.h"

#define PATH_SIZE 512
/* Maximum number of trip points (temperature thresholds) of a thermal zone in the kernel. */
#define TRIP_MAX 12u
#define SANE_MIN_MDEG 0 /* Sensor values outside SANE_MIN_MDEG .. SANE_MAX_MDEG are ignored. */
#define SANE_MAX_MDEG 150000

/* ---- Kernel files -------------------------------------------------------------------------- */

/* Reads the first line of the file `name` of a thermal zone into `line`. Writes "" if there is no
 * such file. */
static void thermal_read_line(char *line, size_t line_size, const char *root, const char *zone,
                              const char *name)
{
    CORE_ASSERT(line_size >= 2);
    char path[PATH_SIZE];
    const int length = snprintf(path, sizeof path, "%s/%s/%s", root, zone, name);
    line[0] = '\0';
    if (length > 0 && length < PATH_SIZE) {
        file_first_line(path, line, line_size);
    }
}

/* Reads a temperature in thousandths of a degree. Returns true if the file has a plausible
 * temperature. */
static bool read_mdeg(const char *root, const char *zone, const char *name, int32_t *out)
{
    char line[32], *end;
    thermal_read_line(line, sizeof line, root, zone, name);
    const long value = strtol(line, &end, 10);
    *out = (int32_t)value;
    return end != line && *end == '\0' && value > SANE_MIN_MDEG && value < SANE_MAX_MDEG;
}

/* Returns the temperature of the zone's lowest passive trip point, above which the kernel slows the
 * machine down. Returns THERMAL_LIMIT_MDEG if the zone has no passive trip point. */
static int32_t limit_of(const char *root, const char *zone)
{
    int32_t limit = SANE_MAX_MDEG;
    for (uint32_t trip = 0; trip < TRIP_MAX; trip++) {
        char name[32], kind[32];
        int32_t at_mdeg;
        snprintf(name, sizeof name, "trip_point_%u_type", trip);
        thermal_read_line(kind, sizeof kind, root, zone, name);
        snprintf(name, sizeof name, "trip_point_%u_temp", trip);
        if (strcmp(kind, "passive") == 0 && read_mdeg(root, zone, name, &at_mdeg) &&
            at_mdeg < limit) {
            limit = at_mdeg;
        }
    }
    return limit < SANE_MAX_MDEG ? limit : THERMAL_LIMIT_MDEG;
}

int32_t thermal_read(const char *root)
{
    int32_t least = THERMAL_UNKNOWN_MDEG, now_mdeg;
    DIR *const folder = opendir(root);
    if (!folder) {
        return least;
    }
    for (const struct dirent *entry; (entry = readdir(folder)) != NULL;) {
        if (strncmp(entry->d_name, "thermal_zone", strlen("thermal_zone")) == 0 &&
            read_mdeg(root, entry->d_name, "temp", &now_mdeg)) {
            const int32_t margin = limit_of(root, entry->d_name) - now_mdeg;
            least = margin < least ? margin : least;
        }
    }
    closedir(folder);
    return least;
}

/* ---- Thread -------------------------------------------------------------------------------- */

static void *thermal_thread(void *self)
{
    struct thermal *thermal = self;
    do {
        atomic_store(&thermal->margin_mdeg,
                     thermal_read(thermal->root ? thermal->root : THERMAL_ROOT));
        atomic_fetch_add(&thermal->measured_count, 1u);
    } while (!thread_wait(thermal->end_fd, THERMAL_PERIOD_S));
    return NULL;
}

void thermal_start(struct thermal *thermal)
{
    if (thermal->runs) {
        return;
    }
    atomic_store(&thermal->margin_mdeg, THERMAL_UNKNOWN_MDEG);
    thermal->end_fd = eventfd(0, EFD_CLOEXEC);
    if (thermal->end_fd >= 0) {
        thermal->runs = thread_start(&thermal->thread, thermal_thread, thermal) == 0;
        if (!thermal->runs) {
            close(thermal->end_fd);
        }
    }
}

void thermal_stop(struct thermal *thermal)
{
    if (!thermal->runs) {
        return;
    }
    eventfd_write(thermal->end_fd, 1);
    pthread_join(thermal->thread, NULL);
    close(thermal->end_fd);
    thermal->runs = false;
}
