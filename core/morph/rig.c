/* rig.c -- the curves that blend one fish, and the shapes solved for them. */
#include "core/morph/morph.h"

#include "core/base/panic.h"

void morph_rig_init(struct morph_rig *rig, const struct species_card *card,
                    enum graph_template template)
{
    *rig = (struct morph_rig){ .key_count = card->key_count, .curve_count = card->curve_count };
    for (uint32_t curve = 0; curve < card->curve_count; curve++) {
        rig->curves[curve] = card->curves[curve];
        if (template != TEMPLATE_OWN) {
            graph_template(&rig->curves[curve], template, card->key_count, SIMULTANEOUS_PEAK);
        }
        for (uint32_t key = 0; key < card->key_count; key++) {
            rig->solution[curve][key][key] = 1.0f;
        }
    }
}

void morph_weights(const struct morph_rig *rig, float progress,
                   float weights[MORPH_CURVE_MAX][MORPH_KEY_MAX])
{
    for (uint32_t curve = 0; curve < MORPH_CURVE_MAX; curve++) {
        const uint32_t from = curve < rig->curve_count ? curve : 0;
        graph_weights(&rig->curves[from], rig->key_count, progress, weights[curve]);
    }
}
