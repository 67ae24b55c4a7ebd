/* tickets.c -- runs the sequence of ledger entry and pulse for each ticket. */
#include "core/game/accounting/tickets.h"

#include "core/game/accounting/accounts.h"
#include "core/config.h"

void tickets_owe(struct accounts *accounts, const struct core_config *config, uint32_t count)
{
    struct balance *balance = &accounts->ledger.balance;
    if (config->rules_7) {
        accounts->credit.tickets += count;
        return;
    }
    const uint32_t room = BALANCE_TICKETS_MAX - balance->tickets;
    balance->tickets = (uint16_t)(balance->tickets + (count < room ? count : room));
}

/* Returns the number of owed tickets that are in the balance on disk. */
static uint32_t sure_tickets(const struct ledger *ledger)
{
    const uint16_t kept = ledger->committed.tickets, now = ledger->balance.tickets;
    return kept < now ? kept : now;
}

void tickets_tick(struct accounts *accounts, const struct core_config *config, uint32_t tick,
                  const struct input *input, struct output *output)
{
    struct ledger *ledger = &accounts->ledger;
    struct credit *credit = &accounts->credit;
    const struct ledger_entry entry = { .kind = LEDGER_TICKET, .count = 1 };
    if (credit->ticket_id != 0) {
        if (ledger_is_saved(ledger, credit->ticket_id)) {
            credit->tickets++;
            credit->ticket_id = 0;
        }
    } else if (!config->rules_7 && sure_tickets(ledger) > 0 &&
               input->tickets_done == credit->tickets && ledger_may_write(ledger, LEDGER_TICKET)) {
        ledger->balance.tickets--;
        credit->ticket_id = ledger_write(accounts, tick, &entry, output);
    }
}
