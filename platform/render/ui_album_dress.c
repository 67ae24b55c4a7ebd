/* ui_album_dress.c -- a look's bits as a coat: the designs that the tank's fish wear
 * (assets/bake/patterns.c), drawn as marks on the wakin's own red keys. */
#include "platform/render/ui_album.h"

#define WHITE 0xf8f0e6u
#define PATCH_SOFT 0.05f
#define DESIGNS 11u
#define PATCHES_MAX 5u

/* Where it is red: along u, and down from the back to `low` of its height; 0 length: no more. */
struct patch {
    float u, reach, low;
};

static const struct design {
    uint8_t red; /* All over: only the belly may be white. */
    float belly; /* How far up it is white. */
    struct patch patches[PATCHES_MAX];
} designs[DESIGNS] = {
    { .red = 1 },
    { .red = 1, .belly = 0.34f },
    { .patches = { { 0.12f, 0.24f, 0.0f }, { 0.80f, 0.24f, 0.0f } } },
    { .patches = { { 0.27f, 0.20f, 0.42f }, { 0.74f, 0.17f, 0.48f } } },
    { .patches = { { 0.12f, 0.12f, 0.55f }, { 0.45f, 0.14f, 0.42f }, { 0.79f, 0.13f, 0.50f } } },
    { .patches = { { 0.16f, 0.09f, 0.62f }, { 0.31f, 0.09f, 0.48f }, { 0.47f, 0.09f, 0.66f },
                   { 0.63f, 0.09f, 0.48f }, { 0.80f, 0.12f, 0.58f } } },
    { .patches = { { 0.06f, 0.24f, 0.0f }, { 0.70f, 0.09f, 0.64f } } },
    { .patches = { { 0.14f, 0.08f, 0.70f }, { 0.50f, 0.13f, 0.50f }, { 0.81f, 0.11f, 0.56f } } },
    { .patches = { { 0.14f, 0.09f, 0.72f } } },
    { .patches = { { 0.21f, 0.08f, 0.40f }, { 0.36f, 0.08f, 0.58f }, { 0.52f, 0.08f, 0.36f },
                   { 0.64f, 0.06f, 0.62f }, { 0.83f, 0.10f, 0.48f } } },
    { .patches = { { 0.90f, 0.10f, 0.30f } } },
};

/* As platform/render/fish_pass.c chooses a pattern and a hue from the same bits. */
static const struct design *design_of(uint32_t look)
{
    static const uint8_t layers[16] = { 0, 0, 0, 1, 1, 1, 2, 3, 3, 4, 5, 6, 7, 9, 10, 8 };
    return &designs[layers[look >> 8u & 15u]];
}

static uint32_t mix(uint32_t from, uint32_t to, float t)
{
    uint32_t mixed = 0;
    for (uint32_t shift = 0; shift <= 16u; shift += 8u) {
        const float a = (float)(from >> shift & 255u), b = (float)(to >> shift & 255u);
        mixed |= (uint32_t)(a + (b - a) * t + 0.5f) << shift;
    }
    return mixed;
}

static uint32_t hue_of(uint32_t look, uint32_t red)
{
    const float hue = (float)(look >> 16u & 1023u) / 1023.0f;
    return mix(red, 0xf08a2cu, 0.7f * hue * hue * hue);
}

static void add_patch(struct species_coat *coat, const struct patch *patch, uint32_t colour)
{
    if (patch->reach > 0.0f && coat->mark_count < MARK_MAX) {
        coat->marks[coat->mark_count++] = (struct species_mark){
            .kind = MARK_PATCH, .part = PART_BODY, .colour = colour,
            .from = patch->u > patch->reach ? patch->u - patch->reach : 0.0f,
            .to = patch->u + patch->reach, .low = patch->low, .high = 1.0f, .width = PATCH_SOFT,
        };
    }
}

/* One key's coat; what it had of marks but its scales, mouth and gills makes room. */
static void dress_key(struct species_coat *coat, const struct design *design, uint32_t look)
{
    const uint32_t back = hue_of(look, coat->back), flank = hue_of(look, coat->flank);
    if (design->red) {
        coat->back = back;
        coat->flank = flank;
        coat->belly = design->belly > 0.0f ? WHITE : hue_of(look, coat->belly);
        return;
    }
    for (uint32_t i = 0; i < coat->mark_count; i++) {
        if (coat->marks[i].kind == MARK_ROWS) {
            coat->marks[i].colour = mix(coat->marks[i].colour, WHITE, 0.8f);
        }
    }
    coat->back = mix(WHITE, back, 0.06f);
    coat->flank = coat->belly = WHITE;
    coat->fin = mix(WHITE, flank, 0.25f + 0.5f * (float)(look & 1u));
    for (uint32_t i = 0; i < PATCHES_MAX; i++) {
        add_patch(coat, &design->patches[i], mix(back, flank, 0.5f));
    }
}

const struct album_dress *ui_album_dress(struct ui_album *album, uint32_t index, uint32_t look)
{
    struct album_dress *dress = &album->dresses[index];
    if (dress->edition == 0 || dress->look != look) {
        dress->look = look;
        dress->edition = ++album->edition;
        dress->species = species_wakin;
        const uint32_t keys = species_wakin.card.key_count;
        for (uint32_t key = keys - 2u; key < keys; key++) { /* Red comes with the last two. */
            dress_key(&dress->species.coats[key], design_of(look), look);
        }
    }
    return dress;
}
