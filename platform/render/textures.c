/* textures.c -- uploads the generated pictures of build/generated/assets.h to OpenGL. */
#include "platform/render/textures.h"

#include "assets.h"
#include "core/base/fmath.h"

static GLuint grey_tile(struct gl_status *status, const char *name, const uint8_t *pixels,
                        uint32_t side, bool mipmaps)
{
    return gl_texture(status, name,
                      &(struct gl_texture_desc){ .internal_format = GL_R8,
                                                 .width = side,
                                                 .height = side,
                                                 .pixels = pixels,
                                                 .mipmaps = mipmaps,
                                                 .wrap = GL_REPEAT });
}

void textures_open(struct gl_status *status, struct textures *textures)
{
    textures->caustics = gl_texture(status, "caustics",
                                    &(struct gl_texture_desc){ .internal_format = GL_R8,
                                                               .width = ASSET_CAUSTICS_SIZE,
                                                               .height = ASSET_CAUSTICS_SIZE,
                                                               .layers = ASSET_CAUSTICS_FRAMES,
                                                               .pixels = asset_caustics,
                                                               .mipmaps = true,
                                                               .wrap = GL_REPEAT });
    textures->patterns = gl_texture(status, "patterns",
                                    &(struct gl_texture_desc){ .internal_format = GL_RG8,
                                                               .width = ASSET_PATTERN_WIDTH,
                                                               .height = ASSET_PATTERN_HEIGHT,
                                                               .layers = ASSET_PATTERN_LAYERS,
                                                               .pixels = asset_patterns,
                                                               .mipmaps = true });
    textures->environment = gl_texture(status, "environment",
                                       &(struct gl_texture_desc){ .internal_format = GL_RGB8,
                                                                  .width = ASSET_ENVIRONMENT_SIZE,
                                                                  .height = ASSET_ENVIRONMENT_SIZE,
                                                                  .pixels = asset_environment });
    textures->backdrop = gl_texture(status, "backdrop",
                                    &(struct gl_texture_desc){ .internal_format = GL_RGB8,
                                                               .width = ASSET_BACKDROP_WIDTH,
                                                               .height = ASSET_BACKDROP_HEIGHT,
                                                               .layers = 2,
                                                               .pixels = asset_backdrop,
                                                               .mipmaps = true,
                                                               .wrap = GL_MIRRORED_REPEAT });
    textures->wood = grey_tile(status, "wood", asset_wood, ASSET_WOOD_SIZE, true);
    textures->paper = grey_tile(status, "paper", asset_paper, ASSET_PAPER_SIZE, false);
}

/* Returns the number, [0, 15], of the kind of fish with the appearance number `look`. The kinds are
 * equally likely. */
static uint32_t kind_of(uint32_t look)
{
    return look >> 8u & 15u;
}

#define BLACK_KIND 12u  /* The kind that is black, one fish in sixteen. */
#define RYUKIN_KIND 15u /* The kind with blotches, half of whose fish are ryukin. */

/* Returns the pattern layer for the appearance number `look`. The fish are as at a stall: of the
 * sixteen kinds six are all red (0), six have a pale belly or pale flanks (1, 2), one is black with
 * a pale belly, and only three have patches. */
float textures_pattern(uint32_t look)
{
    static const uint8_t layers[16] = { 0, 0, 0, 0, 0, 0, 1, 1, 1, 1, 2, 2, 1, 3, 4, 5 };
    const uint32_t layer = layers[kind_of(look)];
    /* Half of the fish with blotches (5) are nearly white (6). */
    return (float)((layer == 5u ? layer + (look >> 31u) : layer) % ASSET_PATTERN_LAYERS);
}

float textures_hue(uint32_t look)
{
    const float hue = (float)(look >> 16u & 1023u) / 1023.0f;
    return kind_of(look) == BLACK_KIND ? 1.0f + f_max(hue, 0.001f) : hue;
}

const struct species *textures_variety(uint32_t look)
{
    const uint32_t kind = kind_of(look);
    const bool is_ryukin = kind == RYUKIN_KIND && (look >> 30u & 1u) != 0;
    return kind == BLACK_KIND ? &species_demekin : is_ryukin ? &species_ryukin : &species_wakin;
}

void textures_close(struct textures *textures)
{
    const GLuint names[] = { textures->caustics, textures->patterns, textures->environment,
                             textures->backdrop, textures->wood,     textures->paper };
    glDeleteTextures(sizeof names / sizeof *names, names);
}
