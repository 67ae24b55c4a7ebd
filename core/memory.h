/* memory.h -- the persistent state that the store loads at startup and the core continues from. All
 * zero: nothing was stored. */
#ifndef KINGYO_CORE_MEMORY_H
#define KINGYO_CORE_MEMORY_H

#include "core/game/audits.h"
#include "core/game/ranking.h"
#include "core/ledger.h"
#include "core/settings.h"

struct persistent_state {
    struct ledger_start ledger;
    struct settings settings; /* A value that settings_allows() rejects is replaced by its
                                 default. */
    struct audits audits;
    struct ranking ranking;
};

#endif
