/* phases.h -- the phases of the game and the steps of a tick that belong to no phase.
 *
 * game_tick.c calls the tick function of the current phase, and a phase begins the next phase. A
 * new phase has its first tick in the following tick. core.c calls the functions of the score and
 * of the sessions. lab/lab.h, menu/menu.h and ranking/name.h declare the functions of the other
 * phases. */
#ifndef KINGYO_CORE_GAME_PHASES_H
#define KINGYO_CORE_GAME_PHASES_H

#include <stdint.h>

#include "core/game/game.h"
#include "core/poi/catch/catch.h"

struct settings_edit;

/* ---- State of the current phase -------------------------------------------------------------- */

/* Switches the game to `phase` (enum scene_phase). */
void game_enter_phase(struct game *game, uint8_t phase);

/* Returns 1 if player `index` may dip the poi. Dips are allowed in attract mode. In a round, dips
 * are allowed while the clock runs, time is left and the player is not out. Otherwise the poi stays
 * above the water. */
int game_may_scoop(const struct game *game, uint32_t index);

/* Returns 1 if the tank's pump bubbles at `tick`, otherwise 0. The pump is off during a round, as
 * the rules of the federation require. In attract mode the pump runs at intervals. Visitors
 * therefore see the fish surface for air and dive again. */
int game_pumps(const struct game *game, uint32_t tick);

/* Returns the seconds left in the round. In READY: seconds until the round begins. In mode
 * selection and name entry: seconds until the timeout. In other phases 0. */
float game_seconds_left(const struct game *game, uint32_t tick);

/* ---- Phases ---------------------------------------------------------------------------------- */

/* Attract mode: begins and runs the demonstration between games, in which the bot plays at the
 * configured tank. */
void attract_begin(struct game *game, struct world *world, const struct core_config *config);
void attract_tick(struct game *game, struct world *world, const struct core_config *config,
                  const struct input *input, struct output *output);

/* Handles a request to play. Without a credit the state stays unchanged. If players can choose
 * between several modes, the mode selection starts; otherwise READY starts immediately. */
void game_mode_select_begin(struct game *game, struct world *world,
                            const struct core_config *config, struct output *output);
void game_mode_select_tick(struct game *game, struct world *world, const struct core_config *config,
                           const struct input *input, struct output *output);

/* Starts a new round of the selected mode, with its tank, empty bowls and zero scores. */
void round_ready_begin(struct game *game, struct world *world, const struct core_config *config,
                       struct output *output);
void round_ready_tick(struct game *game, struct world *world, const struct core_config *config,
                      struct output *output);

/* Begins the round after READY and starts its clock. */
void round_begin(struct game *game, struct world *world, struct output *output);
void round_tick(struct game *game, struct world *world, const struct core_config *config,
                struct output *output);

/* Ends the round, logs its result and shows the result. */
void round_result_begin(struct game *game, struct world *world, const struct core_config *config,
                        struct output *output);
/* Ends a round whose credit is not refundable, because the operator's menu opens. The result is
 * logged but not shown. */
void round_result_skip(struct game *game, const struct world *world,
                       const struct core_config *config, struct output *output);
void round_result_tick(struct game *game, struct world *world, const struct core_config *config,
                       const struct input *input, struct output *output);

/* Returns the time announcement at `elapsed_ticks` into a round of `total_ticks`, or CALL_NONE.
 * Each announcement is returned in exactly one tick. A minute announcement is omitted if the round
 * is too short or has ten seconds or less left. */
enum time_call round_call_at(uint32_t elapsed_ticks, uint32_t total_ticks);

/* ---- Players --------------------------------------------------------------------------------- */

/* Returns 1 if the controller at `hand_m` has left its rest position, otherwise 0. */
int player_stirs(const struct player *player, vec3 hand_m);

/* Makes `hand_m` the rest position of the player's controller. */
void player_rests(struct player *player, vec3 hand_m);

uint64_t player_hash(uint64_t hash, const struct player *player);

/* Pauses during a round: the clock stops while a controller is lost, for a limited time. */

/* Runs one tick of the pause logic, before the other steps of a round. The round pauses while time
 * is left and a player who is not out has lost the controller. During a pause the clock stops and
 * dips are blocked. A player is out if the other players have waited too long, in one pause
 * (GAME_LOST_TICKS_OTHERS) or in total (GAME_WAIT_TICKS_OTHERS). */
void player_tick_pause(struct game *game, const struct world *world);

/* Returns 1 if player `index` has a poi in use: its source is the bot or a connected controller
 * with valid input. */
int player_has_poi(const struct world *world, uint32_t index);

/* ---- Fouls and score ------------------------------------------------------------------------- */

/* The umpire: detects fouls from the motion of pois and fish.
 *
 * Fouls are recorded in every mode, for the hints. In modes with judging rules a foul is also
 * announced and counted. A foul that lasts counts once, and so does a foul that recurs within
 * FOUL_APART_TICKS. The third counted foul ends a player's round. */

#define FOUL_APART_TICKS (2u * CORE_TICK_HZ)
/* Time for which a shadow must rest over fish before the start of a round to count as a foul. */
#define FOUL_SHADE_S 1.5f
/* First 1.2 s of READY, in which the player's stance is not checked. In that time a poi moves from
 * the rest position to its controller, and two of the longest frames pass. */
#define FOUL_SETTLE_TICKS 144u

/* Checks before the start for shadows held over fish. A fan's shadow is always a foul. A poi's
 * shadow is a foul only if its controller has moved since READY began. */
