/* wetting.h -- simulates the wetting of a poi's paper: immersion, wicking and softening. */
#ifndef KINGYO_CORE_POI_PAPER_WETTING_H
#define KINGYO_CORE_POI_PAPER_WETTING_H

#include "core/poi/paper/sheet.h"

/* Advances the wetness of a sheet by one tick (1/120 s). Paper in the half-plane `wet` is under
 * water and becomes wet, dry paper wicks water from wet paper, and wet paper becomes softer for one
 * minute. */
void wetting_tick(struct sheet *sheet, struct sheet_wetting wet);

/* Returns how strongly a cell lies on the line between wet and dry paper, from 0 (not on the line)
 * to 1 (on a fully developed line). */
float wetting_line(const struct sheet *sheet, uint32_t row, uint32_t column);

/* Returns the fraction of the initial wet strength that a cell still has after softening. */
static inline float wetting_strength(const struct sheet *sheet, uint32_t cell)
{
    return 1.0f - SHEET_SOFTENING * (float)sheet->soak_ticks[cell] / (float)SHEET_SOAK_TICKS;
}

#endif
