/* players.c -- checks how many fish simulated players with different habits and input devices
 * catch.
 *
 * Usage: players SEEDS OUT [--level LEVEL] [--first SEED] [--only PLAYER,PLAYER..]
 *
 * OUT is the folder of players.tsv. All players play the same seeds in the festival tank with 300
 * fish and No. 6 paper, for at most 60 s. Their input passes through the decoders of their input
 * devices and the kiosk's frame loop.
 *
 * Returns exit status 1 if a target (goals.c) is missed. With fewer than SEEDS_ENOUGH seeds, missed
 * targets are only printed, because the median of few rounds varies too much. */
#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include "platform/ctl/play/rounds.h"
#include "platform/os/exit_code.h"
#include "platform/os/number.h"
#include "core/game/rules.h"
#include "tests/bench/players/goals.h"
#include "tests/bench/players/round_pool.h"

#define SEEDS_MAX 2000u
#define SEEDS_ENOUGH 30u
#define PLAYERS_MAX 32u
#define PATH_CHARS 1200u

static const char prefix[] = "players";

struct player_options {
    uint32_t seeds, first;
    uint8_t level;
    const char *folder;
    const char *only; /* Names of the players who play, separated by commas; empty means all. */
};

/* ---- Rounds ---------------------------------------------------------------------------------- */

struct league_hall {
    const struct player_options *options;
    const struct habits *players[PLAYERS_MAX];
    uint32_t player_count;
    /* Results of all rounds: first the `options->seeds` rounds of the first player, then those of
     * the second player, and so on. */
    struct player_round *rounds;
};

/* Plays all rounds. First all players play the first seed, then all players play the second seed,
 * and so on. Returns false if there is no memory, or if a round did not end. */
static bool play_all(struct league_hall *hall, double *took_s)
{
    const struct player_options *options = hall->options;
    const uint32_t count = hall->player_count * options->seeds;
    struct pool_round *pool = calloc(count, sizeof *pool);
    hall->rounds = calloc(count, sizeof *hall->rounds);
    for (uint32_t i = 0; pool && hall->rounds && i < count; i++) {
        const uint32_t player = i % hall->player_count, seed = i / hall->player_count;
        pool[i] = (struct pool_round){ .habits = hall->players[player],
                                       .seed = options->first + seed,
                                       .result = &hall->rounds[player * options->seeds + seed] };
    }
    const bool is_played =
        pool && hall->rounds && round_pool_play(prefix, pool, count, options->level, took_s);
    free(pool);
    return is_played;
}

/* ---- Report ---------------------------------------------------------------------------------- */

/* Sums over the rounds of one player. */
struct tally {
    uint32_t torn, scoops, near_misses, attempts, flights, sight, pressure;
    /* For each cause of a tear, the number of rounds in which the first cell of the paper tore for
     * this cause. */
    uint32_t first[TEAR_CAUSE_COUNT];
    uint32_t cells[TEAR_CAUSE_COUNT], ends[ATTEMPT_END_COUNT];
    double torn_s, first_s, flight_s, flight_m, flight_above_m, flight_m_s;
    uint32_t first_count;
};

static struct tally tally_of(const struct player_round *rounds, uint32_t count)
{
    struct tally sum = { 0 };
    for (uint32_t i = 0; i < count; i++) {
        const struct player_round *round = &rounds[i];
        sum.torn += round->torn;
        sum.torn_s += round->torn_s;
        sum.scoops += round->scoops;
        sum.near_misses += round->near_misses;
        sum.flights += round->flights;
        sum.sight += round->flights_by_sight;
        sum.pressure += round->flights_by_pressure;
        sum.flight_s += round->flight_s;
        sum.flight_m += round->flight_m;
        sum.flight_above_m += round->flight_above_m;
        sum.flight_m_s += round->flight_m_s;
        if (round->first_s > 0.0) {
            sum.first[round->first_cause]++;
            sum.first_s += round->first_s;
            sum.first_count++;
        }
        for (uint32_t k = 0; k < TEAR_CAUSE_COUNT; k++) {
            sum.cells[k] += round->cells[k];
        }
        for (uint32_t k = 0; k < ATTEMPT_END_COUNT; k++) {
            sum.ends[k] += round->attempts[k];
            sum.attempts += round->attempts[k];
        }
    }
    return sum;
}

static double per(double sum, uint32_t count)
{
    return count > 0 ? sum / (double)count : 0.0;
}

