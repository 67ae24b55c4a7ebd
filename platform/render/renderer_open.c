/* renderer_open.c -- opens and closes a renderer with its render targets and passes, and describes
 * the OpenGL context. */
#include "core/base/panic.h"
#include "platform/render/renderer.h"

#include <stdio.h>
#include <string.h>

#ifndef GL_CONTEXT_LOST_KHR
/* Error code of the extension GL_KHR_robustness. Drivers without the extension never return this
 * code. */
#define GL_CONTEXT_LOST_KHR 0x0507
#endif

/* Margin on each side of the kept picture of the rim and the counter, as a fraction of the smaller
 * side of the screen, and the least margin as a fraction of the difference between the sides. In
 * attract mode, the drifting camera shows up to this much beyond the picture of the camera at rest.
 * The second fraction is the larger margin if the screen is wider than 16:9. */
#define DECK_MARGIN 0.1f
#define DECK_MARGIN_WIDE 0.125f

static const char *gl_string(GLenum name)
{
    const char *const text = (const char *)glGetString(name);
    return text ? text : "unknown";
}

static uint32_t scaled(uint32_t size, float scale)
{
    const float pixels = (float)size * scale + 0.5f;
    return pixels < 1.0f ? 1u : (uint32_t)pixels;
}

static void open_targets(struct renderer *renderer)
{
    CORE_ASSERT(renderer->samples_max > 0 && renderer->side_max > 0);
    const uint32_t width = renderer->config.width;
    const uint32_t height = renderer->config.height;
    const struct quality best = quality_choose(&(struct quality_request){
        .renderer = gl_string(GL_RENDERER),
        .width = width,
        .height = height,
        .scene_scale = renderer->config.scene_scale,
        .samples = renderer->config.samples,
        .samples_max = renderer->samples_max,
        .side_max = renderer->side_max,
    });
    renderer->quality = quality_lower(&best, renderer->step);
    const struct quality *const quality = &renderer->quality;
    renderer->below_px[0] = scaled(width, quality->scene_scale);
    renderer->below_px[1] = scaled(height, quality->scene_scale);
    uint32_t *const screen_px = renderer->screen_px;
    screen_px[0] = scaled(width, quality->screen_scale);
    screen_px[1] = scaled(height, quality->screen_scale);
    const uint32_t short_px = screen_px[screen_px[0] > screen_px[1]];
    const uint32_t long_px = screen_px[screen_px[0] <= screen_px[1]];
    const uint32_t room_px = renderer->side_max - long_px;
    const float wide_px = DECK_MARGIN_WIDE * (float)(long_px - short_px);
    const uint32_t wanted_px = scaled(1u, f_max(DECK_MARGIN * (float)short_px, wide_px));
    const uint32_t margin_px = wanted_px < room_px / 2u ? wanted_px : room_px / 2u;
    basin_pass_forget(&renderer->basin);
    gl_target_open(&renderer->status, "deck", &renderer->deck,
                   &(struct gl_target_desc){ .internal_format = GL_RGBA8,
                                             .width = screen_px[0] + 2u * margin_px,
                                             .height = screen_px[1] + 2u * margin_px,
                                             .samples = quality->samples });
    if (quality->samples > 1 || quality->screen_scale < 1.0f) {
        gl_target_open(&renderer->status, "screen", &renderer->screen,
                       &(struct gl_target_desc){ .internal_format = GL_RGBA8,
                                                 .width = screen_px[0],
                                                 .height = screen_px[1],
                                                 .samples = quality->samples,
                                                 .depth = true });
    }
}

static void close_below(struct renderer *renderer)
{
    gl_target_close(&renderer->ground);
    gl_target_close(&renderer->life);
    gl_target_close(&renderer->mirror);
    renderer->part = (struct frame_part){ 0 };
}

