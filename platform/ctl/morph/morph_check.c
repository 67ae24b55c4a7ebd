/* morph_check.c -- `kingyoctl morph check`, which reports errors in the growth of a species, for
 * example flipped triangles. */
#include <stddef.h>
#include <stdio.h>

#include "core/base/panic.h"
#include "platform/ctl/morph/morph_options.h"
#include "platform/ctl/morph/morph_survey.h"
#include "platform/os/json.h"
#include "platform/species/part.h"

static const char command[] = "check";

enum column { NEAR, FAR, ORDINARY, COLUMNS };
static const char *const column_names[COLUMNS] = { "near", "far", "ordinary" };

struct check_plan {
    struct morph_options pick;
    uint32_t steps;
    bool as_json;
    const struct species *ordinary;
    struct morph_rig ordinary_rig;
    struct morph_survey survey[COLUMNS];
};

/* One printed value of a survey (morph_survey.h) and its limit. */
struct row {
    const char *title, *key;
    size_t offset; /* Position of the value in struct morph_survey. */
    /* Type of the value. A finding also has the progress and the vertex of the worst value. */
    enum { IS_FLOAT, IS_COUNT, IS_FINDING } type;
    const char *format;
    /* Factor by which the measured value is multiplied for printing. 100 prints a share in
     * percent. */
    double scale;
    double limit; /* Limit in the unit of the printed value. */
    enum { AT_MOST, AT_LEAST, TOLD_ONLY } rule;
};

#define REAL(name) #name, offsetof(struct morph_survey, name), IS_FLOAT
#define COUNT(name) #name, offsetof(struct morph_survey, name), IS_COUNT
#define FOUND(name) #name, offsetof(struct morph_survey, name), IS_FINDING
#define CHORD(name) #name, offsetof(struct morph_survey, name.from_chord), IS_FLOAT

static const struct row rows[] = {
    { "keys' sizes: off one another, %", FOUND(size_error), "%.3f", 100.0, 1.0, AT_MOST },
    { "length off the growth curve, %", FOUND(off_growth), "%.3f", 100.0, 2.0, AT_MOST },
    { "moments at which age does not rise", COUNT(moments_not_older), "%.0f", 1.0, 0.0, AT_MOST },
    { "age leads to another progress, by", FOUND(progress_lost), "%.1e", 1.0, 1e-3, AT_MOST },
    { "length leads to another length, %", FOUND(length_lost), "%.3f", 100.0, 0.1, AT_MOST },
    { "weights: sum is off 1 by", REAL(sum_error), "%.1e", 1.0, 1e-6, AT_MOST },
    { "weights: least", REAL(weight_min), "%.4f", 1.0, 0.0, AT_LEAST },
    { "weights of drawings: sum is off 1 by", REAL(drawn_sum_error), "%.1e", 1.0, 2e-6, AT_MOST },
    { "weights of drawings: least", REAL(drawn_weight_min), "%.4f", 1.0, 0.0, TOLD_ONLY },
    { "keys shown alone", COUNT(keys_alone), "%.0f", 1.0, 0.0, TOLD_ONLY },
    { "key, where shown alone, missed by", FOUND(key_error), "%.1e", 1.0, 0.0, AT_MOST },
    { "triangles turned over: body, eyes", COUNT(flipped_skin), "%.0f", 1.0, 0.0, AT_MOST },
    { "triangles turned over: fins", COUNT(flipped_fins), "%.0f", 1.0, 0.0, AT_MOST },
    { "moments at which the body has a hole", COUNT(moments_open), "%.0f", 1.0, 0.0, AT_MOST },
    { "skin folded into itself, % of length", FOUND(body_in_body), "%.3f", 100.0, 0.0, AT_MOST },
    { "fin deeper than its root, % of length", FOUND(fin_in_body), "%.3f", 100.0, 0.05, AT_MOST },
    { "fin in an eye, % of length", FOUND(fin_in_eye), "%.3f", 100.0, 0.0, AT_MOST },
    { "eye in the head, % of length", FOUND(eye_in_body), "%.3f", 100.0, 0.0, AT_MOST },
    { "pupil in the head, % of length", FOUND(pupil_in_body), "%.3f", 100.0, 0.0, AT_MOST },
    { "eye in the other eye, % of length", FOUND(eye_in_eye), "%.3f", 100.0, 0.0, AT_MOST },
    { "fin root off the skin, % of length", FOUND(root_off_skin), "%.3f", 100.0, 0.0, TOLD_ONLY },
    { "volume below the lesser key's, %", FOUND(volume_dip), "%.3f", 100.0, 2.0, AT_MOST },
    { "dorsal root's path off its chord", CHORD(dorsal_root), "%.5f", 1.0, 0.0, TOLD_ONLY },
    { "right eye's path off its chord", CHORD(eye_right), "%.5f", 1.0, 0.0, TOLD_ONLY },
    { "left eye's path off its chord", CHORD(eye_left), "%.5f", 1.0, 0.0, TOLD_ONLY },
};
#define ROWS (sizeof rows / sizeof rows[0])

