/* edit_file.c -- graphs in words. */
#include "platform/edit_file.h"

#include <ctype.h>
#include <errno.h>
#include <fcntl.h>
#include <math.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "platform/folder.h"

#define PATH_SIZE 1200u
#define LINE_SIZE 256u

static const char *const templates[TEMPLATE_COUNT] = {
    [TEMPLATE_OWN] = "own",
    [TEMPLATE_ORDINARY] = "ordinary",
    [TEMPLATE_PAIRWISE] = "pairwise",
    [TEMPLATE_SIMULTANEOUS] = "simultaneous",
    [TEMPLATE_SMOOTH] = "smooth",
};
static const char *const lines[] = { [GRAPH_STRAIGHT] = "straight", [GRAPH_SMOOTH] = "smooth" };

/* ---- Writing -------------------------------------------------------------------------------- */

struct text_out {
    char *out;
    size_t used;
};

__attribute__((format(printf, 2, 3)))
static void put(struct text_out *text, const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    const int length =
        vsnprintf(text->out + text->used, EDIT_TEXT_MAX - text->used, format, arguments);
    va_end(arguments);
    text->used += (size_t)length;
}

size_t edit_file_format(const struct edit_record *record, char out[EDIT_TEXT_MAX])
{
    const struct graph *graph = &record->edit.graph;
    struct text_out text = { .out = out };
    put(&text, "kingyo-graph %u\nspecies %s\nkeys %u\n", EDIT_FILE_VERSION, record->species,
        record->key_count);
    put(&text, "template %s\nline %s\nsolved %u\n", templates[record->edit.template],
        lines[graph->line], graph->solved);
    for (uint32_t i = 0; i < graph->knot_count; i++) {
        put(&text, "knot %.9g", (double)graph->knots[i].progress);
        for (uint32_t key = 0; key < record->key_count; key++) {
            put(&text, " %.9g", (double)graph->knots[i].weight[key]);
        }
        put(&text, "\n");
    }
    for (uint32_t i = 0; i < record->edit.scale_knot_count; i++) {
        const struct scale_knot *knot = &record->edit.scale_knots[i];
        put(&text, "scale %.9g %.9g\n", (double)knot->progress, (double)knot->length_m);
    }
    put(&text, "end\n");
    return text.used;
}

/* ---- Reading -------------------------------------------------------------------------------- */

struct reading {
    const char *text;
    size_t size, at;
    uint32_t line;         /* Of what was read last, from 1. */
    char words[LINE_SIZE]; /* It, without comment and white space around. */
    char *why;
};

__attribute__((format(printf, 2, 3)))
static int refuse(struct reading *reading, const char *format, ...)
{
    char what[EDIT_WHY_SIZE - 12u];
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(what, sizeof what, format, arguments);
    va_end(arguments);
    snprintf(reading->why, EDIT_WHY_SIZE, "%u: %s", reading->line, what);
    return 0;
}

/* The next line that says something; 0 at the end, or when it is none that was ever written. */
static int next_line(struct reading *reading)
{
    while (reading->at < reading->size) {
        size_t length = 0, end = reading->at;
        reading->line++;
        while (end < reading->size && reading->text[end] != '\n') {
            end++;
        }
        for (size_t i = reading->at; i < end && reading->text[i] != '#'; i++) {
            const char c = reading->text[i];
            if (c == 0 || length + 1u == LINE_SIZE) {
                return refuse(reading, c == 0 ? "not a text" : "longer than %u characters",
                              LINE_SIZE - 1u);
            }
            if (length > 0 || !isspace((unsigned char)c)) {
                reading->words[length++] = c;
            }
        }
        reading->at = end + 1u;
        while (length > 0 && isspace((unsigned char)reading->words[length - 1u])) {
            length--;
        }
        reading->words[length] = 0;
        if (length > 0) {
            return 1;
        }
    }
    return refuse(reading, "the file ends without 'end'");
}

/* What follows `word` on the line, or null when the line begins otherwise. */
static const char *after(const struct reading *reading, const char *word)
{
    const size_t length = strlen(word);
    const char *rest = reading->words + length;
    return strncmp(reading->words, word, length) == 0 && (*rest == ' ' || *rest == 0) ? rest
                                                                                      : NULL;
}

/* Reads a line "`word` VALUE" and finds the value among names; its place, or -1. */
static int named(struct reading *reading, const char *word, const char *const *names, int count)
{
    const char *rest = next_line(reading) ? after(reading, word) : NULL;
    for (int i = 0; rest != NULL && i < count; i++) {
        if (*rest == ' ' && strcmp(rest + 1, names[i]) == 0) {
            return i;
        }
    }
    if (reading->why[0] == 0) {
        refuse(reading, "expected '%s' and one of its words", word);
    }
    return -1;
}

