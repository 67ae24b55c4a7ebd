/* doctor_board.c -- checks what only a Raspberry Pi has: throttling by the firmware, the supply
 * voltage, the HDMI socket of the screen and the overlay that names the header's lines. Also checks
 * the memory card of any board.
 *
 * The firmware's bits of throttling are described in Raspberry Pi's documentation of `vcgencmd
 * get_throttled`. The vendor's kernel has them in a file. Other kernels may have the alarm of the
 * supply voltage, of the driver raspberrypi-hwmon. Debian 13's kernel has neither. */
#include "platform/ctl/doctor/doctor.h"

#include <ctype.h>
#include <fcntl.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "core/base/panic.h"
#include "core/base/printable.h"
#include "drivers/gpio/gpio_config.h"
#include "platform/os/file.h"
#include "platform/thermal.h"

/* ---- Throttling and supply voltage ----------------------------------------------------------- */

#define GET_THROTTLED "/sys/devices/platform/soc/soc:firmware/get_throttled"

/* Bits of get_throttled. The same bits shifted left by PAST_SHIFT mean "at some time since the
 * start". */
enum {
    UNDER_VOLTAGE = 1u << 0,
    FREQUENCY_CAPPED = 1u << 1,
    THROTTLED = 1u << 2,
    SOFT_TEMPERATURE_LIMIT = 1u << 3,
    PAST_SHIFT = 16,
};

/* Returns the bits of the firmware, or what another kernel knows of them. Sets `is_measured` to
 * true if the kernel knows the supply voltage. The firmware's bits are ignored unless the whole
 * line is a hexadecimal number of at most 32 bits. */
static uint32_t throttle_bits(const struct doctor *doctor, bool *is_measured)
{
    static struct doctor_names monitors;
    char line[64], path[OPTIONS_PATH_MAX + 64u];
    doctor_line(doctor, line, sizeof line, GET_THROTTLED);
    char *end;
    const unsigned long number = strtoul(line, &end, 16);
    *is_measured = isxdigit((unsigned char)line[0]) && !*end && number <= UINT32_MAX;
    uint32_t bits = *is_measured ? (uint32_t)number : 0u;
    doctor_list(doctor, "/sys/class/hwmon", "hwmon", &monitors);
    for (uint32_t i = 0; i < monitors.count; i++) {
        doctor_line(doctor, line, sizeof line, "/sys/class/hwmon/%.64s/name", monitors.name[i]);
        if (strcmp(line, "rpi_volt") == 0) {
            doctor_line(doctor, line, sizeof line, "/sys/class/hwmon/%.64s/in0_lcrit_alarm",
                        monitors.name[i]);
            bits |= strcmp(line, "1") == 0 ? UNDER_VOLTAGE : 0u;
            *is_measured = true;
        }
    }
    snprintf(path, sizeof path, "%s" THERMAL_ROOT, doctor->root);
    return bits | (thermal_read(path) <= 0 ? SOFT_TEMPERATURE_LIMIT : 0u);
}

static void check_power(struct doctor *doctor, uint32_t bits, bool is_measured,
                        bool was_seen_in_log)
{
    const bool is_low = (bits & UNDER_VOLTAGE) != 0;
    const bool was_low = (bits >> PAST_SHIFT & UNDER_VOLTAGE) != 0 || was_seen_in_log;
    struct doctor_finding *finding = doctor_find(doctor, "power",
                                                 is_low    ? DOCTOR_WRONG
                                                 : was_low ? DOCTOR_CHECK
                                                           : DOCTOR_FINE,
                                                 "supply");
    doctor_state(finding, "the voltage %s",
                 is_low    ? "is too low now (under-voltage)"
                 : was_low ? "was too low since the start (under-voltage)"
                 : is_measured
                     ? "is high enough"
                     : "is unknown to this kernel; a flash of lightning on the screen means that "
                       "the voltage is too low");
    if (is_low || was_low) {
        doctor_todo(finding, "use the supply of Raspberry Pi for this model and a short cable, and "
                             "feed lamps and the ticket dispenser from another supply");
    }
}

/* The firmware also throttles a processor whose supply voltage is too low. Therefore the advice
 * names the supply first if the voltage is or was too low. */
static void check_heat(struct doctor *doctor, uint32_t bits)
{
    const uint32_t heat = FREQUENCY_CAPPED | THROTTLED | SOFT_TEMPERATURE_LIMIT;
    const bool is_slow = (bits & heat) != 0, was_slow = (bits >> PAST_SHIFT & heat) != 0;
    struct doctor_finding *finding =
        doctor_find(doctor, "heat", is_slow || was_slow ? DOCTOR_CHECK : DOCTOR_FINE, "processor");
    doctor_state(finding, "%s",
                 is_slow    ? "throttled: the processor runs slower now"
                 : was_slow ? "was throttled since the start"
                            : "not throttled");
    if (is_slow || was_slow) {
        doctor_todo(finding,
                    "%sclean the vents, add a fan or a larger heat sink, and keep the cabinet out "
                    "of the sun",
                    ((bits | bits >> PAST_SHIFT) & UNDER_VOLTAGE) == 0
                        ? ""
                        : "repair the supply first, because a low voltage also slows the "
                          "processor; if the processor is then still throttled, ");
    }
}

