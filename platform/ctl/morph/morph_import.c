/* morph_import.c -- `kingyoctl morph import`, which converts meshes or a species text to a packed
 * species for a kiosk. */
#include <stdio.h>
#include <string.h>

#include "core/base/panic.h"
#include "platform/ctl/morph/morph_import_words.h"
#include "platform/ctl/morph/morph_options.h"
#include "platform/os/file.h"
#include "platform/os/print.h"

static const char name[] = "import";

/* ---- Input files ----------------------------------------------------------------------------- */

static enum exit_code read_meshes(const struct morph_import_words *words, struct import_mesh *mesh)
{
    CORE_ASSERT(words->file_count >= 1 && words->file_count <= MORPH_KEY_MAX);
    char why[IMPORT_WHY_SIZE];
    enum exit_code code = EXIT_OK;
    const bool is_obj = file_has_suffix(words->files[0], ".obj");
    if (!is_obj && words->file_count > 1) {
        return morph_usage(name, "several files must be .obj files, one for each key shape");
    }
    if (!is_obj) {
        code = import_scene(mesh, words->files[0], why);
    }
    for (uint32_t key = 0; is_obj && key < words->file_count && code == EXIT_OK; key++) {
        code = import_obj(mesh, key, words->files[key], why);
        memset(mesh->key_names[key], 0, IMPORT_NAME_SIZE);
        morph_import_words_name(words->files[key], mesh->key_names[key]);
    }
    if (code != EXIT_OK) {
        print_error("%s", why);
    }
    return code;
}

static enum exit_code make_of_meshes(struct morph_import_words *words, struct species_slot *slot)
{
    static struct import_mesh mesh;
    struct import_report report = { .front = AXIS_NONE };
    char why[IMPORT_WHY_SIZE];
    enum exit_code code = read_meshes(words, &mesh);
    if (code != EXIT_OK) {
        return code;
    }
    if (mesh.key_count < 3) {
        snprintf(why, sizeof why, "has %u key shapes; a species has 3 to %u", mesh.key_count,
                 MORPH_KEY_MAX);
        return print_fail(EXIT_BAD_DATA, "%s: %s", words->files[0], why);
    }
    if (words->plan.measure == IMPORT_UNSET) {
        words->plan.measure = mesh.has_life      ? mesh.measure
                              : words->plan.like ? words->plan.like->card.measure
                                                 : (uint8_t)MEASURE_TOTAL;
    }
    if (!import_orient(&mesh, &words->plan, &report, why) ||
        !import_build(&mesh, slot, &report, why) ||
        !import_life(&mesh, &words->plan, slot, &report, why)) {
        return print_fail(EXIT_BAD_DATA, "%s: %s", words->files[0], why);
    }
    /* A packed species needs a near and a far mesh. The far mesh is a copy of the near mesh,
     * because an imported model is small enough for every distance. */
    slot->tables[1] = slot->tables[0];
    slot->species.lod[1] = slot->species.lod[0];
    pack_point(slot);
    char fault[VALIDATE_WHY_SIZE];
    if (!species_validate(&slot->species, fault)) {
        return print_fail(EXIT_BAD_DATA, "%s: %s", words->files[0], fault);
    }
    const struct species_card *card = &slot->species.card;
    print_line(stdout, "%s: %s, %u shapes, %u vertices (%u joined), %u triangles; front was %s",
               words->out, card->id, card->key_count, slot->species.lod[0].vertex_count,
               report.joined_count, slot->species.lod[0].index_count / 3u,
               import_axis_names[report.front]);
    for (uint32_t key = 0; key < card->key_count; key++) {
        printf("  %-12s %8.1f days %10.2f mm\n", card->key_names[key],
               (double)card->key_age_days[key], 1e3 * (double)card->key_length_m[key]);
    }
    if (report.knot_count > 0) {
        printf("  graph        %u knots of %u moments, at most %.4f off\n", report.knot_count,
               mesh.time_count, (double)report.graph_error);
    }
    return EXIT_OK;
}

/* ---- Command --------------------------------------------------------------------------------- */

static enum exit_code make(struct morph_import_words *words, struct species_slot *slot)
{
    if (!file_has_suffix(words->files[0], ".txt") &&
        !file_has_suffix(words->files[0], PACK_SUFFIX)) {
        const enum exit_code code = morph_import_words_open_like(words, IMPORT_MESHES);
        return code == EXIT_OK ? make_of_meshes(words, slot) : code;
    }
    if (words->file_count > 1) {
        return morph_usage(name, "a species is made from one text; write one FILE.txt");
    }
    const enum exit_code code = morph_options_file(words->files[0], name, slot);
    if (code == EXIT_OK && words->plan.id) {
        memset(slot->species.card.id, 0, SPECIES_NAME_SIZE);
        snprintf(slot->species.card.id, SPECIES_NAME_SIZE, "%s", words->plan.id);
    }
    return code;
}

static enum exit_code morph_import_run(int argc, const char *const *argv)
{
    static struct morph_import_words words;
    static struct species_slot slot;
    char why[VALIDATE_WHY_SIZE];
    enum exit_code code = morph_import_words_read(&words, IMPORT_MESHES, argc, argv);
    if (code == EXIT_OK) {
        code = make(&words, &slot);
    }
    if (code == EXIT_OK && pack_write(words.out, &slot, why) != PACK_OK) {
        code = morph_fail(EXIT_IO, name, "%.200s: %s", words.out, why);
    }
    return code;
}

const struct morph_command ctl_morph_import = {
    .name = name,
    .words = "OUT.kfish FILE.txt | MODEL.glb | A.obj B.obj C.obj .. [options]",
    .summary = "packs a species for a kiosk: from a text, morph targets, or a file for each shape",
    .options = &morph_import_words_table,
    .groups = IMPORT_MESHES,
    .usage = "Copy OUT.kfish to DATA/species of a kiosk. The kiosk shows the species after\n"
             "its next start. 'kingyoctl morph refit' converts meshes with any triangles.\n"
             "The names of groups or objects determine the parts of the fish: eye, tail or\n"
             "caudal, dorsal, dorsal_2, anal, pectoral, pelvic, finlet_upper and\n"
             "finlet_lower. Everything else belongs to the body.\n",
    .run = morph_import_run,
};
