/* words.c -- converts the list of rejected player names, assets/words/refused.txt, to a table of
 * the core.
 *
 * A line `word` rejects every name that contains the word. A line `=word` rejects only the word as
 * a whole name. A line that begins with `#` is a comment. Each word is normalized in the same way
 * as a player's name. */
#include "assets/bake/bake.h"

#include <assert.h>
#include <stdbool.h>

#include "core/game/ranking/name_filter.h"

/* The output file, and the number of words in it. */
struct word_table {
    FILE *file;
    uint32_t count;
};

static void write_word(void *self, const char *path, char *word, uint32_t line)
{
    struct word_table *table = self;
    uint16_t letters[NAME_NORMALIZE_MAX];
    const bool is_whole = word[0] == '=';
    const uint32_t count = name_normalize(word + is_whole, NAME_ENDS_KEPT, letters);
    if (count == 0 || count > REFUSED_LETTERS_MAX) {
        bake_fail("%s:%u: a word has 1 to 16 letters, of kana or the Latin alphabet", path, line);
    }
    if (count < 3 && !is_whole) {
        bake_fail("%s:%u: a word of one or two letters is in too many names: write =word", path,
                  line);
    }
    assert(count <= NAME_NORMALIZE_MAX);
    fprintf(table->file, "    { %d, %u, { ", is_whole, count);
    for (uint32_t i = 0; i < count; i++) {
        fprintf(table->file, "0x%04x%s", letters[i], i + 1 < count ? ", " : " } },\n");
    }
    table->count++;
}

void words_bake(char **paths)
{
    struct word_table table = { .file = bake_open(paths[1]) };
    fputs("/* refused_words.c -- written by assets/bake/words.c from assets/words/refused.txt. */\n"
          "#include \"core/game/ranking/name_filter.h\"\n\n"
          "const struct refused_word refused_words[] = {\n",
          table.file);
    bake_read_lines(paths[0], write_word, &table);
    if (table.count == 0) {
        bake_fail("%s: the list has no words", paths[0]);
    }
    fprintf(table.file, "};\nconst uint32_t refused_word_count = %uu;\n", table.count);
    bake_close(table.file, paths[1]);
}
