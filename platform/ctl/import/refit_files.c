/* refit_files.c -- reads meshes and landmarks from files, rotates them to the axes of Kingyo, and
 * fits each key of the template. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "platform/ctl/import/import.h"
#include "platform/ctl/import/refit.h"
#include "platform/os/print.h"

/* Greatest distance of a landmark from the surface of the mesh, as a share of the fish's length.
 * Landmarks may lie inside the body. */
#define STRAY_MAX 0.1f

static const struct refit_landmark *mark_of(const struct refit_marks *marks, const char *name)
{
    for (uint32_t i = 0; i < marks->count; i++) {
        if (strcmp(marks->marks[i].name, name) == 0) {
            return &marks->marks[i];
        }
    }
    return NULL;
}

/* Sets `axis` to the coordinate axis nearest to the direction from the landmark `from` to the
 * landmark `to`. If either landmark is missing, `axis` is unchanged. */
static void axis_from(const struct refit_marks *marks, const char *to, const char *from,
                      uint8_t *axis)
{
    const struct refit_landmark *a = mark_of(marks, from), *b = mark_of(marks, to);
    if (a && b) {
        const vec3 way = v3_sub(b->place, a->place);
        const float part[3] = { way.x, way.y, way.z };
        uint8_t most = AXIS_X;
        for (uint8_t i = AXIS_Y; i <= AXIS_Z; i++) {
            most = fabsf(part[i]) > fabsf(part[most]) ? i : most;
        }
        *axis = part[most] < 0.0f ? (uint8_t)(most + AXIS_MINUS_X) : most;
    }
}

/* Rotates and scales a mesh together with its landmarks. For this, the landmarks are appended to
 * the mesh as vertices without triangles. Returns false and writes the reason to `why` after an
 * error. */
static bool orient(struct import_mesh *mesh, struct refit_marks *marks,
                   const struct import_options *plan, char why[IMPORT_WHY_SIZE])
{
    struct import_options own = *plan;
    struct import_report report = { .front = AXIS_NONE };
    const uint32_t first = mesh->vertex_count;
    if (first + marks->count > IMPORT_VERTEX_MAX) {
        snprintf(why, IMPORT_WHY_SIZE, "more than %u vertices", IMPORT_VERTEX_MAX);
        return false;
    }
    for (uint32_t i = 0; i < marks->count; i++) {
        mesh->positions[0][first + i] = marks->marks[i].place;
    }
    mesh->vertex_count += marks->count;
    mesh->key_count = 1; /* Only the first key shape of a scene is used. */
    axis_from(marks, "back", "belly", &own.up);
    axis_from(marks, "snout", "tail_root", &own.front);
    const bool good = import_orient(mesh, &own, &report, why) == EXIT_OK;
    for (uint32_t i = 0; i < marks->count; i++) {
        marks->marks[i].place = mesh->positions[0][first + i];
    }
    mesh->vertex_count = first;
    return good;
}

enum exit_code refit_files(struct species_slot *slot, const char *const *files,
                           const char *const *marks, uint32_t count,
                           const struct import_options *plan, char why[IMPORT_WHY_SIZE])
{
    static struct import_mesh mesh;
    static struct refit_marks list;
    for (uint32_t key = 0; key < count; key++) {
        struct refit_result result;
        char own[IMPORT_WHY_SIZE];
        const size_t length = strlen(files[key]);
        const bool is_obj = length > 4 && strcmp(files[key] + length - 4, ".obj") == 0;
        enum exit_code code =
            is_obj ? import_obj(&mesh, 0, files[key], why) : import_scene(&mesh, files[key], why);
        if (code == EXIT_OK) {
            code = refit_marks_read(marks[key], &list, why);
        }
        if (code != EXIT_OK) {
            return code;
        }
        if (!orient(&mesh, &list, plan, own)) {
            snprintf(why, IMPORT_WHY_SIZE, "%.80s: %.110s", files[key], own);
            return EXIT_BAD_DATA;
        }
        refit_key(slot, key, &mesh, &list, &result);
        if (result.stray_gap > STRAY_MAX) {
            snprintf(why, IMPORT_WHY_SIZE, "%.80s: %s lies %.0f %% of the length off the mesh",
                     marks[key], result.stray, 100.0 * (double)result.stray_gap);
            return EXIT_BAD_DATA;
        }
        print_line(stdout,
                   "  %-24s fit to mesh: mean %.3f, RMS %.3f, max %.2f %% of length;"
                   " mesh to fit: %.3f, %.3f, %.2f %%; landmarks within %.2f %%",
                   files[key], 100.0 * (double)result.to_mesh.mean,
                   100.0 * (double)result.to_mesh.rms, 100.0 * (double)result.to_mesh.max,
                   100.0 * (double)result.from_mesh.mean, 100.0 * (double)result.from_mesh.rms,
                   100.0 * (double)result.from_mesh.max, 100.0 * (double)result.mark_max);
    }
    return EXIT_OK;
}
