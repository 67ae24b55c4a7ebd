-- ledger.sql -- the SQL texts of the ledger file: tables, migrations, reads and writes of rows, deletion of old data.
-- The format of this file is described in assets/bake/sql.awk.
--
-- SQLite stores the text of a table in the file, and each opened file is compared with this text. A change of a
-- space in a table of an old version therefore makes all files of this version unreadable.

-- Tables. The columns have the names of the fields in core/ledger.h. SQLite stores a zero without any byte of data.
-- NULL in a player's column means that an earlier version did not record the number.

--- rounds_1
CREATE TABLE rounds (
number INTEGER PRIMARY KEY, -- Number of the round, counted over all program runs.
id INTEGER NOT NULL, -- Number of the round, counted within one program run.
seed INTEGER NOT NULL,
start_tick INTEGER NOT NULL,
end_tick INTEGER NOT NULL,
caught INTEGER NOT NULL, -- Total of all players' caught fish.
by_bot INTEGER NOT NULL,
ended_at INTEGER NOT NULL) -- Unix time in seconds.

-- The definition is the table of version 1 with the columns that ALTER TABLE has appended.
--- rounds_2
CREATE TABLE rounds (
number INTEGER PRIMARY KEY, id INTEGER NOT NULL, seed INTEGER NOT NULL,
start_tick INTEGER NOT NULL, end_tick INTEGER NOT NULL, caught INTEGER NOT NULL,
by_bot INTEGER NOT NULL, ended_at INTEGER NOT NULL,
mode INTEGER NOT NULL DEFAULT 0, grade INTEGER NOT NULL DEFAULT 6,
players INTEGER NOT NULL DEFAULT 1)

--- round_players_2
CREATE TABLE round_players (
round INTEGER NOT NULL REFERENCES rounds (number) ON DELETE CASCADE,
player INTEGER NOT NULL, -- Number of the player, counted from 0.
caught INTEGER NOT NULL, scoops INTEGER, hole_area_mm2 INTEGER, torn_tick INTEGER,
fouls INTEGER NOT NULL,
PRIMARY KEY (round, player)) WITHOUT ROWID

--- entries
CREATE TABLE entries (
id INTEGER PRIMARY KEY, boot INTEGER NOT NULL, tick INTEGER NOT NULL,
day INTEGER NOT NULL, minute INTEGER NOT NULL, kind INTEGER NOT NULL,
detail INTEGER NOT NULL, count INTEGER NOT NULL, value INTEGER NOT NULL,
units INTEGER NOT NULL, bonus_units INTEGER NOT NULL, paid INTEGER NOT NULL,
service INTEGER NOT NULL, untold INTEGER NOT NULL, open INTEGER NOT NULL,
up_s INTEGER NOT NULL, dropped_ticks INTEGER NOT NULL, device_faults INTEGER NOT NULL,
name TEXT NOT NULL,
sum INTEGER NOT NULL) -- Checksum of all columns except the name, because a name may be revoked.

--- rounds_3
CREATE TABLE rounds (
entry INTEGER PRIMARY KEY, boot INTEGER NOT NULL, day INTEGER NOT NULL,
minute INTEGER NOT NULL, seed INTEGER NOT NULL, start_tick INTEGER NOT NULL,
end_tick INTEGER NOT NULL, caught INTEGER NOT NULL, by_bot INTEGER NOT NULL,
mode INTEGER NOT NULL, grade INTEGER NOT NULL,
players INTEGER NOT NULL, -- Bit set of the players of the round.
unscored INTEGER NOT NULL)

--- rounds_4
CREATE TABLE rounds (
entry INTEGER PRIMARY KEY, boot INTEGER NOT NULL, day INTEGER NOT NULL,
minute INTEGER NOT NULL, seed INTEGER NOT NULL, start_tick INTEGER NOT NULL,
end_tick INTEGER NOT NULL, caught INTEGER NOT NULL, by_bot INTEGER NOT NULL,
mode INTEGER NOT NULL, grade INTEGER NOT NULL,
players INTEGER NOT NULL, -- Bit set of the players of the round.
unscored INTEGER NOT NULL,
fish_count INTEGER NOT NULL, -- Number of fish. 0 means that fish_count, round_s and preset are unknown.
round_s INTEGER NOT NULL, preset INTEGER NOT NULL)