static void print_catches(const struct league_hall *hall, const struct score *scores)
{
    const uint32_t seeds = hall->options->seeds;
    printf("  %-14s %6s %6s %7s %6s %6s %6s %7s  %s\n", "caught", "mean", "median", "empty", "dips",
           "missed", "torn", "after", "rounds by the load of the first tear");
    for (uint32_t i = 0; i < hall->player_count; i++) {
        const struct tally sum = tally_of(hall->rounds + i * seeds, seeds);
        printf("  %-14s %6.2f %6.1f %5.0f %% %6.1f %6.2f %4.0f %% %5.0f s ", scores[i].player,
               scores[i].mean, scores[i].median, 100.0 * scores[i].empty_share,
               per(sum.scoops, seeds), per(sum.near_misses, seeds), 100.0 * per(sum.torn, seeds),
               per(sum.torn_s, sum.torn));
        for (uint32_t k = 0; k < TEAR_CAUSE_COUNT; k++) {
            if (sum.first[k] > 0) {
                printf(" %s %u", round_tear_names[k], sum.first[k]);
            }
        }
        printf("\n");
    }
}

static void print_attempts(const struct league_hall *hall)
{
    const uint32_t seeds = hall->options->seeds;
    printf("\n  %-14s %6s", "attempts in %", "number");
    for (uint32_t k = 0; k < ATTEMPT_END_COUNT; k++) {
        printf(" %11s", round_attempt_names[k]);
    }
    printf("  %6s %6s %6s %6s %8s %6s\n", "s", "mm", "mm up", "m/s", "pressure", "sight");
    for (uint32_t i = 0; i < hall->player_count; i++) {
        const struct tally sum = tally_of(hall->rounds + i * seeds, seeds);
        if (hall->players[i]->device == PLAYER_BOT) {
            continue;
        }
        printf("  %-14s %6u", hall->players[i]->name, sum.attempts);
        for (uint32_t k = 0; k < ATTEMPT_END_COUNT; k++) {
            printf(" %11.0f", 100.0 * per(sum.ends[k], sum.attempts));
        }
        printf("  %6.2f %6.0f %6.0f %6.2f %8.0f %6.0f\n", per(sum.flight_s, sum.flights),
               1000.0 * per(sum.flight_m, sum.flights),
               1000.0 * per(sum.flight_above_m, sum.flights), per(sum.flight_m_s, sum.flights),
               100.0 * per(sum.pressure, sum.flights), 100.0 * per(sum.sight, sum.flights));
    }
}

static void write_round(FILE *file, const char *player, const char *level, uint32_t seed,
                        const struct player_round *round)
{
    fprintf(file, "%s\t%s\t%u\t%u\t%u\t%u\t%.3f\t%.3f\t%.3f\t%s", player, level, seed,
            round->caught, round->scoops, round->near_misses, round->torn_s, round->first_s,
            round->wet_s, round->first_s > 0.0 ? round_tear_names[round->first_cause] : "");
    for (uint32_t k = 0; k < TEAR_CAUSE_COUNT; k++) {
        fprintf(file, "\t%u", round->cells[k]);
    }
    for (uint32_t k = 0; k < ATTEMPT_END_COUNT; k++) {
        fprintf(file, "\t%u", round->attempts[k]);
    }
    fprintf(file, "\n");
}

/* Writes each round into players.tsv. Returns EXIT_OK, or EXIT_IO after an error message. */
static enum exit_code write_rounds(const struct league_hall *hall)
{
    const struct player_options *options = hall->options;
    char path[PATH_CHARS];
    snprintf(path, sizeof path, "%s/players.tsv", options->folder);
    FILE *file = fopen(path, "w");
    if (!file) {
        fprintf(stderr, "%s: %s: %s\n", prefix, path, strerror(errno));
        return EXIT_IO;
    }
    fputs(
        "player\tlevel\tseed\tcaught\tdips\tnear_misses\ttorn_s\tfirst_tear_s\twet_s\tfirst_cause",
        file);
    for (uint32_t k = 0; k < TEAR_CAUSE_COUNT; k++) {
        fprintf(file, "\tcells_%s", round_tear_names[k]);
    }
    for (uint32_t k = 0; k < ATTEMPT_END_COUNT; k++) {
        fprintf(file, "\t%s", round_attempt_names[k]);
    }
    fprintf(file, "\n");
    for (uint32_t i = 0; i < hall->player_count * options->seeds; i++) {
        write_round(file, hall->players[i / options->seeds]->name,
                    rules_of_level(options->level)->name, options->first + i % options->seeds,
                    &hall->rounds[i]);
    }
    const bool failed = ferror(file) != 0;
    if (fclose(file) != 0 || failed) {
        fprintf(stderr, "%s: %s: cannot be written\n", prefix, path);
        return EXIT_IO;
    }
    return EXIT_OK;
}

