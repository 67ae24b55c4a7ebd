/* renderer_warm_up.c -- draws with every shader program once, while the game loads.
 *
 * A driver compiles a program completely only when a draw call uses the program for the first time,
 * because the result depends on the render target and on other state. A frame of the game would be
 * late by this time. Therefore an artificial scene is drawn by the same functions as the game. */
#include "core/base/panic.h"
#include "platform/render/renderer.h"

#include <string.h>

/* Quality steps whose pictures are drawn. At the last step, the objects above the water have a
 * render target of their own, because the picture is smaller than the screen. */
static const uint32_t warm_steps[2] = { QUALITY_STEP_MAX, 0 };
#define WARM_KINDS 2u /* Number of pictures at each step. */
_Static_assert(RENDERER_WARM_UPS == WARM_KINDS * sizeof warm_steps / sizeof *warm_steps,
               "every picture is drawn");

#define WARM_FISH 4u

/* Fills in a fish below the water surface, a gulping fish, a fish on a poi and a fish in a bowl. */
static void add_fish(struct scene *scene)
{
    static const uint8_t places[WARM_FISH] = { SCENE_IN_TANK, SCENE_IN_TANK, SCENE_ON_POI,
                                               SCENE_IN_BOWL };
    scene->fish_count = WARM_FISH;
    for (uint32_t i = 0; i < WARM_FISH; i++) {
        scene->fish[i] = (struct scene_fish){ .position_m = v3(0.0f, i == 0 ? -0.05f : 0.0f, 0.0f),
                                              .length_m = 0.04f,
                                              .gulp = 0.5f,
                                              .progress = 0.5f,
                                              .maturity = 1.0f,
                                              .place = places[i] };
    }
}

/* Fills in a bowl, and a poi for each variant of the paper: with and without a pool, and with and
 * without stress colours. At the height 0, a poi is drawn below and above the water. Above, water
 * drips from the pois with a pool. */
static void add_pois(struct scene *scene, float height_m)
{
    scene->bowl[0] = (struct scene_bowl){ .present = 1,
                                          .position_m = v3(0.2f, 0.01f, 0.1f),
                                          .radius_m = 0.08f,
                                          .depth_m = 0.06f,
                                          .water_below_m = 0.01f };
    for (uint8_t i = 0; i < POI_MAX; i++) {
        struct scene_poi *const poi = &scene->poi[i];
        *poi = (struct scene_poi){ .present = 1,
                                   .owner = i,
                                   .position_m = v3(0.0f, height_m, 0.0f),
                                   .ring_radius_m = 0.04f,
                                   .shade_dark = 0.5f,
                                   .water_m = i & 1u ? 2.0f * POI_FILM_M : 0.0f,
                                   .shows_stress = i >> 1 };
        memset(poi->integrity, UINT8_MAX, sizeof poi->integrity);
    }
}

static void fill_scene(struct scene *scene, float height_m)
{
    const vec3 size_m = v3(0.9f, 0.2f, 0.6f);
    *scene = (struct scene){
        .view = { .eye_m = v3(0.0f, 0.8f, 0.8f), .half_height_tan = 0.4f, .aspect_min = 1.0f },
        .tank_size_m = size_m,
        .wall_height_m = 1.1f * size_m.y,
        .phase = PHASE_WORDLESS
    };
    scene->splash_count = 1;
    scene->splash[0] = (struct scene_splash){ .age_s = 0.1f, .drops = 4 };
    scene->scrap_count = 1;
    scene->scrap[0] = (struct scene_scrap){ .position_m = v3(0.0f, -0.02f, 0.0f), .age_s = 1.0f };
    /* The first fan shades the rim of the tank. The second fan is over the water. */
    for (uint32_t i = 0; i < 2; i++) {
        scene->fan[i] = (struct scene_fan){
            .present = 1, .x_m = i == 0 ? 0.5f * size_m.x : 0.0f, .radius_m = 0.1f, .dark = 0.5f
        };
    }
    scene->pump = (struct scene_pump){ .present = 1, .runs = 1, .stone_m = v3(0.0f, -0.1f, 0.0f) };
    add_fish(scene);
    add_pois(scene, height_m);
}

/* Draws one quad of each kind of the user interface, and a specimen. */
static void draw_page(struct renderer *renderer)
{
    struct ui_batch *const batch = &renderer->ui.batch;
    ui_batch_clear(batch);
    for (enum ui_kind kind = 0; kind < UI_KIND_COUNT; kind++) {
        if (kind != UI_GLYPH) {
            ui_shape(batch, &(struct ui_shape){ .box = { 0.0f, 0.0f, 8.0f, 8.0f }, .kind = kind });
        }
    }
    ui_text(batch, (struct ui_text){ .size_px = 8.0f, .fill = UINT32_MAX }, 8.0f, 8.0f, "0");
    ui_specimen(batch, &(struct specimen){ .species = &species_wakin,
                                           .progress = 0.5f,
                                           .x_px = 8.0f,
                                           .y_px = 8.0f,
                                           .length_px = 8.0f,
                                           .shadow = 1.0f });
    ui_show(&renderer->ui, &renderer->specimens, &renderer->transform);
}

int renderer_warm_up(struct renderer *renderer, struct scene *scratch, uint32_t picture)
{
    CORE_ASSERT(picture < RENDERER_WARM_UPS);
    const struct ui_memory memory = renderer->ui.memory;
    const struct deck_view kept = renderer->basin.kept;
    const float light = renderer->transform.light;
    const uint32_t step = renderer->step, kind = picture % WARM_KINDS;
    int error = renderer_lower(renderer, warm_steps[picture / WARM_KINDS]);
    if (error == HAL_OK) {
        renderer->transform.light = 0.5f; /* A second program darkens the picture. */
        /* The pois are in the water, then above it. */
        fill_scene(scratch, kind == 1 ? 0.05f : 0.0f);
        renderer_draw(renderer, scratch);
        draw_page(renderer);
        error = renderer_lower(renderer, step);
        /* The next frame does not follow the camera of the artificial scene. */
        renderer->frame.last_below_px[0] = 0;
        renderer->basin.kept = kept;
        basin_pass_forget(&renderer->basin);
    }
    renderer->transform.light = light;
    renderer->ui.memory = memory;
    return renderer_is_alive(renderer) ? error : HAL_ERR_GONE;
}
