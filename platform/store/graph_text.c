/* graph_text.c -- formats and parses the text of a saved graph; see graph_file.h. */
#include "core/base/panic.h"
#include "platform/os/file.h"
#include "platform/store/graph_file.h"

#include <math.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>

static const char *const templates[TEMPLATE_COUNT] = {
    [TEMPLATE_OWN] = "own",           [TEMPLATE_ORDINARY] = "ordinary",
    [TEMPLATE_PAIRWISE] = "pairwise", [TEMPLATE_SIMULTANEOUS] = "simultaneous",
    [TEMPLATE_SMOOTH] = "smooth",
};
static const char *const lines[] = { [GRAPH_STRAIGHT] = "straight", [GRAPH_SMOOTH] = "smooth" };

/* ---- Formatting ---------------------------------------------------------------------------- */

struct text_out {
    char *out;
    size_t used;
};

__attribute__((format(printf, 2, 3))) static void graph_text_put(struct text_out *text,
                                                                 const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    const int length =
        vsnprintf(text->out + text->used, GRAPH_FILE_TEXT_MAX - text->used, format, arguments);
    va_end(arguments);
    text->used += (size_t)length;
}

size_t graph_file_format(const struct graph_edit_record *record, char out[GRAPH_FILE_TEXT_MAX])
{
    CORE_ASSERT(record->edit.graph.knot_count <= GRAPH_KNOT_MAX);
    CORE_ASSERT(record->edit.scale_knot_count <= GRAPH_KNOT_MAX);
    CORE_ASSERT(record->key_count <= MORPH_KEY_MAX);
    const struct graph *graph = &record->edit.graph;
    struct text_out text = { .out = out };
    graph_text_put(&text, "kingyo-graph %u\nspecies %s\nkeys %u\n", GRAPH_FILE_VERSION,
                   record->species, record->key_count);
    graph_text_put(&text, "template %s\nline %s\nsolved %u\n", templates[record->edit.template_id],
                   lines[graph->line], graph->solved);
    for (uint32_t i = 0; i < graph->knot_count; i++) {
        graph_text_put(&text, "knot %.9g", (double)graph->knots[i].progress);
        for (uint32_t key = 0; key < record->key_count; key++) {
            graph_text_put(&text, " %.9g", (double)graph->knots[i].weight[key]);
        }
        graph_text_put(&text, "\n");
    }
    for (uint32_t i = 0; i < record->edit.scale_knot_count; i++) {
        const struct scale_knot *knot = &record->edit.scale_knots[i];
        graph_text_put(&text, "scale %.9g %.9g\n", (double)knot->progress, (double)knot->length_m);
    }
    graph_text_put(&text, "end\n");
    return text.used;
}

/* ---- Parsing ------------------------------------------------------------------------------- */

struct reading {
    FILE *file;
    uint32_t line; /* Number of the line that was read last, counted from 1. */
    /* The line that was read last. No line of a saved graph is longer than a whole file. */
    char buffer[GRAPH_FILE_TEXT_MAX + 1u];
    const char *words; /* The line in `buffer` without comment and surrounding white space. */
    uint32_t knot_line[GRAPH_KNOT_MAX], scale_line[GRAPH_KNOT_MAX];
    char *why;
    bool is_unreadable; /* True if the file has ended or a line is malformed. `why` then has the
                           reason, and the parser skips all later checks. */
};

__attribute__((format(printf, 2, 3))) static bool graph_text_error(struct reading *reading,
                                                                   const char *format, ...)
{
    char what[GRAPH_FILE_WHY_SIZE - 12u];
    va_list arguments;
    if (reading->is_unreadable) {
        return false;
    }
    va_start(arguments, format);
    vsnprintf(what, sizeof what, format, arguments);
    va_end(arguments);
    snprintf(reading->why, GRAPH_FILE_WHY_SIZE, "%u: %s", reading->line, what);
    return 0;
}

static bool end_reading(struct reading *reading, const char *what)
{
    /* For an empty file `line` is still 0, so the error message names line 1. */
    reading->line += reading->line == 0;
    graph_text_error(reading, "%s", what);
    reading->is_unreadable = true;
    return 0;
}

/* Reads the next line that is not empty. Returns false at the end of the file or at a malformed
 * line. */