void renderer_fit_below(struct renderer *renderer)
{
    const struct frame_part *const part = &renderer->frame.part;
    const struct quality *const quality = &renderer->quality;
    CORE_ASSERT(part->width > 0 && part->height > 0);
    if (memcmp(part, &renderer->part, sizeof *part) == 0) {
        return;
    }
    const float floor_scale = quality->floor_scale / quality->scene_scale;
    const float mirror_scale = quality->mirror_scale / quality->scene_scale;
    close_below(renderer);
    renderer->part = *part;
    gl_target_open(&renderer->status, "ground", &renderer->ground,
                   &(struct gl_target_desc){ .internal_format = GL_RGBA8,
                                             .width = scaled(part->width, floor_scale),
                                             .height = scaled(part->height, floor_scale) });
    gl_target_open(&renderer->status, "life", &renderer->life,
                   &(struct gl_target_desc){ .internal_format = GL_RGBA8,
                                             .width = part->width,
                                             .height = part->height,
                                             .samples = quality->samples,
                                             .depth = true });
    gl_target_open(&renderer->status, "mirror", &renderer->mirror,
                   &(struct gl_target_desc){ .internal_format = GL_RGBA8,
                                             .width = scaled(part->width, mirror_scale),
                                             .height = scaled(part->height, mirror_scale) });
}

static void close_targets(struct renderer *renderer)
{
    close_below(renderer);
    gl_target_close(&renderer->deck);
    gl_target_close(&renderer->screen);
}

int renderer_open(struct renderer *renderer, const struct renderer_config *config)
{
    CORE_ASSERT(config->width > 0 && config->height > 0);
    GLint samples_max = 1, side_max = GL_TEXTURE_SURE;
    memset(renderer, 0, sizeof *renderer);
    renderer->config = *config;
    renderer_place(renderer, &(struct display_settings){ .light = 1.0f });
    glGetIntegerv(GL_MAX_SAMPLES, &samples_max);
    glGetIntegerv(GL_MAX_TEXTURE_SIZE, &side_max);
    renderer->samples_max = (uint32_t)samples_max;
    renderer->side_max = (uint32_t)side_max;
    /* For example, the version "OpenGL ES 3.2 Mesa 22.3.6" and the renderer "llvmpipe (LLVM 15.0.6,
     * 256 bits)" give the name "OpenGL ES 3.2 llvmpipe". */
    const char *const version = gl_string(GL_VERSION);
    const char *const device = gl_string(GL_RENDERER);
    const size_t prefix = strlen("OpenGL ES ");
    const int version_length =
        (int)(strlen(version) > prefix ? prefix + strcspn(version + prefix, " ") : strlen(version));
    snprintf(renderer->gl_name, sizeof renderer->gl_name, "%.*s %.*s", version_length, version,
             (int)strcspn(device, "("), device);
    const size_t length = strlen(renderer->gl_name);
    if (length && renderer->gl_name[length - 1] == ' ') {
        renderer->gl_name[length - 1] = '\0';
    }
    struct gl_status *const status = &renderer->status;
    frame_open(&renderer->frame);
    frame_bind(&renderer->frame, false);
    textures_open(status, &renderer->textures);
    light_pass_open(status, &renderer->light);
    basin_pass_open(status, &renderer->basin);
    specimen_pass_open(status, &renderer->specimens, &renderer->textures);
    fish_pass_open(status, &renderer->fish, &renderer->specimens.memory);
    poi_pass_open(status, &renderer->poi);
    hand_pass_open(status, &renderer->hand);
    bowl_pass_open(status, &renderer->bowl);
    quad_pass_open(status, &renderer->quad, &renderer->textures);
    char why[HAL_TEXT_SIZE] = "";
    if (!ui_init(&renderer->ui, why, sizeof why)) {
        gl_fail(status, "words: %s", why);
    }
    renderer->ui.memory.library = renderer->config.library;
    open_targets(renderer);
    return gl_is_well(&renderer->status) ? HAL_OK : HAL_ERR_GONE;
}

