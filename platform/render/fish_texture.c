/* fish_texture.c -- implementation of fish_texture.h. */
#include "platform/render/fish_texture.h"

#include <string.h>

#include "core/base/panic.h"

/* Maximum colour difference, of 255, between neighbouring coarse points. If the difference is
 * larger, the texel is painted from four points. */
#define EDGE 20
/* Minimum number of rows of a dot mark whose dots are drawn as fish scales. */
#define SCALE_ROWS_MIN 6u
/* Minimum number of bands of a mark round the body that the shader draws as lines, because so many
 * bands are too fine for a painted sheet. */
#define LINES_MIN 40u

static GLuint sheets(struct gl_status *status, GLenum internal_format, GLenum format)
{
    return gl_texture(status, "skin",
                      &(struct gl_texture_desc){ .internal_format = internal_format,
                                                 .format = format,
                                                 .width = PAINT_SIZE,
                                                 .height = PAINT_SIZE,
                                                 .layers = FISH_TEXTURE_SHEETS });
}

void fish_texture_open(struct gl_status *status, struct fish_texture *skin)
{
    skin->paints = sheets(status, GL_RGBA8, GL_RGBA);
    skin->shines = sheets(status, GL_R8, GL_RED);
}

void fish_texture_close(struct fish_texture *skin)
{
    const GLuint textures[2] = { skin->paints, skin->shines };
    glDeleteTextures(2, textures);
}

float fish_texture_scales(const struct fish_texture *skin)
{
    /* Number of fish scales from head to tail for each body form. A carp has about 30, a bream
     * 50. */
    static const float along[] = { [FORM_FUSIFORM] = 31.0f,
                                   [FORM_COMPRESSED] = 50.0f,
                                   [FORM_DEPRESSED] = 80.0f,
                                   [FORM_EEL] = 0.0f,
                                   [FORM_PUFFER] = 0.0f };
    const struct species_card *const card = &skin->species.card;
    const bool bare = card->motion == MOTION_WING || card->motion == MOTION_TUNA;
    return bare ? 0.0f : along[card->form];
}

/* Removes dot marks that stand for fish scales from the painting if the shader draws the scales
 * with rims. The marks keep their place in the array, because marks of two key shapes correspond to
 * each other by their index. */
static void leave_out_dots(struct fish_texture *skin)
{
    for (uint32_t key = 0; key < skin->species.card.key_count; key++) {
        struct species_coat *const coat = &skin->species.coats[key];
        for (uint32_t i = 0; i < coat->mark_count; i++) {
            struct species_mark *const mark = &coat->marks[i];
            if (mark->kind == MARK_ROWS && mark->part == PART_BODY &&
                mark->seed >= SCALE_ROWS_MIN) {
                mark->part = PART_COUNT; /* The value PART_COUNT matches no body part. Therefore the
                                            mark is not painted. */
            }
        }
    }
}

static bool is_lines(const struct species_mark *mark)
{
    return mark->kind == MARK_BANDS && mark->part == PART_BODY && mark->count >= LINES_MIN;
}

/* Removes the marks that the shader draws as lines from the painting. Copies of these marks are
 * stored in skin->lined. */
static void leave_out_lines(struct fish_texture *skin)
{
    for (uint32_t key = 0; key < skin->species.card.key_count; key++) {
        struct species_coat *const coat = &skin->species.coats[key];
        skin->lined[key].count = 0;
        for (uint32_t i = 0; i < coat->mark_count; i++) {
            if (is_lines(&coat->marks[i])) {
                skin->lined[key] = coat->marks[i];
                coat->marks[i].part = PART_COUNT;
            }
        }
    }
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
    leave_out_lines(skin);
    if (fish_texture_scales(skin) > 0.0f) {
        leave_out_dots(skin);
    }
}

static uint8_t byte(float x)
{
    return (uint8_t)(f_clamp(x, 0.0f, 1.0f) * 255.0f + 0.5f);
}

/* Parameters for painting one sheet. */
struct painting {
    const struct species *species;
    float weights[MORPH_KEY_MAX];
    struct fish_texture_brush *brush;
};

