/* text.c -- reads a species' text: one fact a line, a word and its numbers. */
#include "platform/species/drawing.h"

#include <math.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>

#define LINE_SIZE 256
#define WORD_MAX 16
#define THIN_MIN 0.002f /* A leptocephalus of 64 mm is 0.6 mm thin; less has no side. */

struct reader {
    const char *path;
    FILE *complaints;
    uint32_t line;
    char text[LINE_SIZE];
    const char *words[WORD_MAX];
    uint32_t word_count;
    struct species_text *species;
    struct key_text *key; /* What a line of a key adds to; null before the first. */
    struct fin *fin;      /* What a ray adds to; null outside a fin. */
    bool has_growth, has_hatch;
};

__attribute__((format(printf, 2, 3))) static bool refuse(const struct reader *r, const char *format,
                                                         ...)
{
    va_list values;
    va_start(values, format);
    fprintf(r->complaints, "%s:%u: ", r->path, r->line);
    vfprintf(r->complaints, format, values);
    fputc('\n', r->complaints);
    va_end(values);
    return false;
}

/* Word `index` as a number in [low, high]. */
static bool number(const struct reader *r, uint32_t index, float low, float high, float *out)
{
    char *end = NULL;
    const float value = strtof(r->words[index], &end);
    if (*end != '\0' || !isfinite(value)) {
        return refuse(r, "'%s' is not a number", r->words[index]);
    }
    if (value < low || value > high) {
        return refuse(r, "%s is outside %g .. %g", r->words[index], (double)low, (double)high);
    }
    *out = value;
    return true;
}

static bool wants(const struct reader *r, uint32_t count, const char *names)
{
    return r->word_count == count + 1 || refuse(r, "write: %s %s", r->words[0], names);
}

static bool name(const struct reader *r, char out[SPECIES_NAME_SIZE])
{
    const char *word = r->words[1];
    const size_t size = strspn(word, "abcdefghijklmnopqrstuvwxyz0123456789_");
    if (size == 0 || word[size] != '\0' || size >= SPECIES_NAME_SIZE) {
        return refuse(r, "'%s' is no name: up to %d of a-z, 0-9 and _", word,
                      (int)SPECIES_NAME_SIZE - 1);
    }
    memcpy(out, word, size + 1);
    return true;
}

static bool read_species(struct reader *r)
{
    return wants(r, 1, "ID") && name(r, r->species->id);
}

static bool read_growth(struct reader *r)
{
    struct growth *g = &r->species->growth;
    r->has_growth = true;
    return wants(r, 3, "LENGTH_INF_M K_PER_YEAR T0_YEAR") &&
           number(r, 1, 0.01f, 20.0f, &g->length_inf_m) &&
           number(r, 2, 0.001f, 10.0f, &g->k_per_year) && number(r, 3, -20.0f, 20.0f, &g->t0_year);
}

static bool read_hatch(struct reader *r)
{
    struct growth *g = &r->species->growth;
    r->has_hatch = true;
    g->point_count = 1;
    return wants(r, 2, "LENGTH_M FADE_YEAR") &&
           number(r, 1, 0.0005f, 2.0f, &g->points[0].length_m) &&
           number(r, 2, 0.001f, 5.0f, &g->fade_year);
}

static bool read_key(struct reader *r)
{
    struct species_text *s = r->species;
    if (s->key_count == MORPH_KEY_MAX) {
        return refuse(r, "more than %u keys", MORPH_KEY_MAX);
    }
    if (s->graph.knot_count > 0) {
        return refuse(r, "all keys stand above the first knot");
    }
    r->key = &s->keys[s->key_count];
    r->fin = NULL;
    if (!wants(r, 2, "NAME TOTAL_LENGTH_MM") || !name(r, r->key->name) ||
        !number(r, 2, 1.0f, 20000.0f, &r->key->length_m)) {
        return false;
    }
    r->key->length_m /= 1000.0f;
    if (s->key_count > 0 && r->key->length_m <= r->key[-1].length_m) {
        return refuse(r, "keys go from short to long");
    }
    s->key_count++;
    return true;
}

