/* soak.h -- how paper takes up water: what is under the surface, what creeps, what softens. */
#ifndef KINGYO_CORE_POI_SOAK_H
#define KINGYO_CORE_POI_SOAK_H

#include "core/poi/sheet.h"

/* One tick. Paper under the line gets wet; beside wet paper dry paper drinks; what is wet softens
 * on for a minute. */
void soak_tick(struct sheet *sheet, struct sheet_wetting wet);

/* [0, 1]: how full a line between wet and dry paper runs through a cell. */
float soak_line(const struct sheet *sheet, uint32_t row, uint32_t column);

/* Of its strength when freshly wet, what a cell still has. */
static inline float soak_keeps(const struct sheet *sheet, uint32_t cell)
{
    return 1.0f - SHEET_SOFTENING * (float)sheet->soak_ticks[cell] / (float)SHEET_SOAK_TICKS;
}

#endif
