/* wetting.h -- wetting of the paper: immersion, wicking and softening. */
#ifndef KINGYO_CORE_POI_PAPER_WETTING_H
#define KINGYO_CORE_POI_PAPER_WETTING_H

#include "core/poi/paper/sheet.h"

/* Advances one tick. Paper under the line becomes wet, dry paper wicks water from wet paper, and
 * wet paper softens for a minute. */
void wetting_tick(struct sheet *sheet, struct sheet_wetting wet);

/* Returns [0, 1], the strength of the line between wet and dry paper through a cell. */
float wetting_line(const struct sheet *sheet, uint32_t row, uint32_t column);

/* Returns the share of its initial wet strength that a cell still has. */
static inline float wetting_strength(const struct sheet *sheet, uint32_t cell)
{
    return 1.0f - SHEET_SOFTENING * (float)sheet->soak_ticks[cell] / (float)SHEET_SOAK_TICKS;
}

#endif
