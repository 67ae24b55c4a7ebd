/* morph_import.c -- `kingyoctl morph import`: what makers drew, packed for a kiosk. */
#include <stdio.h>
#include <string.h>

#include "core/morph/morph.h"
#include "platform/ctl/import_plan.h"
#include "platform/ctl/morph_pick.h"
#include "platform/ctl/refit.h"
#include "platform/number.h"

#define UNSET 255u
#define PATH_SIZE 256u

static const char name[] = "import";

struct import_words {
    const char *out;
    const char *files[MORPH_KEY_MAX];
    uint32_t file_count;
    const char *id, *like, *fit;
    char marks[MORPH_KEY_MAX][PATH_SIZE]; /* Of each file, with --fit. */
    uint32_t mark_count;
    struct import_plan plan;
};

/* ---- Options -------------------------------------------------------------------------------- */

/* Calls `take` for each piece of "A,B,C"; answers how many there were, or UNSET. */
static uint32_t each_piece(const char *list, uint32_t count_max, void *out,
                           bool (*take)(const char *piece, uint32_t index, void *out))
{
    uint32_t count = 0;
    while (*list) {
        char piece[PATH_SIZE];
        const size_t length = strcspn(list, ",");
        if (length >= sizeof piece || count == count_max) {
            return UNSET;
        }
        memcpy(piece, list, length);
        piece[length] = '\0';
        if (!take(piece, count++, out)) {
            return UNSET;
        }
        list += length + (list[length] == ',');
    }
    return count > 0 ? count : UNSET;
}

/* Nothing of these reaches the core beyond the range that a text may say (text_life.c). */
static bool take_length(const char *piece, uint32_t index, void *out)
{
    return number_parse_decimal(piece, 0.5, 20000.0, (double *)out + index);
}

static bool take_age(const char *piece, uint32_t index, void *out)
{
    return number_parse_decimal(piece, 0.0, 14610.0, (double *)out + index);
}

static bool take_growth(const char *piece, uint32_t index, void *out)
{
    static const double ranges[5][2] = { { 10.0, 20000.0 }, { 0.001, 10.0 }, { -20.0, 20.0 },
                                         { 0.5, 2000.0 },   { 0.001, 5.0 } };
    return number_parse_decimal(piece, ranges[index][0], ranges[index][1], (double *)out + index);
}

static bool take_name(const char *piece, uint32_t index, void *out)
{
    char (*names)[SPECIES_NAME_SIZE] = out;
    const size_t length = strlen(piece);
    if (length >= SPECIES_NAME_SIZE) {
        return false;
    }
    memset(names[index], 0, SPECIES_NAME_SIZE);
    memcpy(names[index], piece, length);
    return species_name_is_good(names[index]);
}

static bool take_path(const char *piece, uint32_t index, void *out)
{
    char (*paths)[PATH_SIZE] = out;
    snprintf(paths[index], PATH_SIZE, "%s", piece);
    return true;
}

static bool take_colour(const char *piece, uint32_t index, void *out)
{
    uint32_t value = 0;
    if (strlen(piece) != 6) {
        return false;
    }
    for (; *piece; piece++) {
        const char *digit = strchr("0123456789abcdef", *piece);
        if (!digit) {
            return false;
        }
        value = value << 4 | (uint32_t)(digit - "0123456789abcdef");
    }
    ((uint32_t *)out)[index] = value;
    return true;
}

static bool take_axis(const char *value, uint8_t *out)
{
    for (uint8_t axis = 0; axis < AXIS_NONE; axis++) {
        if (strcmp(value, import_axis_names[axis]) == 0 ||
            strcmp(value, import_axis_names[axis] + 1) == 0) {
            *out = axis;
            return axis < AXIS_MINUS_X || value[0] == '-';
        }
    }
    return false;
}

static bool take_choice(const char *value, const char *const *words, uint32_t count, uint8_t *out)
{
    for (uint32_t i = 0; i < count; i++) {
        if (strcmp(value, words[i]) == 0) {
            *out = (uint8_t)i;
            return true;
        }
    }
    return false;
}