static struct painting painting_of(const struct fish_texture *skin,
                                   struct fish_texture_brush *brush, uint32_t sheet)
{
    struct painting painting = { .species = &skin->species, .brush = brush };
    const uint32_t key = sheet / skin->per_key;
    const float part = (float)(sheet % skin->per_key) / (float)skin->per_key;
    painting.weights[key] = 1.0f - part;
    if (part > 0.0f) {
        painting.weights[key + 1u] = part;
    }
    return painting;
}

static bool paint_point(const struct painting *painting, float x, float y, struct paint *paint)
{
    struct species_vertex at;
    if (!paint_atlas_at(x, y, &at)) {
        return false;
    }
    *paint = paint_at(painting->species, painting->weights, &at);
    return true;
}

static void fish_texture_put(const struct painting *painting, uint32_t index,
                             const struct paint *paint)
{
    const uint8_t texel[4] = { byte(paint->colour.x), byte(paint->colour.y), byte(paint->colour.z),
                               byte(paint->clear) };
    memcpy(painting->brush->paint[index], texel, sizeof texel);
    painting->brush->shine[index] = byte(paint->shine);
}

/* Paints the band of texels that begins at texel row `first`. Each texel gets the paint at its
 * centre. */
static void paint_plainly(const struct painting *painting, uint32_t first)
{
    struct paint paint;
    for (uint32_t i = 0; i < FISH_TEXTURE_BAND * PAINT_SIZE; i++) {
        const float x = (float)(i % PAINT_SIZE) + 0.5f;
        const float y = (float)(first + i / PAINT_SIZE) + 0.5f;
        if (paint_point(painting, x, y, &paint)) {
            fish_texture_put(painting, i, &paint);
        }
    }
}

/* ---- Coarse painting: points several texels apart, with interpolation between them ----------- */

static void paint_coarse_points(const struct painting *painting)
{
    const float middle = 0.5f * (float)FISH_TEXTURE_COARSE;
    for (uint32_t i = 0; i < FISH_TEXTURE_COARSE_SIZE * FISH_TEXTURE_COARSE_SIZE; i++) {
        struct paint paint = { .colour = { 0.0f, 0.0f, 0.0f } };
        float *const point = painting->brush->coarse[i];
        paint_point(painting, (float)(i % FISH_TEXTURE_COARSE_SIZE * FISH_TEXTURE_COARSE) + middle,
                    (float)(i / FISH_TEXTURE_COARSE_SIZE * FISH_TEXTURE_COARSE) + middle, &paint);
        point[0] = paint.colour.x;
        point[1] = paint.colour.y;
        point[2] = paint.colour.z;
        point[3] = paint.clear;
        point[4] = paint.shine;
    }
}

/* Writes the indices of the two coarse points between which texel `at` lies. Both points are within
 * the texel's atlas cell, which is `size` texels wide. Returns the interpolation weight of the
 * second point. */
static float beside(uint32_t at, uint32_t size, uint32_t points[2])
{
    const float first = (float)(at - at % size) / (float)FISH_TEXTURE_COARSE;
    const float last = first + (float)(size / FISH_TEXTURE_COARSE) - 1.0f;
    const float x = f_clamp(((float)at + 0.5f) / (float)FISH_TEXTURE_COARSE - 0.5f, first, last);
    points[0] = (uint32_t)x;
    points[1] = (float)points[0] + 1.0f <= last ? points[0] + 1u : points[0];
    return x - (float)points[0];
}

