/* import_life.c -- sets the names, ages, lengths, growth curve, deformation graph and colours of an
 * imported species. */
#include <ctype.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "core/base/panic.h"
#include "core/morph/morph.h"
#include "platform/ctl/import/import.h"

#define DAYS_PER_YEAR 365.25
/* Days between two key shapes if neither the options nor the file contain ages. */
#define KEY_DAYS 30.0

/* Ratio of the fish's greatest possible (asymptotic) length to the length of the last key shape.
 * Used if no growth parameters are given. */
#define GROWN 1.05
#define FADE_YEAR 0.3f

/* Largest growth coefficient in 1/year. A fish with this coefficient is fully grown within one
 * year. */
#define K_MAX 5.0
#define SAME_SIZE 0.01f
#define UNSET 255u

static void name_keys(const struct import_mesh *mesh, const struct import_options *plan,
                      struct species_card *card)
{
    memset(card->key_names, 0, sizeof card->key_names);
    for (uint32_t key = 0; key < card->key_count; key++) {
        char *name = card->key_names[key];
        if (plan->name_count > 0) {
            memcpy(name, plan->names[key], SPECIES_NAME_SIZE);
            continue;
        }
        /* Converts the name that another program gave to the key shape to a valid name. For
         * example, "Shape Key.001" becomes shape_key_001. */
        uint32_t length = 0;
        for (const char *from = mesh->key_names[key]; *from && length + 1 < SPECIES_NAME_SIZE;
             from++) {
            const char c = (char)tolower((unsigned char)*from);
            const bool fits = (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9');
            if (fits || (length > 0 && name[length - 1] != '_')) {
                name[length++] = fits ? c : '_';
            }
        }
        bool is_good = name[0] != '\0';
        for (uint32_t other = 0; other < key; other++) {
            is_good = is_good && strcmp(name, card->key_names[other]) != 0;
        }
        if (!is_good) {
            memset(name, 0, SPECIES_NAME_SIZE);
            snprintf(name, SPECIES_NAME_SIZE, "key_%u", key);
        }
    }
}

/* Sets the lengths of the key shapes from the first available source. The sources are the options,
 * the file, the species `like`, and the sizes of the shapes, in this order. Returns false if only
 * the sizes are available and all sizes are equal. */
static bool set_lengths(const struct import_mesh *mesh, const struct import_options *plan,
                        const struct import_report *report, struct species_card *card)
{
    float least = INFINITY, most = 0.0f;
    for (uint32_t key = 0; key < card->key_count; key++) {
        least = fminf(least, report->size[key]);
        most = fmaxf(most, report->size[key]);
    }
    for (uint32_t key = 0; key < card->key_count; key++) {
        card->key_length_m[key] = plan->length_count > 0 ? (float)(1e-3 * plan->lengths_mm[key])
                                  : mesh->has_life       ? mesh->lengths_m[key]
                                  : plan->like           ? plan->like->card.key_length_m[key]
                                               : (float)((double)report->size[key] * plan->unit_m);
    }
    return plan->length_count > 0 || mesh->has_life || plan->like ||
           most > least * (1.0f + SAME_SIZE);
}

static void set_growth(const struct import_options *plan, struct species_card *card)
{
    struct growth *g = &card->growth;
    const uint32_t last = card->key_count - 1u;
    if (plan->growth_count > 0) {
        *g = (struct growth){ .length_inf_m = (float)(1e-3 * plan->growth[0]),
                              .k_per_year = (float)plan->growth[1],
                              .t0_year = (float)plan->growth[2],
                              .fade_year = (float)plan->growth[4],
                              .point_count = 1,
                              .points = { { 0.0f, (float)(1e-3 * plan->growth[3]) } } };
        return;
    }
    /* Sets a growth curve that passes through the lengths of the key shapes and continues smoothly
     * after the last key shape. */
    *g = (struct growth){ .length_inf_m = (float)(GROWN * (double)card->key_length_m[last]),
                          .fade_year = FADE_YEAR };
    const double grown_years = (double)card->key_age_days[last] / DAYS_PER_YEAR;
    /* `k_years` is the growth coefficient K multiplied by the time in years from t0 (length 0) to
     * the age of the last key shape. At this age the fish has the length of the last key shape. */
    const double k_years = -log(1.0 - 1.0 / GROWN);
    g->k_per_year = (float)fmin(k_years / fmax(grown_years, 0.01), K_MAX);
    g->t0_year = (float)(grown_years - k_years / (double)g->k_per_year);
    if (card->key_age_days[0] > 0.0f) {
        g->points[g->point_count++] = (struct growth_point){ 0.0f, card->key_length_m[0] };
    }
    for (uint32_t key = 0; key <= last; key++) {
        g->points[g->point_count++] =
            (struct growth_point){ card->key_age_days[key], card->key_length_m[key] };
    }
}

/* Sets the ages of the key shapes and the growth curve from the first available source. The sources
 * are the ages of the options, the growth parameters of the options, the file, and the species
 * `like`, in this order. Without any source, the key shapes are one month apart. */
static void set_ages(const struct import_mesh *mesh, const struct import_options *plan,
                     struct species_card *card)
{
    const bool by_growth = plan->age_count == 0 && plan->growth_count > 0;
    for (uint32_t key = 0; key < card->key_count; key++) {
        card->key_age_days[key] = plan->age_count > 0      ? (float)plan->ages_days[key]
                                  : mesh && mesh->has_life ? mesh->ages_days[key]
                                  : plan->like             ? plan->like->card.key_age_days[key]
                                                           : (float)(KEY_DAYS * key);
    }
    set_growth(plan, card);
    for (uint32_t key = 0; key < card->key_count && by_growth; key++) {
        card->key_age_days[key] = growth_age_days(&card->growth, card->key_length_m[key]);
    }
}

/* Returns true if ages or lengths come from a source other than the species `like`. */
static bool has_own_life(const struct import_mesh *mesh, const struct import_options *plan)
{
    return !plan->like || (mesh && mesh->has_life) || plan->length_count > 0 ||
           plan->age_count > 0 || plan->growth_count > 0;
}

/* Returns the greatest difference between the animated weights and a straight line between the
 * keyframes `from` and `to`. Sets `*at` to the keyframe with the greatest difference. */
static float worst_line_deviation(const struct import_mesh *mesh, uint32_t from, uint32_t to,
                                  uint32_t *at)
{
    float worst = 0.0f;
    const float span = mesh->times[to] - mesh->times[from];
    for (uint32_t i = from + 1; i < to; i++) {
        const float t = (mesh->times[i] - mesh->times[from]) / span;
        for (uint32_t key = 0; key < mesh->key_count; key++) {
            const float line = mesh->weights[from][key] * (1.0f - t) + mesh->weights[to][key] * t;
            const float off = fabsf(mesh->weights[i][key] - line);
            if (off > worst) {
                worst = off;
                *at = i;
            }
        }
    }
    return worst;
}

/* Approximates the animation by knots of the deformation graph. The first knots are the two ends.
 * Then the keyframe with the greatest error is repeatedly added as a knot. */
static void draw_graph(const struct import_mesh *mesh, struct graph *graph,
                       struct import_report *report)
{
    CORE_ASSERT(mesh->time_count >= 2 && mesh->time_count <= IMPORT_TIME_MAX);
    uint32_t chosen[GRAPH_KNOT_MAX] = { 0, mesh->time_count - 1 }, count = 2;
    for (;;) {
        uint32_t gap = 0, where = 0;
        float worst = 0.0f;
        for (uint32_t i = 0; i + 1 < count; i++) {
            uint32_t at = chosen[i];
            const float off = worst_line_deviation(mesh, chosen[i], chosen[i + 1], &at);
            if (off > worst) {
                worst = off;
                gap = i;
                where = at;
            }
        }
        report->graph_error = worst;
        if (worst <= 1e-4f || count == GRAPH_KNOT_MAX) {
            break;
        }
        memmove(&chosen[gap + 2], &chosen[gap + 1], (count - gap - 1) * sizeof chosen[0]);
        chosen[gap + 1] = where;
        count++;
    }
    const float begin = mesh->times[0], span = mesh->times[mesh->time_count - 1] - begin;
    *graph = (struct graph){ .knot_count = (uint8_t)count, .line = GRAPH_STRAIGHT };
    for (uint32_t i = 0; i < count; i++) {
        struct graph_knot *knot = &graph->knots[i];
        knot->progress = i + 1 == count ? 1.0f : (mesh->times[chosen[i]] - begin) / span;
        /* Copies the weights of the keyframe and scales them so that their sum is 1. Files contain
         * rounded weights, but the deformation graph requires a sum of exactly 1. */
        const float *from = mesh->weights[chosen[i]];
        double sum = 0.0;
        for (uint32_t key = 0; key < MORPH_KEY_MAX; key++) {
            sum += (double)from[key];
        }
        for (uint32_t key = 0; key < MORPH_KEY_MAX; key++) {
            knot->weight[key] = (float)((double)from[key] / sum);
        }
    }
    report->knot_count = count;
}

/* Computes the mean colour of the vertices of a part at one height. `third` is 0 for the lowest
 * third of the part, 1 for the middle, 2 for the highest, and -1 for the whole part. Returns false
 * if there are no such vertices. */
static bool mean_colour(const struct import_mesh *mesh, enum species_part part, int third,
                        uint32_t *out)
{
    uint64_t sum[3] = { 0, 0, 0 }, count = 0;
    for (uint32_t i = 0; i < mesh->triangle_count; i++) {
        const enum species_part its = import_part_of(mesh, i);
        if (part == PART_TAIL ? its < PART_TAIL : its != part) {
            continue;
        }
        const uint32_t vertex = mesh->triangles[i][0];
        const float y = mesh->positions[0][vertex].y;
        const int height = y < -0.04f ? 0 : y > 0.04f ? 2 : 1;
        if (third < 0 || height == third) {
            for (int c = 0; c < 3; c++) {
                sum[c] += mesh->colours[vertex] >> (16 - 8 * c) & 255u;
            }
            count++;
        }
    }
    if (count == 0) {
        return false;
    }
    *out = (uint32_t)(sum[0] / count << 16 | sum[1] / count << 8 | sum[2] / count);
    return true;
}

static void set_coats(const struct import_mesh *mesh, const struct import_options *plan,
                      struct species *species)
{
    struct species_coat coat = { .back = 0x3b4a52,
                                 .flank = 0x8a979c,
                                 .belly = 0xe6e4da,
                                 .fin = 0x7d8a90,
                                 .iris = 0xc9b26a,
                                 .shine = 90 };
    /* Each colour of the coat, with the part and the height of the vertices from which
     * mean_colour() computes it. */
    const struct {
        uint32_t *colour;
        enum species_part part;
        int third;
    } rows[] = { { &coat.back, PART_BODY, 2 },
                 { &coat.flank, PART_BODY, 1 },
                 { &coat.belly, PART_BODY, 0 },
                 { &coat.fin, PART_TAIL, -1 },
                 { &coat.iris, PART_EYE, -1 } };
    const bool has_file_coats = mesh->has_coats && plan->colour_count == 0;
    if (plan->like || has_file_coats) {
        memcpy(species->coats, plan->like ? plan->like->coats : mesh->coats, sizeof species->coats);
        return;
    }
    for (uint32_t i = 0; i < sizeof rows / sizeof rows[0]; i++) {
        uint32_t colour;
        if (plan->colour_count > 0) {
            *rows[i].colour = plan->colours[i];
        } else if (mesh->has_colours && mean_colour(mesh, rows[i].part, rows[i].third, &colour)) {
            *rows[i].colour = colour;
        }
    }
    for (uint32_t key = 0; key < species->card.key_count; key++) {
        species->coats[key] = coat;
    }
}

static bool counts_agree(uint32_t key_count, const struct import_options *plan,
                         char why[IMPORT_WHY_SIZE])
{
    const struct {
        const char *what;
        uint32_t count;
    } lists[] = { { "--names", plan->name_count },
                  { "--lengths-mm", plan->length_count },
                  { "--ages-days", plan->age_count },
                  { "--like", plan->like ? plan->like->card.key_count : 0 } };
    for (size_t i = 0; i < sizeof lists / sizeof lists[0]; i++) {
        if (lists[i].count > 0 && lists[i].count != key_count) {
            return import_error(why, "%s: %u given for %u key shapes; give one for each",
                                lists[i].what, lists[i].count, key_count);
        }
    }
    return true;
}

bool import_fitted_life(const struct import_options *plan, struct species_card *card,
                        char why[IMPORT_WHY_SIZE])
{
    CORE_ASSERT(plan->name_count <= MORPH_KEY_MAX && plan->length_count <= MORPH_KEY_MAX);
    if (!counts_agree(card->key_count, plan, why)) {
        return false;
    }
    strncpy(card->id, plan->id,
            sizeof card->id - 1); /* strncpy() also fills the rest of the id with zeros. */
    for (uint32_t key = 0; key < plan->name_count; key++) {
        memcpy(card->key_names[key], plan->names[key], SPECIES_NAME_SIZE);
    }
    for (uint32_t key = 0; key < plan->length_count; key++) {
        card->key_length_m[key] = (float)(1e-3 * plan->lengths_mm[key]);
    }
    if (has_own_life(NULL, plan)) {
        set_ages(NULL, plan, card);
        card->scale_knot_count = 0; /* The knots of the template's growth scale apply only to the
                                       lengths of the template. */
    }
    return true;
}

bool import_life(const struct import_mesh *mesh, const struct import_options *plan,
                 struct species_slot *slot, struct import_report *report, char why[IMPORT_WHY_SIZE])
{
    CORE_ASSERT(mesh->key_count >= 2 && mesh->key_count <= MORPH_KEY_MAX);
    struct species_card *card = &slot->species.card;
    if (!counts_agree(mesh->key_count, plan, why)) {
        return false;
    }
    if (plan->like) {
        *card = plan->like->card;
    } else {
        card->thesis_key[1] = (uint8_t)(mesh->key_count / 2u);
        card->thesis_key[2] = (uint8_t)(mesh->key_count - 1u);
        card->thesis_template = TEMPLATE_PAIRWISE;
    }
    strncpy(card->id, plan->id, sizeof card->id - 1);
    card->key_count = (uint8_t)mesh->key_count;
    card->measure = plan->measure;
    card->motion = plan->motion != UNSET ? plan->motion : plan->like ? card->motion : MOTION_TAIL;
    card->form = plan->form != UNSET ? plan->form : plan->like ? card->form : FORM_FUSIFORM;
    if (!plan->like || plan->name_count > 0) {
        name_keys(mesh, plan, card);
    }
    if (!set_lengths(mesh, plan, report, card)) {
        return import_error(why, "lengths: all shapes have the same size; use --lengths-mm A,B,C");
    }
    if (has_own_life(mesh, plan)) {
        set_ages(mesh, plan, card);
        card->scale_knot_count = 0; /* The growth scale of the species `like` applies only to the
                                       lengths of `like`, so its knots are removed. */
    }
    card->curve_count = 1;
    memset(card->curve_names, 0, sizeof card->curve_names);
    memcpy(card->curve_names[0], "whole", sizeof "whole");
    const bool is_own = plan->template_id == TEMPLATE_OWN;
    if (is_own && mesh->time_count >= 2) {
        draw_graph(mesh, &card->curves[0], report);
    } else if (!is_own || !plan->like) {
        graph_from_template(&card->curves[0],
                            is_own ? TEMPLATE_PAIRWISE : (enum graph_template)plan->template_id,
                            card->key_count, SIMULTANEOUS_PEAK);
    }
    set_coats(mesh, plan, &slot->species);
    return true;
}
