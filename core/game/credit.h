/* credit.h -- what was paid: coins become credits, and a credit buys the tank a round.
 *
 * One credit plays for everybody who has a poi in hand: it is the tank that is hired. It is taken
 * when what was chosen begins, not when START is pressed: who only looks at the choice and leaves
 * has paid nothing. It comes back when that round ends because the pois' controllers went and
 * nobody came again, or because the operator opened the menu.
 * All of it is kept in memory only. */
#ifndef KINGYO_CORE_GAME_CREDIT_H
#define KINGYO_CORE_GAME_CREDIT_H

#include <stdint.h>

#define CREDIT_COINS_MAX 20u /* A round that costs more is paid with banknotes. */
#define CREDIT_TICKET_FISH_MAX 20u /* More than most people catch. */

#endif