static bool graph_text_next_line(struct reading *reading)
{
    enum file_line got;
    while ((got = file_read_line(reading->file, reading->buffer, sizeof reading->buffer)) !=
           FILE_LINE_END) {
        reading->line++;
        if (got == FILE_LINE_BAD) {
            return end_reading(reading, "not a text");
        }
        reading->buffer[strcspn(reading->buffer, "#")] = 0;
        reading->words = file_trim(reading->buffer);
        if (reading->words[0] != 0) {
            return true;
        }
    }
    return end_reading(reading, "the file ends without 'end'");
}

/* Returns the text that follows `word` on the current line, or null if the line does not start with
 * `word`. */
static const char *text_after_word(const struct reading *reading, const char *word)
{
    const size_t length = strlen(word);
    const char *rest = reading->words + length;
    return strncmp(reading->words, word, length) == 0 && (*rest == ' ' || *rest == 0) ? rest : NULL;
}

/* Reads a line of the form "`word` VALUE". Returns the index of VALUE in `names`, or -1 if the line
 * has another form. */
static int read_named_value(struct reading *reading, const char *word, const char *const *names,
                            int count)
{
    const char *rest = graph_text_next_line(reading) ? text_after_word(reading, word) : NULL;
    for (int i = 0; rest != NULL && i < count; i++) {
        if (*rest == ' ' && strcmp(rest + 1, names[i]) == 0) {
            return i;
        }
    }
    if (reading->why[0] == 0) {
        graph_text_error(reading, "expected '%s' and one of its words", word);
    }
    return -1;
}

/* Parses exactly `count` numbers from `rest` into `out`. Returns false after an error. */
static bool parse_numbers(struct reading *reading, const char *rest, float *out, uint32_t count)
{
    for (uint32_t i = 0; i < count; i++) {
        char *end;
        out[i] = strtof(rest, &end);
        if (end == rest || !isfinite(out[i])) {
            return graph_text_error(reading, "expected %u numbers", count);
        }
        rest = end;
    }
    while (*rest == ' ') {
        rest++;
    }
    return *rest == 0 || graph_text_error(reading, "more than %u numbers", count);
}

static bool read_head(struct reading *reading, const struct species_card *card,
                      struct lab_edit *edit)
{
    static const char *const first[] = { "1" };
    static const char *const yes_or_no[] = { "0", "1" };
    const char *const id[] = { card->id };
    char count[4];
    const char *const keys[] = { count };
    snprintf(count, sizeof count, "%u", (unsigned)card->key_count % 100u);
    if (read_named_value(reading, "kingyo-graph", first, 1) < 0) {
        return graph_text_error(reading, "not a graph of version %u", GRAPH_FILE_VERSION);
    }
    if (read_named_value(reading, "species", id, 1) < 0) {
        return graph_text_error(reading, "not of the species %s", card->id);
    }
    if (read_named_value(reading, "keys", keys, 1) < 0) {
        return graph_text_error(reading, "%s has %u keys", card->id, card->key_count);
    }
    const int template_id = read_named_value(reading, "template", templates, TEMPLATE_COUNT);
    const int line = template_id < 0 ? -1 : read_named_value(reading, "line", lines, 2);
    const int solved = line < 0 ? -1 : read_named_value(reading, "solved", yes_or_no, 2);
    if (solved < 0) {
        return false;
    }
    edit->template_id = (uint8_t)template_id;
    edit->graph.line = (uint8_t)line;
    edit->graph.solved = (uint8_t)solved;
    return true;
}

static bool read_knot(struct reading *reading, const char *rest, const struct species_card *card,
                      struct graph *graph)
{
    float values[1u + MORPH_KEY_MAX] = { 0 };
    CORE_ASSERT(graph->knot_count <= GRAPH_KNOT_MAX);
    if (graph->knot_count == GRAPH_KNOT_MAX) {
        return graph_text_error(reading, "more than %u knots", GRAPH_KNOT_MAX);
    }
    if (!parse_numbers(reading, rest, values, 1u + card->key_count)) {
        return false;
    }
    reading->knot_line[graph->knot_count] = reading->line;
    struct graph_knot *knot = &graph->knots[graph->knot_count++];
    knot->progress = values[0];
    memcpy(knot->weight, values + 1, card->key_count * sizeof values[0]);
    return true;
}