void score_fouls_before_start(struct game *game, const struct world *world, struct output *output);

/* Runs the last step of a tick: counts the fish that reached the bowls, as the mode's rules
 * require. */
void game_score(struct game *game, const struct world *world,
                const struct catch_result caught[POI_MAX], struct output *output);

/* Returns the record of the current round, or of the last round if none runs. The record's `id` is
 * 0. */
struct round_record game_record(const struct game *game, const struct world *world,
                                const struct core_config *config);

/* Logs the LEDGER_ROUND of a finished round that was not refunded. The entry also closes the
 * balance and updates the leaderboards. A round without players is not logged. A round in a mode
 * without a score produces no record. */
void score_keep(struct game *game, const struct world *world, const struct core_config *config,
                uint32_t tickets, struct output *output);

/* ---- Hints ----------------------------------------------------------------------------------- */

/* Hints for a player: one line of text at a time, about the next skill to learn.
 *
 * With several players the hints are for the first player who has a poi in use. The hint about a
 * lost controller is shown for any player. Each rule checks the player's actions and selects a
 * helpful hint. A hint stays until the player follows it. Within HINT_TICKS_MIN a hint is replaced
 * only if the player followed it or if an urgent hint must be shown. */

/* Evaluates the rules and updates `hints`. Call once per tick. The function changes no other
 * state. */
void hints_tick(struct hints *hints, const struct game *game, const struct world *world,
                const struct core_config *config);

uint64_t hints_hash(uint64_t hash, const struct hints *hints);

/* ---- Health log ------------------------------------------------------------------------------ */

/* The health log: ledger entries about starts, crashes, uptime and faults.
 *
 * The first entry of each start is LEDGER_BOOT. A round that was open at that time was interrupted
 * by a crash or a power cut, and its credit is refunded if it is refundable. A LEDGER_HEALTH is
 * logged every two minutes and whenever the operator opens the menu. Each LEDGER_HEALTH contains
 * the uptime and the faults since the previous LEDGER_HEALTH. */

/* Logs repeated losses of each slot's controller. Call once per tick of the round, after
 * player_tick_pause(). */
void health_log_note_losses(struct game *game, const struct world *world,
                            const struct core_config *config, struct output *output);

/* Logs the boot entry and the health entries at their scheduled times. Call once per tick, before
 * any other entry of the tick. */
void health_log_tick(struct game *game, const struct core_config *config, const struct input *input,
                     struct output *output);

/* Logs a LEDGER_HEALTH immediately. */
void health_log_write(struct accounts *accounts, struct health_log *health_log, uint32_t tick,
                      const struct input *input, struct output *output);

/* Fills `out` with the final LEDGER_HEALTH for a shutdown after the last tick, with the next id.
 * The core's state does not change, so the state still matches the session's recording. Returns 1,
 * or 0 if the kiosk has no store. */
int health_log_final(const struct accounts *accounts, const struct health_log *health_log,
                     uint32_t tick, const struct input *input, struct ledger_entry *out);

uint64_t health_log_hash(uint64_t hash, const struct health_log *health_log);

/* ---- Sessions -------------------------------------------------------------------------------- */

/* Sessions: the periods into which the running time is divided. Each session has one recording.
 *
 * A new session begins at each start of attract mode, and after every ten minutes in attract mode.
 * At the start of a session the core restarts from its configuration, with the state that
 * core_init() creates. The tank and the seed are new. Money, ledger, audits, leaderboards, saved
 * graphs and the tick number continue.
 *
 * The configuration and the inputs since the session's start reproduce any round of the session. A
 * round starts at most ten minutes plus its own waiting time after the session's start. The player
 * sees a short fade to dark when a session starts. */

/* Requests a new session. The session starts when the picture is dark, if attract mode is still
 * active at that time. */
void session_request(struct game *game);

/* Returns 1 if the finished tick was the last tick of the session, otherwise 0. */
int session_is_over(const struct game *game);

/* Writes the configuration of the next session to `config`. The caller then initializes the game
 * and the world from `config`, as core_init() does. */
void session_restart(const struct game *game, struct core_config *config);

/* Copies the state in `session` to a newly initialized game. Does nothing at the kiosk's start. */
void session_restore(struct game *game, const struct game_session *session);

/* Returns the darkness of the picture, [0, 1]; 1 at the start of a session. */
float session_fade(const struct game *game, const struct core_config *config);

uint64_t session_hash(uint64_t hash, const struct game_session *session, int rules_7);

/* ---- Language -------------------------------------------------------------------------------- */

/* The display language. The operator's setting is the default, and a visitor may choose a
 * different language for a limited time.
 *
 * A language chosen during a game lasts until attract mode begins. A language chosen in attract
 * mode lasts for LANGUAGE_TICKS after the last press. Under the rules of format 7 a choice does
 * not end. */

/* Changes to the next language when the LANGUAGE button is pressed. Ends a choice after
 * LANGUAGE_TICKS in attract mode. */
void session_language_tick(struct game *game, const struct core_config *config,
                           const struct input *input);

/* Resets the display to the operator's language at the start of attract mode. */
void session_language_reset(struct game *game, const struct core_config *config);

/* Returns `hash` continued over `choice`. Without a choice `hash` is returned unchanged, so that
 * hashes of older recordings stay valid. */
uint64_t session_language_hash(uint64_t hash, const struct language_choice *choice);

#endif
