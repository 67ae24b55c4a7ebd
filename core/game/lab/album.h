/* album.h -- the album after a round: each caught fish is shown growing from hatching to old age.
 *
 * Every goldfish of the tank has its own age and appearance; the album shows the rest of its life.
 * START or a dip starts the next game; OK turns the page. */
#ifndef KINGYO_CORE_GAME_LAB_ALBUM_H
#define KINGYO_CORE_GAME_LAB_ALBUM_H

#include "core/input.h"
#include "core/output.h"
#include "core/scene.h"

#define ALBUM_LIFE_TICKS (7u * CORE_TICK_HZ) /* Duration of one fish's life. */
/* Delay between the start of one fish and the next. */
#define ALBUM_STAGGER_TICKS (CORE_TICK_HZ * 4u / 5u)
/* Time for which the grown fish stay on the page. */
#define ALBUM_REST_TICKS (4u * CORE_TICK_HZ)

struct album {
    uint32_t caught; /* Fish caught in this round by all players, including fish that did not fit on
                        the page. */
    uint32_t fish_count;
    struct album_fish {
        uint32_t fish; /* Index of the fish in the tank. */
        uint32_t look;
        uint32_t owner; /* Player index. */
        float age_days, length_m;
    } fish[ALBUM_FISH_MAX];
};

struct game;
struct world;
struct core_config;

void album_clear(struct album *album);

/* Records that player `index` caught `count` fish. Fish beyond ALBUM_FISH_MAX are counted, but not
 * stored. Fish are stored in the order of the catch. */
void album_note(struct album *album, const struct world *world, uint32_t index, uint32_t count);

/* Enters the album phase. Returns 1, or 0 without any change if the album is empty. */
int album_begin(struct game *game);
void album_tick(struct game *game, struct world *world, const struct core_config *config,
                const struct input *input, struct output *output);

/* Returns the duration in ticks of a page with `fish_count` fish. */
uint32_t album_ticks(uint32_t fish_count);

/* Fills `out` with the visible state of the album; all zero in other phases. */
void album_show(const struct game *game, struct scene_album *out);

uint64_t album_hash(uint64_t hash, const struct album *album);

#endif
