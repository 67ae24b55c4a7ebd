/* words.c -- the tool `bake_words assets/words/refused.txt OUT.c`, which converts the list of
 * rejected player names to a table of the core.
 *
 * A line `word` rejects every name that contains the word. A line `=word` rejects only the word as
 * a whole name. A line that begins with `#` is a comment. Each word is normalized in the same way
 * as a player's name. */
#include <assert.h>
#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "core/game/ranking/name_filter.h"
#include "platform/os/exit_code.h"

#define LINE_SIZE 256

static void words_fail(const char *path, unsigned line, const char *what)
{
    fprintf(stderr, "%s:%u: %s\n", path, line, what);
    exit(EXIT_BAD_DATA);
}

static void write_word(FILE *out, const char *word, const char *path, unsigned line)
{
    uint16_t letters[NAME_NORMALIZE_MAX];
    const int is_whole = word[0] == '=';
    const uint32_t count = name_normalize(word + is_whole, NAME_ENDS_KEPT, letters);
    if (count == 0 || count > REFUSED_LETTERS_MAX) {
        words_fail(path, line, "a word has 1 to 16 letters, of kana or the Latin alphabet");
    }
    if (count < 3 && !is_whole) {
        words_fail(path, line, "a word of one or two letters is in too many names: write =word");
    }
    assert(count <= NAME_NORMALIZE_MAX);
    fprintf(out, "    { %d, %u, { ", is_whole, count);
    for (uint32_t i = 0; i < count; i++) {
        fprintf(out, "0x%04x%s", letters[i], i + 1 < count ? ", " : " } },\n");
    }
}

static uint32_t write_words(FILE *in, FILE *out, const char *path)
{
    char text[LINE_SIZE];
    uint32_t count = 0;
    for (unsigned line = 1; fgets(text, sizeof text, in) != NULL; line++) {
        if (strchr(text, '\n') == NULL && !feof(in)) {
            words_fail(path, line, "this line is too long");
        }
        text[strcspn(text, "\n")] = 0;
        if (text[0] != 0 && text[0] != '#') {
            write_word(out, text, path, line);
            count++;
        }
    }
    return count;
}

static FILE *open_or_fail(const char *path, const char *mode)
{
    FILE *file = fopen(path, mode);
    if (file == NULL) {
        fprintf(stderr, "bake_words: %s: %s\n", path, strerror(errno));
        exit(EXIT_IO);
    }
    return file;
}

int main(int count, char **arguments)
{
    if (count != 3) {
        fputs("usage: bake_words refused.txt OUT.c\n", stderr);
        return EXIT_USAGE;
    }
    FILE *in = open_or_fail(arguments[1], "r"), *out = open_or_fail(arguments[2], "w");
    fputs("/* refused_words.c -- written by assets/bake/words.c from assets/words/refused.txt. */\n"
          "#include \"core/game/ranking/name_filter.h\"\n\n"
          "const struct refused_word refused_words[] = {\n",
          out);
    const uint32_t words = write_words(in, out, arguments[1]);
    fprintf(out, "};\nconst uint32_t refused_word_count = %uu;\n", words);
    fclose(in);
    if (words == 0) {
        words_fail(arguments[1], 1, "there is no word in it");
    }
    if (ferror(out) || fclose(out) != 0) {
        fprintf(stderr, "bake_words: %s: cannot be written\n", arguments[2]);
        return EXIT_IO;
    }
    return 0;
}