/* ---- HDMI socket ----------------------------------------------------------------------------- */

/* Returns true if a screen has answered at a connector. The kernel's option video=...D reports a
 * connector as connected without a screen, but such a connector has no EDID. */
static bool has_edid(const struct doctor *doctor, const char *connector)
{
    char path[DOCTOR_PATH + OPTIONS_PATH_MAX], byte;
    snprintf(path, sizeof path, "%s/sys/class/drm/%.200s/edid", doctor->root, connector);
    const int fd = open(path, O_RDONLY | O_CLOEXEC | O_NONBLOCK);
    const bool has = fd >= 0 && read(fd, &byte, 1) == 1;
    if (fd >= 0) {
        close(fd);
    }
    return has;
}

/* A model with two sockets shows the picture on the first, HDMI 0. */
static void check_socket(struct doctor *doctor)
{
    static struct doctor_names connectors;
    bool has_screen[2] = { false, false };
    doctor_list(doctor, "/sys/class/drm", "card", &connectors);
    for (uint32_t i = 0; i < connectors.count; i++) {
        const char *socket = strstr(connectors.name[i], "-HDMI-A-");
        const int number = socket ? atoi(socket + strlen("-HDMI-A-")) : 0;
        if (number == 1 || number == 2) {
            has_screen[number - 1] |= has_edid(doctor, connectors.name[i]);
        }
    }
    if (has_screen[1] && !has_screen[0]) {
        struct doctor_finding *finding =
            doctor_find(doctor, "display", DOCTOR_WRONG, "HDMI socket");
        doctor_state(finding, "the screen is in the socket HDMI 1, and HDMI 0 is empty");
        doctor_todo(finding, "plug the screen into HDMI 0, the socket next to the power plug");
    }
}

/* ---- Overlay --------------------------------------------------------------------------------- */

/* The header's lines in the device tree: of a Raspberry Pi up to 4, and of a Raspberry Pi 5 with
 * the kernels of different years. */
static const char *const line_names[] = {
    "/proc/device-tree/soc/gpio@7e200000/gpio-line-names",
    "/proc/device-tree/axi/pcie@1000120000/rp1/gpio@d0000/gpio-line-names",
    "/proc/device-tree/axi/pcie@120000/rp1/gpio@d0000/gpio-line-names",
};

/* Returns true if the list of line names, each of which ends with a zero byte, has `name`. */
static bool device_tree_has(const struct doctor *doctor, const char *path, const char *name)
{
    char text[2048], whole[DOCTOR_PATH + OPTIONS_PATH_MAX];
    snprintf(whole, sizeof whole, "%s%s", doctor->root, path);
    FILE *file = file_open(whole, FILE_KERNEL_SIZE_MAX);
    const size_t size = file ? fread(text, 1, sizeof text - 1u, file) : 0;
    if (file) {
        fclose(file);
    }
    text[size] = '\0';
    for (size_t at = 0; at < size; at += strlen(text + at) + 1u) {
        if (strcmp(text + at, name) == 0) {
            return true;
        }
    }
    return false;
}

static void check_overlay(struct doctor *doctor)
{
    struct gpio_wire wires[GPIO_ROLE_COUNT];
    const char *missing = NULL;
    doctor_wires(doctor, wires);
    for (uint32_t role = 0; role < GPIO_ROLE_COUNT; role++) {
        bool is_named = !wires[role].wired || !wires[role].name[0];
        for (size_t i = 0; i < sizeof line_names / sizeof line_names[0]; i++) {
            is_named |= device_tree_has(doctor, line_names[i], wires[role].name);
        }
        missing = is_named ? missing : wires[role].name;
    }
    if (missing) {
        struct doctor_finding *finding =
            doctor_find(doctor, "overlay", DOCTOR_WRONG, "device tree");
        doctor_state(finding, "no line of the header has the name '%s'", missing);
        doctor_todo(finding, "add dtoverlay=kingyo-cabinet to config.txt and copy "
                             "kingyo-cabinet.dtbo, as board/cabinet/README.md describes; restart");
    }
}

/* ---- Memory card ----------------------------------------------------------------------------- */

/* Errors in the kernel log that concern the card, and the text of the last. */
struct log_findings {
    uint32_t card_errors;
    bool had_under_voltage, is_readable;
    char last[DOCTOR_TEXT];
};

/* Returns true if a message of the kernel reports an error of a memory card. The message names a
 * block device (mmcblk0), or begins with the host of a block device: "mmc0:" belongs to mmcblk0. A
 * host without a block device is for example the Wi-Fi chip, whose driver also reports a missing
 * optional file. The text "errors=" is an option of a mount. */
