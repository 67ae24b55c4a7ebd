/* bench_hid.c -- benchmark of the parser of HID report descriptors and of the decoder of reports.
 *
 * Usage: bench_hid FOLDER [TSV]. FOLDER is tests/hid. The table is also written to the file TSV.
 *
 * The parser reads the descriptors of real devices, malformed descriptors, and descriptors that
 * were built to take as long as possible. The decoder reads one report of a real device, and one
 * report of a simulated device that was built to take as long as possible. Each figure is the CPU
 * time of this thread in the fastest of at least RUNS runs, so that other processes have little
 * influence. The table names the slowest file of each group.
 *
 * Returns exit status 1 if a descriptor takes more than GOAL_US (about a tenth of a frame) or a
 * report takes more than GOAL_REPORT_US. */
#include <dirent.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include "drivers/hid/hid_learn.h"
#include "drivers/hid/poi_hid.h"
#include "platform/ctl/devices/hid_file.h"

#define RUNS 25u
#define GOAL_US 1600.0
#define GOAL_REPORT_US 50.0

static struct hid_descriptor descriptor;
static uint8_t bytes[HID_FILE_SIZE];
static FILE *tsv;
static double worst_us, worst_report_us;

static double now_us(void)
{
    struct timespec now;
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return (double)now.tv_sec * 1e6 + (double)now.tv_nsec * 1e-3;
}

static double read_us(const uint8_t *from, size_t size)
{
    double best = 1e9;
    for (uint32_t run = 0; run < RUNS; run++) {
        const double begin = now_us();
        hid_descriptor_read(&descriptor, from, size);
        const double took = now_us() - begin;
        best = took < best ? took : best;
    }
    worst_us = best > worst_us ? best : worst_us;
    return best;
}

static void row(const char *what, double us, const char *of)
{
    printf("  %-52s %9.2f us   %s\n", what, us, of);
    if (tsv) {
        fprintf(tsv, "%s\t%.3f\t%s\n", what, us, of);
    }
}

/* ---- Benchmarks of recorded files ----------------------------------------------------------- */

static size_t load(const char *path)
{
    FILE *file = fopen(path, "rb");
    if (!file) {
        perror(path);
        exit(74);
    }
    const size_t size = fread(bytes, 1, sizeof bytes, file);
    fclose(file);
    const long count = hid_from_hex(bytes, size, NULL);
    return count >= 0 ? (size_t)count : size;
}

static void bench_folder(const char *what, const char *path)
{
    char file[768], slowest[256] = "";
    double worst = 0.0;
    uint32_t count = 0;
    DIR *folder = opendir(path);
    for (const struct dirent *entry; folder && (entry = readdir(folder));) {
        if (!strstr(entry->d_name, ".hid")) {
            continue;
        }
        snprintf(file, sizeof file, "%s/%s", path, entry->d_name);
        const double us = read_us(bytes, load(file));
        count++;
        if (us > worst) {
            worst = us;
            snprintf(slowest, sizeof slowest, "%s", entry->d_name);
        }
    }
    if (!folder || count == 0) {
        fprintf(stderr, "bench_hid: %s: no descriptors\n", path);
        exit(74);
    }
    closedir(folder);
    row(what, worst, slowest);
}

/* ---- Descriptors that are slow to parse ----------------------------------------------------- */

static void bench_filled(const char *what, const uint8_t *pattern, size_t size)
{
    size_t at = 0;
    for (; at + size <= HID_DESCRIPTOR_SIZE_MAX; at += size) {
        memcpy(bytes + at, pattern, size);
    }
    const double us = read_us(bytes, at);
    row(what, us, hid_error_text(descriptor.error));
}

#define FILLED(what, ...)                                                                          \
    bench_filled((what), (const uint8_t[]){ __VA_ARGS__ }, sizeof((const uint8_t[]){ __VA_ARGS__ }))

/* ---- Reports -------------------------------------------------------------------------------- */

