/* morph_import.c -- `kingyoctl morph import`, which converts meshes or a species text to a packed
 * species for a kiosk. */
#include <stdio.h>
#include <string.h>

#include "core/base/panic.h"
#include "core/morph/morph.h"
#include "platform/ctl/morph/morph_import_words.h"
#include "platform/ctl/morph/morph_options.h"
#include "platform/os/print.h"

static const char name[] = "import";

/* ---- Input files ----------------------------------------------------------------------------- */

static bool ends_with(const char *word, const char *suffix)
{
    const size_t length = strlen(word), tail = strlen(suffix);
    return length >= tail && strcmp(word + length - tail, suffix) == 0;
}

static enum exit_code read_meshes(const struct morph_import_words *words, struct import_mesh *mesh)
{
    CORE_ASSERT(words->file_count >= 1 && words->file_count <= MORPH_KEY_MAX);
    char why[IMPORT_WHY_SIZE];
    enum exit_code code = EXIT_OK;
    if (!ends_with(words->files[0], ".obj")) {
        code = words->file_count == 1
                   ? import_scene(mesh, words->files[0], why)
                   : morph_usage(name, "several files are .obj files, a shape each");
        if (code != EXIT_OK && code != EXIT_USAGE) {
            print_error("%s", why);
        }
        return code;
    }
    for (uint32_t key = 0; key < words->file_count && code == EXIT_OK; key++) {
        code = import_obj(mesh, key, words->files[key], why);
        memset(mesh->key_names[key], 0, IMPORT_NAME_SIZE);
        morph_import_words_name(words->files[key], mesh->key_names[key]);
    }
    if (code != EXIT_OK) {
        print_error("%s", why);
    }
    return code;
}

static enum exit_code morph_import_error(const char *path, const char *why)
{
    print_error("%s: %s", path, why);
    return EXIT_BAD_DATA;
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
        snprintf(why, sizeof why, "%u shapes, and a species has 3 to %u", mesh.key_count,
                 MORPH_KEY_MAX);
        return morph_import_error(words->files[0], why);
    }
    if (words->plan.measure == IMPORT_UNSET) {
        words->plan.measure = mesh.has_life      ? mesh.measure
                              : words->plan.like ? words->plan.like->card.measure
                                                 : (uint8_t)MEASURE_TOTAL;
    }
    if (import_orient(&mesh, &words->plan, &report, why) != EXIT_OK ||
        import_build(&mesh, slot, &report, why) != EXIT_OK ||
        import_life(&mesh, &words->plan, slot, &report, why) != EXIT_OK) {
        return morph_import_error(words->files[0], why);
    }
    /* The far mesh is a copy of the near mesh, because a packed species needs both. A small
     * imported model is used at every distance. */
    struct species_mesh *far = &slot->species.lod[1];
    slot->tables[1] = slot->tables[0];
    *far = slot->species.lod[0];
    far->vertices = slot->tables[1].vertices;
    far->anchors = slot->tables[1].anchors;
    far->indices = slot->tables[1].indices;
    for (uint32_t key = 0; key < slot->species.card.key_count; key++) {
        far->points[key] = slot->tables[1].points[key];
    }
    char fault[VALIDATE_WHY_SIZE];
    if (!species_validate(&slot->species, fault)) {
        return morph_import_error(words->files[0], fault);
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
    if (ends_with(words->files[0], ".txt") || ends_with(words->files[0], PACK_SUFFIX)) {
        const enum exit_code code = words->file_count == 1
                                        ? morph_options_file(words->files[0], name, slot)
                                        : morph_usage(name, "one text makes one species");
        if (code == EXIT_OK && words->id) {
            memset(slot->species.card.id, 0, SPECIES_NAME_SIZE);
            snprintf(slot->species.card.id, SPECIES_NAME_SIZE, "%s", words->id);
        }
        return code;
    }
    const enum exit_code code = morph_import_words_open_like(words, IMPORT_MESHES);
    return code == EXIT_OK ? make_of_meshes(words, slot) : code;
}

static enum exit_code morph_import_run(int argc, const char *const *argv)
{
    static struct morph_import_words words;
    static struct species_slot slot;
    char why[VALIDATE_WHY_SIZE];
    enum exit_code code = morph_import_words_read(&words, IMPORT_MESHES, argc, argv);
    if (code != EXIT_OK) {
        return code;
    }
    code = make(&words, &slot);
    if (code != EXIT_OK) {
        return code;
    }
    if (pack_write(words.out, &slot, why) != PACK_OK) {
        return morph_fail(EXIT_IO, name, "%.200s: %s", words.out, why);
    }
    return EXIT_OK;
}

const struct morph_command ctl_morph_import = {
    .name = name,
    .words = "OUT.kfish FILE.txt | MODEL.glb | A.obj B.obj C.obj .. [options]",
    .summary = "packs a species for a kiosk: from a text, morph targets, or a shape a file",
    .usage =
        "Put OUT.kfish into DATA/species of a kiosk, and it is there at the next start. What is\n"
        "made of meshes:\n"
        "  --id ID              its name, a-z, 0-9 and _; otherwise OUT's\n"
        "  --names A,B,C        the keys' names; otherwise the file's\n"
        "  --lengths-mm A,B,C   how long each key truly is, 0.5 to 20000; otherwise as in\n"
        "                       the file\n"
        "  --unit-m U           what the file's 1 is worth in metres; 1 otherwise\n"
        "  --ages-days A,B,C    how old each key is, 0 to 14610; otherwise by --growth, else\n"
        "                       as in the file, else as --like, else a month apart\n"
        "  --growth LINF_MM,K_PER_YEAR,T0_YEAR,HATCH_MM,FADE_YEAR\n"
        "                       von Bertalanffy's curve (10 to 20000 mm, 0.001 to 10, -20 to 20,\n"
        "                       0.5 to 2000 mm, 0.001 to 5); otherwise one through the keys. Ages\n"
        "                       and lengths that it does not give within 2 % are refused\n"
        "  --like SPECIES|FILE  takes ages, lengths, growth, colours, marks and curves of a\n"
        "                       species with as many keys; where ages or lengths are told, its\n"
        "                       growth gives way to one through the keys\n"
        "  --graph T            pairwise, simultaneous, smooth or ordinary; otherwise the file's\n"
        "                       animation of weights, else --like's, else pairwise\n"
        "  --front AXIS         where the snout points: +x, -x, +y, -y, +z or -z; otherwise\n"
        "                       toward the eyes, else the thicker half of the longer axis\n"
        "  --up AXIS            where the back is; +y otherwise\n"
        "  --measure M          total, standard, fork or disc: the length that is meant\n"
        "  --motion M           tail, eel, fins, tuna or wing\n"
        "  --form F             fusiform, compressed, depressed, eel or puffer\n"
        "  --colours BACK,FLANK,BELLY,FIN,IRIS\n"
        "                       each rrggbb; otherwise what our own .glb says of each key,\n"
        "                       else the file's vertex colours, for all keys. Marks are painted\n"
        "                       by a text or by --like alone\n"
        "Meshes of any topology are for 'kingyoctl morph refit'.\n"
        "Parts are known by the names of groups or objects: eye, tail or caudal, dorsal,\n"
        "dorsal_2, anal, pectoral, pelvic, finlet_upper, finlet_lower; all else is body.\n",
    .run = morph_import_run,
};
