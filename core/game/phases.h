/* phases.h -- the phases of the game and the steps of a tick that belong to no phase.
 *
 * game_tick.c calls the tick function of the current phase, and a phase begins the next phase. A
 * new phase has its first tick in the following tick. core.c calls the functions of the score and
 * of the sessions. lab/lab.h, menu/menu.h and ranking/name.h declare the functions of the other
 * phases. */
#pragma once

#include <stdbool.h>
#include <stdint.h>

#include "core/game/game.h"
#include "core/poi/catch/catch.h"

/* ---- State of the current phase -------------------------------------------------------------- */

/* Switches the game to the phase `phase` (enum scene_phase). */
void game_enter_phase(struct game *game, uint8_t phase);

/* Returns true if player `index` may dip the poi. Dips are allowed in attract mode. In a round,
 * dips are allowed while the clock runs, time is left and the player is not out. Otherwise the poi
 * stays above the water. */
bool game_may_scoop(const struct game *game, uint32_t index);

/* Returns true if the tank's pump bubbles at `tick`. The pump is off during a round, as the rules
 * of the federation require. In attract mode the pump runs at intervals. Visitors therefore see the
 * fish surface for air and dive again. */
bool game_pumps(const struct game *game, uint32_t tick);

/* Returns the seconds left in the round. In READY: seconds until the round begins. In mode
 * selection and name entry: seconds until the timeout. In other phases 0. */
float game_seconds_left(const struct game *game, uint32_t tick);

/* ---- Start and tick of each phase ------------------------------------------------------------ */

/* Functions that run one tick of attract mode, of the mode selection, of READY (the phase before a
 * round), of the round, or of the result screen. */
game_phase_tick attract_tick, game_mode_select_tick;
game_phase_tick round_ready_tick, round_tick, round_result_tick;

/* Begins attract mode, the demonstration between two games. In attract mode the built-in bot plays
 * at the configured tank. */
void attract_begin(struct game *game, struct world *world, const struct core_config *config);

/* Returns the tag (core/game/mode_tags.h) that `player` has selected in the mode selection. All
 * players share the mode, and each player has a separate level. */
uint32_t game_mode_select_tag(const struct game *game, uint32_t player);

/* Returns the player for whom the buttons select: the first player with a connected controller, or
 * player 0 if no controller is connected. */
uint32_t game_mode_select_lead(const struct world *world);

/* Handles a request to play. Without a credit the state stays unchanged. If players can choose
 * between several modes, the mode selection starts; otherwise READY starts immediately. If the
 * session must end after the last game, attract mode starts instead, and repeats the request in the
 * new session. */
void game_mode_select_begin(struct game *game, struct world *world,
                            const struct core_config *config, struct output *output);

/* Starts a new round of the selected mode, with its tank, empty bowls and zero scores. */
void round_ready_begin(struct game *game, struct world *world, const struct core_config *config,
                       struct output *output);

/* Ends a round whose credit is not refundable, because the operator opens the menu. The result is
 * logged but not shown. */
void round_result_skip(struct game *game, const struct world *world,
                       const struct core_config *config, struct output *output);

/* Returns the time announcement at `elapsed_ticks` into a round of `total_ticks`, or CALL_NONE.
 * Each announcement is returned in exactly one tick. A minute announcement is omitted if the round
 * is too short or has ten seconds or less left. */
enum time_call round_call_at(uint32_t elapsed_ticks, uint32_t total_ticks);

/* ---- Players and their controllers ----------------------------------------------------------- */

/* Returns true if the player's controller, whose position is `hand_m`, has left its rest
 * position. */
bool player_stirs(const struct player *player, vec3 hand_m);

/* Stores `hand_m` as the rest position of the player's controller. */
void player_rests(struct player *player, vec3 hand_m);

/* Pauses of a round. While a player's controller is lost, the clock of the round stops for a
 * limited time. */

/* Runs one tick of the pause logic, before the other steps of a round. The round pauses while time
 * is left and a player who is not out has lost the controller. During a pause the clock stops and
 * dips are blocked. A player is out if the other players have waited too long, in one pause
 * (GAME_LOST_TICKS_OTHERS) or in total (GAME_WAIT_TICKS_OTHERS). */
