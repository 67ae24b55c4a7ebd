/* morph_check.c -- `kingyoctl morph check`, which reports errors in the growth of a species, for
 * example flipped triangles. */
#include <stddef.h>
#include <stdio.h>

#include "core/base/panic.h"
#include "platform/ctl/morph/morph_options.h"
#include "platform/ctl/morph/morph_survey.h"
#include "platform/os/json.h"
#include "platform/species/part.h"

enum column { NEAR, FAR, ORDINARY, COLUMNS };
static const char *const column_names[COLUMNS] = { "near", "far", "ordinary" };

static struct check_plan {
    struct morph_options pick;
    uint32_t steps;
    bool as_json;
    const struct species *ordinary;
    struct morph_rig ordinary_rig;
    struct morph_survey survey[COLUMNS];
} plan;

/* One printed value of a survey (morph_survey.h) and its limit. */
struct row {
    const char *title, *key;
    size_t offset; /* Position of the value in struct morph_survey. */
    /* Type of the value. A finding also has the progress and the vertex of the worst value. */
    enum { IS_FLOAT, IS_COUNT, IS_FINDING } type;
    /* Offset in struct morph_survey of a progress that is printed with the value: the progress of
     * the worst value, or of the first moment that was counted. 0 means that the survey records no
     * progress for this value. */
    size_t moment;
    const char *format;
    /* Factor by which the measured value is multiplied for printing. 100 prints a share in
     * percent. */
    double scale;
    double limit; /* Limit in the unit of the printed value. */
    enum { AT_MOST, AT_LEAST, PRINT_ONLY } rule;
};

#define FIELD(name) offsetof(struct morph_survey, name)
#define REAL(name) #name, FIELD(name), IS_FLOAT, 0
#define COUNT(name) #name, FIELD(name), IS_COUNT, 0
#define COUNT_FROM(name, moment) #name, FIELD(name), IS_COUNT, FIELD(moment)
#define FOUND(name) #name, FIELD(name), IS_FINDING, FIELD(name.progress)

static const struct row rows[] = {
    { "keys' sizes: off one another, %", FOUND(size_error), "%.3f", 100.0, 1.0, AT_MOST },
    { "length off the growth curve, %", FOUND(off_growth), "%.3f", 100.0, 2.0, AT_MOST },
    { "moments at which age does not rise", COUNT_FROM(moments_not_older, age_stands_at), "%.0f",
      1.0, 0.0, AT_MOST },
    { "age leads to another progress, by", FOUND(progress_lost), "%.1e", 1.0, 1e-3, AT_MOST },
    { "length leads to another length, %", FOUND(length_lost), "%.3f", 100.0, 0.1, AT_MOST },
    { "weights: sum is off 1 by", REAL(sum_error), "%.1e", 1.0, 1e-6, AT_MOST },
    { "weights: least", REAL(weight_min), "%.4f", 1.0, 0.0, AT_LEAST },
    { "weights of drawings: sum is off 1 by", REAL(drawn_sum_error), "%.1e", 1.0, 2e-6, AT_MOST },
    { "weights of drawings: least", REAL(drawn_weight_min), "%.4f", 1.0, 0.0, PRINT_ONLY },
    { "keys shown alone", COUNT(keys_alone), "%.0f", 1.0, 0.0, PRINT_ONLY },
    { "key, where shown alone, missed by", FOUND(key_error), "%.1e", 1.0, 0.0, AT_MOST },
    { "triangles turned over: body, eyes", COUNT_FROM(flipped_skin, flipped_at), "%.0f", 1.0, 0.0,
      AT_MOST },
    { "triangles turned over: fins", COUNT_FROM(flipped_fins, flipped_at), "%.0f", 1.0, 0.0,
      AT_MOST },
    { "moments at which the body has a hole", COUNT(moments_open), "%.0f", 1.0, 0.0, AT_MOST },
    { "skin folded into itself, % of length", FOUND(body_in_body), "%.3f", 100.0, 0.0, AT_MOST },
    { "fin deeper than its root, % of length", FOUND(fin_in_body), "%.3f", 100.0, 0.05, AT_MOST },
    { "fin in an eye, % of length", FOUND(fin_in_eye), "%.3f", 100.0, 0.0, AT_MOST },
    { "eye in the head, % of length", FOUND(eye_in_body), "%.3f", 100.0, 0.0, AT_MOST },
    { "pupil in the head, % of length", FOUND(pupil_in_body), "%.3f", 100.0, 0.0, AT_MOST },
    { "eye in the other eye, % of length", FOUND(eye_in_eye), "%.3f", 100.0, 0.0, AT_MOST },
    { "fin root off the skin, % of length", FOUND(root_off_skin), "%.3f", 100.0, 0.0, PRINT_ONLY },
    { "volume below the lesser key's, %", FOUND(volume_dip), "%.3f", 100.0, 2.0, AT_MOST },
    { "dorsal root's path off its chord", REAL(dorsal_root), "%.5f", 1.0, 0.0, PRINT_ONLY },
    { "right eye's path off its chord", REAL(eye_right), "%.5f", 1.0, 0.0, PRINT_ONLY },
    { "left eye's path off its chord", REAL(eye_left), "%.5f", 1.0, 0.0, PRINT_ONLY },
};
#define ROWS (sizeof rows / sizeof rows[0])

