/* text.c -- converts the user interface's text to an enum of keys and a table of texts.
 *
 * A text file consists of lines `key = words`. A line that begins with `#` is a comment. The file
 * of the first language determines the order of the keys. */
#include "assets/bake/bake.h"

#include <assert.h>
#include <string.h>

#include "core/base/printable.h"

static const char *const language_names[TEXT_LANGUAGES] = { "ja", "en" };

static const struct text_line *find_key(const struct text_file *file, const char *key)
{
    assert(file->count <= TEXT_KEYS_MAX);
    for (uint32_t i = 0; i < file->count; i++) {
        if (strcmp(file->lines[i].key, key) == 0) {
            return &file->lines[i];
        }
    }
    return NULL;
}

static void add_line(void *self, const char *path, char *line, uint32_t number)
{
    struct text_file *file = self;
    char *equals = strchr(line, '=');
    if (equals == NULL) {
        bake_fail("%s:%u: expected `key = words`", path, number);
    }
    *equals = 0;
    char *key = bake_trim(line), *words = bake_trim(equals + 1);
    if (*key == 0 || key[strspn(key, "abcdefghijklmnopqrstuvwxyz0123456789_")] != 0) {
        bake_fail("%s:%u: `%s` is not a key (a-z, 0-9 and _)", path, number, key);
    }
    if (*words == 0) {
        bake_fail("%s:%u: `%s` has no words", path, number, key);
    }
    const struct text_line *twin = find_key(file, key);
    if (twin != NULL) {
        bake_fail("%s:%u: `%s` is already on line %u", path, number, key, twin->line);
    }
    if (file->count == TEXT_KEYS_MAX) {
        bake_fail("%s:%u: more than %u keys (TEXT_KEYS_MAX)", path, number, TEXT_KEYS_MAX);
    }
    const char *at = words;
    for (uint32_t code = printable_next(&at); code != 0; code = printable_next(&at)) {
        if (code < 0x20 || code == PRINTABLE_MALFORMED) {
            bake_fail("%s:%u: `%s` holds bytes that are not UTF-8 text", path, number, key);
        }
    }
    file->lines[file->count++] = (struct text_line){ .key = key, .words = words, .line = number };
}

static void check_same_keys(const struct text_file *has, const struct text_file *lacks)
{
    for (uint32_t i = 0; i < has->count; i++) {
        if (find_key(lacks, has->lines[i].key) == NULL) {
            bake_fail("%s lacks `%s`, which is at %s:%u", lacks->path, has->lines[i].key, has->path,
                      has->lines[i].line);
        }
    }
}

void text_read(struct text_file files[TEXT_LANGUAGES], const char *directory)
{
    for (uint32_t i = 0; i < TEXT_LANGUAGES; i++) {
        snprintf(files[i].path, sizeof files[i].path, "%s/%s.txt", directory, language_names[i]);
        bake_read_lines(files[i].path, add_line, &files[i]);
    }
    for (uint32_t i = 1; i < TEXT_LANGUAGES; i++) {
        check_same_keys(&files[0], &files[i]);
        check_same_keys(&files[i], &files[0]);
    }
}

/* Writes the enum of the text keys as a C header. */
static void write_keys(const struct text_file files[TEXT_LANGUAGES], const char *path)
{
    FILE *file = bake_open(path);
    fputs("/* text_keys.h -- the name of each text of the kiosk; written by assets/bake from "
          "assets/text. */\n#ifndef KINGYO_GENERATED_TEXT_KEYS_H\n"
          "#define KINGYO_GENERATED_TEXT_KEYS_H\n\nenum text_key {\n",
          file);
    for (uint32_t i = 0; i < files[0].count; i++) {
        fputs("    TEXT_", file);
        bake_put_capitals(file, files[0].lines[i].key);
        fputs(",\n", file);
    }
    fprintf(file,
            "    TEXT_COUNT,\n};\n\n/* By enum language, then enum text_key; UTF-8. */\n"
            "extern const char *const text_table[%u][TEXT_COUNT];\n\n#endif\n",
            TEXT_LANGUAGES);
    bake_close(file, path);
}

/* Writes the texts of all languages as a C table. */
static void write_table(const struct text_file files[TEXT_LANGUAGES], const char *path)
{
    FILE *file = bake_open(path);
    fprintf(
        file,
        "/* text_table.c -- the texts of the kiosk; written by assets/bake from assets/text. */\n"
        "#include \"text_keys.h\"\n\nconst char *const text_table[%u][TEXT_COUNT] = {\n",
        TEXT_LANGUAGES);
    for (uint32_t i = 0; i < TEXT_LANGUAGES; i++) {
        fprintf(file, "    { /* %s */\n", language_names[i]);
        for (uint32_t k = 0; k < files[0].count; k++) {
            const struct text_line *line = find_key(&files[i], files[0].lines[k].key);
            /* The line exists, because text_read() has checked that all text files have the same
             * keys. */
            assert(line);
            fputs("        \"", file);
            for (const char *c = line->words; *c != 0; c++) {
                /* A question mark is escaped, because the C compiler would replace a trigraph such
                 * as ??=. */
                fprintf(file, strchr("\"\\?", *c) ? "\\%c" : "%c", *c);
            }
            fputs("\",\n", file);
        }
        fputs("    },\n", file);
    }
    fputs("};\n", file);
    bake_close(file, path);
}

void text_bake(char **paths)
{
    static struct text_file files[TEXT_LANGUAGES];
    text_read(files, paths[0]);
    write_keys(files, paths[1]);
    write_table(files, paths[2]);
}
