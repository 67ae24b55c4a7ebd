/* morph_import_words.h -- parses the command line of `kingyoctl morph import`. */
#ifndef KINGYO_PLATFORM_CTL_MORPH_MORPH_IMPORT_WORDS_H
#define KINGYO_PLATFORM_CTL_MORPH_MORPH_IMPORT_WORDS_H

#include <stdbool.h>
#include <stdint.h>

#include "platform/ctl/import/import_options.h"
#include "platform/ctl/lib/ctl.h"

#define IMPORT_UNSET 255u /* Value of a field of the plan that no option has set. */
#define IMPORT_PATH_SIZE 256u

struct morph_import_words {
    const char *out;
    const char *files[MORPH_KEY_MAX];
    uint32_t file_count;
    const char *id, *like, *fit;
    /* Path of the landmarks of each file, used with --fit. */
    char marks[MORPH_KEY_MAX][IMPORT_PATH_SIZE];
    uint32_t mark_count;
    struct import_options plan;
};

/* Parses the command line. argv[0] is the first word after `import`. `words` keeps pointers into
 * argv. Returns EXIT_OK. For an unknown option, a value that is not valid, or too many files,
 * prints one line to standard error and returns EXIT_USAGE. */
enum exit_code morph_import_words_read(struct morph_import_words *words, int argc,
                                       const char *const *argv);

/* Parses `piece` as the name of the species or of a key into element `index` of `out`, an array of
 * char[SPECIES_NAME_SIZE]. Returns false if the name is not valid. */
bool morph_import_words_take_name(const char *piece, uint32_t index, void *out);

#endif
