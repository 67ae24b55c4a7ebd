/* lesson.h -- the lessons: aids that show each player the technique without words.
 *
 * A ring marks a fish that is easy to catch now, at the levels easy and normal. An arrow points to
 * the player's bowl while a fish lies on the paper. The championship has no lessons.
 *
 * The lessons are used for display only: the simulation never reads them, and no hash contains
 * them. They depend only on the state of the game and of the world, so a replay shows the same
 * lessons. */
#pragma once

#include "core/game/game.h"
#include "core/poi/world.h"

/* Value of a fish index that stands for no fish. */
#define LESSON_NO_FISH 0xffffu

/* Lesson of one player. */
struct lesson {
    uint16_t fish;      /* Index of the marked fish, or LESSON_NO_FISH. */
    uint32_t fish_tick; /* Tick at which this fish was marked. */
};

struct lessons {
    struct lesson player[POI_MAX];
};

/* Initializes the lessons for the start of a session. */
void lesson_init(struct lessons *lessons);

/* Runs one tick of the lessons of all players. Must be called after game_tick(). */
void lesson_tick(struct lessons *lessons, const struct game *game, const struct world *world);

/* Writes to `out` what the lesson of `player` shows. */
void lesson_show(const struct lessons *lessons, const struct game *game, const struct world *world,
                 uint32_t player, struct scene_lesson *out);

/* ---- Fish that are easy to catch ------------------------------------------------------------- */

/* Returns true if the lesson of `player` may mark `fish`. The fish is calm, near the surface, clear
 * of the walls and of all bowls, and not nearer to the bowl of another player. A fish that is
 * already marked (`is_marked`) may be slightly faster and deeper. */
bool lesson_is_easy(const struct fish *fish, const struct world *world, uint32_t player,
                    bool is_marked);

/* Returns the index of the fish that is the easiest to catch for `player`, or LESSON_NO_FISH if no
 * fish is easy. Fish of the lessons of other players are skipped. */
uint16_t lesson_easiest_fish(const struct lessons *lessons, const struct world *world,
                             uint32_t player);
