/* morph_curve.h -- a species' curves by their names: --curve. */
#ifndef KINGYO_PLATFORM_CTL_MORPH_CURVE_H
#define KINGYO_PLATFORM_CTL_MORPH_CURVE_H

#include "core/morph/species.h"
#include "platform/ctl/morph.h"

/* Which curve of the card `curve_name` (null: the whole fish's) is. EXIT_OK, or EXIT_USAGE,
 * told. */
enum exit_code morph_curve_find(const struct species_card *card, const char *command,
                                const char *curve_name, uint32_t *curve);

#endif
