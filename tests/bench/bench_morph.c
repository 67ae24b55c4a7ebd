/* bench_morph.c -- benchmark of the blending of morph targets, compared with the memory bandwidth.
 *
 * Usage: bench_morph [TSV]. The table is also written to the file TSV, with a row for each number
 * of morph targets (keys).
 *
 * For each vertex a blend reads 8 bytes per key and 16 more bytes, and writes 24 bytes (position
 * and normal). A blend cannot be faster than a copy of the same number of bytes. The benchmark
 * therefore alternates between blends and memcpy() of this number of bytes. The benchmark uses so
 * many fish that their data do not fit in a cache. The figure is the bandwidth of the blend in the
 * fastest round, as a share of the copy's bandwidth. This share must be at least GOAL.
 *
 * The table also has the time for one fish that stays in the cache, as in the kiosk, with and
 * without SIMD. A second table has fish with several blend curves and anchors. The second table has
 * no goal, because these fish need more arithmetic than memory accesses.
 *
 * Returns exit status 1 if a share in the first table is below GOAL. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include "core/base/panic.h"
#include "core/base/rng.h"
#include "core/morph/blend_lanes.h"

#define VERTICES 1000u /* Number of vertices of one fish. */
/* Number of vertices that are attached to an anchor, as the vertices of fins and eyes are. The
 * detailed meshes of the game's fish have about as many. */
#define ANCHORED 400u
/* Size of the memory for all fish in bytes. The size is six times that of the last-level cache of
 * the reference machine, so that the fish do not fit in the cache. */
#define ARENA_SIZE ((size_t)192 << 20)
#define ROUNDS 15u
#define GOAL 0.5

_Noreturn void core_panic(const char *condition, const char *file, int line)
{
    fprintf(stderr, "bench_morph: %s:%d: %s\n", file, line, condition);
    abort();
}

static double now_s(void)
{
    struct timespec now;
    /* CPU time of this thread, because other processes may run at the same time. */
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return (double)now.tv_sec + (double)now.tv_nsec * 1e-9;
}

struct one_fish {
    struct species_vertex vertices[VERTICES];
    struct species_point points[MORPH_KEY_MAX][VERTICES];
    vec3 positions[VERTICES], normals[VERTICES];
};

static struct one_fish *arena;
static size_t fish_count;
static struct species_anchor anchors[ANCHOR_MAX];
static struct morph_pose pose;

static size_t bytes_moved(uint32_t key_count)
{
    return 8u * key_count + sizeof(struct species_vertex) + 2u * sizeof(vec3);
}

static void fill(bool anchored)
{
    uint32_t use = 0;
    for (size_t i = 0; i < fish_count; i++) {
        int16_t *words = &arena[i].points[0][0].x;
        for (size_t k = 0; k < sizeof arena[i].points / sizeof words[0]; k++) {
            words[k] = (int16_t)(rng_u32((struct rng_key){ 1, 2, use++, RNG_TEST }) >> 17);
        }
        for (uint32_t k = 0; k < VERTICES; k++) {
            const bool rides = anchored && k >= VERTICES - ANCHORED;
            arena[i].vertices[k] = (struct species_vertex){
                .anchor = rides ? (uint8_t)(k / 6u % ANCHOR_MAX) : ANCHOR_NONE,
                .mask = { rides ? 155 : 255, rides ? 100 : 0 },
            };
        }
    }
}

static void pose_of(uint32_t key_count)
{
    pose = (struct morph_pose){ 0 };
    for (uint32_t curve = 0; curve < MORPH_CURVE_MAX; curve++) {
        for (uint32_t key = 0; key < key_count; key++) {
            pose.weight[curve][key] = 1.0f / (float)key_count;
        }
    }
    for (uint32_t i = 0; i < ANCHOR_MAX; i++) {
        pose.anchor[i].turn = (struct quat){ 0.6f, 0.0f, 0.0f, 0.8f };
    }
}

/* Returns the time in seconds for `count` blends of the first `among` fish of the arena, in turn.
 * If `single` is true, the function blends one vertex at a time, without SIMD. */
