/* bot_file.h -- the parser of bot files, which describe how a bot plays.
 *
 * A bot file has `key=value` lines. The keys are the fields of struct technique. `base=novice` or
 * `base=expert` may precede all other keys and selects the values of the keys that are not set. The
 * default base is the expert. White space around key and value is ignored. A '#' at the start of a
 * line or after white space begins a comment.
 *
 * Every error is reported and none is ignored. Otherwise a misspelt key would make a comparison of
 * two bots compare a bot with itself. */
#ifndef KINGYO_PLATFORM_CTL_PLAY_BOT_FILE_H
#define KINGYO_PLATFORM_CTL_PLAY_BOT_FILE_H

#include <stddef.h>
#include <stdint.h>

#include "core/game/bot/technique.h"
#include "platform/config/options.h"

/* Largest size of a bot file in bytes. A file with all keys needs about a tenth of it. */
#define BOT_FILE_SIZE_MAX 16384u
#define BOT_FILE_TEXT_MAX 200u

/* Position and text of an error in a bot file. */
struct bot_file_problem {
    uint32_t line; /* Line number of the problem, from 1. 0 means that the problem concerns the
                      whole file. */
    char text[BOT_FILE_TEXT_MAX];
};

/* Parses `size` bytes of text into `out`. Returns 0, or -1 with `problem` filled and `out`
 * unchanged. */
int bot_file_parse(const char *text, size_t size, struct technique *out,
                   struct bot_file_problem *problem);

/* Reads and parses the bot file at `path` into `out`.
 *
 * Returns EXIT_OK, EXIT_IO or EXIT_BAD_DATA. An error leaves `out` unchanged and prints one line on
 * standard error, "SPEAKER: PATH:LINE: ...". */
enum exit_code bot_file_read(const char *speaker, const char *path, struct technique *out);

/* Fills `out` for the bot `bot`, which is "novice", "expert" or the path of a bot file. Returns the
 * same codes as bot_file_read(). */
enum exit_code bot_file_named(const char *speaker, const char *bot, struct technique *out);

#endif
