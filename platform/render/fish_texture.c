/* fish_texture.c -- paints the sheets of a fish texture in small portions, and uploads the
 * sheets. */
#include "platform/render/fish_texture.h"

#include <string.h>

#include "core/base/panic.h"

/* Minimum number of dot rows in a mark of kind MARK_ROWS from which the dots stand for fish
 * scales. */
#define SCALE_ROWS_MIN 6u
/* Minimum number of bands round the body in a mark of kind MARK_BANDS from which the shader draws
 * the bands as lines, because so many bands are too fine for a painted sheet. */
#define LINES_MIN 40u

static GLuint make_sheet_array(struct gl_status *status, GLenum internal_format)
{
    return gl_texture(status, "skin",
                      &(struct gl_texture_desc){ .internal_format = internal_format,
                                                 .width = PAINT_SIZE,
                                                 .height = PAINT_SIZE,
                                                 .layers = FISH_TEXTURE_SHEETS });
}

void fish_texture_open(struct gl_status *status, struct fish_texture *skin)
{
    skin->paints = make_sheet_array(status, GL_RGBA8);
    skin->shines = make_sheet_array(status, GL_R8);
}

void fish_texture_close(struct fish_texture *skin)
{
    const GLuint textures[2] = { skin->paints, skin->shines };
    glDeleteTextures(2, textures);
}

float fish_texture_scales(const struct fish_texture *skin)
{
    /* Number of fish scales from head to tail for each body form. A carp has about 30 scales, and a
     * bream has about 50. */
    static const float along[FORM_PUFFER + 1] = {
        [FORM_FUSIFORM] = 31.0f, [FORM_COMPRESSED] = 50.0f, [FORM_DEPRESSED] = 80.0f
    };
    const struct species_card *const card = &skin->species.card;
    const bool bare = card->motion == MOTION_WING || card->motion == MOTION_TUNA;
    return bare ? 0.0f : along[card->form];
}

void fish_texture_bind(struct fish_texture *skin, const struct species *species)
{
    const uint32_t steps = species->card.key_count - 1u;
    CORE_ASSERT(steps >= 1 && steps < MORPH_KEY_MAX);
    skin->species = *species;
    skin->per_key = (FISH_TEXTURE_SHEETS - 1u) / steps;
    skin->sheet_count = steps * skin->per_key + 1u;
    skin->shown = skin->shown_px = 0.0f;
    memset(skin->bands_done, 0, sizeof skin->bands_done);
    memset(skin->is_coarse, 0, sizeof skin->is_coarse);
    /* The loop removes the marks that the shader draws from the marks to paint. These marks are
     * lines round the body, whose copies are stored in skin->lined, and dots that stand for fish
     * scales if the shader draws scales. A removed mark keeps its place in the array, because the
     * marks of two key shapes correspond to each other by their index. */
    const bool has_scales = fish_texture_scales(skin) > 0.0f;
    for (uint32_t key = 0; key <= steps; key++) {
        struct species_coat *const coat = &skin->species.coats[key];
        skin->lined[key].count = 0;
        for (uint32_t i = 0; i < coat->mark_count; i++) {
            struct species_mark *const mark = &coat->marks[i];
            const bool on_body = mark->part == PART_BODY;
            const bool is_line = on_body && mark->kind == MARK_BANDS && mark->count >= LINES_MIN;
            const bool is_dot = on_body && mark->kind == MARK_ROWS && mark->seed >= SCALE_ROWS_MIN;
            if (is_line) {
                skin->lined[key] = *mark;
            }
            if (is_line || (is_dot && has_scales)) {
                mark->part = PART_COUNT; /* The value PART_COUNT matches no body part. Therefore the
                                            mark is not painted. */
            }
        }
    }
}

static struct painting painting_of(const struct fish_texture *skin, struct paint_brush *brush,
                                   uint32_t sheet)
{
    CORE_ASSERT(sheet < skin->sheet_count);
    struct painting painting = { .species = &skin->species, .brush = brush };
    const uint32_t key = sheet / skin->per_key;
    const float part = (float)(sheet % skin->per_key) / (float)skin->per_key;
    painting.weights[key] = 1.0f - part;
    if (part > 0.0f) {
        painting.weights[key + 1u] = part;
    }
    return painting;
}

static void upload_paint_band(const struct fish_texture *skin, const struct paint_brush *brush,
                              uint32_t sheet, uint32_t first)
{
    CORE_ASSERT(sheet < FISH_TEXTURE_SHEETS && first < PAINT_SIZE);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    gl_bind_texture(0, GL_TEXTURE_2D_ARRAY, skin->paints);
    glTexSubImage3D(GL_TEXTURE_2D_ARRAY, 0, 0, (GLint)first, (GLint)sheet, PAINT_SIZE, PAINT_BAND,
                    1, GL_RGBA, GL_UNSIGNED_BYTE, brush->paint);
    gl_bind_texture(0, GL_TEXTURE_2D_ARRAY, skin->shines);
    glTexSubImage3D(GL_TEXTURE_2D_ARRAY, 0, 0, (GLint)first, (GLint)sheet, PAINT_SIZE, PAINT_BAND,
                    1, GL_RED, GL_UNSIGNED_BYTE, brush->shine);
}

