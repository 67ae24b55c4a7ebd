/* album.h -- the album after a round: shows the growth of each caught fish from hatching to old
 * age.
 *
 * Every goldfish of the tank has its own age and appearance. The album shows the fish's life before
 * and after the catch. START or a dip starts the next game; OK turns the page. */
#ifndef KINGYO_CORE_GAME_LAB_ALBUM_H
#define KINGYO_CORE_GAME_LAB_ALBUM_H

#include "core/input.h"
#include "core/output.h"
#include "core/scene.h"

#define ALBUM_LIFE_TICKS (7u * CORE_TICK_HZ) /* Duration of the display of one fish's life. */
/* Delay between the starts of two successive fish. */
#define ALBUM_STAGGER_TICKS (CORE_TICK_HZ * 4u / 5u)
/* Time for which the grown fish remain on the page after the last fish has grown. */
#define ALBUM_REST_TICKS (4u * CORE_TICK_HZ)

struct album {
    uint32_t caught; /* Number of fish caught in this round by all players, including fish that did
                        not fit on the page. */
    uint32_t fish_count;
    struct album_fish {
        uint32_t fish; /* Index of the fish in the tank. */
        uint32_t look;
        uint32_t owner; /* Index of the player who caught the fish. */
        float age_days, length_m;
    } fish[ALBUM_FISH_MAX];
};

struct game;
struct world;
struct core_config;

void album_clear(struct album *album);

/* Records that player `index` caught `count` fish, in the order of the catch. Fish beyond
 * ALBUM_FISH_MAX are counted but not stored. */
void album_note(struct album *album, const struct world *world, uint32_t index, uint32_t count);

/* Enters the album phase and returns 1. If the album is empty, changes nothing and returns 0. */
int album_begin(struct game *game);
void album_tick(struct game *game, struct world *world, const struct core_config *config,
                const struct input *input, struct output *output);

/* Returns the duration in ticks of a page with `fish_count` fish. */
uint32_t album_ticks(uint32_t fish_count);

/* Fills `out` with the visible state of the album. In other phases all fields of `out` are 0. */
void album_show(const struct game *game, struct scene_album *out);

uint64_t album_hash(uint64_t hash, const struct album *album);

#endif
