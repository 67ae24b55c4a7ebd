/* thermal.c -- reads the kernel's thermal zones on a separate thread; see thermal.h. */
#include "platform/thermal.h"

#include <dirent.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include "core/base/panic.h"
#include "platform/os/file.h"

#define PATH_SIZE 512
#define TRIP_MAX 12u    /* Maximum number of trip points of a zone in the kernel. */
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

/* Reads a temperature in thousandths of a degree. Returns 1 if the file has a plausible
 * temperature, otherwise 0. */
static int read_mdeg(const char *root, const char *zone, const char *name, int32_t *out)
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

/* Waits up to THERMAL_LOOK_S on the monotonic clock. If the wait used the civil clock and this
 * clock were set back by years, the wait would take years. */
static void wait_a_while(struct thermal *thermal)
{
    struct timespec until;
    clock_gettime(CLOCK_MONOTONIC, &until);
    until.tv_sec += THERMAL_LOOK_S;
    pthread_cond_timedwait(&thermal->bell, &thermal->lock, &until);
}

static void *thermal_thread(void *self)
{
    struct thermal *thermal = self;
    const char *root = thermal->root ? thermal->root : "/sys/class/thermal";
    pthread_mutex_lock(&thermal->lock);
    while (!thermal->ends) {
        pthread_mutex_unlock(&thermal->lock);
        atomic_store(&thermal->margin_mdeg, thermal_read(root));
        atomic_fetch_add(&thermal->looks, 1u);
        pthread_mutex_lock(&thermal->lock);
        if (!thermal->ends) {
            wait_a_while(thermal);
        }
    }
    pthread_mutex_unlock(&thermal->lock);
    return NULL;
}

void thermal_start(struct thermal *thermal)
{
    if (thermal->runs) {
        return;
    }
    thermal->ends = false;
    atomic_store(&thermal->margin_mdeg, THERMAL_UNKNOWN_MDEG);
    pthread_mutex_init(&thermal->lock, NULL);
    pthread_condattr_t monotonic;
    pthread_condattr_init(&monotonic);
    pthread_condattr_setclock(&monotonic, CLOCK_MONOTONIC);
    pthread_cond_init(&thermal->bell, &monotonic);
    pthread_condattr_destroy(&monotonic);
    thermal->runs = pthread_create(&thermal->thread, NULL, thermal_thread, thermal) == 0;
}

void thermal_stop(struct thermal *thermal)
{
    if (!thermal->runs) {
        return;
    }
    pthread_mutex_lock(&thermal->lock);
    thermal->ends = true;
    pthread_cond_signal(&thermal->bell);
    pthread_mutex_unlock(&thermal->lock);
    pthread_join(thermal->thread, NULL);
    thermal->runs = false;
}
