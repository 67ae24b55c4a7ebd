/* hints.h -- hints for a player: one line at a time, for the next thing to learn.
 *
 * With several players the hints are for the first player who has a poi in use. A pause for a lost
 * controller is shown for any player. Each rule checks the player's actions and selects a helpful
 * hint. A hint stays until the player follows it. A hint is replaced within HINT_TICKS_MIN only if
 * it was followed or an urgent hint is due. */
#ifndef KINGYO_CORE_GAME_HINTS_H
#define KINGYO_CORE_GAME_HINTS_H

#include <stdint.h>

#define HINT_TICKS_MIN 180u /* 1.5 s, the time to read a short line. */

struct hints {
    uint8_t pupil;        /* Player for whom the hints are, < POI_MAX. */
    uint8_t shown;        /* enum scene_hint */
    uint32_t shown_tick;  /* Tick at which the hint appeared. */
    uint32_t learned;     /* Bits (1 << enum scene_hint) of the actions that this player has
                             done. */
    uint32_t haste_tick;  /* Tick at which fast motion last tore the paper; 0: never. */
    uint32_t haste_cells; /* Cells torn by fast motion since the last evaluation. */
    uint32_t paper_cells; /* Paper cells of the player's poi in the last tick. */
    uint32_t dips_before; /* Number of dips of that poi at its last catch, or 0 for a new poi. */
    uint32_t caught;      /* Fish caught by the player at the last evaluation. */
    float moved_m;        /* Distance that the poi has moved in this round, up to 1 m. */
};

struct game;
struct world;
struct core_config;

/* Resets the hints for a new player. */
void hints_init(struct hints *hints);

/* Evaluates the rules. Call once per tick; writes only to `hints`. */
void hints_tick(struct hints *hints, const struct game *game, const struct world *world,
                const struct core_config *config);

uint64_t hints_hash(uint64_t hash, const struct hints *hints);

#endif
