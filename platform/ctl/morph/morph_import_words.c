/* morph_import_words.c -- the table of the options of `kingyoctl morph import` and `kingyoctl morph
 * refit`, and the parsers of their values. */
#include "platform/ctl/morph/morph_import_words.h"

#include <stdio.h>
#include <string.h>

#include "core/base/panic.h"
#include "core/morph/morph.h"
#include "platform/ctl/morph/morph_options.h"
#include "platform/os/number.h"
#include "platform/species/part.h"

/* ---- Lists of values ------------------------------------------------------------------------- */

/* Parses a number in the range of the option. The ranges of lengths and ages are those of a species
 * text (text_life.c), so that the core receives no other value. */
static bool take_number(const struct option *option, const char *item, uint32_t index, void *out)
{
    return number_parse_decimal(item, option->min, option->max, (double *)out + index);
}

static bool take_growth(const struct option *option, const char *item, uint32_t index, void *out)
{
    static const double ranges[5][2] = {
        { 10.0, 20000.0 }, { 0.001, 10.0 }, { -20.0, 20.0 }, { 0.5, 2000.0 }, { 0.001, 5.0 }
    };
    (void)option;
    return number_parse_decimal(item, ranges[index][0], ranges[index][1], (double *)out + index);
}

static bool take_name(const struct option *option, const char *item, uint32_t index, void *out)
{
    char(*names)[SPECIES_NAME_SIZE] = out;
    (void)option;
    memset(names[index], 0, SPECIES_NAME_SIZE);
    snprintf(names[index], SPECIES_NAME_SIZE, "%s", item);
    return strlen(item) < SPECIES_NAME_SIZE && species_name_is_good(names[index]);
}

static bool take_path(const struct option *option, const char *item, uint32_t index, void *out)
{
    char(*paths)[IMPORT_PATH_SIZE] = out;
    (void)option;
    snprintf(paths[index], IMPORT_PATH_SIZE, "%s", item);
    return true;
}

static bool take_colour(const struct option *option, const char *item, uint32_t index, void *out)
{
    uint32_t *colour = (uint32_t *)out + index;
    (void)option;
    return strlen(item) == 6 && strspn(item, "0123456789abcdef") == 6 &&
           sscanf(item, "%x", colour) == 1;
}

enum list_id { LIST_NAMES, LIST_MARKS, LIST_LENGTHS, LIST_AGES, LIST_GROWTH, LIST_COLOURS };

/* Values of the options whose value is a list with commas between the items. */
static const struct list {
    bool (*take)(const struct option *option, const char *item, uint32_t index, void *out);
    size_t count;         /* Offset of the number of parsed items in struct morph_import_words. */
    uint32_t least, most; /* Allowed number of items. */
} lists[] = {
    [LIST_NAMES] = { take_name, offsetof(struct morph_import_words, plan.name_count), 3,
                     MORPH_KEY_MAX },
    [LIST_MARKS] = { take_path, offsetof(struct morph_import_words, mark_count), 3, MORPH_KEY_MAX },
    [LIST_LENGTHS] = { take_number, offsetof(struct morph_import_words, plan.length_count), 2,
                       MORPH_KEY_MAX },
    [LIST_AGES] = { take_number, offsetof(struct morph_import_words, plan.age_count), 2,
                    MORPH_KEY_MAX },
    [LIST_GROWTH] = { take_growth, offsetof(struct morph_import_words, plan.growth_count), 5, 5 },
    [LIST_COLOURS] = { take_colour, offsetof(struct morph_import_words, plan.colour_count), 5, 5 },
};

static bool set_list(void *target, const struct option *option, const char *value, char *why)
{
    const struct list *list = &lists[option->id];
    void *const place = (char *)target + list->count;
    uint32_t *const count = place;
    (void)why;
    for (*count = 0; *value; ++*count) {
        char item[IMPORT_PATH_SIZE];
        const size_t length = strcspn(value, ",");
        if (length >= sizeof item || *count == list->most) {
            return false;
        }
        memcpy(item, value, length);
        item[length] = '\0';
        if (!list->take(option, item, *count, (char *)target + option->offset)) {
            return false;
        }
        value += length + (value[length] == ',');
    }
    return *count >= list->least;
}

