/* report.c -- prints the tables of a simulated day. */
#include "tests/bench/day/report.h"

#include "core/game/rules.h"
#include "platform/ctl/play/rounds.h"

#define S_PER_MIN 60.0
#define S_PER_HOUR 3600.0

static const char *const fate_names[] = {
    [VISITOR_COMES] = "comes",
    [VISITOR_PLAYED] = "played",
    [VISITOR_LEFT] = "left",
    [VISITOR_DECLINED] = "declined",
};

static double per(double sum, double count)
{
    return count > 0.0 ? sum / count : 0.0;
}

static double percent(uint32_t part, uint32_t whole)
{
    return 100.0 * per((double)part, (double)whole);
}

static uint32_t round_count(const struct day *day)
{
    uint32_t sum = 0;
    for (uint32_t level = 0; level < LEVEL_COUNT; level++) {
        sum += day->rounds[level];
    }
    return sum;
}

struct day_sums report_sums(const struct day *day, uint32_t kind, uint32_t level)
{
    struct day_sums sums = { 0 };
    for (uint32_t i = 0; i < day->visitor_count; i++) {
        const struct visitor *visitor = &day->visitors[i];
        if ((kind != REPORT_ALL && kind != visitor->kind) ||
            (level != REPORT_ALL && level != visitor->level)) {
            continue;
        }
        sums.visitors++;
        sums.declined += visitor->fate == VISITOR_DECLINED;
        sums.left += visitor->fate == VISITOR_LEFT;
        sums.played += visitor->fate == VISITOR_PLAYED;
        sums.with_fish += visitor->caught > 0;
        sums.plays += visitor->plays;
        sums.caught += visitor->caught;
    }
    return sums;
}

/* ---- Goal, advice and accounts --------------------------------------------------------------- */

bool report_is_goal_met(const struct day *day)
{
    const struct day_sums all = report_sums(day, REPORT_ALL, REPORT_ALL);
    return 100u * all.with_fish >= day->options->goal * all.visitors;
}

const char *report_advice(const struct day *day)
{
    const struct day_options *options = day->options;
    const struct day_sums all = report_sums(day, REPORT_ALL, REPORT_ALL);
    const uint32_t empty = all.played - all.with_fish;
    if (all.declined > all.left && all.declined > empty) {
        return "the largest loss is the price: lower PRICE";
    }
    /* If as many visitors left the queue as played without a catch, the advice is about the queue.
     * The report does not advise an easier level in this case, because rounds at an easier level
     * last longer and lengthen the queue. */
    if (all.left >= empty) {
        return options->bowls < POI_MAX
                   ? "the largest loss is the queue: add bowls (PLAYERS), or shorten ROUND"
                   : "the largest loss is the queue: shorten ROUND, or add a second kiosk";
    }
    return options->level != LEVEL_EASY
               ? "the largest loss is plays without a fish: choose an easier default level (LEVEL)"
               : "the largest loss is plays without a fish: lengthen ROUND";
}

bool report_is_money_right(const struct day *day, const struct day_money *money)
{
    const uint32_t rounds = round_count(day), price = day->options->price;
    const struct day_sums all = report_sums(day, REPORT_ALL, REPORT_ALL);
    return money->units == rounds * price && money->paid_plays == (price > 0 ? rounds : 0u) &&
           money->free_plays == (price > 0 ? 0u : rounds) && money->refunds == 0 &&
           money->caught == all.caught;
}

/* ---- Tables ---------------------------------------------------------------------------------- */

static void print_head(const char *name)
{
    printf("  %-16s %8s %8s %6s %6s  %8s %7s  %6s %7s %9s", name, "visitors", "declined", "left",
           "played", "own fish", "of all", "plays", "again", "fish/play");
}

static void print_sums(const char *name, const struct day_sums *sums)
{
    printf("  %-16s %8u %8u %6u %6u  %6.0f %% %5.0f %%  %6u %5.0f %% %9.2f", name, sums->visitors,
           sums->declined, sums->left, sums->played, percent(sums->with_fish, sums->played),
           percent(sums->with_fish, sums->visitors), sums->plays,
           percent(sums->plays - sums->played, sums->plays),
           per((double)sums->caught, (double)sums->plays));
}

