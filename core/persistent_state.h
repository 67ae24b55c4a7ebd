/* persistent_state.h -- the persistent state, which the store loads at startup and the core then
 * updates. All fields are 0 if nothing was stored. */
#pragma once

#include "core/game/accounting/audits.h"
#include "core/game/ranking/ranking.h"
#include "core/ledger.h"
#include "core/settings.h"

struct persistent_state {
    struct ledger_start ledger;
    /* Stored settings. A value that settings_allows() rejects is replaced by its default. */
    struct settings settings;
    struct audits audits;
    struct ranking ranking;
};