static const void *field_at(const struct morph_survey *survey, size_t offset)
{
    return (const char *)survey + offset;
}

static float value_of(const struct row *row, const struct morph_survey *survey)
{
    const void *field = field_at(survey, row->offset);
    return row->type == IS_COUNT     ? (float)*(const uint32_t *)field
           : row->type == IS_FINDING ? ((const struct finding *)field)->value
                                     : *(const float *)field;
}

static bool is_so(const struct row *row, const struct morph_survey *survey)
{
    const double value = (double)value_of(row, survey) * row->scale;
    return row->rule == PRINT_ONLY ||
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
    snprintf(text, sizeof text, row->format, (double)value_of(row, survey) * row->scale);
    printf(" %10s", text);
}

static void print_faults(enum column column)
{
    CORE_ASSERT(column < ORDINARY);
    const struct morph_survey *survey = &plan.survey[column];
    for (const struct row *row = rows; row < rows + ROWS; row++) {
        if (is_so(row, survey)) {
            continue;
        }
        printf("check failed (%s): %s", column_names[column], row->title);
        print_number(row, survey);
        /* Appends the position of the value to the row, for example " at progress 0.431, vertex 312
         * (eye)". */
        if (row->moment > 0) {
            printf("%s at progress %.4f", row->type == IS_COUNT ? ", first" : "",
                   (double)*(const float *)field_at(survey, row->moment));
        }
        const struct finding *found = field_at(survey, row->offset);
        if (row->type == IS_FINDING && found->vertex != MORPH_SURVEY_NOWHERE) {
            const struct species_mesh *mesh = &plan.pick.fish->lod[column];
            printf(", vertex %u (%s)", found->vertex,
                   part_names[mesh->vertices[found->vertex].part]);
        }
        putchar('\n');
    }
}

static void print_text(void)
{
    const struct species *fish = plan.pick.fish;
    printf("%s: %u keys, %u curves, %u moments; %u vertices near, %u far\n", fish->card.id,
           fish->card.key_count, fish->card.curve_count, plan.steps + 1u, fish->lod[0].vertex_count,
           fish->lod[1].vertex_count);
    printf("%-38s %10s %10s %10s   must be\n", "", column_names[NEAR], column_names[FAR],
           column_names[ORDINARY]);
    for (const struct row *row = rows; row < rows + ROWS; row++) {
        printf("%-38s", row->title);
        for (int column = 0; column < COLUMNS; column++) {
            print_number(row, &plan.survey[column]);
        }
        if (row->rule != PRINT_ONLY) {
            printf("   %s %g", row->rule == AT_MOST ? "<=" : ">=", row->limit);
        }
        putchar('\n');
    }
    print_faults(NEAR);
    print_faults(FAR);
}