static const void *field_of(const struct row *row, const struct morph_survey *survey)
{
    return (const char *)survey + row->offset;
}

static float value_of(const struct row *row, const struct morph_survey *survey)
{
    const void *field = field_of(row, survey);
    return row->type == IS_COUNT     ? (float)*(const uint32_t *)field
           : row->type == IS_FINDING ? ((const struct finding *)field)->value
                                     : *(const float *)field;
}

static double scaled_row_value(const struct row *row, const struct morph_survey *survey)
{
    return (double)value_of(row, survey) * row->scale;
}

static bool is_so(const struct row *row, const struct morph_survey *survey)
{
    const double value = scaled_row_value(row, survey);
    return row->rule == TOLD_ONLY ||
           (row->rule == AT_MOST ? value <= row->limit : value >= row->limit);
}

static bool is_survey_good(const struct morph_survey *survey)
{
    bool good = true;
    for (size_t i = 0; i < ROWS; i++) {
        good = good && is_so(&rows[i], survey);
    }
    return good;
}

static void print_number(const struct row *row, const struct morph_survey *survey)
{
    char text[32];
    snprintf(text, sizeof text, row->format, scaled_row_value(row, survey));
    printf(" %10s", text);
}

static void print_faults(const struct check_plan *plan, enum column column)
{
    CORE_ASSERT(column < COLUMNS);
    for (size_t i = 0; i < ROWS; i++) {
        const struct morph_survey *survey = &plan->survey[column];
        if (!is_so(&rows[i], survey)) {
            printf("not so (%s): %s", column_names[column], rows[i].title);
            print_number(&rows[i], survey);
            if (rows[i].type == IS_FINDING) {
                /* The text is for example " at progress 0.431, vertex 312 (eye)". */
                const struct finding *at = field_of(&rows[i], survey);
                printf(" at progress %.4f", (double)at->progress);
                if (at->vertex != MORPH_SURVEY_NOWHERE) {
                    const struct species_mesh *mesh = column == ORDINARY
                                                          ? &plan->ordinary->lod[0]
                                                          : &plan->pick.fish->lod[column];
                    const uint8_t part = mesh->vertices[at->vertex].part;
                    printf(", vertex %u (%s)", at->vertex, part_names[part]);
                }
            } else if (rows[i].offset == offsetof(struct morph_survey, flipped_skin) ||
                       rows[i].offset == offsetof(struct morph_survey, flipped_fins)) {
                printf(", first at progress %.4f", (double)survey->flipped_at);
            } else if (rows[i].offset == offsetof(struct morph_survey, moments_not_older)) {
                printf(", first at progress %.4f", (double)survey->age_stands_at);
            }
            putchar('\n');
        }
    }
}

static void morph_check_print_text(const struct check_plan *plan)
{
    const struct species_card *card = &plan->pick.fish->card;
    printf("%s: %u keys, %u curves, %u moments; %u vertices near, %u far\n", card->id,
           card->key_count, card->curve_count, plan->steps + 1u,
           plan->pick.fish->lod[0].vertex_count, plan->pick.fish->lod[1].vertex_count);
    printf("%-38s %10s %10s %10s   must be\n", "", column_names[NEAR], column_names[FAR],
           column_names[ORDINARY]);
    for (size_t i = 0; i < ROWS; i++) {
        printf("%-38s", rows[i].title);
        for (int column = 0; column < COLUMNS; column++) {
            print_number(&rows[i], &plan->survey[column]);
        }
        if (rows[i].rule != TOLD_ONLY) {
            printf("   %s %g", rows[i].rule == AT_MOST ? "<=" : ">=", rows[i].limit);
        }
        putchar('\n');
    }
    print_faults(plan, NEAR);
    print_faults(plan, FAR);
}