void player_tick_pause(struct game *game, const struct world *world);

/* Returns true if player `index` has a poi in use. The source of such a poi is the bot or a
 * connected controller with valid input. */
bool player_has_poi(const struct world *world, uint32_t index);

/* ---- Fouls of the players, and score of a round ---------------------------------------------- */

/* Fouls: actions that the rules of the game forbid, such as a shadow that is held over fish before
 * the start. The functions detect fouls from the motion of pois and fish.
 *
 * Fouls are recorded in every mode, because hints explain them. In modes with an umpire a foul is
 * also announced and counted. A foul counts once for as long as it lasts. The same foul does not
 * count again within FOUL_APART_TICKS. The third counted foul ends the player's round. */

#define FOUL_APART_TICKS (2u * CORE_TICK_HZ)
/* Time in seconds after which a shadow that rests over fish before the start of a round is a
 * foul. */
#define FOUL_SHADE_S 1.5f
/* Length of the first part of READY (1.2 s), in which motion of a controller does not count as
 * motion by the player. In this part the poi still moves from its rest position to the controller's
 * pose. The pose of a pointer may also jump for two frames, because the view has changed. The
 * length is therefore more than two of the longest frames. */
#define FOUL_SETTLE_TICKS 144u

/* Detects shadows that are held over fish before the start of a round, and records them as fouls. A
 * fan's shadow is always a foul. A poi's shadow is a foul only if its controller has moved since
 * READY began. `is_turned` is as in game_score(). */
void score_fouls_before_start(struct player player[POI_MAX], const struct game *game,
                              const struct world *world, bool is_turned, struct output *output);

/* Runs the last step of a tick: counts the fish that reached the bowls, as the mode's rules
 * require. `is_turned` is as in struct input, so that the sound of a foul comes from the player's
 * side. */
void game_score(struct player player[POI_MAX], struct album *album, const struct game *game,
                const struct world *world, const struct catch_result caught[POI_MAX],
                bool is_turned, struct output *output);

/* Returns the easiest level of the players in the current round, or in the last round until attract
 * mode begins. All fish follow this level, and all scores of the round rank at this level. Only
 * players who play or have a poi in use count. Without players the level is LEVEL_MASTER. */
uint8_t game_level(const struct game *game);

/* Returns the record (scores and statistics) of the current round, or of the last round if no round
 * runs. The member `id` of the record is 0. */
struct round_record game_record(const struct game *game, const struct world *world,
                                const struct core_config *config);

/* Writes the ledger entry LEDGER_ROUND of a finished round whose credit was not refunded. The entry
 * also marks the round as closed in the balance, and updates the leaderboards. A round without
 * players is not logged. A round in a mode without a score is marked as unscored and is not
 * ranked. */
void score_keep(struct accounts *accounts, struct name *name, const struct game *game,
                const struct world *world, const struct core_config *config, uint32_t tickets,
                struct output *output);

/* ---- Hints for players ----------------------------------------------------------------------- */

/* A hint is one line of text about the next skill that the player should learn. At most one hint
 * is shown at a time.
 *
 * With several players the hints are for the first player who has a poi in use. The hint about a
 * lost controller is shown for any player. Each rule checks the player's actions and selects a
 * helpful hint. A hint stays until the player follows it. Within HINT_TICKS_MIN a hint is replaced
 * only if the player followed it or if an urgent hint must be shown. */

/* Selects the hint to show and stores it in `hints`. Call once per tick. The function changes no
 * other state. */
void hints_tick(struct hints *hints, const struct game *game, const struct world *world,
                const struct core_config *config);

/* Writes to `hints` the hint that fits the situation of the player `hints->pupil` now, and the tick
 * since which the hint fits. Must be called once per tick of READY and of the round. The lessons
 * (core/game/lesson/lesson.h) decide whether the hint is shown. */
void hints_player_tick(struct hints *hints, const struct game *game, const struct world *world);

/* Returns true if the hint `next` may replace the hint `shown`, which has been visible for
 * `shown_ticks` beside `poi`. */
bool hints_may_change(uint8_t shown, uint8_t next, uint32_t shown_ticks, const struct poi *poi);

/* ---- Health log: starts, crashes, uptime and faults ------------------------------------------ */