/* Exactly `count` numbers. */
static int numbers(struct reading *reading, const char *rest, float *out, uint32_t count)
{
    for (uint32_t i = 0; i < count; i++) {
        char *end;
        out[i] = strtof(rest, &end);
        if (end == rest || !isfinite(out[i])) {
            return refuse(reading, "expected %u numbers", count);
        }
        rest = end;
    }
    while (*rest == ' ') {
        rest++;
    }
    return *rest == 0 ? 1 : refuse(reading, "more than %u numbers", count);
}

static int read_head(struct reading *reading, const struct species_card *card,
                     struct lab_edit *edit)
{
    static const char *const first[] = { "1" };
    static const char *const yes_or_no[] = { "0", "1" };
    const char *const id[] = { card->id };
    char count[4];
    const char *const keys[] = { count };
    snprintf(count, sizeof count, "%u", (unsigned)card->key_count % 100u);
    if (named(reading, "kingyo-graph", first, 1) < 0) {
        return refuse(reading, "not a graph of version %u", EDIT_FILE_VERSION);
    }
    if (named(reading, "species", id, 1) < 0) {
        return refuse(reading, "not of the species %s", card->id);
    }
    if (named(reading, "keys", keys, 1) < 0) {
        return refuse(reading, "%s has %u keys", card->id, card->key_count);
    }
    const int template = named(reading, "template", templates, TEMPLATE_COUNT);
    const int line = template < 0 ? -1 : named(reading, "line", lines, 2);
    const int solved = line < 0 ? -1 : named(reading, "solved", yes_or_no, 2);
    if (solved < 0) {
        return 0;
    }
    edit->template = (uint8_t)template;
    edit->graph.line = (uint8_t)line;
    edit->graph.solved = (uint8_t)solved;
    return 1;
}

static int read_knot(struct reading *reading, const char *rest, const struct species_card *card,
                     struct graph *graph)
{
    float values[1u + MORPH_KEY_MAX] = { 0 };
    if (graph->knot_count == GRAPH_KNOT_MAX) {
        return refuse(reading, "more than %u knots", GRAPH_KNOT_MAX);
    }
    if (!numbers(reading, rest, values, 1u + card->key_count)) {
        return 0;
    }
    struct graph_knot *knot = &graph->knots[graph->knot_count++];
    knot->progress = values[0];
    memcpy(knot->weight, values + 1, card->key_count * sizeof values[0]);
    return 1;
}

static int read_scale(struct reading *reading, const char *rest, struct lab_edit *edit)
{
    float values[2] = { 0 };
    if (edit->scale_knot_count == GRAPH_KNOT_MAX) {
        return refuse(reading, "more than %u scale knots", GRAPH_KNOT_MAX);
    }
    if (!numbers(reading, rest, values, 2)) {
        return 0;
    }
    edit->scale_knots[edit->scale_knot_count++] = (struct scale_knot){ values[0], values[1] };
    return 1;
}

/* Of a graph that is none: which knot, and what is wrong with it. */
static int judge(struct reading *reading, const struct species_card *card,
                 const struct lab_edit *edit)
{
    static const char *const faults[] = {
        [GRAPH_GOOD] = "the scale does not rise from 0 to 1 within 0.2 mm to 20 m",
        [GRAPH_KNOT_COUNT] = "fewer than 2 knots",
        [GRAPH_ENDS] = "the first knot is not at 0, or the last not at 1",
        [GRAPH_ORDER] = "its progress does not rise",
        [GRAPH_NEGATIVE] = "a weight is negative",
        [GRAPH_SUM] = "its weights do not sum to 1",
    };
    if (lab_edit_is_good(edit, card)) {
        return 1;
    }
    const struct graph_verdict verdict = graph_check(&edit->graph, card->key_count);
    const size_t known = sizeof faults / sizeof *faults;
    const char *fault = verdict.fault < known ? faults[verdict.fault] : NULL;
    return refuse(reading, "knot %u: %s", verdict.knot + 1u,
                  fault != NULL ? fault : "it leaves no shape to solve for");
}

int edit_file_parse(const char *text, size_t size, const struct species_card *card,
                    struct lab_edit *edit, char why[EDIT_WHY_SIZE])
{
    struct reading reading = { .text = text, .size = size, .why = why };
    struct lab_edit read = { 0 };
    why[0] = 0;
    if (!read_head(&reading, card, &read)) {
        return 0;
    }
    while (next_line(&reading)) {
        const char *knot = after(&reading, "knot"), *scale = after(&reading, "scale");
        if (strcmp(reading.words, "end") == 0) {
            if (!judge(&reading, card, &read)) {
                return 0;
            }
            *edit = read;
            return 1;
        }
        if (knot == NULL && scale == NULL) {
            return refuse(&reading, "expected 'knot', 'scale' or 'end'");
        }
        if (!(knot != NULL ? read_knot(&reading, knot, card, &read.graph)
                           : read_scale(&reading, scale, &read))) {
            return 0;
        }
    }
    return 0;
}