static bool read_scale(struct reading *reading, const char *rest, struct lab_edit *edit)
{
    float values[2] = { 0 };
    if (edit->scale_knot_count == GRAPH_KNOT_MAX) {
        return graph_text_error(reading, "more than %u scale knots", GRAPH_KNOT_MAX);
    }
    if (!parse_numbers(reading, rest, values, 2)) {
        return false;
    }
    reading->scale_line[edit->scale_knot_count] = reading->line;
    edit->scale_knots[edit->scale_knot_count++] = (struct scale_knot){ values[0], values[1] };
    return true;
}

/* Returns true if the graph is valid. Otherwise reports the number of the invalid knot with the
 * reason, and returns false. */
static bool check_graph(struct reading *reading, const struct species_card *card,
                        const struct graph *graph)
{
    static const char *const faults[] = {
        [GRAPH_ENDS] = "the first knot is not at 0, or the last not at 1",
        [GRAPH_ORDER] = "its progress does not rise",
        [GRAPH_NEGATIVE] = "a weight is negative",
        [GRAPH_SUM] = "its weights do not sum to 1",
    };
    const struct graph_verdict verdict = graph_check(graph, card->key_count);
    switch (verdict.fault) {
    case GRAPH_GOOD:
        return true;
    case GRAPH_KNOT_COUNT:
        return graph_text_error(reading, "fewer than 2 knots");
    case GRAPH_UNSOLVABLE:
        return graph_text_error(
            reading, "the key '%s' is hardly seen at its own progress: no shape to solve",
            card->key_names[verdict.key]);
    default:
        reading->line = reading->knot_line[verdict.knot];
        return graph_text_error(reading, "knot %u: %s", verdict.knot + 1u, faults[verdict.fault]);
    }
}

static bool check_scale(struct reading *reading, const struct lab_edit *edit)
{
    const uint32_t count = edit->scale_knot_count;
    for (uint32_t i = 0; i < count; i++) {
        const struct scale_knot *knot = &edit->scale_knots[i];
        const float end = i == 0 ? 0.0f : i + 1u == count ? 1.0f : knot->progress;
        reading->line = reading->scale_line[i];
        if (count == 1u || knot->progress != end ||
            (i > 0 && knot->progress <= knot[-1].progress)) {
            return graph_text_error(reading, "scale knot %u: they do not rise from 0 to 1", i + 1u);
        }
        if (!(knot->length_m >= LAB_LENGTH_MIN_M && knot->length_m <= LAB_LENGTH_MAX_M)) {
            return graph_text_error(reading, "scale knot %u: not of 0.2 mm to 20 m", i + 1u);
        }
    }
    return true;
}

static bool read_graph(struct reading *reading, const struct species_card *card,
                       struct lab_edit *edit)
{
    struct lab_edit read = { 0 };
    if (!read_head(reading, card, &read)) {
        return false;
    }
    while (graph_text_next_line(reading)) {
        const char *knot = text_after_word(reading, "knot"),
                   *scale = text_after_word(reading, "scale");
        if (strcmp(reading->words, "end") == 0) {
            if (!check_graph(reading, card, &read.graph) || !check_scale(reading, &read)) {
                return false;
            }
            if (!lab_edit_is_valid(&read, card)) {
                return graph_text_error(reading, "no graph of %s", card->id);
            }
            *edit = read;
            return true;
        }
        if (knot == NULL && scale == NULL) {
            return graph_text_error(reading, "expected 'knot', 'scale' or 'end'");
        }
        if (!(knot != NULL ? read_knot(reading, knot, card, &read.graph)
                           : read_scale(reading, scale, &read))) {
            return false;
        }
    }
    return false;
}

bool graph_file_parse(const char *text, size_t size, const struct species_card *card,
                      struct lab_edit *edit, char why[GRAPH_FILE_WHY_SIZE])
{
    CORE_ASSERT(text && card->key_count <= MORPH_KEY_MAX);
    struct reading reading = { .file = fmemopen((void *)text, size, "r"), .why = why };
    why[0] = 0;
    if (!reading.file) {
        return graph_text_error(&reading, "cannot be read");
    }
    const bool is_valid = read_graph(&reading, card, edit);
    fclose(reading.file);
    return is_valid;
}
