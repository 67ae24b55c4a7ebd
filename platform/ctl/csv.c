/* csv.c -- one line at a time: the head says where the columns are, each row gives their values. */
#include "platform/ctl/csv.h"

#include <errno.h>
#include <stdarg.h>
#include <string.h>

#include "platform/number.h"

#define FIELD_SHOWN 40 /* Characters of a wrong value that are told again. */

static enum exit_code refuse_line(const struct csv *csv, const char *what)
{
    fprintf(stderr, "%s: %s: line %u: %s\n", csv->speaker, csv->path, csv->line, what);
    return EXIT_BAD_DATA;
}

enum exit_code csv_refuse(const struct csv *csv, uint32_t index, const char *format, ...)
{
    va_list arguments;
    fprintf(stderr, "%s: %s: line %u, column %u (%s): ", csv->speaker, csv->path, csv->line,
            csv->field_of[index], csv->columns[index].name);
    va_start(arguments, format);
    vfprintf(stderr, format, arguments);
    va_end(arguments);
    fputc('\n', stderr);
    return EXIT_BAD_DATA;
}

static int is_blank(char c)
{
    return c == ' ' || c == '\t' || c == '\r' || c == '\n';
}

/* Reads the next line that is not empty into csv->text. `*is_end` when there is none. */
static enum exit_code next_line(struct csv *csv, int *is_end)
{
    *is_end = 0;
    for (;;) {
        csv->line++;
        if (!fgets(csv->text, sizeof csv->text, csv->file)) {
            *is_end = 1;
            if (ferror(csv->file)) {
                fprintf(stderr, "%s: %s: %s\n", csv->speaker, csv->path, strerror(errno));
                return EXIT_IO;
            }
            return EXIT_OK;
        }
        const size_t length = strlen(csv->text);
        if (length == sizeof csv->text - 1 && csv->text[length - 1] != '\n') {
            return refuse_line(csv, "is longer than any line of numbers");
        }
        size_t blank = 0;
        while (is_blank(csv->text[blank])) {
            blank++;
        }
        if (csv->text[blank] != '\0') {
            return EXIT_OK;
        }
    }
}

/* Cuts the next field off `*rest`, without the white space around it; null behind the last. */
static char *cut_field(char **rest)
{
    char *field = *rest;
    if (!field) {
        return NULL;
    }
    char *comma = strchr(field, ',');
    *rest = comma ? comma + 1 : NULL;
    char *end = comma ? comma : field + strlen(field);
    while (end > field && is_blank(end[-1])) {
        end--;
    }
    *end = '\0';
    while (is_blank(*field)) {
        field++;
    }
    return field;
}

static enum exit_code read_head(struct csv *csv)
{
    int is_end;
    const enum exit_code code = next_line(csv, &is_end);
    if (code != EXIT_OK || is_end) {
        return code != EXIT_OK ? code : refuse_line(csv, "is empty: a head of columns is missing");
    }
    char *rest = csv->text;
    uint32_t number = 1;
    for (char *name = cut_field(&rest); name; name = cut_field(&rest), number++) {
        for (uint32_t i = 0; i < csv->column_count; i++) {
            if (strcmp(name, csv->columns[i].name) == 0) {
                if (csv->field_of[i]) {
                    return csv_refuse(csv, i, "is there twice");
                }
                csv->field_of[i] = number;
            }
        }
    }
    for (uint32_t i = 0; i < csv->column_count; i++) {
        if (!csv->field_of[i] && !csv->columns[i].may_miss) {
            fprintf(stderr, "%s: %s: line %u: the column %s is missing\n", csv->speaker, csv->path,
                    csv->line, csv->columns[i].name);
            return EXIT_BAD_DATA;
        }
    }
    return EXIT_OK;
}

enum exit_code csv_open(struct csv *csv, const char *speaker, const char *path,
                        const struct csv_column *columns, uint32_t column_count)
{
    *csv = (struct csv){
        .speaker = speaker, .path = path, .columns = columns, .column_count = column_count
    };
    csv->file = fopen(path, "r");
    if (!csv->file) {
        fprintf(stderr, "%s: %s: %s\n", speaker, path, strerror(errno));
        return EXIT_IO;
    }
    return read_head(csv);
}

int csv_has(const struct csv *csv, uint32_t index)
{
    return csv->field_of[index] != 0;
}

static enum exit_code read_word(const struct csv *csv, uint32_t index, const char *text,
                                double *value)
{
    char list[128] = "";
    const char *const *words = csv->columns[index].words;
    for (uint32_t i = 0; words[i]; i++) {
        if (strcmp(text, words[i]) == 0) {
            *value = (double)i;
            return EXIT_OK;
        }
        const size_t used = strlen(list);
        snprintf(list + used, sizeof list - used, "%s%s", i ? ", " : "", words[i]);
    }
    return csv_refuse(csv, index, "'%.*s' is none of %s", FIELD_SHOWN, text, list);
}

static enum exit_code read_value(const struct csv *csv, uint32_t index, const char *text,
                                 double *value)
{
    const struct csv_column *column = &csv->columns[index];
    if (column->words) {
        return read_word(csv, index, text, value);
    }
    if (!number_parse_decimal(text, column->min, column->max, value)) {
        return csv_refuse(csv, index, "'%.*s' is not a number from %g to %g", FIELD_SHOWN, text,
                          column->min, column->max);
    }
    return EXIT_OK;
}

enum exit_code csv_row(struct csv *csv, double *values, int *is_end)
{
    const enum exit_code code = next_line(csv, is_end);
    if (code != EXIT_OK || *is_end) {
        return code;
    }
    uint32_t found = 0, wanted = 0, number = 1;
    for (uint32_t i = 0; i < csv->column_count; i++) {
        values[i] = csv->columns[i].otherwise;
        wanted += csv_has(csv, i) ? 1u : 0u;
    }
    char *rest = csv->text;
    for (char *text = cut_field(&rest); text; text = cut_field(&rest), number++) {
        for (uint32_t i = 0; i < csv->column_count; i++) {
            if (csv->field_of[i] == number) {
                found++;
                const enum exit_code right = read_value(csv, i, text, &values[i]);
                if (right != EXIT_OK) {
                    return right;
                }
            }
        }
    }
    for (uint32_t i = 0; found < wanted && i < csv->column_count; i++) {
        if (csv->field_of[i] >= number) {
            return csv_refuse(csv, i, "is missing: the line ends before it");
        }
    }
    return EXIT_OK;
}

void csv_close(struct csv *csv)
{
    if (csv->file) {
        fclose(csv->file);
        csv->file = NULL;
    }
}