/* ---- Files ---------------------------------------------------------------------------------- */

/* Names that could lead elsewhere are no species'. */
static int is_plain_name(const char id[SPECIES_NAME_SIZE])
{
    size_t length = 0;
    while (length < SPECIES_NAME_SIZE && id[length] != 0) {
        const char c = id[length];
        if (!((c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '_')) {
            return 0;
        }
        length++;
    }
    return length > 0 && length < SPECIES_NAME_SIZE;
}

static int write_whole(int fd, const char *text, size_t size)
{
    size_t done = 0;
    while (done < size) {
        const ssize_t written = write(fd, text + done, size - done);
        if (written < 0 && errno == EINTR) {
            continue;
        }
        if (written <= 0) {
            return written < 0 ? -errno : -EIO;
        }
        done += (size_t)written;
    }
    return fsync(fd) != 0 ? -errno : 0;
}

/* A name in a folder lasts once the folder is on the disk. */
static int sync_folder(const char *folder)
{
    const int fd = open(folder, O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (fd < 0) {
        return -errno;
    }
    const int error = fsync(fd) != 0 ? -errno : 0;
    close(fd);
    return error;
}

static int replace(const char *path, const char *text, size_t size)
{
    char beside[PATH_SIZE + SPECIES_NAME_SIZE + 32u];
    snprintf(beside, sizeof beside, "%s.new", path);
    const int fd = open(beside, O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0644);
    if (fd < 0) {
        return -errno;
    }
    int error = write_whole(fd, text, size);
    if (close(fd) != 0 && error == 0) {
        error = -errno;
    }
    if (error == 0 && rename(beside, path) != 0) {
        error = -errno;
    }
    if (error != 0) {
        unlink(beside);
    }
    return error;
}

int edit_file_keep(const char *data, const struct edit_record *record)
{
    char folder[PATH_SIZE], path[PATH_SIZE + SPECIES_NAME_SIZE + 16u], text[EDIT_TEXT_MAX];
    const int length = snprintf(folder, sizeof folder, "%s/" EDIT_FOLDER, data);
    if (!is_plain_name(record->species) || length < 0 || (size_t)length >= sizeof folder) {
        return -ENAMETOOLONG;
    }
    int error = folder_make(folder);
    if (error != 0) {
        return error;
    }
    snprintf(path, sizeof path, "%s/%s" EDIT_SUFFIX, folder, record->species);
    if (record->is_own) {
        error = unlink(path) != 0 && errno != ENOENT ? -errno : 0;
    } else {
        error = replace(path, text, edit_file_format(record, text));
    }
    return error != 0 ? error : sync_folder(folder);
}

static void tell(struct edit_warn warn, const char *path, const char *why)
{
    char line[PATH_SIZE + EDIT_WHY_SIZE];
    if (warn.tell != NULL) {
        snprintf(line, sizeof line, "%s:%s", path, why);
        warn.tell(warn.context, line);
    }
}

/* Only what a text of ours can be long is read; more is none. */
static void fill_one(const char *path, const struct species_card *card, uint8_t *has,
                     struct lab_edit *edit, struct edit_warn warn)
{
    char text[EDIT_TEXT_MAX + 1u], why[EDIT_WHY_SIZE];
    const int fd = open(path, O_RDONLY | O_CLOEXEC | O_NONBLOCK);
    if (fd < 0) {
        if (errno != ENOENT && errno != ENOTDIR) {
            snprintf(why, sizeof why, " cannot open: %.80s", strerror(errno));
            tell(warn, path, why);
        }
        return;
    }
    const ssize_t size = read(fd, text, sizeof text);
    close(fd);
    if (size < 0 || (size_t)size > EDIT_TEXT_MAX) {
        tell(warn, path, size < 0 ? " cannot read" : " longer than any graph");
    } else if (edit_file_parse(text, (size_t)size, card, edit, why)) {
        *has = 1;
    } else {
        tell(warn, path, why);
    }
}

void edit_file_fill(const char *data, struct lab_book *book, struct edit_warn warn)
{
    char path[PATH_SIZE];
    for (uint32_t i = 0; i < lab_book_count(book) && data != NULL && data[0] != 0; i++) {
        const struct species_card *card = lab_book_card(book, i);
        const int length = snprintf(path, sizeof path, "%s/" EDIT_FOLDER "/%s" EDIT_SUFFIX, data,
                                    card->id);
        if (length > 0 && (size_t)length < sizeof path && is_plain_name(card->id)) {
            fill_one(path, card, &book->has_edit[i], &book->edits[i], warn);
        }
    }
}
