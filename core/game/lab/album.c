/* album.c -- the album: stores the caught fish, and computes each fish's life from the species'
 * growth curve. */
#include "core/game/lab/album.h"

#include "core/base/hash.h"
#include "core/game/game.h"
#include "core/poi/world.h"
#include "core/config.h"
#include "core/game/phases.h"
#include "core/morph/morph.h"
#include "core/scene_helpers.h"

void album_clear(struct album *album)
{
    *album = (struct album){ 0 };
}

static int is_noted(const struct album *album, uint32_t fish)
{
    for (uint32_t i = 0; i < album->fish_count; i++) {
        if (album->fish[i].fish == fish) {
            return 1;
        }
    }
    return 0;
}

void album_note(struct album *album, const struct world *world, uint32_t index, uint32_t count)
{
    album->caught += count;
    for (uint32_t i = 0; i < world->tank.fish_count && count > 0; i++) {
        const struct fish *fish = &world->tank.fish[i];
        if (album->fish_count == ALBUM_FISH_MAX) {
            return;
        }
        if (fish->gait == GAIT_BOWL && fish->holder == index && !is_noted(album, i)) {
            album->fish[album->fish_count++] = (struct album_fish){
                .fish = i,
                .look = fish->look,
                .owner = index,
                .age_days = fish->age_days,
                .length_m = fish->length_m,
            };
            count--;
        }
    }
}

uint32_t album_ticks(uint32_t fish_count)
{
    return fish_count == 0
               ? 0u
               : ALBUM_LIFE_TICKS + (fish_count - 1u) * ALBUM_STAGGER_TICKS + ALBUM_REST_TICKS;
}

int album_begin(struct game *game)
{
    if (game->album.fish_count == 0) {
        return 0;
    }
    game_enter_phase(game, PHASE_ALBUM);
    return 1;
}

void album_tick(struct game *game, struct world *world, const struct core_config *config,
                const struct input *input, struct output *output)
{
    const uint32_t elapsed = game->tick - game->phase_tick;
    const int dipped = game_dipped_player(game, world, input) < POI_MAX;
    if (dipped || (input->pressed & INPUT_START)) {
        mode_select_begin(game, world, config, output);
    } else if ((input->pressed & INPUT_OK) || elapsed >= album_ticks(game->album.fish_count)) {
        attract_begin(game, world, config);
    }
}

/* Returns the progress of fish `index` through its life, [0, 1]. The progress is slow at both ends,
 * where the fish changes most. */
static float lived(uint32_t elapsed, uint32_t index)
{
    const uint32_t begin = index * ALBUM_STAGGER_TICKS;
    const uint32_t since = elapsed > begin ? elapsed - begin : 0u;
    return f_smoothstep(0.0f, 1.0f, f_min((float)since / (float)ALBUM_LIFE_TICKS, 1.0f));
}

/* Returns the length of the fish at `age_days`. The length starts at the species' usual length. At
 * the age of the catch, the fish's length has its own ratio to the usual length. After that age the
 * ratio stays constant. */
static float own_length_m(const struct species_card *card, const struct album_fish *fish,
                          float progress, float age_days)
{
    const float usual_m = life_length_m(card, life_progress(card, fish->age_days));
    const float part = f_min(age_days / f_max(fish->age_days, 1.0f), 1.0f);
    return life_length_m(card, progress) * f_lerp(1.0f, fish->length_m / usual_m, part);
}

static void show_fish(const struct album_fish *fish, float progress, struct scene_grown *out)
{
    const struct species_card *card = &species_wakin.card;
    const float age_days = life_age_days(card, progress);
    *out = (struct scene_grown){
        .owner = (uint8_t)fish->owner,
        .is_caught = age_days >= fish->age_days,
        .look = fish->look,
        .caught_age_days = fish->age_days,
        .caught_length_m = fish->length_m,
        .age_days = age_days,
        .length_m = own_length_m(card, fish, progress, age_days),
        .progress = progress,
        .maturity = scene_maturity(age_days),
    };
}

void album_show(const struct game *game, struct scene_album *out)
{
    const struct album *album = &game->album;
    *out = (struct scene_album){ 0 };
    if (game->phase != PHASE_ALBUM) {
        return;
    }
    out->caught = album->caught;
    out->fish_count = album->fish_count;
    for (uint32_t i = 0; i < album->fish_count; i++) {
        show_fish(&album->fish[i], lived(game->tick - game->phase_tick, i), &out->fish[i]);
    }
}

uint64_t album_hash(uint64_t hash, const struct album *album)
{
    hash = hash_u32(hash, album->caught);
    hash = hash_u32(hash, album->fish_count);
    for (uint32_t i = 0; i < ALBUM_FISH_MAX; i++) {
        const struct album_fish *fish = &album->fish[i];
        hash = hash_u32(hash, fish->fish);
        hash = hash_u32(hash, fish->look);
        hash = hash_u32(hash, fish->owner);
        hash = hash_float(hash, fish->age_days);
        hash = hash_float(hash, fish->length_m);
    }
    return hash;
}