--- rounds
CREATE TABLE rounds (
entry INTEGER PRIMARY KEY, boot INTEGER NOT NULL, day INTEGER NOT NULL,
minute INTEGER NOT NULL, seed INTEGER NOT NULL, start_tick INTEGER NOT NULL,
end_tick INTEGER NOT NULL, caught INTEGER NOT NULL, by_bot INTEGER NOT NULL,
mode INTEGER NOT NULL, grade INTEGER NOT NULL,
players INTEGER NOT NULL, -- Bit set of the players of the round.
unscored INTEGER NOT NULL,
fish_count INTEGER NOT NULL, -- Number of fish. 0 means that fish_count, round_s and preset are unknown.
round_s INTEGER NOT NULL, preset INTEGER NOT NULL,
level INTEGER NOT NULL)

--- round_players
CREATE TABLE round_players (
round INTEGER NOT NULL, seat INTEGER NOT NULL, caught INTEGER NOT NULL,
scoops INTEGER, hole_area_mm2 INTEGER, torn_tick INTEGER, sheets INTEGER,
fouls INTEGER NOT NULL, name TEXT NOT NULL DEFAULT '',
PRIMARY KEY (round, seat)) WITHOUT ROWID

--- settings
CREATE TABLE settings (name TEXT PRIMARY KEY, value INTEGER NOT NULL) WITHOUT ROWID

--- audits
CREATE TABLE audits (name TEXT PRIMARY KEY, count INTEGER NOT NULL) WITHOUT ROWID

--- ranking_3
CREATE TABLE ranking (
mode INTEGER NOT NULL, period INTEGER NOT NULL, place INTEGER NOT NULL,
caught INTEGER NOT NULL, round INTEGER NOT NULL, day INTEGER NOT NULL,
seat INTEGER NOT NULL, name TEXT NOT NULL,
PRIMARY KEY (mode, period, place)) WITHOUT ROWID

--- ranking
CREATE TABLE ranking (
level INTEGER NOT NULL,
mode INTEGER NOT NULL, period INTEGER NOT NULL, place INTEGER NOT NULL,
caught INTEGER NOT NULL, round INTEGER NOT NULL, day INTEGER NOT NULL,
seat INTEGER NOT NULL, name TEXT NOT NULL,
PRIMARY KEY (level, mode, period, place)) WITHOUT ROWID

--- state
CREATE TABLE state (name TEXT PRIMARY KEY, value INTEGER NOT NULL) WITHOUT ROWID

--- replays
CREATE TABLE replays (round INTEGER PRIMARY KEY, bytes BLOB NOT NULL)

-- Migration of a file of version 1. Version 1 had only one game mode (the festival with paper No. 6) and one
-- player. Version 1 recorded neither the number of scoops nor the damage of the paper.

--- to_2
ALTER TABLE rounds ADD COLUMN mode INTEGER NOT NULL DEFAULT 0; -- Game mode of the round (enum game_mode).
ALTER TABLE rounds ADD COLUMN grade INTEGER NOT NULL DEFAULT 6;
ALTER TABLE rounds ADD COLUMN players INTEGER NOT NULL DEFAULT 1; -- Number of players in the round.

--- fill_2
INSERT INTO round_players (round, player, caught, fouls)
SELECT number, 0, caught, 0 FROM rounds;

-- Migration of the rounds and of the ranking to version 6. Rounds of older versions were played at the level 0, which
-- is the level master. Version 3 did not record the tank.

--- rename_rounds
ALTER TABLE rounds RENAME TO old_rounds;

--- fill_rounds_3
INSERT INTO rounds SELECT *, 0, 0, 0, 0 FROM old_rounds;
DROP TABLE old_rounds;

--- fill_rounds_4
INSERT INTO rounds SELECT *, 0 FROM old_rounds;
DROP TABLE old_rounds;

--- rename_ranking
ALTER TABLE ranking RENAME TO old_ranking;

--- fill_ranking
INSERT INTO ranking SELECT 0, * FROM old_ranking;
DROP TABLE old_ranking;

-- Migration from versions 1 and 2, in which rounds become entries.

--- rename_old
ALTER TABLE rounds RENAME TO old_rounds;
ALTER TABLE round_players RENAME TO old_round_players;

