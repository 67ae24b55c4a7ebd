/* file_seeds.c -- writes valid files of this version as the seed corpus of the fuzz targets file_*.
 *
 * Usage: file_seeds FOLDER. FOLDER must contain the folders replay, graph, conf, usb, tail and
 * entries. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "platform/config/config_file.h"
#include "platform/replay/replay.h"
#include "platform/store/graph_file.h"

static const char *folder;

static FILE *begin(const char *name)
{
    char path[512];
    snprintf(path, sizeof path, "%s/%s", folder, name);
    FILE *file = fopen(path, "w");
    if (!file) {
        perror(path);
        exit(1);
    }
    return file;
}

static void put(const char *name, const void *bytes, size_t size)
{
    FILE *file = begin(name);
    fwrite(bytes, 1, size, file);
    if (fclose(file) != 0) {
        perror(name);
        exit(1);
    }
}

/* Returns the input of a tick of the recording: a coin at tick 20, START at tick 40, and a poi over
 * the water. */
static struct input play_of(uint32_t tick)
{
    struct input input = { .day = 9000, .minute = 600, .store_well = 1 };
    input.coin_count[0] = tick == 20u;
    input.pressed = tick == 40u ? INPUT_START : 0u;
    input.poi[0].link = POI_SOURCE_LIVE;
    input.poi[0].target.position_m = v3(0.001f * (float)(tick % 60u), 0.08f, 0.1f);
    return input;
}

static void put_replay(const char *name, const struct core_config *config, uint32_t ticks)
{
    static struct core core;
    static struct output output;
    static struct replay_writer writer;
    static uint8_t memory[65536], copy[65536];
    if (core_init(&core, config) != CORE_OK ||
        replay_create_in(&writer, memory, sizeof memory, config, core_hash(&core))) {
        fprintf(stderr, "file_seeds: no recording %s\n", name);
        exit(1);
    }
    for (uint32_t tick = 0; tick < ticks; tick++) {
        const struct input input = play_of(tick);
        output.sound_count = 0;
        core_tick(&core, &input, &output);
        const struct replay_totals totals = { .ticks = core.game.tick, .hash = core_hash(&core) };
        replay_add(&writer, &input, (uint32_t)core_hash_quick(&core), &totals);
    }
    put(name, copy, replay_copy(&writer, core_hash(&core), copy, sizeof copy));
}

static void put_replays(void)
{
    static struct core_config config = { .seed = 3, .fish_count = 4 };
    put_replay("replay/short", &config, 30);
    config.players = 2;
    config.credit_coins = 1;
    config.modes = OPTIONS_MODES_ALL;
    config.persistent.ranking.row[0][0][0].caught = 7;
    config.persistent.ledger.boots = 4;
    put_replay("replay/paid", &config, 130);
}

static void put_graphs(void)
{
    for (uint32_t i = 0; i < species_table_count; i++) {
        const struct species_card *card = &species_table[i]->card;
        struct graph_edit_record record = { .id = 1, .key_count = card->key_count };
        char name[64], text[GRAPH_FILE_TEXT_MAX + 1u] = { (char)i };
        memcpy(record.species, card->id, sizeof record.species);
        lab_edit_own(&record.edit, card);
        if (i % 2u) {
            lab_edit_template(&record.edit, card, TEMPLATE_SMOOTH);
            lab_edit_size(&record.edit, card, 0, 0.01f);
        }
        snprintf(name, sizeof name, "graph/%u", i);
        put(name, text, 1u + graph_file_format(&record, text + 1));
    }
}

/* Writes the default configuration. Writes also a second file that has only the section lines and
 * the key lines of the first, uncommented. */
static void put_confs(void)
{
    char *text = NULL;
    size_t size = 0;
    FILE *out = open_memstream(&text, &size);
    config_file_print_defaults(out);
    fclose(out);
    char *kept = malloc(size + 1u);
    size_t length = 0;
    for (const char *line = text; line && *line;) {
        const char *end = strchr(line, '\n');
        const size_t count = end ? (size_t)(end - line) + 1u : strlen(line);
        const int is_key = line[0] == '#' && line[1] != ' ' && line[1] != '\n';
        if (is_key || line[0] == '[') {
            memcpy(kept + length, line + is_key, count - (size_t)is_key);
            length += count - (size_t)is_key;
        }
        line += count;
    }
    put("conf/keys", kept, length);
    free(kept);
    free(text);
}

static void put_usb(void)
{
    static const char text[] = "# Controllers on USB that play, or rest.\nplays 1209:0001:A-1\n"
                               "rests 057e:2009\nplays 054c:0ce6:00:11\n";
    put("usb/three", text, sizeof text - 1u);
}

/* Writes `head` and five ledger entries: a start of the kiosk, a coin, the beginning of a paid
 * round, the result of this round, and the player's name. */
static void put_entries(const char *name, const uint8_t *head, size_t head_size)
{
    struct ledger_entry entry[5];
    memset(entry, 0, sizeof entry);
    for (uint32_t i = 0; i < 5; i++) {
        entry[i].id = i + 1u;
        entry[i].boot = 1;
        entry[i].tick = 100u * i;
        entry[i].day = 9000;
    }
    entry[0].kind = LEDGER_BOOT;
    entry[0].count = 1;
    entry[1].kind = LEDGER_COINS;
    entry[1].count = 1;
    entry[1].value = 1;
    entry[2].kind = LEDGER_BEGIN;
    entry[2].count = 6;
    entry[2].balance.open = PAYMENT_PAID;
    entry[3].kind = LEDGER_ROUND;
    entry[3].round = (struct round_record){ .id = 4,
                                            .end_tick = 7200,
                                            .caught = 3,
                                            .fish_count = 40,
                                            .round_s = 60,
                                            .grade = 6,
                                            .players = 1 };
    entry[3].round.player[0] = (struct player_record){ 3, 9, 120, 0, 1, 0 };
    entry[4].kind = LEDGER_NAME;
    entry[4].count = 4;
    memcpy(entry[4].name, "KOI", 4);
    FILE *file = begin(name);
    fwrite(head, 1, head_size, file);
    fwrite(entry, 1, sizeof entry, file);
    if (fclose(file) != 0) {
        perror(name);
        exit(1);
    }
}

int main(int count, char **arguments)
{
    static const uint8_t even[1],
        cells[25] = { 2, 0, 4, 0, 0, 9, 0, 0, 0, 0, 0, 0, 0, 7, 4, 0, 0, 2 };
    if (count != 2) {
        fputs("usage: file_seeds FOLDER\n", stderr);
        return 2;
    }
    folder = arguments[1];
    put_replays();
    put_graphs();
    put_confs();
    put_usb();
    put_entries("tail/round", even, sizeof even);
    put_entries("entries/round", even, sizeof even);
    put_entries("entries/cells", cells, sizeof cells);
    return 0;
}