static void print_levels(const struct day *day)
{
    print_head("level");
    printf(" %7s %6s\n", "rounds", "coins");
    for (uint32_t i = LEVEL_COUNT; i-- > 0;) {
        const struct day_sums sums = report_sums(day, REPORT_ALL, i);
        print_sums(rules_of_level((uint8_t)i)->name, &sums);
        printf(" %7u %6u\n", day->rounds[i], day->rounds[i] * day->options->price);
    }
    const struct day_sums all = report_sums(day, REPORT_ALL, REPORT_ALL);
    print_sums("all", &all);
    printf(" %7u %6u\n\n", round_count(day), round_count(day) * day->options->price);
}

static void print_kinds(const struct day *day)
{
    print_head("kind");
    printf("\n");
    for (uint32_t i = 0; i < visitor_kind_count; i++) {
        const struct day_sums sums = report_sums(day, i, REPORT_ALL);
        print_sums(visitor_kinds[i].name, &sums);
        printf("\n");
    }
    printf("\n");
}

/* Prints how long the visitors who played had waited. */
static void print_queue(const struct day *day)
{
    uint32_t waits_s[DAY_VISITORS_MAX], count = 0;
    for (uint32_t i = 0; i < day->visitor_count; i++) {
        if (day->visitors[i].fate == VISITOR_PLAYED) {
            waits_s[count++] = (uint32_t)(day->visitors[i].wait_s + 0.5);
        }
    }
    if (count > 0) {
        const struct summary wait = rounds_summary(waits_s, count);
        printf("  queue: median %.1f min, p90 %.1f min, longest wait %.1f min, longest queue %u\n",
               wait.median / S_PER_MIN, wait.p90 / S_PER_MIN, (double)wait.max / S_PER_MIN,
               day->queue_longest);
    }
}

enum exit_code report_print(const struct day *day, const struct day_money *money)
{
    const struct day_options *options = day->options;
    const struct day_sums all = report_sums(day, REPORT_ALL, REPORT_ALL);
    const bool is_met = report_is_goal_met(day), is_right = report_is_money_right(day, money);
    print_levels(day);
    print_kinds(day);
    print_queue(day);
    printf("  plays that led to another play: %u of %u\n", all.plays - all.played, all.plays);
    printf("  coins: %u, for %u paid and %u free rounds (the core's accounts)\n", money->units,
           money->paid_plays, money->free_plays);
    printf("  kiosk: in use for %.1f h; the last round ended %.1f h after the opening\n\n",
           day->busy_s / S_PER_HOUR, day->end_s / S_PER_HOUR);
    printf("%s: %.1f %% of all visitors have a fish of their own (goal %u %%), %.1f %% of those "
           "who played\n",
           is_met ? "so" : "NOT SO", percent(all.with_fish, all.visitors), options->goal,
           percent(all.with_fish, all.played));
    if (!is_met) {
        printf("to change: %s\n", report_advice(day));
    }
    if (!is_right) {
        printf("NOT SO: the accounts of the core differ from the rounds: %u units, %u paid, %u "
               "free, %u refunds, %u fish\n",
               money->units, money->paid_plays, money->free_plays, money->refunds, money->caught);
    }
    return is_met && is_right ? EXIT_OK : EXIT_NOT_SO;
}

void report_write(const struct day *day, FILE *file)
{
    fputs("visitor\tkind\tlevel\tarrival_s\twait_s\tfate\tplays\tcaught\n", file);
    for (uint32_t i = 0; i < day->visitor_count; i++) {
        const struct visitor *visitor = &day->visitors[i];
        fprintf(file, "%u\t%s\t%s\t%.1f\t%.1f\t%s\t%u\t%u\n", i, visitor_kinds[visitor->kind].name,
                rules_of_level(visitor->level)->name, visitor->arrival_s, visitor->wait_s,
                fate_names[visitor->fate], visitor->plays, visitor->caught);
    }
}
