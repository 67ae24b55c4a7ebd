/* csv.c -- the CSV reader.
 *
 * The reader parses one line at a time. The header line gives the order of the columns, and each
 * later line gives one value for each column. */
#include "platform/ctl/lib/csv.h"

#include <errno.h>
#include <stdarg.h>
#include <stdbool.h>
#include <string.h>

#include "core/base/panic.h"
#include "platform/ctl/lib/ctl.h"
#include "platform/os/file.h"
#include "platform/os/number.h"
#include "platform/os/print.h"

/* Maximum number of characters of an invalid value that an error message quotes. */
#define FIELD_SHOWN 40
#define LIST_MAX 256u

#define BLANKS " \t\r\n"

static enum exit_code reject_line(const struct csv *csv, const char *what)
{
    return print_fail(EXIT_BAD_DATA, "%s: %s: line %u: %s", csv->prefix, csv->path, csv->line,
                      what);
}

enum exit_code csv_error(const struct csv *csv, uint32_t index, const char *format, ...)
{
    char words[PRINT_LINE_MAX];
    CORE_ASSERT(index < csv->column_count);
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(words, sizeof words, format, arguments);
    va_end(arguments);
    return print_fail(EXIT_BAD_DATA, "%s: %s: line %u, column %u (%s): %s", csv->prefix, csv->path,
                      csv->line, csv->field_of[index], csv->columns[index].name, words);
}

/* Reads the next line that is not empty into csv->text. Sets `*is_end` to true at the end of the
 * file, otherwise to false. */
static enum exit_code csv_next_line(struct csv *csv, bool *is_end)
{
    do {
        csv->line++;
        const enum file_line result = file_read_line(csv->file, csv->text, sizeof csv->text);
        *is_end = result == FILE_LINE_END;
        if (*is_end) {
            return ferror(csv->file) ? ctl_file_error(csv->prefix, csv->path, CSV_SIZE_MAX, errno)
                                     : EXIT_OK;
        }
        if (result == FILE_LINE_BAD) {
            return reject_line(csv, "is longer than any line of numbers");
        }
        if (csv->line == 1) {
            const char *first = file_skip_mark(csv->text);
            memmove(csv->text, first, strlen(first) + 1u);
        }
    } while (csv->text[strspn(csv->text, BLANKS)] == '\0');
    return EXIT_OK;
}

/* Returns the next field of the line, without the white space around the field. Returns null after
 * the last field. Advances `*rest` past the field. */
static char *cut_field(char **rest)
{
    char *field = strsep(rest, ",");
    if (field) {
        field += strspn(field, BLANKS);
        for (size_t size = strlen(field); size > 0 && strchr(BLANKS, field[size - 1u]);) {
            field[--size] = '\0';
        }
    }
    return field;
}

/* Records that the column `name` is the `number`-th column of the file, counted from 1. */
static enum exit_code take_name(struct csv *csv, const char *name, uint32_t number)
{
    char list[LIST_MAX] = "";
    for (uint32_t i = 0; i < csv->column_count; i++) {
        if (strcmp(name, csv->columns[i].name) == 0) {
            if (csv->field_of[i]) {
                return csv_error(csv, i, "occurs twice");
            }
            csv->field_of[i] = number;
            return EXIT_OK;
        }
        ctl_list_word(list, sizeof list, csv->columns[i].name);
    }
    return print_fail(EXIT_BAD_DATA, "%s: %s: line %u, column %u: '%.*s' is none of %s",
                      csv->prefix, csv->path, csv->line, number, FIELD_SHOWN, name, list);
}

static enum exit_code read_head(struct csv *csv)
{
    bool is_end;
    enum exit_code code = csv_next_line(csv, &is_end);
    if (code == EXIT_OK && is_end) {
        return reject_line(csv, "is empty: the header line with the column names is missing");
    }
    char *rest = csv->text;
    for (char *name; code == EXIT_OK && (name = cut_field(&rest));) {
        code = take_name(csv, name, ++csv->field_count);
    }
    for (uint32_t i = 0; code == EXIT_OK && i < csv->column_count; i++) {
        if (!csv->field_of[i] && !csv->columns[i].may_miss) {
            return print_fail(EXIT_BAD_DATA, "%s: %s: line %u: the column %s is missing",
                              csv->prefix, csv->path, csv->line, csv->columns[i].name);
        }
    }
    return code;
}

static enum exit_code read_value(const struct csv *csv, uint32_t index, const char *text,
                                 double *value)
{
    const struct csv_column *column = &csv->columns[index];
    if (column->unread) {
        return EXIT_OK;
    }
    if (column->words) {
        char list[LIST_MAX] = "";
        for (uint32_t i = 0; column->words[i]; i++) {
            if (strcmp(text, column->words[i]) == 0) {
                *value = (double)i;
                return EXIT_OK;
            }
            ctl_list_word(list, sizeof list, column->words[i]);
        }
        return csv_error(csv, index, "'%.*s' is none of %s", FIELD_SHOWN, text, list);
    }
    if (!number_parse_decimal(text, column->min, column->max, value)) {
        return csv_error(csv, index, "'%.*s' is not a number from %g to %g", FIELD_SHOWN, text,
                         column->min, column->max);
    }
    return EXIT_OK;
}

/* Reads the next row into values[column_count]. Sets `*is_end` to true at the end of the file,
 * otherwise to false. */
static enum exit_code read_row(struct csv *csv, double *values, bool *is_end)
{
    const enum exit_code code = csv_next_line(csv, is_end);
    if (code != EXIT_OK || *is_end) {
        return code;
    }
    for (uint32_t i = 0; i < csv->column_count; i++) {
        values[i] = csv->columns[i].otherwise;
    }
    char *rest = csv->text;
    for (uint32_t number = 1; number <= csv->field_count; number++) {
        uint32_t index = 0;
        while (index + 1u < csv->column_count && csv->field_of[index] != number) {
            index++;
        }
        /* The header line defines a column at each position, so the assertion holds. */
        CORE_ASSERT(csv->field_of[index] == number);
        const char *text = cut_field(&rest);
        if (!text) {
            return csv_error(csv, index, "is missing: the line ends before it");
        }
        const enum exit_code right = read_value(csv, index, text, &values[index]);
        if (right != EXIT_OK) {
            return right;
        }
    }
    const char *surplus = cut_field(&rest);
    if (surplus) {
        return print_fail(EXIT_BAD_DATA,
                          "%s: %s: line %u, column %u: '%.*s' is beyond the head's %u columns",
                          csv->prefix, csv->path, csv->line, csv->field_count + 1u, FIELD_SHOWN,
                          surplus, csv->field_count);
    }
    return EXIT_OK;
}

enum exit_code csv_read(struct csv *csv,
                        enum exit_code (*take)(void *self, const struct csv *csv,
                                               const double *values),
                        void *self)
{
    double values[CSV_COLUMN_MAX];
    uint32_t row_count = 0;
    bool is_end = false;
    CORE_ASSERT(csv->columns && csv->column_count >= 1 && csv->column_count <= CSV_COLUMN_MAX);
    enum exit_code code = ctl_file_open(csv->prefix, csv->path, CSV_SIZE_MAX, &csv->file);
    if (code != EXIT_OK) {
        return code;
    }
    code = read_head(csv);
    while (code == EXIT_OK && !is_end) {
        code = read_row(csv, values, &is_end);
        if (code == EXIT_OK && !is_end) {
            row_count++;
            code = take(self, csv, values);
        }
    }
    if (code == EXIT_OK && row_count == 0) {
        code = reject_line(csv, "a row of numbers is missing");
    }
    fclose(csv->file);
    return code;
}
