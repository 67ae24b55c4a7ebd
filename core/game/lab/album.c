/* album.c -- the album: stores the caught fish, and computes each fish's life from the species'
 * growth curve. */
#include "core/game/lab/lab.h"

#include "core/base/panic.h"
#include "core/config.h"
#include "core/game/control/controller.h"
#include "core/game/game.h"
#include "core/game/phases.h"
#include "core/morph/morph.h"
#include "core/poi/world.h"
#include "core/scene_helpers.h"

void album_note(struct album *album, const struct world *world, uint32_t index, uint32_t count)
{
    CORE_ASSERT(index < POI_MAX && album->fish_count <= ALBUM_FISH_MAX);
    album->caught += count;
    for (uint32_t i = 0; i < world->tank.fish_count && count > 0; i++) {
        const struct fish *fish = &world->tank.fish[i];
        bool is_noted = false;
        if (album->fish_count == ALBUM_FISH_MAX) {
            return;
        }
        for (uint32_t k = 0; k < album->fish_count; k++) {
            is_noted |= album->fish[k].fish == i;
        }
        if (fish->gait == GAIT_BOWL && fish->holder == index && !is_noted) {
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
    CORE_ASSERT(fish_count <= ALBUM_FISH_MAX);
    return fish_count == 0
               ? 0u
               : ALBUM_LIFE_TICKS + (fish_count - 1u) * ALBUM_STAGGER_TICKS + ALBUM_REST_TICKS;
}

bool album_begin(struct game *game)
{
    if (game->album.fish_count == 0) {
        return false;
    }
    game_enter_phase(game, PHASE_ALBUM);
    return true;
}

void album_tick(struct game *game, struct world *world, struct core_config *config,
                const struct input *input, struct output *output)
{
    CORE_ASSERT(game->phase == PHASE_ALBUM && game->album.fish_count > 0);
    const uint32_t elapsed = game->tick - game->phase_tick;
    const bool dipped = controller_dipped_player(game, world, input) < POI_MAX;
    if (dipped || (input->pressed & INPUT_START)) {
        game_mode_select_begin(game, world, config, output);
    } else if ((input->pressed & INPUT_OK) || elapsed >= album_ticks(game->album.fish_count)) {
        attract_begin(game, world, config);
    }
}

void album_show(const struct game *game, struct scene_album *out)
{
    const struct album *album = &game->album;
    const struct species_card *card = &species_wakin.card;
    const uint32_t elapsed = game->tick - game->phase_tick;
    *out = (struct scene_album){ 0 };
    if (game->phase != PHASE_ALBUM) {
        return;
    }
    out->caught = album->caught;
    out->fish_count = album->fish_count;
    for (uint32_t i = 0; i < album->fish_count; i++) {
        const struct album_fish *fish = &album->fish[i];
        const uint32_t begin = i * ALBUM_STAGGER_TICKS;
        const float share =
            (float)(elapsed > begin ? elapsed - begin : 0u) / (float)ALBUM_LIFE_TICKS;
        /* The displayed life runs slowly at its beginning and at its end, where the fish changes
         * most. */
        const float progress = f_smoothstep(0.0f, 1.0f, f_min(share, 1.0f));
        const float age_days = life_age_days(card, progress);
        /* At the start of the life, the displayed length is the usual length of the species. Until
         * the age at which the fish was caught, the ratio of the displayed length to the usual
         * length changes gradually to the ratio of this fish. After that age the ratio stays
         * constant. */
        const float usual_m = life_length_m(card, life_progress(card, fish->age_days));
        const float part = f_min(age_days / f_max(fish->age_days, 1.0f), 1.0f);
        out->fish[i] = (struct scene_grown){
            .owner = (uint8_t)fish->owner,
            .is_caught = age_days >= fish->age_days,
            .look = fish->look,
            .caught_age_days = fish->age_days,
            .caught_length_m = fish->length_m,
            .age_days = age_days,
            .length_m =
                life_length_m(card, progress) * f_lerp(1.0f, fish->length_m / usual_m, part),
            .progress = progress,
            .maturity = scene_maturity(age_days),
        };
    }
}