static const struct option options[] = {
    { "steps", "N", "number of moments minus one", OPTION_WHOLE,
      .offset = offsetof(struct check_plan, steps), 1, 100000, .initial = "1000" },
    { "json", NULL, "print JSON, in which shares are not percentages", OPTION_FLAG,
      .offset = offsetof(struct check_plan, as_json) },
};

static const struct option_table table = { options, sizeof options / sizeof options[0],
                                           &morph_options_table };

static enum exit_code morph_check_run(int argc, const char *const *argv)
{
    static struct check_plan plan;
    plan = (struct check_plan){ .steps = 0 };
    const enum exit_code code =
        morph_options_read(&plan.pick, command, MORPH_REQUIRES_CURVES, &table, argc, argv);
    if (code != EXIT_OK) {
        return code;
    }
    plan.ordinary = morph_options_ordinary(&plan.pick, &plan.ordinary_rig);
    for (uint32_t lod = 0; lod < SPECIES_LOD_COUNT; lod++) {
        morph_survey(plan.pick.fish, &plan.pick.rig, lod, plan.steps, &plan.survey[lod]);
    }
    morph_survey(plan.ordinary, &plan.ordinary_rig, 0, plan.steps, &plan.survey[ORDINARY]);
    const bool good = is_survey_good(&plan.survey[NEAR]) && is_survey_good(&plan.survey[FAR]);
    if (plan.as_json) {
        struct json json = { .file = stdout };
        json_open(&json, NULL, '{');
        json_text(&json, "species", plan.pick.fish->card.id);
        json_value(&json, "moments", "%u", plan.steps + 1u);
        json_bool(&json, "good", good);
        for (int column = 0; column < COLUMNS; column++) {
            const struct morph_survey *survey = &plan.survey[column];
            json_line(&json, 1);
            json_open(&json, column_names[column], '{');
            json_bool(&json, "good", is_survey_good(survey));
            for (size_t i = 0; i < ROWS; i++) {
                json_value(&json, rows[i].key, "%.9g", (double)value_of(&rows[i], survey));
                const struct finding *at = field_of(&rows[i], survey);
                if (rows[i].type == IS_FINDING && at->value > 0.0f) {
                    char key[64];
                    snprintf(key, sizeof key, "%s_at", rows[i].key);
                    json_value(&json, key, "%.6f", (double)at->progress);
                }
            }
            json_close(&json, '}');
        }
        json_close(&json, '}');
        json_end(&json);
    } else {
        morph_check_print_text(&plan);
    }
    return good ? EXIT_OK : EXIT_NOT_SO;
}

const struct morph_command ctl_morph_check = {
    .name = command,
    .options = &table,
    .groups = MORPH_REQUIRES_CURVES,
    .words = "SPECIES|FILE [--template T] [--thesis] [--steps N] [--json]",
    .summary = "whether it grows without a flaw, in figures, the ordinary morph's beside them",
    .usage =
        "near and far are the two levels of detail, ordinary is the near fish morphed straight\n"
        "from its first key to its last. Lengths are of the body's own length.\n\n"
        "What counts, and what is by design:\n"
        "  sizes         all keys are one long as the species measures it (size is a curve of its\n"
        "                own), snout at one place\n"
        "  length, age   older at every moment; as long as the growth curve says, but for a size\n"
        "                drawn by hand; each leads back to the other\n"
        "  turned over   a triangle of body or eye that faces inward; a fin's that faces back at\n"
        "                once, for one that turns step by step does not count\n"
        "  a hole        without a closed body nothing can be told to be inside of it\n"
        "  skin folded   a point just outside the body's skin that is inside the body; told is\n"
        "                the way out along its normal\n"
        "  fin           it is rooted in the body, and lies in it whole before it has grown: told\n"
        "                is how much deeper than the root of its own ray a point is. Fins against\n"
        "                fins do not count: they are sheets that the water bends\n"
        "  eye           a ball half sunk in the skin: what shows of it counts, in the head (the\n"
        "                middle half, the pupil, apart) and in the other eye; its seat does not\n"
        "  volume        of the body, one long, against the lesser of the two keys around\n"
        "  weights       the graph's must be at least 0; where shapes are solved so that the fish\n"
        "                passes through every drawing, the drawings' own may be less\n"
        "\nExit status 1 when something is not so.\n",
    .run = morph_check_run,
};