/* ---- Single values --------------------------------------------------------------------------- */

static bool set_id(void *target, const struct option *option, const char *value, char *why)
{
    char id[1][SPECIES_NAME_SIZE];
    (void)why;
    ((struct morph_import_words *)target)->plan.id = value;
    return take_name(option, value, 0, id);
}

static bool set_axis(void *target, const struct option *option, const char *value, char *why)
{
    (void)why;
    for (uint32_t axis = 0; axis < AXIS_NONE; axis++) {
        const char *name = import_axis_names[axis];
        if (strcmp(value, name) == 0 || (axis < AXIS_MINUS_X && strcmp(value, name + 1) == 0)) {
            *((uint8_t *)target + option->offset) = (uint8_t)axis;
            return true;
        }
    }
    return false;
}

static bool set_graph(void *target, const struct option *option, const char *value, char *why)
{
    (void)why;
    for (enum graph_template i = TEMPLATE_ORDINARY; i < TEMPLATE_COUNT; i++) {
        if (strcmp(value, morph_template_name(i)) == 0) {
            *((uint8_t *)target + option->offset) = (uint8_t)i;
            return true;
        }
    }
    return false;
}

static bool add_file(void *target, const struct option *option, const char *value, char *why)
{
    struct morph_import_words *words = target;
    (void)option;
    if (words->file_count == MORPH_KEY_MAX) {
        snprintf(why, OPTION_TEXT_MAX, "more than %u files", MORPH_KEY_MAX);
        return false;
    }
    words->files[words->file_count++] = value;
    return true;
}

/* ---- Command line ---------------------------------------------------------------------------- */

#define AT(member) .offset = offsetof(struct morph_import_words, member)
#define LIST(list_id) OPTION_CUSTOM, .set = set_list, .id = (list_id)
#define AXES "+x, -x, +y, -y, +z or -z"

/* clang-format off */
static const struct option options[] = {
    { NULL, "OUT.kfish", "packed species to write", OPTION_ARGUMENT, AT(out) },
    { NULL, "SPECIES|FILE", "species whose body is fitted to the meshes", OPTION_ARGUMENT,
      AT(like), .groups = IMPORT_REFIT },
    { NULL, "FILE", "input file; a mesh is an .obj file or a scene (.glb and other formats)",
      OPTION_ARGUMENT, .set = add_file },
    { "marks", "A,B,C", "landmark file of each mesh; the default for FISH.obj is FISH.marks",
      LIST(LIST_MARKS), AT(marks), .expects = "a path for each key shape", .groups = IMPORT_REFIT },
    { "id", "ID", "id of the species, of a-z, 0-9 and _; the default is the name of OUT",
      OPTION_CUSTOM, .set = set_id, .expects = "a name of a-z, 0-9 and _" },
    { "names", "A,B,C", "name of each key shape; the default is the name in the file",
      LIST(LIST_NAMES), AT(plan.names), .expects = "3 to 8 names of a-z, 0-9 and _" },
    { "lengths-mm", "A,B,C",
      "real length of each key shape in mm, 0.5 to 20000; the default is the length in the file or "
      "in the fitted species",
      LIST(LIST_LENGTHS), AT(plan.lengths_mm), 0.5, 20000.0,
      .expects = "2 to 8 numbers from 0.5 to 20000" },
    { "unit-m", "U", "length of one unit of the file in metres", OPTION_DECIMAL,
      AT(plan.unit_m), 1e-6, 1e3, .initial = "1", .groups = IMPORT_MESHES },
    { "ages-days", "A,B,C",
      "age of each key shape in days, 0 to 14610; the default comes from --growth, else from the "
      "file, else from --like or the fitted species, else the key shapes are 30 days apart",
      LIST(LIST_AGES), AT(plan.ages_days), 0.0, 14610.0,
      .expects = "2 to 8 numbers from 0 to 14610" },
    { "growth", "LINF_MM,K_PER_YEAR,T0_YEAR,HATCH_MM,FADE_YEAR",
      "von Bertalanffy's growth curve (10 to 20000 mm, 0.001 to 10, -20 to 20, 0.5 to 2000 mm, "
      "0.001 to 5); the default is a curve through the key shapes. Ages and lengths that differ "
      "from the curve by more than 2 % are rejected",
      LIST(LIST_GROWTH), AT(plan.growth),
      .expects = "5 numbers: 10 to 20000, 0.001 to 10, -20 to 20, 0.5 to 2000, 0.001 to 5" },
    { "like", "SPECIES|FILE",
      "species with as many key shapes, from which absent ages, lengths, colours, marks and curves "
      "are taken; its growth is taken only if no option and no file contains ages or lengths",
      OPTION_TEXT, AT(like), .expects = "a species or a file", .groups = IMPORT_MESHES },
    { "graph", "T",
      "deformation graph: ordinary, pairwise, simultaneous or smooth; the default is the file's "
      "animation of the weights, else the graph of --like, else pairwise",
      OPTION_CUSTOM, AT(plan.template_id), .set = set_graph,
      .expects = "ordinary, pairwise, simultaneous or smooth", .groups = IMPORT_MESHES },
    { "front", "AXIS",
      "direction of the snout: " AXES "; the default comes from the landmarks snout and tail_root, "
      "or is the end near the eyes, else the end of the thicker half",
      OPTION_CUSTOM, AT(plan.front), .set = set_axis, .expects = AXES },
    { "up", "AXIS",
      "direction of the back; the default comes from the landmarks back and belly, or is +y",
      OPTION_CUSTOM, AT(plan.up), .set = set_axis, .expects = AXES },
    { "measure", "M", "length measure of the species", OPTION_CHOICE, AT(plan.measure),
      .choices = species_measure_names },
    { "motion", "M", "kind of swimming", OPTION_CHOICE, AT(plan.motion),
      .choices = species_motion_names, .groups = IMPORT_MESHES },
    { "form", "F", "form of the body", OPTION_CHOICE, AT(plan.form),
      .choices = species_form_names, .groups = IMPORT_MESHES },
    { "colours", "BACK,FLANK,BELLY,FIN,IRIS",
      "colours as rrggbb for all key shapes; the default comes from a .glb file that kingyoctl "
      "wrote, else from the vertex colours. Marks come only from a text or from --like",
      LIST(LIST_COLOURS), AT(plan.colours), .expects = "5 colours, each as rrggbb",
      .groups = IMPORT_MESHES },
};
/* clang-format on */