static void smooth_texel(const struct painting *painting, uint32_t index, uint32_t x, uint32_t y)
{
    const bool body = y < PAINT_BODY_HEIGHT;
    uint32_t columns[2], rows[2];
    float value[5];
    const float right = beside(x, body ? PAINT_SIZE : PAINT_CELL_WIDTH, columns);
    const float down = beside(y, body ? PAINT_BODY_HEIGHT : PAINT_CELL_HEIGHT, rows);
    for (uint32_t i = 0; i < 5; i++) {
        float line[2];
        for (uint32_t k = 0; k < 2; k++) {
            const uint32_t row = rows[k] * FISH_TEXTURE_COARSE_SIZE;
            line[k] = f_lerp(painting->brush->coarse[row + columns[0]][i],
                             painting->brush->coarse[row + columns[1]][i], right);
        }
        value[i] = f_lerp(line[0], line[1], down);
    }
    fish_texture_put(painting, index,
                     &(struct paint){ .colour = { value[0], value[1], value[2] },
                                      .clear = value[3],
                                      .shine = value[4] });
}

static bool differ(const uint8_t a[4], const uint8_t b[4])
{
    int32_t most = 0;
    for (uint32_t i = 0; i < 4; i++) {
        const int32_t d = (int32_t)a[i] - (int32_t)b[i];
        most = d > most ? d : -d > most ? -d : most;
    }
    return most > EDGE;
}

/* Paints texel (x, y) as the mean of the paint at four points. */
static void paint_finely(const struct painting *painting, uint32_t index, uint32_t x, uint32_t y)
{
    struct paint mean = { .colour = { 0.0f, 0.0f, 0.0f } }, paint;
    for (uint32_t i = 0; i < 4; i++) {
        const float right = 0.25f + 0.5f * (float)(i & 1u), down = 0.25f + 0.5f * (float)(i >> 1);
        if (!paint_point(painting, (float)x + right, (float)y + down, &paint)) {
            return;
        }
        mean.colour = v3_muladd(mean.colour, paint.colour, 0.25f);
        mean.clear += 0.25f * paint.clear;
        mean.shine += 0.25f * paint.shine;
    }
    fish_texture_put(painting, index, &mean);
}

/* Smooths the edges of marks in the band that begins at texel row `first`. An edge may be narrower
 * than a texel and would be jagged if each texel were painted from one point. */
static void smooth_rims(const struct painting *painting, uint32_t first)
{
    bool rim[FISH_TEXTURE_BAND * PAINT_SIZE] = { false };
    for (uint32_t i = 0; i < FISH_TEXTURE_BAND * PAINT_SIZE; i++) {
        const uint32_t right = i % PAINT_SIZE < PAINT_SIZE - 1u ? i + 1u : i;
        const uint32_t below = i + PAINT_SIZE < FISH_TEXTURE_BAND * PAINT_SIZE ? i + PAINT_SIZE : i;
        const uint8_t(*const texels)[4] = (const uint8_t(*)[4])painting->brush->paint;
        if (differ(texels[i], texels[right])) {
            rim[i] = rim[right] = true;
        }
        if (differ(texels[i], texels[below])) {
            rim[i] = rim[below] = true;
        }
    }
    for (uint32_t i = 0; i < FISH_TEXTURE_BAND * PAINT_SIZE; i++) {
        if (rim[i]) {
            paint_finely(painting, i, i % PAINT_SIZE, first + i / PAINT_SIZE);
        }
    }
}

static void send(const struct fish_texture *skin, const struct fish_texture_brush *brush,
                 uint32_t sheet, uint32_t first)
{
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    gl_bind_texture(0, GL_TEXTURE_2D_ARRAY, skin->paints);
    glTexSubImage3D(GL_TEXTURE_2D_ARRAY, 0, 0, (GLint)first, (GLint)sheet, PAINT_SIZE,
                    FISH_TEXTURE_BAND, 1, GL_RGBA, GL_UNSIGNED_BYTE, brush->paint);
    gl_bind_texture(0, GL_TEXTURE_2D_ARRAY, skin->shines);
    glTexSubImage3D(GL_TEXTURE_2D_ARRAY, 0, 0, (GLint)first, (GLint)sheet, PAINT_SIZE,
                    FISH_TEXTURE_BAND, 1, GL_RED, GL_UNSIGNED_BYTE, brush->shine);
}

