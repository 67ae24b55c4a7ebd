/* hints.h -- hints for a player: one line of text at a time, about the next skill to learn.
 *
 * With several players the hints are for the first player who has a poi in use. The hint about a
 * lost controller is shown for any player. Each rule checks the player's actions and selects a
 * helpful hint. A hint stays until the player follows it. Within HINT_TICKS_MIN a hint is replaced
 * only if the player followed it or if an urgent hint must be shown. */
#ifndef KINGYO_CORE_GAME_HINTS_H
#define KINGYO_CORE_GAME_HINTS_H

#include <stdint.h>

/* Shortest time for which a hint is shown: 1.5 s, enough to read a short line. */
#define HINT_TICKS_MIN 180u

struct hints {
    uint8_t pupil;        /* Player who receives the hints, < POI_MAX. */
    uint8_t shown;        /* Hint that is shown (enum scene_hint). */
    uint32_t shown_tick;  /* Tick at which the hint appeared. */
    uint32_t learned;     /* Bit mask (1 << enum scene_hint) of the hints whose actions the player
                             has done. */
    uint32_t haste_tick;  /* Tick at which fast motion last tore the paper; 0 means never. */
    uint32_t haste_cells; /* Cells torn by fast motion since the last evaluation. */
    uint32_t paper_cells; /* Number of paper cells that the player's poi had in the last tick. */
    uint32_t dips_before; /* Number of dips of the player's poi at the last catch, or 0 for a new
                             poi. */
    uint32_t caught;      /* Number of fish that the player had caught at the last evaluation. */
    float moved_m;        /* Distance that the poi has moved in this round, up to 1 m. */
};

struct game;
struct world;
struct core_config;

/* Resets the hints for a new player. */
void hints_init(struct hints *hints);

/* Evaluates the rules and updates `hints`. Call once per tick. The function changes no other
 * state. */
void hints_tick(struct hints *hints, const struct game *game, const struct world *world,
                const struct core_config *config);

uint64_t hints_hash(uint64_t hash, const struct hints *hints);

#endif
