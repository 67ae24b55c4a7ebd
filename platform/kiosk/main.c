/* main.c -- the program `kingyo`: parses the options, detects a screen and runs the kiosk or the
 * demonstration. */
#include <signal.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "platform/board.h"
#include "platform/config/config_file.h"
#include "platform/config/options.h"
#include "platform/kiosk/demo.h"
#include "platform/kiosk/run_common.h"
#include "platform/kiosk/video.h"
#include "platform/os/log.h"
#include "platform/os/print.h"
#include "platform/os/file.h"
#include "platform/os/panic.h"

static volatile sig_atomic_t stop;
/* State of the program. The variable is static because the structure of several MB is too large for
 * the stack. */
static struct run_common evening;

static void on_signal(int number)
{
    (void)number;
    stop = 1;
}

/* Reports a rejected line of the configuration file in the log and in the operator's menu. */
static void warn_of_config(const char *line)
{
    log_print(LOG_LEVEL_WARNING, "%s", line);
    run_common_note_refused(&evening, line);
}

/* Returns the language of the machine's locale: Japanese, or English in all other cases. The
 * demonstration ignores the locale because its result must be identical on every machine. */
static uint8_t machine_language(void)
{
    static const char *const names[] = { "LC_ALL", "LC_MESSAGES", "LANG" };
    for (size_t i = 0; i < sizeof names / sizeof names[0]; i++) {
        const char *value = getenv(names[i]);
        if (value && value[0]) {
            return strncmp(value, "ja", 2) == 0 ? LANGUAGE_JA : LANGUAGE_EN;
        }
    }
    return LANGUAGE_EN;
}

/* Returns the path of the configuration file to read, or null. A path on the command line is
 * preferred. Otherwise the path is CONFIG_FILE_DEFAULT if the file exists. A demonstration or a
 * video reads only a file named on the command line, because its result must be identical on every
 * machine. */
static const char *config_of(const struct options *options)
{
    static char named[OPTIONS_PATH_MAX];
    if (options->config[0]) {
        memcpy(named, options->config, sizeof named);
        return named;
    }
    const bool is_fixed = options->demo || options->video[0];
    return !is_fixed && access(CONFIG_FILE_DEFAULT, F_OK) == 0 ? CONFIG_FILE_DEFAULT : NULL;
}

/* Reads the configuration file `path`. Returns EXIT_IO if a file named on the command line cannot
 * be read. If CONFIG_FILE_DEFAULT cannot be read, the kiosk starts without a configuration file. */
static enum exit_code read_config(struct options *options, const char *path)
{
    char line[OPTIONS_PATH_MAX + 64];
    const bool is_named = options->config[0] != '\0';
    *options = (struct options){ .demo_s = OPTIONS_DEMO_S };
    const int failed = config_file_read(options, path, warn_of_config);
    if (failed) {
        snprintf(line, sizeof line, "%s: cannot read: %s", path, file_error(-failed));
        log_print(LOG_LEVEL_WARNING, "%s", line);
        if (!is_named) {
            run_common_note_refused(&evening, line);
        }
    }
    return failed && is_named ? EXIT_IO : EXIT_OK;
}

/* Parses the command line, reads the configuration file that the command line names, and parses the
 * command line again. The second pass overrides the configuration file. */
static enum exit_code read_options(struct options *options, int argc, char **argv)
{
    char error[OPTIONS_ERROR_MAX];
    const char *const *words = (const char *const *)argv;
    *options = (struct options){ .demo_s = OPTIONS_DEMO_S };
    int failed = options_parse(options, argc, words, error);
    const char *config = failed || options->help || options->version ? NULL : config_of(options);
    if (config) {
        const enum exit_code code = read_config(options, config);
        if (code != EXIT_OK) {
            return code;
        }
        failed = options_parse(options, argc, words, error);
    }
    if (failed) {
        return log_fail(EXIT_USAGE, LOG_LEVEL_WARNING, "%s", error);
    }
    return EXIT_OK;
}