static bool is_card_error(const struct doctor *doctor, const char *message)
{
    static const char *const words[] = { "error", "failed", "timeout", "read-only" };
    char is_locked[8] = "";
    bool is_error = false;
    for (size_t i = 0; i < sizeof words / sizeof words[0]; i++) {
        is_error |= strcasestr(message, words[i]) != NULL;
    }
    if (is_error && strncmp(message, "mmc", 3) == 0 && isdigit((unsigned char)message[3])) {
        doctor_line(doctor, is_locked, sizeof is_locked, "/sys/block/mmcblk%u/ro",
                    (unsigned)strtoul(message + 3, NULL, 10));
    }
    return is_error && (is_locked[0] || strstr(message, "mmcblk")) && !strstr(message, "errors=");
}

/* Reads the kernel log, /dev/kmsg, to its present end. A record has the form
 * "6,339,5140900,-;message". The first number is below 8 if the kernel wrote the message. */
static void read_log(const struct doctor *doctor, struct log_findings *log)
{
    static char record[8192]; /* The kernel refuses to write a record to a smaller buffer. */
    char path[OPTIONS_PATH_MAX + 64u], line[1024];
    snprintf(path, sizeof path, "%s/dev/kmsg", doctor->root);
    const int fd = open(path, O_RDONLY | O_CLOEXEC | O_NONBLOCK);
    FILE *file = fd >= 0 ? fdopen(fd, "r") : NULL;
    log->is_readable = file != NULL;
    if (!file) {
        return;
    }
    setvbuf(file, record, _IOFBF, sizeof record);
    while (file_read_line(file, line, sizeof line) != FILE_LINE_END) {
        const char *message = strchr(line, ';');
        message = message ? message + 1 : line;
        if (strtoul(line, NULL, 10) < 8u && is_card_error(doctor, message)) {
            log->card_errors++;
            snprintf(log->last, sizeof log->last, "%.200s", message);
            printable(log->last);
        }
        log->had_under_voltage |= strcasestr(message, "under-voltage detected") != NULL ||
                                  strcasestr(message, "undervoltage detected") != NULL;
    }
    fclose(file);
}

/* Adds a finding if a memory card cannot be written or has reported errors. */
static void check_card(struct doctor *doctor, const char *card, const struct log_findings *log)
{
    char is_locked[8], worn[8];
    doctor_line(doctor, is_locked, sizeof is_locked, "/sys/block/%.64s/ro", card);
    doctor_line(doctor, worn, sizeof worn, "/sys/block/%.64s/device/pre_eol_info", card);
    struct doctor_finding *finding = doctor_find(doctor, "card", DOCTOR_FINE, "%s", card);
    if (strcmp(is_locked, "1") == 0) {
        finding->level = DOCTOR_WRONG;
        doctor_state(finding, "is read-only: a worn card protects itself in this way");
    } else if (log->card_errors > 0) {
        finding->level = DOCTOR_WRONG;
        doctor_state(finding, "%u error%s in the kernel log, the last: %s", log->card_errors,
                     log->card_errors == 1 ? "" : "s", log->last);
    } else if (strtoul(worn, NULL, 16) >= 2) { /* JEDEC eMMC: 1 normal, 2 warning, 3 urgent. */
        finding->level = DOCTOR_CHECK;
        doctor_state(finding, "reports that it is worn");
    } else if (!log->is_readable) {
        doctor_state(finding, "can be written; only root can read the errors in the kernel log");
    } else {
        doctor_state(finding, "can be written; no errors in the kernel log");
    }
    if (finding->level != DOCTOR_FINE) {
        doctor_todo(finding, "copy the takings now (kingyoctl backup FILE), and replace the card");
    }
}

static void check_cards(struct doctor *doctor, const struct log_findings *log)
{
    static struct doctor_names cards;
    doctor_list(doctor, "/sys/block", "mmcblk", &cards);
    for (uint32_t i = 0; i < cards.count; i++) {
        if (!strstr(cards.name[i], "boot")) { /* mmcblk0boot0 is a start partition of an eMMC. */
            check_card(doctor, cards.name[i], log);
        }
    }
}

void doctor_board(struct doctor *doctor)
{
    static struct log_findings log;
    char model[DOCTOR_TEXT];
    log = (struct log_findings){ .card_errors = 0 };
    read_log(doctor, &log);
    check_cards(doctor, &log);
    doctor_line(doctor, model, sizeof model, "/proc/device-tree/model");
    if (strstr(model, "Raspberry Pi")) {
        bool is_measured;
        const uint32_t bits = throttle_bits(doctor, &is_measured);
        doctor_state(doctor_find(doctor, "board", DOCTOR_FINE, "model"), "%s", model);
        check_power(doctor, bits, is_measured, log.had_under_voltage);
        check_heat(doctor, bits);
        check_socket(doctor);
        check_overlay(doctor);
    }
}