static double blend_s(uint32_t key_count, bool single, size_t count, size_t among)
{
    const double begin = now_s();
    for (size_t i = 0; i < count; i++) {
        struct one_fish *fish = &arena[i % among];
        struct species_mesh mesh = { .vertex_count = VERTICES,
                                     .anchor_count = ANCHOR_MAX,
                                     .reach = 1.0f,
                                     .vertices = fish->vertices,
                                     .anchors = anchors };
        for (uint32_t key = 0; key < key_count; key++) {
            mesh.points[key] = fish->points[key];
        }
        if (single) {
            blend_each(&mesh, key_count, &pose, 0, fish->positions, fish->normals);
        } else {
            morph_shape(&mesh, key_count, &pose, fish->positions, fish->normals);
        }
    }
    return now_s() - begin;
}

/* Copies one half of the fish memory to the other half in pieces of the size of one blend's output,
 * so that the cache is used as by a blend. Returns the seconds per byte. Each copied byte counts
 * twice, because it is read and written. */
static double copy_s_per_byte(void)
{
    const size_t piece = VERTICES * 2u * sizeof(vec3), half = fish_count / 2u * sizeof arena[0];
    size_t copied = 0;
    const double begin = now_s();
    for (; copied + piece <= half; copied += piece) {
        memcpy((char *)arena + copied, (char *)arena + half + copied, piece);
    }
    return (now_s() - begin) / (2.0 * (double)copied);
}

struct measured {
    double ns, bound_ns, hot_ns, scalar_ns;
};

static void keep_least(double *least, double ns)
{
    *least = ns < *least ? ns : *least;
}

/* Returns the shortest time of each case over all rounds, because other processes disturb the
 * shortest round least. */
static struct measured measure(uint32_t key_count)
{
    struct measured least = { 1e9, 1e9, 1e9, 1e9 };
    const double per_vertex = 1e9 / (double)VERTICES, fish = (double)fish_count;
    pose_of(key_count);
    for (uint32_t round = 0; round < ROUNDS; round++) {
        keep_least(&least.ns,
                   blend_s(key_count, false, fish_count, fish_count) / fish * per_vertex);
        keep_least(&least.bound_ns, copy_s_per_byte() * (double)bytes_moved(key_count) * 1e9);
        keep_least(&least.hot_ns, blend_s(key_count, false, 200, 1) / 200.0 * per_vertex);
        keep_least(&least.scalar_ns, blend_s(key_count, true, 100, 1) / 100.0 * per_vertex);
    }
    return least;
}

static bool print_table(bool anchored, FILE *tsv)
{
    static const uint32_t key_counts[] = { 3, 5, 8 };
    bool good = true;
    fill(anchored);
    puts(anchored ? "Two curves, 40 % of the vertices on anchors" : "One curve, no anchors");
    printf("  %4s %10s %12s %10s %8s %12s %14s\n", "keys", "bytes", "bound ns", "ns", "share",
           "in cache ns", "one by one ns");
    for (size_t i = 0; i < sizeof key_counts / sizeof key_counts[0]; i++) {
        const uint32_t keys = key_counts[i];
        const struct measured m = measure(keys);
        printf("  %4u %10zu %12.2f %10.2f %7.0f%% %12.2f %14.2f\n", keys, bytes_moved(keys),
               m.bound_ns, m.ns, 100.0 * (m.bound_ns / m.ns), m.hot_ns, m.scalar_ns);
        if (tsv) {
            fprintf(tsv, "%s\t%u\t%zu\t%.3f\t%.3f\t%.4f\t%.3f\t%.3f\n",
                    anchored ? "anchored" : "plain", keys, bytes_moved(keys), m.bound_ns, m.ns,
                    m.bound_ns / m.ns, m.hot_ns, m.scalar_ns);
        }
        good = good && m.bound_ns / m.ns >= GOAL;
    }
    return good;
}

int main(int argc, char **argv)
{
    FILE *tsv = argc > 1 ? fopen(argv[1], "w") : NULL;
    fish_count = ARENA_SIZE / sizeof arena[0];
    arena = malloc(fish_count * sizeof arena[0]);
    if (!arena || (argc > 1 && !tsv)) {
        fputs("bench_morph: no memory, or no file\n", stderr);
        return 74;
    }
    if (tsv) {
        fputs("mesh\tkeys\tbytes\tbound_ns\tns\tshare\tin_cache_ns\tone_by_one_ns\n", tsv);
    }
    puts("A vertex blended, ns; bound: as many bytes copied; share: bound / ns");
    const bool good = print_table(false, tsv);
    print_table(true, tsv);
    printf("%s: each share of the first table is to be at least %.0f %%\n",
           good ? "good" : "NOT so", 100.0 * GOAL);
    free(arena);
    return (tsv && fclose(tsv) != 0) ? 74 : good ? 0 : 1;
}
