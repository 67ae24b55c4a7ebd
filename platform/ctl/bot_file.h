/* bot_file.h -- how somebody plays, as text: `key=value` lines, one habit of the hand each.
 *
 * The keys are the fields of struct technique. `base=novice` or `base=expert` may come before all
 * others and says where the rest is from; without it the rest is the expert's. White space around
 * key and value is nothing; '#' at the beginning of a line or after white space begins a comment.
 * Nothing that is wrong is passed over: two bots are compared by one key, and a misspelt one would
 * compare a bot with itself. */
#ifndef KINGYO_PLATFORM_CTL_BOT_FILE_H
#define KINGYO_PLATFORM_CTL_BOT_FILE_H

#include <stddef.h>
#include <stdint.h>

#include "core/game/technique.h"
#include "platform/kiosk/options.h"

#define BOT_FILE_SIZE_MAX 16384u /* A page of keys is a tenth of it. */
#define BOT_FILE_TEXT_MAX 200u

struct bot_file_problem {
    uint32_t line; /* From 1; 0: the file as a whole. */
    char text[BOT_FILE_TEXT_MAX];
};

/* Reads `size` bytes of text into `out`: 0; or -1 with `problem` filled and `out` as it was. */
int bot_file_parse(const char *text, size_t size, struct technique *out,
                   struct bot_file_problem *problem);

/* The same from the file at `path`. EXIT_OK; or EXIT_IO or EXIT_BAD_DATA, told on standard error in
 * one line, "SPEAKER: PATH:LINE: ...", and `out` as it was. */
enum exit_code bot_file_read(const char *speaker, const char *path, struct technique *out);

/* Who plays: "novice", "expert", or else the path of a bot FILE. As bot_file_read(). */
enum exit_code bot_file_named(const char *speaker, const char *bot, struct technique *out);

#endif
