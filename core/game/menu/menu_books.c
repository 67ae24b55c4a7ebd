/* menu_books.c -- resets a group of statistics, and logs the reset in the ledger. */
#include "core/game/game.h"
#include "core/config.h"
#include "core/game/menu/menu_internal.h"

void menu_book_activate(struct game *game, struct core_config *config, uint32_t tag,
                        struct output *output)
{
    (void)tag;
    (void)output;
    game->menu.from = game->menu.page;
    menu_turn(game, &config->persistent.settings, MENU_RESET);
}

/* Returns the sum of the group's counters. The ledger entry stores the sum, so that later reports
 * can show the amount that was removed. */
static int32_t sum_of(const struct audits *audits, enum audit_group group)
{
    uint32_t sum = 0;
    for (uint32_t id = 0; id < AUDIT_COUNT; id++) {
        const uint32_t count = audits_group_of(id) == group ? audits->count[id] : 0u;
        sum = (uint32_t)INT32_MAX - sum < count ? (uint32_t)INT32_MAX : sum + count;
    }
    return (int32_t)sum;
}

/* If the ledger has no room, the page that requests confirmation stays open. */
void menu_reset_activate(struct game *game, struct core_config *config, uint32_t tag,
                         struct output *output)
{
    const uint8_t from = game->menu.from, group = menu_page_desc_of(from)->about;
    const struct ledger_entry entry = {
        .kind = LEDGER_RESET,
        .detail = group,
        .value = sum_of(&game->accounts.audits, (enum audit_group)group),
    };
    (void)tag;
    if (ledger_write(&game->accounts, game->tick, &entry, output) != 0) {
        menu_turn(game, &config->persistent.settings, (enum menu_page)from);
    }
}