static void paint_coarsely(struct fish_texture *skin, struct fish_texture_brush *brush,
                           uint32_t sheet)
{
    const struct painting painting = painting_of(skin, brush, sheet);
    paint_coarse_points(&painting);
    for (uint32_t band = 0; band < FISH_TEXTURE_BANDS; band++) {
        for (uint32_t i = 0; i < FISH_TEXTURE_BAND * PAINT_SIZE; i++) {
            smooth_texel(&painting, i, i % PAINT_SIZE, band * FISH_TEXTURE_BAND + i / PAINT_SIZE);
        }
        send(skin, brush, sheet, band * FISH_TEXTURE_BAND);
    }
    skin->is_coarse[sheet] = true;
}

void fish_texture_request(struct fish_texture *skin, struct fish_texture_brush *brush,
                          const float weights[MORPH_KEY_MAX], float length_px, float out[3])
{
    float mean = 0.0f, sum = 0.0f;
    for (uint32_t key = 0; key < skin->species.card.key_count; key++) {
        const float weight = f_max(weights[key], 0.0f); /* paint_at() clamps the weights in the same
                                                           way. */
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
        if (!skin->is_coarse[sheet]) {
            paint_coarsely(skin, brush, sheet);
        }
    }
    out[0] = (float)first;
    out[1] = (float)second;
    out[2] = at - (float)first;
}

/* Returns the unfinished sheet whose number is nearest to the visible sheet, or sheet_count if all
 * sheets are finished. */
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

uint32_t fish_texture_work(struct fish_texture *skin, struct fish_texture_brush *brush,
                           uint32_t bands)
{
    while (bands > 0) {
        const uint32_t sheet = next_sheet(skin);
        if (sheet == skin->sheet_count) {
            break;
        }
        const struct painting painting = painting_of(skin, brush, sheet);
        const uint32_t first = skin->bands_done[sheet] * FISH_TEXTURE_BAND;
        paint_plainly(&painting, first);
        smooth_rims(&painting, first);
        send(skin, brush, sheet, first);
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

static struct fish_texture_lines lines_of(const struct species_mark *mark, float share)
{
    const float step = f_max(mark->to - mark->from, 1e-3f) / f_max((float)mark->count, 1.0f);
    return (struct fish_texture_lines){
        .place = { mark->from, step, (float)mark->count, mark->slant },
        .shape = { 0.5f * mark->width, mark->low, mark->high, share },
        .colour = { (float)(mark->colour >> 16 & 255u) / 255.0f,
                    (float)(mark->colour >> 8 & 255u) / 255.0f,
                    (float)(mark->colour & 255u) / 255.0f },
    };
}

/* Writes the line sets of the two keys with the largest weights. The opacity of each line set is
 * its key's weight divided by the sum of all weights. paint_at() fades marks that exist in only one
 * key in the same way. Two neighbouring keys of a larva have different numbers of muscles, so that
 * their lines cannot be interpolated. */
void fish_texture_lines(const struct fish_texture *skin, const float weights[MORPH_KEY_MAX],
                        struct fish_texture_lines lines[FISH_TEXTURE_LINES])
{
    float sum = 0.0f;
    memset(lines, 0, FISH_TEXTURE_LINES * sizeof *lines);
    for (uint32_t key = 0; key < skin->species.card.key_count; key++) {
        sum += f_max(weights[key], 0.0f);
    }
    for (uint32_t key = 0; key < skin->species.card.key_count; key++) {
        const float share = f_max(weights[key], 0.0f) / f_max(sum, 1e-6f);
        struct fish_texture_lines *const least =
            lines[0].shape[3] < lines[1].shape[3] ? &lines[0] : &lines[1];
        if (skin->lined[key].count > 0 && share > least->shape[3]) {
            *least = lines_of(&skin->lined[key], share);
        }
    }
}

float fish_texture_opacity(const struct fish_texture *skin, const float weights[MORPH_KEY_MAX])
{
    float clear = 0.0f, sum = 0.0f;
    for (uint32_t key = 0; key < skin->species.card.key_count; key++) {
        const float weight = f_max(weights[key], 0.0f);
        clear += weight * (float)skin->species.coats[key].clear / 255.0f;
        sum += weight;
    }
    return clear / sum;
}
