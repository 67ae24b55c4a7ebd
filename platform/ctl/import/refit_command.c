/* refit_command.c -- `kingyoctl morph refit`, which bends the body of a species onto meshes of any
 * topology.
 *
 * The command reads one mesh with its landmarks for each key, rotates the mesh to the axes of
 * Kingyo, fits the key, and writes the packed species. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "platform/ctl/import/refit.h"
#include "platform/ctl/morph/morph_import_words.h"
#include "platform/ctl/morph/morph.h"
#include "platform/os/print.h"

/* Greatest distance of a landmark from the surface of the mesh, as a share of the fish's length.
 * Landmarks may lie inside the body. */
#define STRAY_MAX 0.1f

static const char name[] = "refit";

static const struct refit_landmark *mark_of(const struct refit_marks *marks, const char *mark)
{
    for (uint32_t i = 0; i < marks->count; i++) {
        if (strcmp(marks->marks[i].name, mark) == 0) {
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
        for (uint32_t i = AXIS_Y; i <= AXIS_Z; i++) {
            most = fabsf(part[i]) > fabsf(part[most]) ? (uint8_t)i : most;
        }
        *axis = part[most] < 0.0f ? (uint8_t)(most + AXIS_MINUS_X) : most;
    }
}

/* Rotates and scales a mesh together with its landmarks. The landmarks are temporarily appended to
 * the mesh as vertices without triangles. After an error returns false and writes the reason to
 * `why`. */
static bool orient(struct import_mesh *mesh, struct refit_marks *marks,
                   const struct import_options *plan, char why[IMPORT_WHY_SIZE])
{
    struct import_options own = *plan;
    struct import_report report = { .front = AXIS_NONE };
    const uint32_t first = mesh->vertex_count;
    if (first + marks->count > IMPORT_VERTEX_MAX) {
        return import_error(why, "more than %u vertices", IMPORT_VERTEX_MAX);
    }
    for (uint32_t i = 0; i < marks->count; i++) {
        mesh->positions[0][first + i] = marks->marks[i].place;
    }
    mesh->vertex_count += marks->count;
    mesh->key_count = 1; /* Only the first key shape of a mesh file is used. */
    axis_from(marks, "back", "belly", &own.up);
    axis_from(marks, "snout", "tail_root", &own.front);
    const bool good = import_orient(mesh, &own, &report, why);
    for (uint32_t i = 0; i < marks->count; i++) {
        marks->marks[i].place = mesh->positions[0][first + i];
    }
    mesh->vertex_count = first;
    return good;
}

/* Fits the template in `slot` to one mesh for each key. The meshes are rotated and scaled as the
 * options and the landmarks require. The error of each key is printed on standard output. Returns
 * EXIT_OK. After an error, writes the reason with the file name to `why` and returns EXIT_BAD_DATA
 * or EXIT_IO. */
static enum exit_code fit_files(struct species_slot *slot, const struct morph_import_words *words,
                                char why[IMPORT_WHY_SIZE])
{
    static struct import_mesh mesh;
    static struct refit_marks list;
    for (uint32_t key = 0; key < words->file_count; key++) {
        struct refit_result result;
        char own[IMPORT_WHY_SIZE];
        const size_t length = strlen(words->files[key]);
        const bool is_obj = length > 4 && strcmp(words->files[key] + length - 4, ".obj") == 0;
        enum exit_code code = is_obj ? import_obj(&mesh, 0, words->files[key], why)
                                     : import_scene(&mesh, words->files[key], why);
        if (code == EXIT_OK) {
            code = refit_marks_read(words->marks[key], &list, why);
        }
        if (code != EXIT_OK) {
            return code;
        }
        if (!orient(&mesh, &list, &words->plan, own)) {
            snprintf(why, IMPORT_WHY_SIZE, "%.80s: %.110s", words->files[key], own);
            return EXIT_BAD_DATA;
        }
        refit_key(slot, key, &mesh, &list, &result);
        if (result.stray_gap > STRAY_MAX) {
            snprintf(why, IMPORT_WHY_SIZE,
                     "%.80s: landmark %s is %.0f %% of the length away from the mesh",
                     words->marks[key], result.stray, 100.0 * (double)result.stray_gap);
            return EXIT_BAD_DATA;
        }
        print_line(stdout,
                   "  %-24s fit to mesh: mean %.3f, RMS %.3f, max %.2f %% of length;"
                   " mesh to fit: %.3f, %.3f, %.2f %%; landmarks within %.2f %%",
                   words->files[key], 100.0 * (double)result.to_mesh.mean,
                   100.0 * (double)result.to_mesh.rms, 100.0 * (double)result.to_mesh.max,
                   100.0 * (double)result.from_mesh.mean, 100.0 * (double)result.from_mesh.rms,
                   100.0 * (double)result.from_mesh.max, 100.0 * (double)result.mark_max);
    }
    return EXIT_OK;
}

static enum exit_code refit_run(int argc, const char *const *argv)
{
    static struct morph_import_words words;
    static struct species_slot slot;
    char why[IMPORT_WHY_SIZE], fault[VALIDATE_WHY_SIZE];
    enum exit_code code = morph_import_words_read(&words, IMPORT_REFIT, argc, argv);
    if (code == EXIT_OK) {
        code = morph_import_words_open_like(&words, IMPORT_REFIT);
    }
    if (code != EXIT_OK) {
        return code;
    }
    const struct species *bent = words.plan.like;
    if (words.file_count != bent->card.key_count) {
        return morph_usage(name, "'%.60s' has %u key shapes, and there are %u files", words.like,
                           bent->card.key_count, words.file_count);
    }
    /* Unless an option names the landmark file, the landmarks of FISH.obj are in FISH.marks. */
    for (uint32_t i = words.mark_count; i < words.file_count; i++) {
        const char *file = words.files[i], *dot = strrchr(file, '.');
        const int length = dot ? (int)(dot - file) : (int)strlen(file);
        snprintf(words.marks[i], sizeof words.marks[i], "%.*s.marks", length < 240 ? length : 240,
                 file);
    }
    pack_copy(bent, &slot);
    if (words.plan.measure == IMPORT_UNSET) {
        words.plan.measure = bent->card.measure;
    }
    code = fit_files(&slot, &words, why);
    if (code != EXIT_OK) {
        return print_fail(code, "%s", why);
    }
    if (!import_fitted_life(&words.plan, &slot.species.card, why)) {
        return print_fail(EXIT_BAD_DATA, "%s: %s", words.files[0], why);
    }
    if (!species_validate(&slot.species, fault)) {
        return print_fail(EXIT_BAD_DATA, "%s: %s", words.files[0], fault);
    }
    return pack_write(words.out, &slot, fault) == PACK_OK
               ? EXIT_OK
               : morph_fail(EXIT_IO, name, "%.200s: %s", words.out, fault);
}

const struct morph_command ctl_morph_refit = {
    .name = name,
    .words = "OUT.kfish SPECIES|FILE A.obj B.obj C.obj .. [options]",
    .summary = "fits the body of a species to meshes with any triangles, one for each key shape",
    .options = &morph_import_words_table,
    .groups = IMPORT_REFIT,
    .usage = "Give one mesh for each key shape of the species. Each mesh needs a landmark\n"
             "file with four or more lines of the form 'NAME X Y Z', in the coordinates of\n"
             "the mesh. The names are snout, tail_root, back, belly, eye_right, eye_left,\n"
             "tail_top, tail_bottom, and FIN_start, FIN_end, FIN_tip with the FIN dorsal,\n"
             "dorsal2, anal, pectoral_right, pectoral_left, pelvic_right or pelvic_left.\n"
             "Each landmark must be within 10 % of the length from the mesh. The command\n"
             "prints the distances of each fit from its mesh.\n",
    .run = refit_run,
};