void renderer_close(struct renderer *renderer)
{
    close_targets(renderer);
    ui_close(&renderer->ui);
    quad_pass_close(&renderer->quad);
    bowl_pass_close(&renderer->bowl);
    hand_pass_close(&renderer->hand);
    poi_pass_close(&renderer->poi);
    fish_pass_close(&renderer->fish);
    specimen_pass_close(&renderer->specimens);
    basin_pass_close(&renderer->basin);
    light_pass_close(&renderer->light);
    textures_close(&renderer->textures);
    frame_close(&renderer->frame);
}

void renderer_place(struct renderer *renderer, const struct display_settings *display_settings)
{
    renderer->display_settings = *display_settings;
    renderer->transform = display_transform_of(display_settings, (float)renderer->config.width,
                                               (float)renderer->config.height);
    const bool is_day = display_settings->is_day != 0;
    if (renderer->frame.is_day != is_day) {
        renderer->frame.is_day = is_day;
        basin_pass_forget(&renderer->basin); /* The picture of the deck contains the light. */
    }
}

int renderer_resize(struct renderer *renderer, uint32_t width, uint32_t height)
{
    CORE_ASSERT(width > 0 && height > 0);
    if (width == renderer->config.width && height == renderer->config.height) {
        return HAL_OK;
    }
    renderer->config.width = width;
    renderer->config.height = height;
    renderer_place(renderer, &renderer->display_settings);
    close_targets(renderer);
    open_targets(renderer);
    return gl_is_well(&renderer->status) ? HAL_OK : HAL_ERR_GONE;
}

int renderer_lower(struct renderer *renderer, uint32_t step)
{
    CORE_ASSERT(step <= QUALITY_STEP_MAX);
    if (step == renderer->step) {
        return HAL_OK;
    }
    renderer->step = step;
    close_targets(renderer);
    open_targets(renderer);
    return gl_is_well(&renderer->status) ? HAL_OK : HAL_ERR_GONE;
}

int renderer_read(struct renderer *renderer, struct hal_image *image)
{
    CORE_ASSERT(image->rgb);
    const uint32_t width = renderer->config.width;
    const uint32_t height = renderer->config.height;
    const size_t row = (size_t)width * 3u;
    image->width = width;
    image->height = height;
    if (image->size < row * height || width > RENDERER_WIDTH_MAX) {
        return HAL_ERR_IO;
    }
    /* OpenGL returns the lowest pixel row first. RGBA is the only pixel format that every OpenGL ES
     * 3 driver can read back. */
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    for (uint32_t y = 0; y < height; y++) {
        uint8_t *out = image->rgb + row * (height - 1u - y);
        glReadPixels(0, (GLint)y, (GLsizei)width, 1, GL_RGBA, GL_UNSIGNED_BYTE, renderer->row);
        for (uint32_t x = 0; x < width; x++, out += 3) {
            memcpy(out, renderer->row + x * 4u, 3);
        }
    }
    return HAL_OK;
}

bool renderer_is_alive(struct renderer *renderer)
{
    const GLenum error = glGetError();
    if (error == GL_OUT_OF_MEMORY) {
        gl_fail(&renderer->status, "OpenGL is out of memory");
    } else if (error == GL_CONTEXT_LOST_KHR) {
        gl_fail(&renderer->status, "the graphics driver has reset");
    }
    return gl_is_well(&renderer->status);
}

void renderer_describe(const struct renderer *renderer, char *out, size_t size)
{
    CORE_ASSERT(size > 0);
    const struct quality *const quality = &renderer->quality;
    const int length = snprintf(out, size, "%s, %ux%u, scene %.2gx, floor %.2gx", renderer->gl_name,
                                renderer->config.width, renderer->config.height,
                                (double)quality->scene_scale, (double)quality->floor_scale);
    if (quality->samples > 1 && length > 0 && (size_t)length < size) {
        snprintf(out + length, size - (size_t)length, ", %u samples", quality->samples);
    }
}
