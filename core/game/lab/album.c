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

static struct album_fish album_fish_of(const struct world *world, uint32_t fish, uint32_t owner)
{
    const struct fish *swimmer = &world->tank.fish[fish];
    return (struct album_fish){
        .fish = fish,
        .look = swimmer->look,
        .owner = owner,
        .age_days = swimmer->age_days,
        .length_m = swimmer->length_m,
    };
}

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
            album->fish[album->fish_count++] = album_fish_of(world, i, index);
            count--;
        }
    }
}

/* ---- Presents -------------------------------------------------------------------------------- */

/* Vertical speed with which the present enters the bowl, about that of a fish that falls from a
 * poi. */
#define PRESENT_M_S (-0.5f)

/* Returns the index of the swimming fish that is nearest to `place_m`, or the number of fish if no
 * fish swims. */
static uint32_t nearest_fish(const struct tank *tank, vec3 place_m)
{
    uint32_t nearest = tank->fish_count;
    float square = 0.0f;
    for (uint32_t i = 0; i < tank->fish_count; i++) {
        const vec3 way = v3_sub(tank->fish[i].position_m, place_m);
        if (fish_swims(&tank->fish[i]) &&
            (nearest == tank->fish_count || v3_dot(way, way) < square)) {
            nearest = i;
            square = v3_dot(way, way);
        }
    }
    return nearest;
}

/* Returns true if `fish` is a present. All fish of a player who caught none are presents, so the
 * album does not mark presents. */
static bool is_present(const struct game *game, const struct album_fish *fish)
{
    CORE_ASSERT(fish->owner < POI_MAX);
    return game->player[fish->owner].caught == 0;
}

void album_give_presents(struct album *album, const struct player player[POI_MAX],
                         struct world *world, const struct core_config *config)
{
    struct tank *tank = &world->tank;
    /* If the page is full, each present replaces a caught fish, beginning with the last fish. */
    uint32_t last = ALBUM_FISH_MAX;
    for (uint32_t i = 0; i < POI_MAX && config_has_rules(config, 9); i++) {
        struct bowl *bowl = &world->bowl[i];
        const uint32_t fish = nearest_fish(tank, bowl->position_m);
        if (!player[i].plays || player[i].caught != 0 || !bowl->present ||
            fish == tank->fish_count) {
            continue;
        }
        const uint32_t at = album->fish_count < ALBUM_FISH_MAX ? album->fish_count++ : --last;
        album->fish[at] = album_fish_of(world, fish, i);
        bowl_take(bowl, i, tank, &tank->fish[fish], v3(0.0f, PRESENT_M_S, 0.0f));
    }
}

bool album_has_present(const struct game *game, uint32_t index)
{
    CORE_ASSERT(index < POI_MAX);
    for (uint32_t i = 0; i < game->album.fish_count; i++) {
        if (game->album.fish[i].owner == index && is_present(game, &game->album.fish[i])) {
            return true;
        }
    }
    return false;
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
        /* A caught fish may be longer or shorter than usual for its age. The ratio of its displayed
         * length to the usual length is 1 at the start of the life, changes linearly with age to
         * the fish's actual ratio at the age of capture, and then stays constant. */
        const float usual_m = life_length_m(card, life_progress(card, fish->age_days));
        const float part = f_min(age_days / f_max(fish->age_days, 1.0f), 1.0f);
        out->fish[i] = (struct scene_grown){
            .owner = (uint8_t)fish->owner,
            .is_caught = age_days >= fish->age_days,
            .is_present = is_present(game, fish),
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