/* The health log: ledger entries about starts, crashes, uptime and faults.
 *
 * The first entry of each start is LEDGER_BOOT. A round that was open at that time was interrupted
 * by a crash or a power cut, and its credit is refunded if it is refundable. A LEDGER_HEALTH is
 * logged every two minutes and whenever the operator opens the menu. Each LEDGER_HEALTH contains
 * the uptime and the faults since the previous LEDGER_HEALTH. */

/* Logs repeated losses of the controller of each player slot. Call once per tick of the round,
 * after player_tick_pause(). */
void health_log_note_losses(struct accounts *accounts, struct health_log *health_log,
                            const struct game *game, const struct world *world,
                            struct output *output);

/* Logs the start of the kiosk, and logs uptime and faults at regular intervals. Call once per tick,
 * before any other entry of the tick. */
void health_log_tick(struct accounts *accounts, struct health_log *health_log,
                     const struct game *game, const struct core_config *config,
                     const struct input *input, struct output *output);

/* Writes the ledger entry LEDGER_HEALTH (uptime and faults) immediately. */
void health_log_write(struct accounts *accounts, struct health_log *health_log, uint32_t tick,
                      const struct input *input, struct output *output);

/* Prepares the last ledger entry before a shutdown, after the last tick: fills `out` with a
 * LEDGER_HEALTH that has the next id. The core's state does not change, so the state still matches
 * the session's recording. Returns true. Returns false if the kiosk has no store, or if the next id
 * would be above LEDGER_ID_MAX; `out` must then not be used. */
bool health_log_final(const struct accounts *accounts, const struct health_log *health_log,
                      uint32_t tick, const struct input *input, struct ledger_entry *out);

/* ---- Sessions and their recordings ----------------------------------------------------------- */

/* Sessions: the periods into which the running time is divided. Each session has one recording.
 *
 * A new session begins at each start of attract mode, and after every ten minutes in attract mode.
 * At the start of a session the core restarts from its configuration, with the state that
 * core_init() creates. The tank and the seed are new. Money, ledger, audits, leaderboards, saved
 * graphs and the tick number continue.
 *
 * The configuration and the inputs since the session's start reproduce any round of the session.
 * Games that follow each other without attract mode belong to one session. The last of these games
 * starts at most ten minutes after the session's start, so that a session lasts for at most ten
 * minutes and a game. The player sees a short fade to dark when a session starts. */

/* Returns true if the session has lasted for SESSION_TICKS_MAX, so that no further game may start
 * in it. Always false in recordings of format 9 and older. */
bool session_must_end(const struct game *game, const struct core_config *config);

/* Requests a new session, which means that the core reinitializes itself from its configuration.
 * The session starts when the picture has faded to dark, if attract mode is still active at that
 * time. */
void session_request(struct game *game);

/* Returns true if the finished tick was the last tick of the session, so that the core must be
 * reinitialized. */
bool session_is_over(const struct game *game);

/* Writes the configuration of the next session to `config`. The caller then initializes the game
 * and the world from `config`, as core_init() does. */
void session_restart(const struct game *game, struct core_config *config);

/* Copies `session`, the state carried over from the previous session, to a newly initialized game.
 * Does nothing at the kiosk's start, when no previous session exists. */
void session_restore(struct game *game, const struct game_session *session);

/* Returns the darkness of the picture for the fade between two sessions, [0, 1]. The picture is
 * black (1) at the start of a session. */
float session_fade(const struct game *game, const struct core_config *config);

/* ---- Display language ------------------------------------------------------------------------ */

/* The display language. The operator's setting is the default, and a visitor may choose a different
 * language for a limited time.
 *
 * A language chosen during a game lasts until attract mode begins. A language chosen in attract
 * mode lasts for LANGUAGE_TICKS after the last press. In a recording of the older format 7, a
 * visitor's choice does not end. */

/* Switches to the next language when the LANGUAGE button is pressed. Ends a visitor's choice of a
 * language after LANGUAGE_TICKS in attract mode. */
void session_language_tick(struct game *game, const struct core_config *config,
                           const struct input *input);

/* Resets the display to the operator's language at the start of attract mode. */
void session_language_reset(struct game *game, const struct core_config *config);
