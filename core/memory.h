/* memory.h -- what the store remembers when the kiosk starts, and the core goes on from.
 * Zero: nothing was ever kept. */
#ifndef KINGYO_CORE_MEMORY_H
#define KINGYO_CORE_MEMORY_H

#include "core/game/audits.h"
#include "core/game/ranking.h"
#include "core/ledger.h"
#include "core/settings.h"

struct memory {
    struct ledger_start ledger;
    struct settings settings; /* A value that setting_allows() not is the standard's. */
    struct audits audits;
    struct ranking ranking;
};

#endif