static void bench_report(const char *path)
{
    static uint8_t report_bytes[HID_REPORT_BITS_MAX / 8u + 1u];
    char file[768];
    double best = 1e9;
    int64_t sum = 0;
    snprintf(file, sizeof file, "%s/good/descriptors/016-ci-dualsense.hid", path);
    hid_descriptor_read(&descriptor, bytes, load(file));
    report_bytes[0] = 1;
    for (uint32_t run = 0; run < 40u * RUNS; run++) {
        const double begin = now_us();
        for (uint32_t i = 0; i < descriptor.group_count; i++) {
            const struct hid_group *group = &descriptor.group[i];
            const struct hid_report report = { report_bytes, 64u };
            for (uint32_t j = 0; group->report_id == 1u && j < group->count; j++) {
                sum += hid_field_value(&descriptor, group, j, report);
            }
        }
        const double took = now_us() - begin;
        best = took < best ? took : best;
    }
    row("every value of a DualSense's report", best, sum == 0 ? "64 bytes, at rest" : "");
}

/* ---- A controller that is slow to decode ---------------------------------------------------- */

/* Number of array fields in the slow device's report. A mapping has HID_BINDING_MAX bindings, and
 * two axes and a button need three of these. */
#define ARRAYS (HID_BINDING_MAX - 3u)
#define ARRAY_USAGES 64u
/* Size of one array element in bits. The elements of all arrays must fit in a report
 * (HID_REPORT_MAX bytes). */
#define ELEMENT_BITS 4u
/* Largest value that an array element can have. Each element of the report has this value, which is
 * an index in the array's list of usages. */
#define ELEMENT_MAX 15u

static struct hid_device_info face;
static struct hid_pose_decoder hand;
static struct hid_learn learn;

static void append(const uint8_t *items, uint32_t size)
{
    memcpy(face.descriptor + face.descriptor_size, items, size);
    face.descriptor_size += size;
}

#define APPEND(...)                                                                                \
    append((const uint8_t[]){ __VA_ARGS__ }, sizeof((const uint8_t[]){ __VA_ARGS__ }))

/* Builds the descriptor of the slow device: a joystick with as many arrays as a mapping has room
 * for (ARRAYS). Each array has the largest number of elements (HID_ARRAY_MAX), and the descriptor
 * lists each usage of an array separately. */
static void make_slow(void)
{
    memset(&face, 0, sizeof face);
    APPEND(0x05, 1, 0x09, 4, 0xa1, 1, 0x09, 0x30, 0x09, 0x31, 0x15, 0, 0x25, 127, 0x75, 8, 0x95, 2,
           0x81, 2, 0x05, 9, 0x09, 1, 0x25, 1, 0x75, 1, 0x95, 1, 0x81, 2);
    APPEND(0x25, ARRAY_USAGES - 1u, 0x75, ELEMENT_BITS, 0x95, HID_ARRAY_MAX);
    for (uint32_t i = 0; i < ARRAYS; i++) {
        for (uint8_t usage = 1; usage <= ARRAY_USAGES; usage++) {
            APPEND(0x09, usage);
        }
        APPEND(0x81, 0);
    }
    APPEND(0xc0);
}

static void bind_all(struct hid_mapping *map)
{
    hid_mapping_choose(map, &face.identity, &descriptor);
    map->count = 0;
    for (uint32_t i = 0; i < descriptor.group_count; i++) {
        const struct hid_group *group = &descriptor.group[i];
        const int is_array = !(group->flags & HID_VARIABLE);
        const int is_axis = !is_array && group->count == 2u;
        for (uint32_t j = 0; j < (is_axis ? 2u : 1u); j++) {
            map->binding[map->count++] = (struct hid_binding){
                .role = is_axis ? (j == 0 ? HID_ROLE_X : HID_ROLE_Z) : HID_ROLE_DIP,
                .manner = is_axis ? HID_BINDING_RATE : HID_BINDING_PRESS,
                .bit_offset = group->bit_offset + j * group->bit_size,
                .bit_size = (uint8_t)group->bit_size,
                .usage = is_array ? 0x00090000u + ELEMENT_MAX + 1u : 0u,
                .full = 1,
            };
        }
    }
}

