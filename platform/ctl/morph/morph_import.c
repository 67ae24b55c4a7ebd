/* morph_import.c -- `kingyoctl morph import`, which converts meshes or a species text to a packed
 * species for a kiosk. */
#include <stdio.h>
#include <string.h>

#include "core/base/panic.h"
#include "core/morph/morph.h"
#include "platform/ctl/import/refit.h"
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

/* Writes the base name of the file without its suffix to `out`, for use as an id or as the name of
 * a key. */
static void name_of_file(const char *path, char out[SPECIES_NAME_SIZE])
{
    CORE_ASSERT(path);
    const char *slash = strrchr(path, '/');
    const char *base = slash ? slash + 1 : path;
    uint32_t length = 0;
    memset(out, 0, SPECIES_NAME_SIZE);
    for (; *base && *base != '.' && length + 1 < SPECIES_NAME_SIZE; base++) {
        const bool upper = *base >= 'A' && *base <= 'Z';
        const char c = upper ? (char)(*base - 'A' + 'a') : *base;
        const bool fits = (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9');
        out[length++] = fits ? c : '_';
    }
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
        name_of_file(words->files[key], mesh->key_names[key]);
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

static enum exit_code make_by_fit(struct morph_import_words *words, struct species_slot *slot)
{
    const char *files[MORPH_KEY_MAX], *marks[MORPH_KEY_MAX];
    char why[IMPORT_WHY_SIZE], fault[VALIDATE_WHY_SIZE];
    const struct species *template_id = words->plan.like;
    if (words->file_count != template_id->card.key_count) {
        return morph_usage(name, "--fit: '%.60s' has %u keys, and there are %u files", words->fit,
                           template_id->card.key_count, words->file_count);
    }
    /* Unless an option names the landmark file, the landmarks of FISH.obj are in FISH.marks. */
    for (uint32_t i = words->mark_count; i < words->file_count; i++) {
        const char *file = words->files[i], *dot = strrchr(file, '.');
        const int length = dot ? (int)(dot - file) : (int)strlen(file);
        snprintf(words->marks[i], sizeof words->marks[i], "%.*s.marks", length < 240 ? length : 240,
                 file);
    }
    for (uint32_t i = 0; i < words->file_count; i++) {
        files[i] = words->files[i];
        marks[i] = words->marks[i];
    }
    pack_copy(template_id, slot);
    if (words->plan.measure == IMPORT_UNSET) {
        words->plan.measure = template_id->card.measure;
    }
    const enum exit_code code =
        refit_files(slot, files, marks, words->file_count, &words->plan, why);
    if (code != EXIT_OK) {
        print_error("%s", why);
        return code;
    }
    if (import_fitted_life(&words->plan, &slot->species.card, why) != EXIT_OK) {
        return morph_import_error(words->files[0], why);
    }
    return species_validate(&slot->species, fault) ? EXIT_OK
                                                   : morph_import_error(words->files[0], fault);
}

/* ---- Command --------------------------------------------------------------------------------- */

static enum exit_code make(struct morph_import_words *words, struct species_slot *slot)
{
    char id[SPECIES_NAME_SIZE];
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
    name_of_file(words->out, id);
    words->plan.id = words->id ? words->id : id;
    words->like = words->fit ? words->fit : words->like;
    if (words->like) {
        /* The species of --like is built-in or a file. Its values are the defaults for options
         * that are absent. */
        static struct morph_options like;
        like.word = words->like;
        const enum exit_code opened = morph_options_open(&like, name);
        if (opened != EXIT_OK) {
            return opened;
        }
        words->plan.like = like.drawn;
    }
    return words->fit ? make_by_fit(words, slot) : make_of_meshes(words, slot);
}

static enum exit_code morph_import_run(int argc, const char *const *argv)
{
    static struct morph_import_words words;
    static struct species_slot slot;
    char why[VALIDATE_WHY_SIZE], id[SPECIES_NAME_SIZE];
    enum exit_code code = morph_import_words_read(&words, argc, argv);
    if (code != EXIT_OK) {
        return code;
    }
    if (words.id && !morph_import_words_take_name(words.id, 0, &id)) {
        return morph_usage(name, "--id: '%.60s' is no name of a-z, 0-9 and _", words.id);
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
        "  --fit SPECIES|FILE   meshes of any topology: bends the body of that species onto each,\n"
        "                       a file a key, by landmarks (FISH.obj has FISH.marks), and prints\n"
        "                       how far off it is. Lines of 'NAME X Y Z': snout, tail_root, back,\n"
        "                       belly, eye_right, eye_left, tail_top, tail_bottom, and\n"
        "                       NAME_start, NAME_end, NAME_tip of dorsal, dorsal2, anal,\n"
        "                       pectoral_right, .._left, pelvic_right, .._left; four or more,\n"
        "                       each within 10 % of the length of the mesh. As many files as the\n"
        "                       species has keys\n"
        "  --marks A,B,C        the landmarks' files, where they stand elsewhere\n"
        "Parts are known by the names of groups or objects: eye, tail or caudal, dorsal,\n"
        "dorsal_2, anal, pectoral, pelvic, finlet_upper, finlet_lower; all else is body.\n",
    .run = morph_import_run,
};