/* Prints the tables and checks the targets. Returns the exit code of the program. */
static enum exit_code report(struct league_hall *hall)
{
    const uint32_t seeds = hall->options->seeds;
    uint32_t caught[PLAYERS_MAX][SEEDS_MAX], sorted[SEEDS_MAX];
    struct score scores[PLAYERS_MAX];
    for (uint32_t i = 0; i < hall->player_count; i++) {
        for (uint32_t k = 0; k < seeds; k++) {
            caught[i][k] = hall->rounds[i * seeds + k].caught;
        }
        scores[i] = goals_score(hall->players[i]->name, caught[i], sorted, seeds);
    }
    print_catches(hall, scores);
    print_attempts(hall);
    printf("\n");
    const enum exit_code code = write_rounds(hall);
    const uint32_t missed = goals_check(scores, hall->player_count, seeds, hall->options->level);
    const bool is_enough = seeds >= SEEDS_ENOUGH;
    printf("%s: %u targets of level %s are missed%s\n", missed == 0 ? "so" : "NOT SO", missed,
           rules_of_level(hall->options->level)->name,
           is_enough ? "" : "; too few seeds for the exit status");
    return code != EXIT_OK ? code : missed == 0 || !is_enough ? EXIT_OK : EXIT_NOT_SO;
}

/* ---- Command line ---------------------------------------------------------------------------- */

static bool read_option(const char *name, const char *value, struct player_options *options)
{
    if (strcmp(name, "--first") == 0) {
        return number_parse(value, 0, UINT32_MAX - SEEDS_MAX, &options->first);
    }
    if (strcmp(name, "--only") == 0) {
        options->only = value;
        return true;
    }
    return strcmp(name, "--level") == 0 && round_pool_level(value, &options->level);
}

static bool read_options(int argc, char **argv, struct player_options *options)
{
    if (argc < 3 || argc % 2 == 0 || !number_parse(argv[1], 1, SEEDS_MAX, &options->seeds)) {
        return false;
    }
    options->folder = argv[2];
    for (int i = 3; i < argc; i += 2) {
        if (!read_option(argv[i], argv[i + 1], options)) {
            return false;
        }
    }
    return true;
}

/* Returns true if the player is in the list, whose names are separated by commas. An empty list
 * contains all players. */
static bool is_listed(const char *list, const char *player)
{
    const size_t length = strlen(player);
    for (const char *name = list; *name; name += strcspn(name, ",")) {
        name += *name == ',';
        if (strncmp(name, player, length) == 0 && strcspn(name, ",") == length) {
            return true;
        }
    }
    return *list == '\0';
}

int main(int argc, char **argv)
{
    struct player_options options = { .level = LEVEL_MASTER, .only = "" };
    struct league_hall hall = { .options = &options };
    if (read_options(argc, argv, &options)) {
        for (uint32_t i = 0; i < sim_player_table_count && i < PLAYERS_MAX; i++) {
            if (is_listed(options.only, sim_player_table[i].name)) {
                hall.players[hall.player_count++] = &sim_player_table[i];
            }
        }
    }
    if (hall.player_count == 0) {
        fprintf(stderr,
                "usage: players SEEDS OUT [--level LEVEL] [--first SEED] [--only PLAYER,PLAYER..]; "
                "SEEDS is 1 to %u\n",
                SEEDS_MAX);
        return EXIT_USAGE;
    }
    const uint32_t count = hall.player_count * options.seeds;
    double took_s = 0.0;
    if (!play_all(&hall, &took_s)) {
        free(hall.rounds);
        return EXIT_NOT_SO;
    }
    printf("festival, %u fish, No. %u paper, at most %u s, level %s, seeds %u to %u; %.0f s on %u "
           "cores, %.2f s of processor time a round\n\n",
           ROUND_FISH_COUNT, rules_grade_at_level(ROUND_GRADE, options.level), ROUND_LENGTH_S,
           rules_of_level(options.level)->name, options.first, options.first + options.seeds - 1u,
           took_s, rounds_workers(), (double)clock() / CLOCKS_PER_SEC / (double)count);
    const enum exit_code code = report(&hall);
    free(hall.rounds);
    return (int)code;
}
