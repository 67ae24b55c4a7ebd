/* scores_verify.h -- the subcommands `kingyoctl scores verify` and `kingyoctl scores replay`.
 *
 * `verify` recomputes the stored replay of a score and compares the result. `replay` writes the
 * stored replay to a file. */
#ifndef KINGYO_PLATFORM_CTL_OPERATOR_SCORES_VERIFY_H
#define KINGYO_PLATFORM_CTL_OPERATOR_SCORES_VERIFY_H

#include "platform/ctl/operator/books.h"

/* Options of `kingyoctl scores` and of its subcommands. */
struct scores_request {
    struct books_words books;
    /* `mode` is the selected game mode, or MODE_COUNT for all modes. `period` is the selected
     * ranking period, or RANK_PERIOD_COUNT for all periods. */
    uint8_t mode, period;
    uint8_t is_all;    /* 1 if all ranked rounds are verified. */
    uint8_t with_pin;  /* 1 if the output file may contain the PIN of the operator's menu. */
    uint32_t round_id; /* Number of the selected round, or 0 if no round is selected. */
    const char *out;   /* Path of the output file for the replay, or null. */
};

/* Verifies the replay of the selected round, or of all ranked rounds if round_id is 0. A missing
 * replay is an error only if a round is selected. Returns the exit code of the program. */
enum exit_code scores_verify(const struct scores_request *request, struct ledger_file *file);

/* Writes the replay of the selected round to the file request->out. Returns the exit code of the
 * program. */
enum exit_code scores_write_replay(const struct scores_request *request, struct ledger_file *file);

#endif