const struct option_table morph_import_words_table = OPTION_TABLE(options, NULL);

static const char *command_name(enum import_command command)
{
    return command == IMPORT_REFIT ? "refit" : "import";
}

enum exit_code morph_import_words_read(struct morph_import_words *words,
                                       enum import_command command, int argc,
                                       const char *const *argv)
{
    CORE_ASSERT(command == IMPORT_MESHES || command == IMPORT_REFIT);
    char error[OPTIONS_ERROR_MAX];
    *words = (struct morph_import_words){
        .plan = { .front = AXIS_NONE,
                  .up = AXIS_Y,
                  .measure = IMPORT_UNSET,
                  .motion = IMPORT_UNSET,
                  .form = IMPORT_UNSET,
                  .template_id = TEMPLATE_OWN },
    };
    if (option_table_parse(&morph_import_words_table, command, words, argc, argv, error)) {
        return morph_usage(command_name(command), "%s", error);
    }
    if (words->file_count == 0) {
        return morph_usage(command_name(command),
                           command == IMPORT_REFIT
                               ? "a mesh for each key shape is missing; write OUT.kfish SPECIES "
                                 "A.obj B.obj C.obj"
                               : "an input file is missing; write OUT.kfish FILE.txt, or meshes");
    }
    return EXIT_OK;
}

void morph_import_words_name(const char *path, char out[SPECIES_NAME_SIZE])
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

enum exit_code morph_import_words_open_like(struct morph_import_words *words,
                                            enum import_command command)
{
    static struct morph_options like;
    static char id[SPECIES_NAME_SIZE];
    morph_import_words_name(words->out, id);
    words->plan.id = words->plan.id ? words->plan.id : id;
    if (!words->like) {
        return EXIT_OK;
    }
    like.word = words->like;
    const enum exit_code code = morph_options_open(&like, command_name(command));
    words->plan.like = code == EXIT_OK ? like.drawn : NULL;
    return code;
}