static bool take_template(const char *value, uint8_t *out)
{
    for (enum graph_template i = TEMPLATE_ORDINARY; i < TEMPLATE_COUNT; i++) {
        if (strcmp(value, morph_template_name(i)) == 0) {
            *out = (uint8_t)i;
            return true;
        }
    }
    return false;
}

static const char *const measures[] = { "total", "standard", "fork", "disc" };
static const char *const motions[] = { "tail", "eel", "fins", "tuna", "wing" };
static const char *const forms[] = { "fusiform", "compressed", "depressed", "eel", "puffer" };

/* Options of one value each. False where it is none; `*known`: is there such an option? */
static bool take_value(struct import_words *words, const char *option, const char *value,
                       bool *known)
{
    struct import_plan *plan = &words->plan;
    *known = true;
    if (strcmp(option, "--id") == 0) {
        words->id = value;
        return value[0] != '\0';
    }
    if (strcmp(option, "--like") == 0) {
        words->like = value;
        return value[0] != '\0';
    }
    if (strcmp(option, "--fit") == 0) {
        words->fit = value;
        return value[0] != '\0';
    }
    if (strcmp(option, "--front") == 0) {
        return take_axis(value, &plan->front);
    }
    if (strcmp(option, "--up") == 0) {
        return take_axis(value, &plan->up);
    }
    if (strcmp(option, "--unit-m") == 0) {
        return number_parse_decimal(value, 1e-6, 1e3, &plan->unit_m) != 0;
    }
    if (strcmp(option, "--measure") == 0) {
        return take_choice(value, measures, 4, &plan->measure);
    }
    if (strcmp(option, "--motion") == 0) {
        return take_choice(value, motions, 5, &plan->motion);
    }
    if (strcmp(option, "--form") == 0) {
        return take_choice(value, forms, 5, &plan->form);
    }
    if (strcmp(option, "--graph") == 0) {
        return take_template(value, &plan->template);
    }
    *known = false;
    return false;
}

/* Options of "A,B,C". */
static bool take_list(struct import_words *words, const char *option, const char *value,
                      bool *known)
{
    struct import_plan *plan = &words->plan;
    const struct {
        const char *name;
        uint32_t *count;
        uint32_t least, most;
        void *out;
        bool (*take)(const char *piece, uint32_t index, void *out);
    } lists[] = {
        { "--names", &plan->name_count, 3, MORPH_KEY_MAX, plan->names, take_name },
        { "--marks", &words->mark_count, 3, MORPH_KEY_MAX, words->marks, take_path },
        { "--lengths-mm", &plan->length_count, 2, MORPH_KEY_MAX, plan->lengths_mm, take_length },
        { "--ages-days", &plan->age_count, 2, MORPH_KEY_MAX, plan->ages_days, take_age },
        { "--growth", &plan->growth_count, 5, 5, plan->growth, take_growth },
        { "--colours", &plan->colour_count, 5, 5, plan->colours, take_colour },
    };
    for (size_t i = 0; i < sizeof lists / sizeof lists[0]; i++) {
        if (strcmp(option, lists[i].name) == 0) {
            const uint32_t got = each_piece(value, lists[i].most, lists[i].out, lists[i].take);
            *known = true;
            *lists[i].count = got;
            return got != UNSET && got >= lists[i].least;
        }
    }
    *known = false;
    return false;
}

/* Sets what `option` says; false where there is no such option or its value is none. */
static bool take_option(struct import_words *words, const char *option, const char *value,
                        bool *known)
{
    const bool good = take_value(words, option, value, known);
    return *known ? good : take_list(words, option, value, known);
}

static enum exit_code read_words(struct import_words *words, int argc, const char *const *argv)
{
    *words = (struct import_words){
        .plan = { .front = AXIS_NONE, .up = AXIS_Y, .measure = UNSET, .motion = UNSET,
                  .form = UNSET, .template = TEMPLATE_OWN, .unit_m = 1.0 },
    };
    for (int i = 0; i < argc; i++) {
        if (strncmp(argv[i], "--", 2) == 0) {
            bool known;
            const char *value = i + 1 < argc ? argv[i + 1] : "";
            if (!take_option(words, argv[i], value, &known)) {
                return known ? morph_usage(name, "%s: '%.60s' will not do; --help says what will",
                                           argv[i], value)
                             : morph_usage(name, "unknown option '%.100s'; --help lists them",
                                           argv[i]);
            }
            i++;
        } else if (!words->out) {
            words->out = argv[i];
        } else if (words->file_count == MORPH_KEY_MAX) {
            return morph_usage(name, "more than %u files", MORPH_KEY_MAX);
        } else {
            words->files[words->file_count++] = argv[i];
        }
    }
    if (words->file_count == 0) {
        return morph_usage(name, "write: OUT.kfish and what to make it of");
    }
    return EXIT_OK;
}

