/* game_fields.h -- the tables of the members of the game's state and of the configuration
 * (core/base/field.h). The state hash, the start state of a recording and the tests read the
 * tables. */
#pragma once

#include "core/base/field.h"
#include "core/game/ranking/ranking.h"

/* Members of struct game, including all nested structs. core_hash() hashes the skipped members of
 * the table separately. */
extern const struct field_table game_fields;

/* Saved edits of struct lab. `game_fields` skips the saved edits, because the saved edits seldom
 * change and the hash of every tick would take longer. */
extern const struct field_table lab_saved_fields;

/* Tables of the configuration, of the persistent state and of the session. core_hash() hashes the
 * parts without a table separately, because their hash depends on the format of the recording. */
extern const struct field_table core_config_fields;
extern const struct field_table ledger_start_fields;
extern const struct field_table audits_fields;
extern const struct field_table ranking_fields;
extern const struct field_table game_session_fields;
extern const struct field_table settings_edit_fields;
extern const struct field_table lab_book_fields;

/* Row of a leaderboard. `ranking_fields` skips the rows of the boards of easier levels, which
 * recordings have since format 9. */
extern const struct field_table rank_row_fields;
/* Number of rows of all boards of easier levels. These rows begin with row[MODE_COUNT]. */
#define RANK_EASIER_ROWS ((RANK_BOARD_COUNT - MODE_COUNT) * RANK_PERIOD_COUNT * RANK_ROWS)

/* Returns `hash` continued over the leaderboards. Empty rows of easier levels do not change the
 * hash, so that the hashes of older recordings stay the same. */
uint64_t game_fields_hash_ranking(uint64_t hash, const struct ranking *ranking);

/* Tables of the parts of struct game that a test hashes separately. */
extern const struct field_table bot_fields;
extern const struct field_table credit_fields;
extern const struct field_table ledger_fields;

/* Members of one edit and of one species card in struct lab_book. A recording stores an edit and a
 * card only for each species that exists, so struct lab_book is not written as a whole. */
extern const struct field_table lab_edit_fields;
extern const struct field_table species_card_fields;
