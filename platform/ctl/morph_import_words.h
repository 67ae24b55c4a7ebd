/* morph_import_words.h -- what the command line of `kingyoctl morph import` says. */
#ifndef KINGYO_PLATFORM_CTL_MORPH_IMPORT_WORDS_H
#define KINGYO_PLATFORM_CTL_MORPH_IMPORT_WORDS_H

#include <stdbool.h>
#include <stdint.h>

#include "platform/ctl/ctl.h"
#include "platform/ctl/import_plan.h"

#define IMPORT_UNSET 255u /* Where the plan was told nothing. */
#define IMPORT_PATH_SIZE 256u

struct import_words {
    const char *out;
    const char *files[MORPH_KEY_MAX];
    uint32_t file_count;
    const char *id, *like, *fit;
    char marks[MORPH_KEY_MAX][IMPORT_PATH_SIZE]; /* Of each file, with --fit. */
    uint32_t mark_count;
    struct import_plan plan;
};

/* argv[0] is the first word behind `import`. Points into argv. One line on standard error and
 * EXIT_USAGE for what is no option, no value of it, or too many files. */
enum exit_code import_words_read(struct import_words *words, int argc, const char *const *argv);

/* `piece` as the species' or a key's name, `out` an array of char[SPECIES_NAME_SIZE]. */
bool import_take_name(const char *piece, uint32_t index, void *out);

#endif