/* `knot PROGRESS W1 W2 ..`: after the last key, so that the count of weights is known. */
static bool read_knot(struct reader *r)
{
    struct species_text *s = r->species;
    if (s->graph.knot_count == GRAPH_KNOT_MAX) {
        return refuse(r, "more than %u knots", GRAPH_KNOT_MAX);
    }
    if (r->word_count != s->key_count + 2) {
        return refuse(r, "write: knot PROGRESS and one weight for each of the %u keys above",
                      s->key_count);
    }
    struct graph_knot *knot = &s->graph.knots[s->graph.knot_count];
    if (!number(r, 1, 0.0f, 1.0f, &knot->progress)) {
        return false;
    }
    if (s->graph.knot_count == 0 ? knot->progress != 0.0f : knot->progress <= knot[-1].progress) {
        return refuse(r, "knots go from progress 0 upward");
    }
    float sum = 0.0f;
    for (uint32_t i = 0; i < s->key_count; i++) {
        if (!number(r, i + 2, 0.0f, 1.0f, &knot->weight[i])) {
            return false;
        }
        sum += knot->weight[i];
    }
    if (fabsf(sum - 1.0f) > 1e-6f) {
        return refuse(r, "the weights' sum is %g, not 1", (double)sum);
    }
    s->graph.knot_count++;
    return true;
}

static bool read_station(struct reader *r)
{
    struct key_text *key = r->key;
    if (key->station_count == STATION_MAX) {
        return refuse(r, "more than %d stations", STATION_MAX);
    }
    struct station *s = &key->stations[key->station_count];
    if (!wants(r, 5, "X DEPTH WIDTH OFFSET EXPONENT") || !number(r, 1, 0.0f, 1.0f, &s->x) ||
        !number(r, 2, 0.0f, 1.0f, &s->depth) || !number(r, 3, 0.0f, 1.0f, &s->width) ||
        !number(r, 4, -0.5f, 0.5f, &s->offset) || !number(r, 5, 1.2f, 4.0f, &s->exponent)) {
        return false;
    }
    if (key->station_count == 0 ? s->x != 0.0f : s->x <= s[-1].x) {
        return refuse(r, "stations go from x 0 backward");
    }
    if (key->station_count > 0 && (s->depth < THIN_MIN || s->width < THIN_MIN)) {
        return refuse(r, "only the snout may be thinner than %g", (double)THIN_MIN);
    }
    key->station_count++;
    return true;
}

static bool read_eye(struct reader *r)
{
    struct eye *eye = &r->key->eye;
    return wants(r, 4, "X Y DIAMETER BULGE") && number(r, 1, 0.01f, 0.5f, &eye->x) &&
           number(r, 2, -0.3f, 0.3f, &eye->y) && number(r, 3, 0.005f, 0.3f, &eye->diameter) &&
           number(r, 4, 0.0f, 0.8f, &eye->bulge);
}

static bool read_fin(struct reader *r)
{
    static const char *const names[PART_COUNT] = {
        [PART_TAIL] = "tail",         [PART_DORSAL] = "dorsal", [PART_ANAL] = "anal",
        [PART_PECTORAL] = "pectoral", [PART_PELVIC] = "pelvic",
    };
    if (!wants(r, 5, "tail|dorsal|anal|pectoral|pelvic START END GIRTH CURL")) {
        return false;
    }
    for (int part = PART_TAIL; part <= PART_PELVIC; part++) {
        if (strcmp(r->words[1], names[part]) == 0) {
            r->fin = &r->key->fins[part];
            if (r->fin->ray_count > 0) {
                return refuse(r, "a second %s", names[part]);
            }
            const float low = part == PART_TAIL ? -0.5f : 0.02f; /* A height, not a place. */
            return number(r, 2, low, 1.0f, &r->fin->start) &&
                   number(r, 3, low, 1.0f, &r->fin->end) &&
                   number(r, 4, 0.0f, 0.5f, &r->fin->girth) &&
                   number(r, 5, -90.0f, 90.0f, &r->fin->curl_deg) &&
                   (r->fin->start < r->fin->end || refuse(r, "the fin ends before it starts"));
        }
    }
    return refuse(r, "'%s' is no fin: tail, dorsal, anal, pectoral or pelvic", r->words[1]);
}

static bool read_ray(struct reader *r)
{
    if (!r->fin) {
        return refuse(r, "a ray stands under its fin");
    }
    if (r->fin->ray_count == RAY_MAX) {
        return refuse(r, "more than %d rays", RAY_MAX);
    }
    struct ray *ray = &r->fin->rays[r->fin->ray_count];
    if (!wants(r, 4, "AT LENGTH SWEEP SIDE") || !number(r, 1, 0.0f, 1.0f, &ray->at) ||
        !number(r, 2, THIN_MIN, 1.0f, &ray->length) ||
        !number(r, 3, -90.0f, 120.0f, &ray->sweep_deg) ||
        !number(r, 4, -90.0f, 90.0f, &ray->side_deg)) {
        return false;
    }
    if (r->fin->ray_count == 0 ? ray->at != 0.0f : ray->at <= ray[-1].at) {
        return refuse(r, "rays go from 0 to 1");
    }
    r->fin->ray_count++;
    return true;
}