/* ---- Sources -------------------------------------------------------------------------------- */

static bool ends_with(const char *word, const char *suffix)
{
    const size_t length = strlen(word), tail = strlen(suffix);
    return length >= tail && strcmp(word + length - tail, suffix) == 0;
}

/* The file's own name, without folder and suffix, as an id or a key's name. */
static void name_of_file(const char *path, char out[SPECIES_NAME_SIZE])
{
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

static enum exit_code read_meshes(const struct import_words *words, struct import_mesh *mesh)
{
    char why[IMPORT_WHY_SIZE];
    enum exit_code code = EXIT_OK;
    if (!ends_with(words->files[0], ".obj")) {
        code = words->file_count == 1
                   ? import_scene(mesh, words->files[0], why)
                   : morph_usage(name, "several files are .obj files, a shape each");
        if (code != EXIT_OK && code != EXIT_USAGE) {
            fprintf(stderr, "%s\n", why);
        }
        return code;
    }
    for (uint32_t key = 0; key < words->file_count && code == EXIT_OK; key++) {
        code = import_obj(mesh, key, words->files[key], why);
        memset(mesh->key_names[key], 0, IMPORT_NAME_SIZE);
        name_of_file(words->files[key], mesh->key_names[key]);
    }
    if (code != EXIT_OK) {
        fprintf(stderr, "%s\n", why);
    }
    return code;
}

static enum exit_code refuse(const char *path, const char *why)
{
    fprintf(stderr, "%s: %s\n", path, why);
    return EXIT_BAD_DATA;
}

/* A packed species has a near and a far mesh; a small model is both. */
static void use_near_as_far(struct species_slot *slot)
{
    struct species_mesh *far = &slot->species.lod[1];
    slot->tables[1] = slot->tables[0];
    *far = slot->species.lod[0];
    far->vertices = slot->tables[1].vertices;
    far->anchors = slot->tables[1].anchors;
    far->indices = slot->tables[1].indices;
    for (uint32_t key = 0; key < slot->species.card.key_count; key++) {
        far->points[key] = slot->tables[1].points[key];
    }
}

static void tell(const struct import_words *words, const struct import_mesh *mesh,
                 const struct species_slot *slot, const struct import_report *report)
{
    const struct species_card *card = &slot->species.card;
    printf("%s: %s, %u shapes, %u vertices (%u joined), %u triangles; front was %s\n", words->out,
           card->id, card->key_count, slot->species.lod[0].vertex_count, report->joined_count,
           slot->species.lod[0].index_count / 3u, import_axis_names[report->front]);
    for (uint32_t key = 0; key < card->key_count; key++) {
        printf("  %-12s %8.1f days %10.2f mm\n", card->key_names[key],
               (double)card->key_age_days[key], 1e3 * (double)card->key_length_m[key]);
    }
    if (report->knot_count > 0) {
        printf("  graph        %u knots of %u moments, at most %.4f off\n", report->knot_count,
               mesh->time_count, (double)report->graph_error);
    }
}

static enum exit_code make_of_meshes(struct import_words *words, struct species_slot *slot)
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
        return refuse(words->files[0], why);
    }
    if (words->plan.measure == UNSET) {
        words->plan.measure = mesh.has_life      ? mesh.measure
                              : words->plan.like ? words->plan.like->card.measure
                                                 : (uint8_t)MEASURE_TOTAL;
    }
    if (import_orient(&mesh, &words->plan, &report, why) != EXIT_OK ||
        import_build(&mesh, slot, &report, why) != EXIT_OK ||
        import_life(&mesh, &words->plan, slot, &report, why) != EXIT_OK) {
        return refuse(words->files[0], why);
    }
    use_near_as_far(slot);
    char fault[VET_WHY_SIZE];
    if (!species_vet(&slot->species, fault)) {
        return refuse(words->files[0], fault);
    }
    tell(words, &mesh, slot, &report);
    return EXIT_OK;
}

