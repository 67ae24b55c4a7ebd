/* panel.c -- generates pulses on lines of gpio-sim and counts pulses, with better timing than a
 * shell script.
 *
 * Usage: panel pulse WIRE WIDTH_MS REST_MS COUNT [MIN_MS MAX_MS]
 *
 * Pulls the line of the folder WIRE low COUNT times. The true length of each pulse is measured,
 * because an emulated machine stops from time to time. With MIN_MS and MAX_MS, only pulses between
 * these lengths count toward COUNT. Finally the program prints "COUNT pulses of A to B ms, S
 * shorter, L longer".
 *
 * Usage: panel count WIRE FILE
 *
 * Writes to FILE how often the value of the line rose, until a signal ends the program. One thread
 * for each processor polls the line every 10 ms, so that a pulse of 100 ms is detected even if a
 * processor stops. */
#include <fcntl.h>
#include <pthread.h>
#include <sched.h>
#include <stdatomic.h>
#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>
#include <unistd.h>

#define PATH_SIZE 256
#define POLL_MS 10.0
/* Largest number of generated pulses. On a machine that never gives a pulse of the required length,
 * this limit ends the program. */
#define PULSES_MAX 100000u

struct pulses {
    double width_ms, rest_ms, min_ms, max_ms;
    uint32_t count, shorter, longer;
    double narrowest_ms, widest_ms; /* Length of the shortest and of the longest accepted pulse. */
};

static double now_ms(void)
{
    struct timespec now;
    clock_gettime(CLOCK_MONOTONIC, &now);
    return (double)now.tv_sec * 1e3 + (double)now.tv_nsec * 1e-6;
}

static void wait_ms(double ms)
{
    const struct timespec time = { (time_t)(ms / 1e3), (long)((ms - 1e3 * (int)(ms / 1e3)) * 1e6) };
    clock_nanosleep(CLOCK_MONOTONIC, 0, &time, NULL);
}

static void pull(const char *path, const char *word)
{
    const int fd = open(path, O_WRONLY | O_CLOEXEC);
    if (fd < 0 || write(fd, word, strlen(word)) != (ssize_t)strlen(word)) {
        perror(path);
        exit(74);
    }
    close(fd);
}

static void note(struct pulses *pulses, double width_ms)
{
    if (width_ms < pulses->min_ms) {
        pulses->shorter++;
    } else if (width_ms > pulses->max_ms) {
        pulses->longer++;
    } else {
        const double least = pulses->narrowest_ms, most = pulses->widest_ms;
        pulses->narrowest_ms = pulses->count == 0 || width_ms < least ? width_ms : least;
        pulses->widest_ms = width_ms > most ? width_ms : most;
        pulses->count++;
    }
}

static void pulse(struct pulses *pulses, const char *wire, uint32_t count)
{
    char path[PATH_SIZE];
    snprintf(path, sizeof path, "%s/pull", wire);
    for (uint32_t i = 0; pulses->count < count && i < PULSES_MAX; i++) {
        const double begin_ms = now_ms();
        pull(path, "pull-down");
        wait_ms(pulses->width_ms);
        pull(path, "pull-up");
        note(pulses, now_ms() - begin_ms);
        wait_ms(pulses->rest_ms);
    }
    printf("%u pulses of %.0f to %.0f ms, %u shorter, %u longer\n", pulses->count,
           pulses->narrowest_ms, pulses->widest_ms, pulses->shorter, pulses->longer);
}

/* Returns 1 if the line is high. Returns 0 if the line is low or its chip does not exist. */
static bool is_high(const char *path)
{
    char value = '0';
    const int fd = open(path, O_RDONLY | O_CLOEXEC);
    if (fd >= 0) {
        value = read(fd, &value, 1) == 1 ? value : '0';
        close(fd);
    }
    return value == '1';
}

/* Writes the count to a temporary file and then renames the file, so that the program that reads
 * the count never gets an incomplete one. */
static void write_count(const char *path, uint32_t count)
{
    char part[PATH_SIZE];
    snprintf(part, sizeof part, "%s.new", path);
    FILE *file = fopen(part, "w");
    if (!file || fprintf(file, "%u\n", count) < 0 || fclose(file) != 0 || rename(part, path) != 0) {
        perror(path);
        exit(74);
    }
}

/* State of the counted line, which all polling threads share. */
static struct {
    char path[PATH_SIZE];
    pthread_mutex_t lock;
    double polled_ms; /* Time at which the newest processed poll began. */
    int was_high;
    _Atomic uint32_t rises;
} seen = { .lock = PTHREAD_MUTEX_INITIALIZER, .was_high = 1 };

/* Processes the level that a thread has polled. A thread on a stopped processor may pass an old
 * level late, and one pulse could then be counted twice. The function therefore ignores a poll that
 * began before the newest processed poll. */
static void process_level(double polled_ms, int high)
{
    pthread_mutex_lock(&seen.lock);
    if (polled_ms >= seen.polled_ms) {
        if (high && !seen.was_high) {
            atomic_fetch_add(&seen.rises, 1);
        }
        seen.was_high = high;
        seen.polled_ms = polled_ms;
    }
    pthread_mutex_unlock(&seen.lock);
}

static void *poll_line(void *self)
{
    const long processor = (long)self;
    cpu_set_t only;
    CPU_ZERO(&only);
    CPU_SET((size_t)processor, &only);
    sched_setaffinity(0, sizeof only, &only);
    for (;; wait_ms(POLL_MS)) {
        const double polled_ms = now_ms();
        process_level(polled_ms, is_high(seen.path));
    }
    return NULL;
}

__attribute__((noreturn)) static void count_rises(const char *wire, const char *out)
{
    const long processors = sysconf(_SC_NPROCESSORS_ONLN);
    snprintf(seen.path, sizeof seen.path, "%s/value", wire);
    for (long i = 0; i < processors; i++) {
        pthread_t eye;
        if (pthread_create(&eye, NULL, poll_line, (void *)i) != 0) {
            fputs("panel: no thread to look with\n", stderr);
            exit(74);
        }
    }
    for (uint32_t printed = UINT32_MAX;; wait_ms(10.0 * POLL_MS)) {
        const uint32_t rises = atomic_load(&seen.rises);
        if (rises != printed) {
            write_count(out, printed = rises);
        }
    }
}

int main(int argc, char **argv)
{
    /* This priority is lower than that of the kernel's interrupt threads (50). */
    const struct sched_param hand = { .sched_priority = 10 };
    sched_setscheduler(0, SCHED_FIFO, &hand);
    if (argc == 4 && strcmp(argv[1], "count") == 0) {
        count_rises(argv[2], argv[3]);
    }
    if ((argc != 6 && argc != 8) || strcmp(argv[1], "pulse") != 0) {
        fprintf(stderr, "usage: panel pulse WIRE WIDTH_MS REST_MS COUNT [MIN_MS MAX_MS]\n"
                        "       panel count WIRE FILE\n");
        return 2;
    }
    struct pulses pulses = {
        .width_ms = strtod(argv[3], NULL),
        .rest_ms = strtod(argv[4], NULL),
        .min_ms = argc == 8 ? strtod(argv[6], NULL) : 0.0,
        .max_ms = argc == 8 ? strtod(argv[7], NULL) : 1e9,
    };
    pulse(&pulses, argv[2], (uint32_t)strtoul(argv[5], NULL, 10));
    return 0;
}