--- select_old
SELECT number, seed, start_tick, end_tick, caught, by_bot, ended_at, mode, grade
FROM old_rounds ORDER BY number

--- select_old_players
SELECT player, caught, coalesce(scoops, 0), coalesce(hole_area_mm2, 0),
coalesce(torn_tick, 0), fouls FROM old_round_players WHERE round = ?1

-- Sets a value to NULL if the old file did not record the value. The column `entry` counts the old rounds in the
-- order of their numbers.
--- forget_unknown
UPDATE round_players SET sheets = NULL;
UPDATE round_players SET scoops = NULL, hole_area_mm2 = NULL, torn_tick = NULL
WHERE (round, seat) IN (SELECT place, player FROM old_round_players
JOIN  (SELECT number, row_number() OVER (ORDER BY number) AS place FROM old_rounds)  ON number = round
WHERE scoops IS NULL);
DROP TABLE old_round_players;
DROP TABLE old_rounds;

-- Writes of rows. The parameters have the order of the values in ledger_write.c.

--- put_entry
INSERT INTO entries VALUES (?1, ?2, ?3, ?4, ?5, ?6, ?7, ?8, ?9, ?10, ?11, ?12, ?13, ?14, ?15, ?16, ?17, ?18,
?20, ?19) -- The text is bound last, and the checksum is the last column.

--- put_round
INSERT INTO rounds VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?)

--- put_player
INSERT INTO round_players (round, seat, caught, scoops, hole_area_mm2, torn_tick, sheets, fouls)
VALUES (?, ?, ?, ?, ?, nullif(?, 0), ?, ?)

--- put_name
UPDATE round_players SET name = ?3 WHERE round = ?1 AND seat = ?2

--- forget_name
UPDATE entries SET name = '' WHERE kind = ?3 AND count = ?1 AND detail = ?2

--- put_setting
INSERT INTO settings (value, name) VALUES (?1, ?2) ON CONFLICT (name) DO UPDATE SET value = ?1

--- forget_settings
DELETE FROM settings

--- put_audit
INSERT INTO audits (count, name) VALUES (?1, ?2) ON CONFLICT (name) DO UPDATE SET count = ?1

--- put_rank
INSERT OR REPLACE INTO ranking VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?)

--- put_state
INSERT INTO state (value, name) VALUES (?1, ?2) ON CONFLICT (name) DO UPDATE SET value = ?1

--- put_replay
INSERT OR REPLACE INTO replays (round, bytes) VALUES (?1, ?2)

-- Reads of rows. The columns have the order in which ledger_read.c reads them.

--- get_replay
SELECT bytes FROM replays WHERE round = ?1

--- has_replay
SELECT 1 FROM replays WHERE round = ?1

--- get_round
SELECT seed, start_tick, end_tick, caught, by_bot, mode, grade, players, unscored,
fish_count, round_s, preset, level FROM rounds WHERE entry = ?

-- A recovered file may have an older version, which lacks columns.
--- get_round_4
SELECT seed, start_tick, end_tick, caught, by_bot, mode, grade, players, unscored,
fish_count, round_s, preset, 0 FROM rounds WHERE entry = ?

--- get_round_3
SELECT seed, start_tick, end_tick, caught, by_bot, mode, grade, players, unscored, 0, 0, 0, 0
FROM rounds WHERE entry = ?

--- get_players
SELECT seat, caught, scoops, hole_area_mm2, torn_tick, sheets, fouls FROM round_players WHERE round = ?

-- Deletes old data. Entries are deleted in large groups, so that most calls write nothing.
--- prune
BEGIN IMMEDIATE;
DELETE FROM replays WHERE round NOT IN (SELECT round FROM ranking WHERE caught > 0);
DELETE FROM entries WHERE id + 32768 <= (SELECT max(id) FROM entries) AND
(SELECT max(id) - min(id) FROM entries) >= 32768 + 256;
DELETE FROM round_players WHERE round <=
(SELECT entry FROM rounds ORDER BY entry DESC LIMIT 1 OFFSET 65536)
AND round NOT IN (SELECT round FROM ranking);
DELETE FROM rounds WHERE entry <=
(SELECT entry FROM rounds ORDER BY entry DESC LIMIT 1 OFFSET 65536)
AND entry NOT IN (SELECT round FROM ranking)
