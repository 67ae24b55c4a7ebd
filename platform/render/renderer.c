/* renderer.c -- the order of a frame. */
#include "platform/render/renderer.h"

#include <stdio.h>
#include <string.h>

static const char *gl_string(GLenum name)
{
    const char *const text = (const char *)glGetString(name);
    return text ? text : "unknown";
}

/* "OpenGL ES 3.2 Mesa 22.3.6" and "llvmpipe (LLVM 15.0.6, 256 bits)" become one short name. */
static void name_context(struct renderer *renderer)
{
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
}

int renderer_open(struct renderer *renderer, const struct renderer_config *config)
{
    GLint samples_max = 1;
    *renderer = (struct renderer){ .width = config->width, .height = config->height };
    glGetIntegerv(GL_MAX_SAMPLES, &samples_max);
    renderer->quality = quality_choose(gl_string(GL_RENDERER), config->scene_scale, config->samples,
                                       (uint32_t)samples_max);
    name_context(renderer);
    return gl_is_well(&renderer->status) ? HAL_OK : HAL_ERR_GONE;
}

void renderer_close(struct renderer *renderer)
{
    *renderer = (struct renderer){ 0 };
}

int renderer_resize(struct renderer *renderer, uint32_t width, uint32_t height)
{
    renderer->width = width;
    renderer->height = height;
    return HAL_OK;
}

void renderer_draw(struct renderer *renderer, const struct scene *scene)
{
    const float calm = scene->phase == PHASE_ATTRACT ? 0.9f : 1.0f;
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    glViewport(0, 0, (GLsizei)renderer->width, (GLsizei)renderer->height);
    glClearColor(0.16f * calm, 0.56f * calm, 0.66f * calm, 1.0f);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
}

int renderer_read(struct renderer *renderer, struct hal_image *image)
{
    const size_t row = (size_t)renderer->width * 3u;
    if (image->size < row * renderer->height) {
        return HAL_ERR_IO;
    }
    /* OpenGL's first row is the lowest: rows are read one by one into their places, as RGBA is the
     * only layout that every ES 3 driver must offer, through a strip of the stack. */
    enum { STRIP = 256 };
    uint8_t strip[STRIP * 4];
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    for (uint32_t y = 0; y < renderer->height; y++) {
        uint8_t *out = image->rgb + row * (renderer->height - 1u - y);
        for (uint32_t x = 0; x < renderer->width; x += STRIP) {
            const uint32_t count = renderer->width - x < STRIP ? renderer->width - x : STRIP;
            glReadPixels((GLint)x, (GLint)y, (GLsizei)count, 1, GL_RGBA, GL_UNSIGNED_BYTE, strip);
            for (uint32_t i = 0; i < count; i++, out += 3) {
                memcpy(out, strip + i * 4u, 3);
            }
        }
    }
    image->width = renderer->width;
    image->height = renderer->height;
    return HAL_OK;
}

bool renderer_is_alive(struct renderer *renderer)
{
    const GLenum error = glGetError();
    if (error == GL_OUT_OF_MEMORY) {
        gl_fail(&renderer->status, "OpenGL is out of memory");
    }
    return gl_is_well(&renderer->status);
}

const char *renderer_error(const struct renderer *renderer)
{
    return renderer->status.text;
}

void renderer_describe(const struct renderer *renderer, char *out, size_t size)
{
    const struct quality *const quality = &renderer->quality;
    const int length =
        snprintf(out, size, "%s, %ux%u, scene %.2gx, floor %.2gx", renderer->gl_name,
                 renderer->width, renderer->height, (double)quality->scene_scale,
                 (double)quality->floor_scale);
    if (quality->samples > 1 && length > 0 && (size_t)length < size) {
        snprintf(out + length, size - (size_t)length, ", %u samples", quality->samples);
    }
}
