/* state_writer.c -- writes the state of the game in the guest to a file, as lines of a name and a
 * value.
 *
 * Usage: state_writer RECORDING FILE
 *
 * The program recomputes the state from the kiosk's recording (twin.h). FILE is rewritten whenever
 * the recording has grown, until a signal ends the program. */
#include <signal.h>
#include <stdio.h>
#include <time.h>

#include "core/game/menu/menu_pages.h"
#include "tests/vm/twin.h"
#include "tests/unit/support/menu_tag.h"

/* Time between two reads of the recording, in ns. The recording grows once a second. */
#define POLL_NS 100000000

static volatile sig_atomic_t must_end;

static void on_signal(int number)
{
    (void)number;
    must_end = 1;
}

/* Prints the value of the first row of the open menu page that has arrows, and the middles of its
 * arrows on the canvas. */
static void print_arrows(FILE *file, const struct core *core)
{
    const struct menu *menu = &core->game.menu;
    for (uint32_t tag = 0; tag < menu_tag_count(menu->page, 0); tag++) {
        if (menu_has_arrows(menu->page, 0, tag)) {
            const struct layout_box row = menu_box(false, menu->page, 0, menu_enabled(menu), tag);
            const struct layout_box lower = menu_arrow_box(row, true);
            const struct layout_box raise = menu_arrow_box(row, false);
            fprintf(file, "arrow_value %d\narrows_y %.0f\nlower_x %.0f\nraise_x %.0f\n",
                    core->config.persistent.settings.value[menu_setting_at(menu->page, 0, tag)],
                    (double)(lower.y + 0.5f * lower.height), (double)(lower.x + 0.5f * lower.width),
                    (double)(raise.x + 0.5f * raise.width));
            return;
        }
    }
}

static void print_state(FILE *file, const struct twin *twin)
{
    static const char *const buttons[] = { "start", "left",    "right", "ok",  "language",
                                           "test",  "service", "tilt",  "door" };
    const struct core *core = &twin->core;
    const struct balance *balance = &core->game.accounts.ledger.balance;
    fprintf(file, "ticks %u\ndiffers_at %u\n", twin->ticks, twin->differs_at);
    for (unsigned i = 0; i < sizeof buttons / sizeof buttons[0]; i++) {
        fprintf(file, "%s %u\n", buttons[i], twin->presses[i]);
    }
    fprintf(file, "coins %u\ncredits %u\ntaken %u\n", twin->coins, balance->paid + balance->service,
            core->game.round_count);
    const struct menu *menu = &core->game.menu;
    fprintf(file, "fallen %u\ngiven_back %u\nmetered %u\n", balance->units,
            core->game.accounts.audits.count[AUDIT_REFUNDS], core->game.accounts.credit.metered);
    fprintf(file, "on_top %d\non_devices %d\non_lines %d\non_upkeep %d\non_files %d\non_sound %d\n",
            menu->page == MENU_TOP, menu->page == MENU_DEVICES, menu->page == MENU_LINES,
            menu->page == MENU_UPKEEP, menu->page == MENU_FILES, menu->page == MENU_SOUND);
    fprintf(
        file, "to_devices %u\nto_lines %u\nto_upkeep %u\nto_files %u\nto_sound %u\nto_back %u\n",
        menu_tag_of(MENU_DEVICES), menu_tag_of(MENU_LINES), menu_tag_of(MENU_UPKEEP),
        menu_tag_of(MENU_FILES), menu_tag_of(MENU_SOUND), menu_tag_count(menu->page, false) - 1u);
    fprintf(file, "asks %d\npage %u\ntag %u\ntest_coins %u\nfiles %u\n",
            menu_is_confirming(&core->game), menu->page, menu->tag[menu->page], menu->test_coins,
            menu->controllers.file_count);
    print_arrows(file, core);
    const uint8_t phase = core->game.phase;
    fprintf(file, "is_ready %d\nis_round %d\n", phase == PHASE_READY, phase == PHASE_ROUND);
    fprintf(file, "phase %u\npaused %u\nrounds %u\ncaught %u\n", phase, core->game.paused,
            core->game.round_count, twin->caught);
    fprintf(file, "level %u\nstart_ms %u\ndip_ms %u\n", core->game.player[0].level,
            twin->start_tick * 1000u / CORE_TICK_HZ, twin->dip_tick * 1000u / CORE_TICK_HZ);
    fprintf(file, "link %u\nlost_spans %u\nlost_ms %u\npaused_ms %u\n", twin->input.poi[0].link,
            twin->lost_spans, twin->lost_ticks * 1000u / CORE_TICK_HZ,
            twin->paused_ticks * 1000u / CORE_TICK_HZ);
    const vec3 at = twin->input.poi[0].target.position_m;
    fprintf(file, "hand_mm %.1f %.1f %.1f\n", (double)at.x * 1e3, (double)at.y * 1e3,
            (double)at.z * 1e3);
}

/* Writes the state to a temporary file and then renames the file, so that the program that reads
 * the state never gets an incomplete one. */
static int write_state(const char *path, const struct twin *twin)
{
    char part[512];
    snprintf(part, sizeof part, "%s.new", path);
    FILE *file = fopen(part, "w");
    if (!file) {
        return 0;
    }
    print_state(file, twin);
    return fclose(file) == 0 && rename(part, path) == 0;
}

int main(int argc, char **argv)
{
    static struct twin twin;
    const struct sigaction action = { .sa_handler = on_signal };
    const struct timespec rest = { .tv_nsec = POLL_NS };
    if (argc != 3) {
        fprintf(stderr, "usage: state_writer RECORDING FILE\n");
        return 2;
    }
    sigaction(SIGTERM, &action, NULL);
    twin.path = argv[1];
    for (;;) {
        const int more = twin_follow(&twin);
        if (more != 0 && !write_state(argv[2], &twin)) {
            perror(argv[2]);
            return 74;
        }
        if (more < 0 || (more == 0 && must_end)) {
            return more < 0 ? 65 : 0;
        }
        nanosleep(&rest, NULL);
    }
}
