/* morph_import_words.h -- parses the command line of `kingyoctl morph import`, which converts
 * meshes to a species. */
#ifndef KINGYO_PLATFORM_CTL_MORPH_MORPH_IMPORT_WORDS_H
#define KINGYO_PLATFORM_CTL_MORPH_MORPH_IMPORT_WORDS_H

#include <stdbool.h>
#include <stdint.h>

#include "platform/ctl/import/import.h"
#include "platform/ctl/lib/ctl.h"

#define IMPORT_UNSET 255u /* Value of an option in `plan` that the command line does not contain. */
#define IMPORT_PATH_SIZE 256u

struct morph_import_words {
    const char *out;
    const char *files[MORPH_KEY_MAX];
    uint32_t file_count;
    const char *id, *like, *fit;
    /* Path of the landmark file for each mesh file. Used with --fit. */
    char marks[MORPH_KEY_MAX][IMPORT_PATH_SIZE];
    uint32_t mark_count;
    struct import_options plan;
};

/* Parses the command line into `words`. argv[0] is the first argument after `import`. `words` keeps
 * pointers into `argv`. Returns EXIT_OK. For an unknown option, an invalid value, or too many
 * files, prints one line to standard error and returns EXIT_USAGE. */
enum exit_code morph_import_words_read(struct morph_import_words *words, int argc,
                                       const char *const *argv);

/* Parses `piece` as the name of a species or of a key, and copies it to element `index` of `out`.
 * `out` points to an array of char[SPECIES_NAME_SIZE]. Returns false if the name is invalid. */
bool morph_import_words_take_name(const char *piece, uint32_t index, void *out);

#endif
