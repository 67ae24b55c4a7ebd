/* accounts.h -- the accounts of the kiosk: the ledger, the credits, the audits and the
 * leaderboards.
 *
 * The ledger is the append-only list of money events. ledger_write() also adds each entry to the
 * audits, which are the operator's statistics, and to the leaderboards. A function that writes an
 * entry therefore takes `struct accounts`. A function that works on one account takes only that
 * account. */
#ifndef KINGYO_CORE_GAME_ACCOUNTING_ACCOUNTS_H
#define KINGYO_CORE_GAME_ACCOUNTING_ACCOUNTS_H

#include "core/game/accounting/audits.h"
#include "core/game/accounting/credit.h"
#include "core/game/accounting/ledger_writer.h"
#include "core/game/ranking/ranking.h"

struct accounts {
    struct ledger ledger;
    struct credit credit;
    struct audits audits;
    struct ranking ranking;
};

#endif
