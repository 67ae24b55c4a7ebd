/* morph_import_words.h -- parses the command lines of `kingyoctl morph import` and `kingyoctl morph
 * refit`, which convert meshes to a species. */
#pragma once

#include <stdint.h>

#include "platform/ctl/import/import.h"
#include "platform/ctl/lib/ctl.h"

/* Value of a field in `plan` if the command line does not contain the option of this field. */
#define IMPORT_UNSET 255u
#define IMPORT_PATH_SIZE 256u

/* Commands that convert meshes. The values are the groups of the options in the table. */
enum import_command {
    IMPORT_MESHES = 1, /* `kingyoctl morph import` */
    IMPORT_REFIT = 2,  /* `kingyoctl morph refit` */
};

struct morph_import_words {
    const char *out;
    const char *files[MORPH_KEY_MAX];
    uint32_t file_count;
    const char *like; /* Value of --like, or the species that `refit` bends. */
    /* Path of the landmark file for each mesh file. Used by `refit`. */
    char marks[MORPH_KEY_MAX][IMPORT_PATH_SIZE];
    uint32_t mark_count;
    struct import_options plan;
};

/* Table of the arguments and the options of both commands. The values are stored in a struct
 * morph_import_words. The field `groups` of each option is a combination of enum import_command. */
extern const struct option_table morph_import_words_table;

/* Parses the command line into `words`. argv[0] is the first argument after the command's name.
 * `words` keeps pointers into `argv`. Returns EXIT_OK. For an unknown option, an invalid value, or
 * too many files, prints one line to standard error and returns EXIT_USAGE. */
enum exit_code morph_import_words_read(struct morph_import_words *words,
                                       enum import_command command, int argc,
                                       const char *const *argv);

/* Writes the base name of the file without its suffix to `out`, for use as an id or as the name of
 * a key. */
void morph_import_words_name(const char *path, char out[SPECIES_NAME_SIZE]);

/* Sets `plan.id`, whose default is the name of the output file, and opens the species `like`, which
 * is built-in or a file. The values of `like` are the defaults for options that are absent. Returns
 * EXIT_OK, or prints one line to standard error and returns another exit code. The species is
 * static, so only one is open at a time. */
enum exit_code morph_import_words_open_like(struct morph_import_words *words,
                                            enum import_command command);