static void panic_handler(void *self, const char *reason)
{
    struct run_common *session = self;
    const bool is_sound = panic_evidence_write(&session->evidence, reason);
    if (is_sound && session->options.record[0]) {
        recorder_end_in_panic(&session->recorder);
    }
}

static enum exit_code run_without_screen(struct run_common *session, const char *why)
{
    if (session->options.selftest_s > 0) {
        return log_fail(EXIT_NOT_SO, LOG_LEVEL_ERROR, "the self-test needs a screen: %s", why);
    }
    print_line(stdout, "No screen: %s. %s", why,
               session->options.replay[0] ? "The replay is checked, and pictures of it are written."
                                          : "The bot plays, and pictures are written.");
    fflush(stdout);
    return demo_run(session);
}

static enum exit_code kiosk_main_run(struct run_common *session)
{
    char why[HAL_TEXT_SIZE];
    struct options *options = &session->options;
    if (options->demo) {
        return demo_run(session);
    }
    if (options->video[0]) {
        return video_run(session);
    }
    if (!run_interactive_waits_for_screen() && !board_has_screen(why, sizeof why)) {
        return run_without_screen(session, why);
    }
    options->machine.is_set[SET_LANGUAGE] = 1;
    options->machine.value[SET_LANGUAGE] = machine_language();
    if (!run_interactive_open(session)) {
        const struct hal_display *display = &session->hal.display;
        options->machine.is_set[SET_LANGUAGE] = 0;
        return run_without_screen(session, display->ops->describe(display->self));
    }
    return run_interactive_run(session);
}

/* Replaces this process by a new process of the same program with the same options. If the package
 * was updated, the new process runs the new version. */
static void begin_anew(const struct run_common *session, char **argv)
{
    if (session->options.record[0]) {
        log_print(LOG_LEVEL_WARNING,
                  "a restart would overwrite the recording; start kingyo again by hand");
        return;
    }
    execvp(argv[0], argv);
    execv("/proc/self/exe", argv);
    log_print(LOG_LEVEL_WARNING, "cannot restart; start kingyo again by hand");
}

static enum exit_code run_words(int argc, char **argv)
{
    enum exit_code code = read_options(&evening.options, argc, argv);
    if (code != EXIT_OK) {
        return code;
    }
    if (evening.options.help) {
        options_print_help();
        return EXIT_OK;
    }
    if (evening.options.version) {
        printf("kingyo %s\n", KINGYO_VERSION);
        return EXIT_OK;
    }
    struct sigaction action = { .sa_handler = on_signal };
    sigemptyset(&action.sa_mask);
    sigaction(SIGINT, &action, NULL);
    sigaction(SIGTERM, &action, NULL);
    signal(SIGPIPE, SIG_IGN);
    panic_prepare(panic_handler, &evening);
    /* The kiosk also starts if its data folder cannot be used. The store then reports the
     * reason. */
    code = evening.options.shots[0] ? run_common_make_folder(evening.options.shots) : EXIT_OK;
    if (code == EXIT_OK) {
        code = run_common_check(&evening);
    }
    if (code == EXIT_OK) {
        code = kiosk_main_run(&evening);
    }
    if (evening.kiosk.end == KIOSK_RESTART) {
        if (evening.kiosk.restart_ns == 0) {
            log_print(LOG_LEVEL_WARNING,
                      "the store became available; kingyo restarts to use its data");
        }
        begin_anew(&evening, argv);
    }
    return code;
}

/* Runs the program. Failed writes to standard output do not end a game; the exit code reports them
 * at the end. */
int main(int argc, char **argv)
{
    const int closed = print_open_streams();
    log_open();
    if (closed) {
        return log_fail(EXIT_IO, LOG_LEVEL_WARNING, "/dev/null: %s", strerror(-closed));
    }
    evening.stop = &stop;
    evening.recorder.writer.fd = -1;
    const enum exit_code code = run_words(argc, argv);
    const int lost = print_finish();
    if (lost && code == EXIT_OK) {
        return log_fail(EXIT_IO, LOG_LEVEL_WARNING, "standard output: %s", strerror(-lost));
    }
    return (int)code;
}
