/* morph_curve.c -- finds a curve of a deformation graph by its name. */
#include "platform/ctl/morph/morph_curve.h"

#include <stdio.h>
#include <string.h>

enum exit_code morph_curve_find(const struct species_card *card, const char *command,
                                const char *curve_name, uint32_t *curve)
{
    char list[MORPH_CURVE_MAX * (SPECIES_NAME_SIZE + 2u)] = "";
    *curve = 0;
    if (!curve_name) {
        return EXIT_OK;
    }
    for (uint32_t i = 0; i < card->curve_count; i++) {
        if (strcmp(curve_name, card->curve_names[i]) == 0) {
            *curve = i;
            return EXIT_OK;
        }
        const size_t used = strlen(list);
        snprintf(list + used, sizeof list - used, "%s%s", used ? ", " : "", card->curve_names[i]);
    }
    return morph_usage(command, "--curve: '%.40s' is none of %s", curve_name, list);
}
