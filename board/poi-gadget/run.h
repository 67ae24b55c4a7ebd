/* run.h -- the main loop of the poi's board, and the commands of `kingyo-poi`. A poi is a paper
 * scoop with sensors. This header also declares the interfaces of pose sources and force-feedback
 * receivers.
 *
 * In each cycle, the loop reads a pose from the pose source, sends the pose to the host, and
 * forwards the host's force feedback to the motor. A pose source is either the real sensors, the
 * simulated sensors, or a script. */
#pragma once

#include <stdbool.h>

#include "board/poi-gadget/poi_config.h"
#include "drivers/hid/poi_report.h"
#include "platform/os/exit_code.h"

enum pose_result {
    /* A report is available. The position in the report is NaN if the position is unknown. */
    POSE_NEW = 1,
    POSE_NONE = 0, /* No report is available yet. */
    POSE_END = -1, /* The source has ended. */
    /* The input contains an invalid pose. An error line was printed to standard error. */
    POSE_BAD = -2,
};

struct pose_source {
    /* Function that computes the next report. `seconds` is the time since the previous call. The
     * function never blocks. The caller sets the sequence number of the report. */
    enum pose_result (*step)(void *self, float seconds, struct poi_report *out);
    void *self;
};

#define RUN_RATE_MIN_HZ 50u
/* Maximum report rate in Hz. A USB high-speed host polls f_hid, Linux's HID gadget, once per
 * millisecond. */
#define RUN_RATE_MAX_HZ 1000u

/* Receiver of the host's force feedback, for example the motor. */
struct force_sink {
    /* Function that handles force feedback. `newest` is the newest report, or null if no report has
     * arrived since the last call. `seconds` is the time since the last call. */
    void (*feel)(void *self, const struct poi_force *newest, float seconds);
    void (*stop)(void *self);
    void *self;
};

struct run_options {
    const char *device; /* Path of the device /dev/hidgN, or "-" for standard output. */
    uint32_t rate_hz;   /* Report rate in Hz, RUN_RATE_MIN_HZ .. RUN_RATE_MAX_HZ. */
    uint32_t seconds;   /* Duration of the loop in seconds. 0 means no limit. */
    /* True if the poses are printed as lines of text (pose_script.h) instead of being sent to the
     * host. */
    bool prints;
};

/* Runs the loop until the source ends, the duration has passed, or a signal arrives. If
 * `options->prints` is true, `sink` is not used. Otherwise the function prints statistics to
 * standard error at the end. Returns EXIT_OK, EXIT_IO if the device is missing at the start, or
 * EXIT_BAD_DATA if the source has an invalid pose. Asserts that the rate is in range. */
enum exit_code run(const struct run_options *options, struct pose_source source,
                   struct force_sink sink);

/* ---- Commands (commands.c) ------------------------------------------------------------------- */

/* Calibrates each draw wire at marks with known positions. Prints the instructions to standard
 * error, and the results, which are lines for the configuration file, to standard output. `root` is
 * the prefix of all paths: "" for this machine, or a test folder. Returns EXIT_OK. Returns
 * EXIT_NOT_SO if the measurements at the marks contradict each other, or EXIT_IO if a sensor or
 * standard input is missing. */
enum exit_code commands_calibrate(const struct poi_config *config, const char *root);

/* Checks each part of a poi, and prints the results to standard output, with advice for each
 * failure. The motor turns for half a second. `root` is the prefix of all paths, as for
 * commands_calibrate(). Returns EXIT_OK, or EXIT_NOT_SO if a check failed. */
enum exit_code commands_self_test(const struct poi_config *config, const char *root,
                                  const char *device);
