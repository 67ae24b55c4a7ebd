/* import_scene.c -- reads glTF and other scene formats with the library assimp in a child process.
 *
 * An importer for many formats is large, and a hostile file may crash it. Therefore this program is
 * not linked with assimp. A child process with limited memory and CPU time loads assimp and writes
 * the mesh to shared memory. The parent process then validates the mesh like any untrusted data. If
 * the child crashes, the parent only prints an error line. A build without assimp's headers rejects
 * scenes with a message. */
#include <errno.h>
#include <float.h>
#include <math.h>
#include <signal.h>
#include <stdio.h>
#include <string.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

#include "core/base/panic.h"
#include "core/base/printable.h"
#include "platform/ctl/import/import.h"

#define MEMORY_MAX (1024ull * 1024ull * 1024ull)
#define CPU_MAX_S 20
#define WAIT_MAX_MS 30000
#define WAIT_STEP_MS 5

/* The address sanitizer reserves terabytes of address space, so a sanitized build cannot set a
 * memory limit. */
#if defined(__has_feature)
#define SANITIZED __has_feature(address_sanitizer)
#elif defined(__SANITIZE_ADDRESS__)
#define SANITIZED 1
#else
#define SANITIZED 0
#endif

struct shared {
    struct import_mesh mesh;
    char why[IMPORT_WHY_SIZE];
    bool done; /* True after a successful import. False means that the import failed. `why` is then
                  the reason, or "" if the child process ended early. */
};

/* Reads the scene in the child process and never returns. The parent process receives only the
 * shared memory and the exit status. */
static _Noreturn void read_in_child(struct shared *shared, const char *path)
{
    const struct rlimit time = { CPU_MAX_S, CPU_MAX_S }, cores = { 0, 0 };
    const struct rlimit memory = { MEMORY_MAX, MEMORY_MAX };
    static const int fatal[] = { SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT, SIGXCPU };
    for (size_t i = 0; i < sizeof fatal / sizeof fatal[0]; i++) {
        signal(fatal[i], SIG_DFL); /* Restores the default action, which ends the child process,
                                      because an inherited signal handler must not run. The parent
                                      process reports the failure. */
    }
    setrlimit(RLIMIT_CPU, &time);
    setrlimit(RLIMIT_CORE, &cores);
    if (!SANITIZED) {
        setrlimit(RLIMIT_AS, &memory);
    }
    shared->done = import_flatten(path, &shared->mesh, shared->why);
    _exit(0);
}

static bool wait_for(pid_t child, int *status)
{
    const struct timespec step = { .tv_nsec = WAIT_STEP_MS * 1000000L };
    for (int ms = 0; ms < WAIT_MAX_MS; ms += WAIT_STEP_MS) {
        if (waitpid(child, status, WNOHANG) == child) {
            return true;
        }
        nanosleep(&step, NULL);
    }
    kill(child, SIGKILL);
    waitpid(child, status, 0);
    return false;
}

/* Returns true if the times of the keyframes increase, and if the weights at each keyframe are at
 * least 0 and have the sum 1, as the deformation graph requires. Sets `*where` to the last checked
 * keyframe. */
static bool validate_weights(const struct import_mesh *m, uint32_t *where)
{
    for (uint32_t i = 0; i < m->time_count; i++) {
        float sum = 0.0f;
        *where = i;
        if (!isfinite(m->times[i]) || (i > 0 && !(m->times[i] > m->times[i - 1]))) {
            return false;
        }
        for (uint32_t key = 0; key < m->key_count; key++) {
            if (!(m->weights[i][key] >= 0.0f)) {
                return false;
            }
            sum += m->weights[i][key];
        }
        if (!(fabsf(sum - 1.0f) <= 1e-4f)) {
            return false;
        }
    }
    return true;
}

/* Returns true if no value is NaN or has an absolute value above `max`. */
static bool are_within(const float *values, uint32_t count, float max)
{
    for (uint32_t i = 0; i < count; i++) {
        if (!(fabsf(values[i]) <= max)) {
            return false;
        }
    }
    return true;
}