void fish_texture_request(struct fish_texture *skin, struct paint_brush *brush,
                          const float weights[MORPH_KEY_MAX], float length_px, float out[3])
{
    CORE_ASSERT(length_px >= 0.0f && skin->sheet_count > 0);
    float mean = 0.0f, sum = 0.0f;
    for (uint32_t key = 0; key < skin->species.card.key_count; key++) {
        /* A negative weight counts as 0, as in paint_at(). */
        const float weight = f_max(weights[key], 0.0f);
        mean += weight * (float)(key * skin->per_key);
        sum += weight;
    }
    const float at = f_clamp(mean / sum, 0.0f, (float)(skin->sheet_count - 1u));
    const uint32_t first = (uint32_t)at;
    if (length_px > skin->shown_px) {
        skin->shown = at;
        skin->shown_px = length_px;
    }
    const uint32_t second = first + 1u < skin->sheet_count ? first + 1u : first;
    for (uint32_t sheet = first; sheet <= second; sheet++) {
        if (skin->is_coarse[sheet]) {
            continue;
        }
        const struct painting painting = painting_of(skin, brush, sheet);
        paint_atlas_coarse_points(&painting);
        for (uint32_t row = 0; row < PAINT_SIZE; row += PAINT_BAND) {
            paint_atlas_coarse_band(&painting, row);
            upload_paint_band(skin, brush, sheet, row);
        }
        skin->is_coarse[sheet] = true;
    }
    out[0] = (float)first;
    out[1] = (float)second;
    out[2] = at - (float)first;
}

/* Returns the number of the unfinished sheet that is nearest to the visible sheet, or sheet_count
 * if all sheets are finished. */
static uint32_t next_sheet(const struct fish_texture *skin)
{
    uint32_t best = skin->sheet_count;
    float least = 1e9f;
    for (uint32_t sheet = 0; sheet < skin->sheet_count; sheet++) {
        const float far = f_abs((float)sheet - skin->shown);
        if (skin->bands_done[sheet] < FISH_TEXTURE_BANDS && far < least) {
            best = sheet;
            least = far;
        }
    }
    return best;
}

uint32_t fish_texture_work(struct fish_texture *skin, struct paint_brush *brush, uint32_t bands)
{
    while (bands > 0) {
        const uint32_t sheet = next_sheet(skin);
        if (sheet == skin->sheet_count) {
            break;
        }
        const struct painting painting = painting_of(skin, brush, sheet);
        const uint32_t first = skin->bands_done[sheet] * PAINT_BAND;
        paint_atlas_fine_band(&painting, first);
        upload_paint_band(skin, brush, sheet, first);
        skin->bands_done[sheet]++;
        skin->is_coarse[sheet] |= skin->bands_done[sheet] == FISH_TEXTURE_BANDS;
        bands--;
    }
    return bands;
}

bool fish_texture_is_done(const struct fish_texture *skin)
{
    return next_sheet(skin) == skin->sheet_count;
}

bool fish_texture_is_fine(const struct fish_texture *skin)
{
    const uint32_t sheet = next_sheet(skin);
    return sheet == skin->sheet_count || f_abs((float)sheet - skin->shown) >= 1.0f;
}

/* Writes the line sets of the two keys with the largest weights. The opacity of a line set is its
 * key's weight divided by the sum of all weights, as for a painted mark that exists in only one key
 * (paint_at()). The lines themselves cannot be interpolated, because two neighbouring keys of a
 * larva have different numbers of lines (muscles). */
void fish_texture_lines(const struct fish_texture *skin, const float weights[MORPH_KEY_MAX],
                        struct fish_texture_lines lines[FISH_TEXTURE_LINES])
{
    CORE_ASSERT(skin->species.card.key_count <= MORPH_KEY_MAX);
    float sum = 0.0f;
    memset(lines, 0, FISH_TEXTURE_LINES * sizeof *lines);
    for (uint32_t key = 0; key < skin->species.card.key_count; key++) {
        sum += f_max(weights[key], 0.0f);
    }
    for (uint32_t key = 0; key < skin->species.card.key_count; key++) {
        const float share = f_max(weights[key], 0.0f) / f_max(sum, 1e-6f);
        struct fish_texture_lines *const least =
            lines[0].shape[3] < lines[1].shape[3] ? &lines[0] : &lines[1];
        const struct species_mark *const mark = &skin->lined[key];
        if (mark->count == 0 || share <= least->shape[3]) {
            continue;
        }
        const float step = f_max(mark->to - mark->from, 1e-3f) / f_max((float)mark->count, 1.0f);
        *least = (struct fish_texture_lines){
            .place = { mark->from, step, (float)mark->count, mark->slant },
            .shape = { 0.5f * mark->width, mark->low, mark->high, share },
            .colour = { (float)(mark->colour >> 16 & 255u) / 255.0f,
                        (float)(mark->colour >> 8 & 255u) / 255.0f,
                        (float)(mark->colour & 255u) / 255.0f },
        };
    }
}

float fish_texture_opacity(const struct fish_texture *skin, const float weights[MORPH_KEY_MAX])
{
    CORE_ASSERT(skin->species.card.key_count <= MORPH_KEY_MAX);
    float clear = 0.0f, sum = 0.0f;
    for (uint32_t key = 0; key < skin->species.card.key_count; key++) {
        const float weight = f_max(weights[key], 0.0f);
        clear += weight * (float)skin->species.coats[key].clear / 255.0f;
        sum += weight;
    }
    return clear / sum;
}
