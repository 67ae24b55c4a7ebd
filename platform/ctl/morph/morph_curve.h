/* morph_curve.h -- finds a curve of a species' deformation graph by the name that --curve gives.
 *
 * A curve states how the weights of the key shapes change during a fish's life. */
#ifndef KINGYO_PLATFORM_CTL_MORPH_MORPH_CURVE_H
#define KINGYO_PLATFORM_CTL_MORPH_MORPH_CURVE_H

#include "core/morph/species.h"
#include "platform/ctl/morph/morph.h"

/* Sets `*curve` to the index of the curve `curve_name`. Null selects the curve of the whole fish.
 * Returns EXIT_OK. If the curve does not exist, prints one line and returns EXIT_USAGE. */
enum exit_code morph_curve_find(const struct species_card *card, const char *command,
                                const char *curve_name, uint32_t *curve);

#endif
