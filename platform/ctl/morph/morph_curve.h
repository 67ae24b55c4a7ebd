/* morph_curve.h -- finds a species' curve by its name (--curve). */
#ifndef KINGYO_PLATFORM_CTL_MORPH_MORPH_CURVE_H
#define KINGYO_PLATFORM_CTL_MORPH_MORPH_CURVE_H

#include "core/morph/species.h"
#include "platform/ctl/morph/morph.h"

/* Sets `*curve` to the index of the curve `curve_name`. A null `curve_name` means the curve of the
 * whole fish. Returns EXIT_OK, or prints one error line and returns EXIT_USAGE. */
enum exit_code morph_curve_find(const struct species_card *card, const char *command,
                                const char *curve_name, uint32_t *curve);

#endif