/* `like`, built in or a file; what it gives is used as far as the options do not say otherwise. */
static enum exit_code open_like(struct import_words *words)
{
    static struct species_slot slot;
    struct import_plan *plan = &words->plan;
    for (uint32_t i = 0; words->like && i < species_table_count; i++) {
        if (strcmp(words->like, species_table[i]->card.id) == 0) {
            plan->like = species_table[i];
        }
    }
    if (words->like && !plan->like && !strpbrk(words->like, "/.")) {
        return morph_pick_unknown(name, words->like);
    }
    if (words->like && !plan->like) {
        const enum exit_code code = morph_pick_file(words->like, name, &slot);
        if (code != EXIT_OK) {
            return code;
        }
        plan->like = &slot.species;
    }
    return EXIT_OK;
}

/* Landmarks stand beside their mesh where nobody says otherwise: FISH.obj, FISH.marks. */
static void find_marks(struct import_words *words)
{
    for (uint32_t i = words->mark_count; i < words->file_count; i++) {
        const char *file = words->files[i], *dot = strrchr(file, '.');
        const int length = dot ? (int)(dot - file) : (int)strlen(file);
        snprintf(words->marks[i], PATH_SIZE, "%.*s.marks", length < 240 ? length : 240, file);
    }
}

static enum exit_code make_by_fit(struct import_words *words, struct species_slot *slot)
{
    const char *files[MORPH_KEY_MAX], *marks[MORPH_KEY_MAX];
    char why[IMPORT_WHY_SIZE], fault[VET_WHY_SIZE];
    const struct species *template = words->plan.like;
    if (words->file_count != template->card.key_count) {
        return morph_usage(name, "--fit: '%.60s' has %u keys, and there are %u files", words->fit,
                           template->card.key_count, words->file_count);
    }
    find_marks(words);
    for (uint32_t i = 0; i < words->file_count; i++) {
        files[i] = words->files[i];
        marks[i] = words->marks[i];
    }
    pack_copy(template, slot);
    if (words->plan.measure == UNSET) {
        words->plan.measure = template->card.measure;
    }
    const enum exit_code code =
        refit_files(slot, files, marks, words->file_count, &words->plan, why);
    if (code != EXIT_OK) {
        fprintf(stderr, "%s\n", why);
        return code;
    }
    if (import_fitted_life(&words->plan, &slot->species.card, why) != EXIT_OK) {
        return refuse(words->files[0], why);
    }
    return species_vet(&slot->species, fault) ? EXIT_OK : refuse(words->files[0], fault);
}

/* ---- All of it ------------------------------------------------------------------------------ */

static enum exit_code make(struct import_words *words, struct species_slot *slot)
{
    char id[SPECIES_NAME_SIZE];
    if (ends_with(words->files[0], ".txt") || ends_with(words->files[0], PACK_SUFFIX)) {
        const enum exit_code code =
            words->file_count == 1 ? morph_pick_file(words->files[0], name, slot)
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
    const enum exit_code code = open_like(words);
    return code != EXIT_OK ? code
           : words->fit    ? make_by_fit(words, slot)
                           : make_of_meshes(words, slot);
}

static enum exit_code run(int argc, const char *const *argv)
{
    static struct import_words words;
    static struct species_slot slot;
    char why[VET_WHY_SIZE], id[SPECIES_NAME_SIZE];
    enum exit_code code = read_words(&words, argc, argv);
    if (code != EXIT_OK) {
        return code;
    }
    if (words.id && !take_name(words.id, 0, &id)) {
        return morph_usage(name, "--id: '%.60s' is no name of a-z, 0-9 and _", words.id);
    }
    code = make(&words, &slot);
    if (code != EXIT_OK) {
        return code;
    }
    if (pack_write(words.out, &slot, why) != PACK_OK) {
        return morph_fail(EXIT_IO, name, "%.200s: %s", words.out, why);
    }
    return morph_end(name);
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
    .run = run,
};