const char *import_validate(const struct import_mesh *m, char room[IMPORT_WHY_SIZE / 2])
{
    uint32_t moment = 0;
    bool good = m->measure <= MEASURE_DISC && m->key_count >= 1 && m->key_count <= MORPH_KEY_MAX &&
                m->vertex_count >= 3 && m->vertex_count <= IMPORT_VERTEX_MAX &&
                m->triangle_count >= 1 && m->triangle_count <= IMPORT_TRIANGLE_MAX &&
                m->group_count >= 1 && m->group_count <= IMPORT_GROUP_MAX &&
                m->time_count <= IMPORT_TIME_MAX;
    for (uint32_t i = 0; good && i < m->key_count; i++) {
        good = memchr(m->key_names[i], 0, IMPORT_NAME_SIZE) != NULL;
    }
    for (uint32_t i = 0; good && i < m->group_count; i++) {
        good = memchr(m->group_names[i], 0, IMPORT_NAME_SIZE) != NULL;
    }
    if (!good) {
        return "no shape, or more shapes, vertices, triangles or groups than are allowed";
    }
    for (uint32_t key = 0; good && key < m->key_count; key++) {
        good = are_within(&m->positions[key][0].x, 3 * m->vertex_count, IMPORT_REACH_MAX);
    }
    if (!good || !are_within(m->uv[0], 2 * m->vertex_count, FLT_MAX)) {
        return "a coordinate is not a number or is beyond 1e6";
    }
    for (uint32_t i = 0; i < m->triangle_count; i++) {
        const uint32_t *t = m->triangles[i];
        if (t[0] >= m->vertex_count || t[1] >= m->vertex_count || t[2] >= m->vertex_count ||
            m->groups[i] >= m->group_count) {
            return "a triangle refers to a missing vertex";
        }
    }
    if (!validate_weights(m, &moment)) {
        snprintf(room, IMPORT_WHY_SIZE / 2,
                 "the animation's moment %u: a weight is negative, or the sum is not 1", moment);
        return room;
    }
    return NULL;
}

static enum exit_code import_scene_read_file(struct import_mesh *mesh, struct shared *shared,
                                             const char *path, pid_t child,
                                             char why[IMPORT_WHY_SIZE])
{
    char room[IMPORT_WHY_SIZE / 2];
    int status = 0;
    if (!wait_for(child, &status)) {
        return import_fail(EXIT_BAD_DATA, why, "%.80s: not read within %d s", path,
                           WAIT_MAX_MS / 1000);
    }
    shared->why[IMPORT_WHY_SIZE - 1] = '\0';
    printable(shared->why);
    if (!WIFEXITED(status) || !shared->done) {
        const bool has_reason = WIFEXITED(status) && shared->why[0];
        return import_fail(EXIT_BAD_DATA, why, "%.80s: %.110s", path,
                           has_reason ? shared->why
                                      : "damaged; the importer crashed while reading it");
    }
    memcpy(mesh, &shared->mesh, sizeof *mesh); /* The mesh is copied before the validation, so that
                                                  the child process cannot change the validated
                                                  data. */
    const char *fault = import_validate(mesh, room);
    if (fault) {
        return import_fail(EXIT_BAD_DATA, why, "%.80s: %s", path, fault);
    }
    for (uint32_t key = 0; key < mesh->key_count; key++) {
        printable(mesh->key_names[key]); /* Unprintable characters in the names of key shapes are
                                            replaced, because error messages quote the names. */
    }
    return EXIT_OK;
}

enum exit_code import_scene(struct import_mesh *mesh, const char *path, char why[IMPORT_WHY_SIZE])
{
    CORE_ASSERT(path);
    char missing[IMPORT_WHY_SIZE];
    FILE *file;
    enum exit_code code = import_open(path, IMPORT_FILE_MAX, &file, why);
    if (code != EXIT_OK) {
        return code;
    }
    fclose(file);
    if (!import_can_flatten(missing)) {
        return import_fail(EXIT_NOT_SO, why, "%.60s: %.130s", path, missing);
    }
    struct shared *shared =
        mmap(NULL, sizeof *shared, PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
    const pid_t child = shared == MAP_FAILED ? -1 : fork();
    if (child == 0) {
        read_in_child(shared, path);
    }
    if (child < 0) {
        import_error(why, "cannot start a process that reads the scene: %s", strerror(errno));
        code = EXIT_IO;
    } else {
        code = import_scene_read_file(mesh, shared, path, child, why);
    }
    if (shared != MAP_FAILED) {
        munmap(shared, sizeof *shared);
    }
    return code;
}
