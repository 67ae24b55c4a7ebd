/* bot_file.h -- the parser of bot files, which describe how a simulated player (a bot) plays.
 *
 * A bot file has lines of the form `key=value`. The keys are the fields of struct technique.
 * `base=novice` or `base=expert` may precede all other keys and selects the values of all keys that
 * the file does not set. The default base is the expert. White space around the key and the value
 * is ignored. A '#' at the start of a line or after white space begins a comment.
 *
 * Every error is reported. If a misspelt key were ignored, the bot would stay unchanged without a
 * message, and a comparison of two bots would be wrong. */
#pragma once

#include <stddef.h>
#include <stdint.h>

#include "core/game/bot/technique.h"
#include "platform/config/options.h"

/* Largest size of a bot file in bytes. A file that sets all keys has about a tenth of this size. */
#define BOT_FILE_SIZE_MAX 16384u
#define BOT_FILE_TEXT_MAX 200u

/* Position and text of an error in a bot file. */
struct bot_file_problem {
    /* Line number of the error, counted from 1. 0 means that the error concerns the whole file. */
    uint32_t line;
    char text[BOT_FILE_TEXT_MAX];
};

/* Parses `size` bytes of text into `out`. Returns 0. After an error, fills `problem`, leaves `out`
 * unchanged and returns -1. */
int bot_file_parse(const char *text, size_t size, struct technique *out,
                   struct bot_file_problem *problem);

/* Fills `out` with the technique of `bot`, which is "novice", "expert" or the path of a bot file.
 *
 * Returns EXIT_OK. After an error, leaves `out` unchanged, prints one line, "SPEAKER: PATH:LINE:
 * ...", on standard error, and returns EXIT_IO or EXIT_BAD_DATA. */
enum exit_code bot_file_read(const char *prefix, const char *bot, struct technique *out);

/* Prints a table of all keys on standard output, with the allowed values, the values of the novice
 * and the expert, and the descriptions. */
void bot_file_print_keys(void);