static void report_row(const char *what, double us, const char *of)
{
    worst_report_us = us > worst_report_us ? us : worst_report_us;
    row(what, us, of);
}

static double slow_report_us(struct hid_raw *raw, int is_learned)
{
    double best = 1e9;
    for (uint32_t run = 0; run < 40u * RUNS; run++) {
        raw->time_ns += 1000000u;
        const double begin = now_us();
        if (is_learned) {
            hid_learn_report(&learn, raw);
        } else {
            hid_pose_decoder_report(&hand, raw);
        }
        const double took = now_us() - begin;
        best = took < best ? took : best;
    }
    return best;
}

static void bench_slow_decoder(void)
{
    static const struct view view = { .eye_m = { 0.0f, 0.9f, 0.7f },
                                      .half_height_tan = 0.4f,
                                      .aspect_min = 1.6f };
    struct hid_mapping map;
    struct hid_raw raw = { .time_ns = 1u };
    char of[96];
    make_slow();
    hid_descriptor_read(&descriptor, face.descriptor, face.descriptor_size);
    bind_all(&map);
    if (map.count != HID_BINDING_MAX || hid_pose_decoder_init(&hand, &face, &map, &view) != 0) {
        fputs("bench_hid: the slow controller cannot be played\n", stderr);
        exit(1);
    }
    raw.size = (descriptor.report_bits[0] + 7u) / 8u;
    /* Sets all bits after the two axis bytes. Each array element then has the value ELEMENT_MAX,
     * which selects the usage that bind_all() has mapped. */
    memset(raw.bytes + 2, 0xff, sizeof raw.bytes - 2u);
    if (raw.size > HID_REPORT_MAX || !hid_pose_decoder_report(&hand, &raw)) {
        fputs("bench_hid: the slow controller's report is refused\n", stderr);
        exit(1);
    }
    snprintf(of, sizeof of, "%u arrays of %u elements and %u usages", ARRAYS, HID_ARRAY_MAX,
             ARRAY_USAGES);
    report_row("a report of a controller made to be slow", slow_report_us(&raw, 0), of);
    hid_learn_begin(&learn, &face);
    report_row("the same while it is learned", slow_report_us(&raw, 1), "");
}

int main(int argc, char **argv)
{
    char path[512];
    if (argc < 2) {
        fputs("usage: bench_hid FOLDER [TSV]\n", stderr);
        return 2;
    }
    tsv = argc > 2 ? fopen(argv[2], "w") : NULL;
    snprintf(path, sizeof path, "%s/good/descriptors", argv[1]);
    bench_folder("the slowest real descriptor", path);
    snprintf(path, sizeof path, "%s/malformed", argv[1]);
    bench_folder("the slowest hostile one of the corpus", path);
    FILLED("65,535 bytes of Push and Pop", 0xa4, 0xb4);
    FILLED("65,535 bytes of collections that open and close", 0xa0, 0xc0);
    FILLED("65,535 bytes of Input items that declare nothing", 0x80);
    FILLED("65,535 bytes of usages that no field uses", 0x08, 0xb0);
    FILLED("65,535 bytes of globals", 0x04, 0x14, 0x24, 0x34, 0x44, 0x54, 0x64, 0x74, 0x94);
    FILLED("65,535 bytes of long items", 0xfe, 0x00, 0x00);
    bench_report(argv[1]);
    bench_slow_decoder();
    printf("  memory of what was read: %zu bytes, the caller's, whatever it says\n",
           sizeof descriptor);
    if (tsv) {
        fclose(tsv);
    }
    if (worst_us > GOAL_US) {
        printf("  OVER ITS BOUND: %.0f us, %.0f allowed\n", worst_us, GOAL_US);
    }
    if (worst_report_us > GOAL_REPORT_US) {
        printf("  A REPORT IS OVER ITS BOUND: %.0f us, %.0f allowed\n", worst_report_us,
               GOAL_REPORT_US);
    }
    return worst_us > GOAL_US || worst_report_us > GOAL_REPORT_US;
}
