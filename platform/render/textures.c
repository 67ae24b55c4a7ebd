/* textures.c -- uploads the generated pictures of build/generated/assets.h to OpenGL. */
#include "platform/render/textures.h"

#include "assets.h"

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
    textures->wood = grey_tile(status, "wood", asset_wood, ASSET_WOOD_SIZE, true);
    textures->paper = grey_tile(status, "paper", asset_paper, ASSET_PAPER_SIZE, false);
}

/* Returns the pattern layer for the appearance number `look`. The sixteen entries of `layers` are
 * equally likely. A frequent pattern has several entries, so that the patterns are as frequent as
 * at breeders and fairs: six entries are all red (0) or have a pale belly (1), two are almost white
 * (8 and 10), and the others have red patches. */
float textures_pattern(uint32_t look)
{
    static const uint8_t layers[16] = { 0, 0, 0, 1, 1, 1, 2, 3, 3, 4, 5, 6, 7, 9, 10, 8 };
    return (float)(layers[look >> 8u & 15u] % ASSET_PATTERN_LAYERS);
}

float textures_hue(uint32_t look)
{
    return (float)(look >> 16u & 1023u) / 1023.0f;
}

void textures_close(struct textures *textures)
{
    const GLuint names[] = { textures->caustics, textures->patterns, textures->environment,
                             textures->wood, textures->paper };
    glDeleteTextures(sizeof names / sizeof *names, names);
}
