/* album.h -- after the round: what was caught grows up, each from hatching to old age.
 *
 * Every goldfish of the tank has an age and a look of its own; the album tells the rest of its
 * life. Somebody who presses START or dips wants to play on instead; OK turns the page. */
#ifndef KINGYO_CORE_GAME_ALBUM_H
#define KINGYO_CORE_GAME_ALBUM_H

#include "core/input.h"
#include "core/output.h"
#include "core/scene.h"

#define ALBUM_LIFE_TICKS (7u * CORE_TICK_HZ)         /* A life takes so long, ... */
#define ALBUM_STAGGER_TICKS (CORE_TICK_HZ * 4u / 5u) /* ... the next begins so much later, ... */
#define ALBUM_REST_TICKS (4u * CORE_TICK_HZ)         /* ... and grown they are looked at so long. */

struct album {
    uint32_t caught; /* In this round, by all; counted on when no page is left. */
    uint32_t fish_count;
    struct album_fish {
        uint32_t fish; /* Which of the tank's. */
        uint32_t look;
        uint32_t owner; /* Player index. */
        float age_days, length_m;
    } fish[ALBUM_FISH_MAX];
};

struct core;

void album_clear(struct album *album);

/* `count` fish of player `index` came into the bowl and are counted: as many as there is room for
 * are noted, in the order in which they came. */
void album_note(struct core *core, uint32_t index, uint32_t count);

/* Opens the album, if there is anything in it; returns whether. */
int album_begin(struct core *core);
void album_tick(struct core *core, const struct input *input, struct output *output);

/* How many ticks a page of so many fish takes. */
uint32_t album_ticks(uint32_t fish_count);

void album_show(const struct core *core, struct scene_album *out);

uint64_t album_hash(uint64_t hash, const struct album *album);

#endif