static bool read_tint(struct reader *r)
{
    uint32_t *out[] = { &r->key->coat.back, &r->key->coat.flank, &r->key->coat.belly,
                        &r->key->coat.fin };
    if (!wants(r, 4, "BACK FLANK BELLY FIN (each as rrggbb)")) {
        return false;
    }
    for (uint32_t i = 0; i < 4; i++) {
        const char *word = r->words[i + 1];
        if (strlen(word) != 6 || strspn(word, "0123456789abcdef") != 6) {
            return refuse(r, "'%s' is no colour: six of 0-9 and a-f", word);
        }
        *out[i] = (uint32_t)strtoul(word, NULL, 16);
    }
    return true;
}

static bool read_line(struct reader *r)
{
    static const struct {
        const char *word;
        bool of_key;
        bool (*read)(struct reader *r);
    } table[] = {
        { "species", false, read_species }, { "growth", false, read_growth },
        { "hatch", false, read_hatch },     { "key", false, read_key },
        { "knot", false, read_knot },       { "station", true, read_station },
        { "eye", true, read_eye },          { "fin", true, read_fin },
        { "ray", true, read_ray },          { "tint", true, read_tint },
    };
    for (size_t i = 0; i < sizeof table / sizeof table[0]; i++) {
        if (strcmp(r->words[0], table[i].word) == 0) {
            if (table[i].of_key && !r->key) {
                return refuse(r, "'%s' stands under a key", r->words[0]);
            }
            return table[i].read(r);
        }
    }
    return refuse(r, "'%s' is no word of a species", r->words[0]);
}

/* Cuts the line into words at blanks; '#' starts a comment. */
static bool split(struct reader *r)
{
    if (strlen(r->text) == LINE_SIZE - 1 && r->text[LINE_SIZE - 2] != '\n') {
        return refuse(r, "the line is longer than %d", LINE_SIZE - 2);
    }
    r->text[strcspn(r->text, "#")] = '\0';
    r->word_count = 0;
    char *rest = NULL;
    for (char *word = strtok_r(r->text, " \t\r\n", &rest); word;
         word = strtok_r(NULL, " \t\r\n", &rest)) {
        if (r->word_count == WORD_MAX) {
            return refuse(r, "more than %d words", WORD_MAX);
        }
        r->words[r->word_count++] = word;
    }
    return true;
}

/* What a key must have before it can be lofted. */
static bool check_key(const struct reader *r, const struct key_text *key)
{
    static const char *const names[PART_COUNT] = { "body", "eye",      "tail",  "dorsal",
                                                   "anal", "pectoral", "pelvic" };
    if (key->station_count < 4 || key->stations[key->station_count - 1].x != 1.0f) {
        return refuse(r, "key %s needs stations from x 0 to x 1, four or more", key->name);
    }
    if (key->eye.diameter <= 0.0f) {
        return refuse(r, "key %s has no eye", key->name);
    }
    if (key->eye.x < 0.5f * key->eye.diameter) {
        return refuse(r, "key %s: the eye reaches beyond the snout", key->name);
    }
    for (int part = PART_TAIL; part <= PART_PELVIC; part++) {
        const struct fin *fin = &key->fins[part];
        if (fin->ray_count < 2 || fin->rays[fin->ray_count - 1].at != 1.0f) {
            return refuse(r, "key %s: the %s needs rays from 0 to 1, two or more", key->name,
                          names[part]);
        }
    }
    return true;
}

static bool check_whole(const struct reader *r)
{
    const struct species_text *s = r->species;
    if (s->id[0] == '\0') {
        return refuse(r, "no species ID");
    }
    if (!r->has_growth || !r->has_hatch) {
        return refuse(r, "no growth or no hatch");
    }
    if (s->key_count < 3) {
        return refuse(r, "fewer than three keys");
    }
    if (s->graph.knot_count < 2 || s->graph.knots[s->graph.knot_count - 1].progress != 1.0f) {
        return refuse(r, "the graph needs knots from progress 0 to 1");
    }
    for (uint32_t i = 0; i < s->key_count; i++) {
        if (!check_key(r, &s->keys[i])) {
            return false;
        }
    }
    return true;
}

bool species_read(FILE *file, const char *path, FILE *complaints, struct species_text *species)
{
    struct reader r = { .path = path, .complaints = complaints, .species = species };
    memset(species, 0, sizeof *species);
    while (fgets(r.text, LINE_SIZE, file)) {
        r.line++;
        if (!split(&r) || (r.word_count > 0 && !read_line(&r))) {
            return false;
        }
    }
    if (ferror(file)) {
        return refuse(&r, "cannot be read further");
    }
    return check_whole(&r);
}
