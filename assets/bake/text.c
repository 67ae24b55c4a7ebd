/* text.c -- converts the user interface's text to an enum of keys and a table of texts.
 *
 * A text file consists of lines `key = words`. A line that begins with `#` is a comment. The file
 * of the first language determines the order of the keys. */
#include "assets/bake/bake.h"

#include <assert.h>
#include <ctype.h>
#include <stdlib.h>
#include <string.h>

#include "core/base/printable.h"

static const char *const language_names[TEXT_LANGUAGES] = { "ja", "en" };

static char *text_trim(char *s)
{
    while (isspace((unsigned char)*s)) {
        s++;
    }
    char *end = s + strlen(s);
    while (end > s && isspace((unsigned char)end[-1])) {
        *--end = 0;
    }
    return s;
}

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

static void add_line(struct text_file *file, char *line, uint32_t number)
{
    char *equals = strchr(line, '=');
    if (equals == NULL) {
        bake_fail("%s:%u: expected `key = words`", file->path, number);
    }
    *equals = 0;
    char *key = text_trim(line), *words = text_trim(equals + 1);
    if (*key == 0 || key[strspn(key, "abcdefghijklmnopqrstuvwxyz0123456789_")] != 0) {
        bake_fail("%s:%u: `%s` is not a key (a-z, 0-9 and _)", file->path, number, key);
    }
    if (*words == 0) {
        bake_fail("%s:%u: `%s` has no words", file->path, number, key);
    }
    const struct text_line *twin = find_key(file, key);
    if (twin != NULL) {
        bake_fail("%s:%u: `%s` is already on line %u", file->path, number, key, twin->line);
    }
    if (file->count == TEXT_KEYS_MAX) {
        bake_fail("%s:%u: more than %u keys (TEXT_KEYS_MAX)", file->path, number, TEXT_KEYS_MAX);
    }
    const char *at = words;
    for (uint32_t code = printable_next(&at); code != 0; code = printable_next(&at)) {
        if (code < 0x20 || code == PRINTABLE_MALFORMED) {
            bake_fail("%s:%u: `%s` holds bytes that are not UTF-8 text", file->path, number, key);
        }
    }
    file->lines[file->count++] = (struct text_line){ .key = key, .words = words, .line = number };
}

/* Reads one text file. The lines point to the file's bytes, which are never freed. */
static void text_read_file(struct text_file *file, const char *directory, const char *language)
{
    char path[1024];
    snprintf(path, sizeof path, "%s/%s.txt", directory, language);
    const size_t path_size = strlen(path) + 1;
    char *kept = bake_alloc(path_size);
    memcpy(kept, path, path_size);
    file->path = kept;
    size_t size;
    char *at = (char *)bake_read(path, &size);
    for (uint32_t number = 1; at != NULL; number++) {
        char *end = strchr(at, '\n');
        if (end != NULL) {
            *end++ = 0;
        }
        char *line = text_trim(at);
        if (*line != 0 && *line != '#') {
            add_line(file, line, number);
        }
        at = end;
    }
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
        text_read_file(&files[i], directory, language_names[i]);
    }
    for (uint32_t i = 1; i < TEXT_LANGUAGES; i++) {
        check_same_keys(&files[0], &files[i]);
        check_same_keys(&files[i], &files[0]);
    }
}

void text_write_keys(const struct text_file files[TEXT_LANGUAGES], const char *path)
{
    FILE *file = bake_open(path);
    fputs("/* text_keys.h -- every phrase of the stall by name; written by assets/bake from "
          "assets/text. */\n#ifndef KINGYO_GENERATED_TEXT_KEYS_H\n"
          "#define KINGYO_GENERATED_TEXT_KEYS_H\n\nenum text_key {\n",
          file);
    for (uint32_t i = 0; i < files[0].count; i++) {
        fputs("    TEXT_", file);
        for (const char *c = files[0].lines[i].key; *c != 0; c++) {
            fputc(toupper((unsigned char)*c), file);
        }
        fputs(",\n", file);
    }
    fprintf(file,
            "    TEXT_COUNT,\n};\n\n/* By enum language, then enum text_key; UTF-8. */\n"
            "extern const char *const text_table[%u][TEXT_COUNT];\n\n#endif\n",
            TEXT_LANGUAGES);
    bake_close(file, path);
}

static void write_quoted(FILE *file, const char *words)
{
    fputs("        \"", file);
    for (const char *c = words; *c != 0; c++) {
        if (*c == '"' || *c == '\\') {
            fputc('\\', file);
        }
        fputc(*c, file);
        if (*c == '?') {
            fputs("\"\"", file); /* The string literal is split so that the C compiler finds no
                                    trigraph. */
        }
    }
    fputs("\",\n", file);
}

void text_write_table(const struct text_file files[TEXT_LANGUAGES], const char *path)
{
    FILE *file = bake_open(path);
    fprintf(file,
            "/* text_table.c -- the stall's words; written by assets/bake from assets/text. */\n"
            "#include \"text_keys.h\"\n\nconst char *const text_table[%u][TEXT_COUNT] = {\n",
            TEXT_LANGUAGES);
    for (uint32_t i = 0; i < TEXT_LANGUAGES; i++) {
        fprintf(file, "    { /* %s */\n", language_names[i]);
        for (uint32_t k = 0; k < files[0].count; k++) {
            const struct text_line *line = find_key(&files[i], files[0].lines[k].key);
            assert(line); /* text_read() has checked that all text files have the same keys, so the
                             line exists. */
            write_quoted(file, line->words);
        }
        fputs("    },\n", file);
    }
    fputs("};\n", file);
    bake_close(file, path);
}