static void print_json(bool good)
{
    struct json json = { .file = stdout };
    json_print(&json, "{species: %s, moments: %u, good: %hhd", plan.pick.fish->card.id,
               plan.steps + 1u, good);
    for (int column = 0; column < COLUMNS; column++) {
        const struct morph_survey *survey = &plan.survey[column];
        json_line(&json, 1);
        json_open(&json, column_names[column], '{');
        json_bool(&json, "good", is_survey_good(survey));
        for (size_t i = 0; i < ROWS; i++) {
            json_value(&json, rows[i].key, "%.9g", (double)value_of(&rows[i], survey));
            if (rows[i].type == IS_FINDING && value_of(&rows[i], survey) > 0.0f) {
                char key[64];
                snprintf(key, sizeof key, "%s_at", rows[i].key);
                json_value(&json, key, "%.6f",
                           (double)*(const float *)field_at(survey, rows[i].moment));
            }
        }
        json_close(&json, '}');
    }
    json_close(&json, '}');
    json_end(&json);
}

static const struct option options[] = {
    { "steps", "N", "number of moments minus one", OPTION_WHOLE,
      .offset = offsetof(struct check_plan, steps), 1, 100000, .initial = "1000" },
    { "json", NULL, "print JSON, in which shares are not percentages", OPTION_FLAG,
      .offset = offsetof(struct check_plan, as_json) },
};

static enum exit_code check(void)
{
    plan.ordinary = morph_options_ordinary(&plan.pick, &plan.ordinary_rig);
    for (uint32_t lod = 0; lod < SPECIES_LOD_COUNT; lod++) {
        morph_survey(plan.pick.fish, &plan.pick.rig, lod, plan.steps, &plan.survey[lod]);
    }
    morph_survey(plan.ordinary, &plan.ordinary_rig, 0, plan.steps, &plan.survey[ORDINARY]);
    const bool good = is_survey_good(&plan.survey[NEAR]) && is_survey_good(&plan.survey[FAR]);
    if (plan.as_json) {
        print_json(good);
    } else {
        print_text();
    }
    return good ? EXIT_OK : EXIT_NOT_SO;
}

const struct morph_command ctl_morph_check = {
    .name = "check",
    .options = MORPH_OPTION_TABLE(options),
    .groups = MORPH_REQUIRES_CURVES,
    .words = "SPECIES|FILE [--template T] [--thesis] [--steps N] [--json]",
    .summary = "checks the growth of a species and prints the results beside ordinary morphing",
    .usage =
        "near and far are the two levels of detail. ordinary is the near mesh, morphed linearly\n"
        "from its first key to its last key. Lengths are in units of the fish's length.\n\n"
        "What is checked:\n"
        "  sizes         all keys have the measured length 1, and the snout is at one place\n"
        "  length, age   the age rises, and the length follows the growth curve unless it was\n"
        "                drawn; both convert to a progress and back\n"
        "  turned over   a triangle of the body or of an eye faces inward, or a triangle of a\n"
        "                fin reverses in a single step\n"
        "  a hole        the body is open, so that nothing can be inside it\n"
        "  skin folded   a point just outside the skin is inside the body\n"
        "  fin           a point is deeper in the body than the root of its ray. Fins may cut\n"
        "                through other fins\n"
        "  eye           a visible point of the eye is inside the head or the other eye; the\n"
        "                pupil is the middle half\n"
        "  volume        the body has less volume than both keys around it\n"
        "  weights       the weights of the graph are at least 0; those of the drawn keys may be\n"
        "                negative if the shapes are solved\n"
        "\nThe exit status is 1 if a limit is exceeded.\n",
    .plan = &plan.pick,
    .run_fish = check,
};
