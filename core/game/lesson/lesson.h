/* lesson.h -- the lessons: aids that show each player the technique without words.
 *
 * - Before the first dip of the first round after attract mode, a ghost shows at a real fish how to
 *   dip, glide, lift and empty the poi. The ghost is a translucent poi with the hand that holds it.
 *   The ghost begins in READY and lasts five seconds. The clock of the round does not wait for the
 *   ghost. A dip ends the ghost of that player.
 * - A ring marks a fish that is easy to catch now, at the levels easy and normal.
 * - An arrow points to the player's bowl while a fish lies on the paper.
 * - A hint beside the poi names the next step, but only after the fault that the hint corrects.
 *
 * Each player sees one aid at a time, near the player's own poi. The championship has no lessons
 * except two hints, which report an event: the paper is useless, or fish were poured into the bowl.
 *
 * The lessons are used for display only: the simulation never reads them, and no hash contains
 * them. The lessons depend only on the state of the game and of the world, so a replay shows the
 * same lessons. */
#pragma once

#include "core/game/game.h"
#include "core/poi/world.h"

/* Value of a fish index that stands for no fish. */
#define LESSON_NO_FISH 0xffffu

/* Duration of the ghost's demonstration. */
#define LESSON_GHOST_TICKS (5u * CORE_TICK_HZ)

enum ghost_state {
    GHOST_WAITS = 0, /* The ghost has not begun. */
    GHOST_RUNS,
    GHOST_IS_OVER, /* The demonstration is complete, or the player dipped the poi. */
};

struct ghost {
    uint8_t state;  /* State of the ghost (enum ghost_state). */
    uint16_t fish;  /* Index of the fish at which the ghost shows the technique. */
    uint32_t ticks; /* Ticks since the ghost began, without pauses of the round. */
    /* Position of the fish `fish`, from which the ghost's path is computed. The position follows
     * the fish until the ghost has moved under the fish. */
    vec3 fish_m;
    /* True if the pose of the player's controller was above the water and has not sunk to
     * RULES_DIP_Y_M since. Used to detect a dip in READY. */
    bool is_raised;
};

/* Lesson of one player. */
struct lesson {
    uint16_t fish;      /* Index of the marked fish, or LESSON_NO_FISH. */
    uint32_t fish_tick; /* Tick at which the fish `fish` was marked. */
    /* State of the rules in hints.c for this player. `hints.shown` is the hint that fits the
     * player's situation. */
    struct hints hints;
    /* Hint that should be shown: `hints.shown`, or the hint for a fault that lesson.c detected. */
    uint8_t wanted;
    uint32_t wanted_tick; /* Tick since which `wanted` has its value. */
    uint8_t hint;         /* Shown hint (enum scene_hint). */
    uint32_t hint_tick;   /* Tick at which the shown hint appeared. */
    uint32_t under_ticks; /* Ticks since the poi was dipped; 0 above the water. */
    uint32_t haste_tick;  /* Tick at which the poi last moved too fast; 0 means never. */
    uint8_t flat_dips;    /* Number of fast entries into the water with a level ring, up to 255. */
    struct ghost ghost;
};

struct lessons {
    bool is_first; /* True from attract mode to the end of the first round after attract mode. */
    struct lesson player[POI_MAX];
};

/* Initializes the lessons of all players for attract mode, so that the next round has ghosts.
 * lesson_tick() resets the lesson of a player, but not the ghost, when READY begins and while the
 * player has no poi. */
void lesson_init(struct lessons *lessons);

/* Runs one tick of the lessons of all players. Must be called after game_tick(). */
void lesson_tick(struct lessons *lessons, const struct game *game, const struct world *world);

/* Writes to `out` what the lesson of `player` shows. */
void lesson_show(const struct lessons *lessons, const struct game *game, const struct world *world,
                 uint32_t player, struct scene_lesson *out);

/* Returns the hint for the whole screen (enum scene_hint). In READY and in the round, only
 * HINT_LOST_POI and HINT_NO_SHADE are for the whole screen, because the other hints are shown
 * beside a poi. */
uint8_t lesson_screen_hint(const struct game *game);

/* ---- Ghost ----------------------------------------------------------------------------------- */

/* Runs one tick of the ghost of `player`. `is_taught` is true if the player gets lessons now. */
void lesson_ghost_tick(struct lessons *lessons, const struct game *game, const struct world *world,
                       uint32_t player, bool is_taught);

/* Writes the present pose of `ghost` to `out`. The path of the ghost leads from the player's bowl
 * `bowl` to the ghost's fish and back. If the ghost does not run, all fields of `out` are 0. */
void lesson_ghost_show(const struct ghost *ghost, const struct bowl *bowl, struct scene_ghost *out);

/* ---- Fish that are easy to catch ------------------------------------------------------------- */

/* Returns true if the lesson of `player` may mark `fish`. The fish is calm, near the surface, clear
 * of the walls and of all bowls, and not nearer to the bowl of another player. A fish that is
 * already marked (`is_marked`) may be slightly faster and deeper. */
bool lesson_is_easy(const struct fish *fish, const struct world *world, uint32_t player,
                    bool is_marked);

/* Returns the index of the fish that is the easiest to catch for `player`, or LESSON_NO_FISH if no
 * fish is easy. Skips fish that the lesson or the ghost of another player uses. */
uint16_t lesson_easiest_fish(const struct lessons *lessons, const struct world *world,
                             uint32_t player);

/* Returns true if a calm fish is over the paper of `poi`, so that a lift may catch the fish. */
bool lesson_fish_is_over(const struct world *world, const struct poi *poi);
