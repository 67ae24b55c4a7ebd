/* coin_rain.c -- implementation of coin_rain.h: draws the coin pulses, the thread delays and the
 * frame lengths at random from one seed. */
#include "tests/gpio/coin_rain.h"

#include <string.h>

#include "drivers/gpio/gpio_config.h"

#define US 1000ull
#define MS 1000000ull

/* Returns the next random number (splitmix64). */
static uint64_t draw(uint64_t *seed)
{
    uint64_t z = *seed += 0x9e3779b97f4a7c15ull;
    z = (z ^ z >> 30) * 0xbf58476d1ce4e5b9ull;
    z = (z ^ z >> 27) * 0x94d049bb133111ebull;
    return z ^ z >> 31;
}

static uint64_t between(uint64_t *seed, uint64_t least, uint64_t most)
{
    return least + draw(seed) % (most - least + 1u);
}

/* ---- Generating the coin pulses ------------------------------------------------------------- */

static void add_edge(struct coin_rain *rain, uint64_t time_ns, bool active)
{
    rain->pulse[rain->edge_count++] = (struct gpio_sim_event){
        .time_ns = time_ns,
        .role = GPIO_COIN,
        .active = active,
    };
}

/* Adds the edges of a contact that closes or opens and bounces up to three times. Successive edges
 * are 20 us to 500 us apart, so the bounces last at most 3 ms. Returns the time of the last
 * edge. */
static uint64_t add_contact(struct coin_rain *rain, uint64_t time_ns, bool active)
{
    const uint64_t jumps = between(&rain->seed, 0, 3);
    add_edge(rain, time_ns, active);
    for (uint64_t i = 0; i < 2 * jumps; i++) {
        time_ns += between(&rain->seed, 20 * US, 500 * US);
        add_edge(rain, time_ns, i % 2 ? active : !active);
    }
    return time_ns;
}

/* Returns the width of the next pulse, without its bounces. One pulse in fifty is a knock (4 to 5.9
 * ms), and one in a hundred is a jam (260 ms and more). Bounces can lengthen a pulse by 3 ms and a
 * late kernel by 6 ms. A knock with both is still shorter than a coin pulse. */
static uint64_t draw_width(struct coin_rain *rain)
{
    const uint64_t kind = draw(&rain->seed) % 100u;
    rain->falls = kind >= 3;
    if (kind < 2) {
        rain->knocks++;
        return between(&rain->seed, 4 * MS, 5900 * US);
    }
    if (kind < 3) {
        rain->jams++;
        return between(&rain->seed, 260 * MS, 900 * MS);
    }
    rain->left--;
    return between(&rain->seed, 20 * MS, 240 * MS);
}

/* Adds two sparks, which a lighter can cause at the coin slot. The sparks are 16 to 80 ms apart, so
 * that together they look like the two edges of a coin pulse. */
static void add_sparks(struct coin_rain *rain)
{
    static const struct gpio_sim_event spark = { .what = GPIO_SIM_SPARK, .role = GPIO_COIN };
    for (uint32_t i = 0; i < 2; i++) {
        rain->time_ns +=
            i ? between(&rain->seed, 16 * MS, 80 * MS) : between(&rain->seed, 30 * MS, 120 * MS);
        rain->pulse[rain->edge_count] = spark;
        rain->pulse[rain->edge_count++].time_ns = rain->time_ns;
    }
    rain->falls = 0;
    rain->sparks++;
}

static void draw_pulse(struct coin_rain *rain)
{
    rain->edge_count = rain->edge_next = 0;
    if (draw(&rain->seed) % 20u == 0) {
        add_sparks(rain);
        return;
    }
    const uint64_t begin_ns = rain->time_ns + between(&rain->seed, 20 * MS, 120 * MS);
    const uint64_t closed_ns = add_contact(rain, begin_ns, true);
    rain->time_ns = add_contact(rain, closed_ns + draw_width(rain), false);
    rain->edges += rain->edge_count;
}

static bool next_edge(void *self, struct gpio_sim_event *out)
{
    struct coin_rain *rain = self;
    if (rain->edge_next == rain->edge_count) {
        /* The last edge of the pulse has been delivered, so the coin counts as inserted. */
        rain->coins += rain->falls;
        rain->falls = 0;
        if (rain->left == 0) {
            return false;
        }
        draw_pulse(rain);
    }
    *out = rain->pulse[rain->edge_next++];
    return true;
}

/* ---- The simulated cabinet ------------------------------------------------------------------ */

struct cabinet {
    struct coin_rain rain;
    struct gpio_lines_sim sim;
    struct gpio_thread gpio;
    uint64_t seed, due_ns, stall_max_ns;
    /* Number of inserted coins at the newest check time (element 0) and at the check time before it
     * (element 1). Check times are at least 200 ms apart. At each check time, the frame loop must
     * therefore have counted the coins of element 1. */
    uint32_t fallen[2];
    uint64_t marked_ns;
    struct rain_result result;
};

static void poll(struct cabinet *cabinet)
{
    const struct hal_buttons buttons = gpio_thread_buttons(&cabinet->gpio);
    struct rain_result *result = &cabinet->result;
    struct button_sample sample;
    buttons.ops->poll(buttons.self, &sample);
    result->counted += sample.coin_count[0];
    result->faults += sample.faults;
    result->looks++;
    result->early += result->counted > cabinet->rain.coins;
    result->late += result->counted < cabinet->fallen[1];
    if (cabinet->sim.now_ns >= cabinet->marked_ns + 200 * MS) {
        cabinet->fallen[1] = cabinet->fallen[0];
        cabinet->fallen[0] = cabinet->rain.coins;
        cabinet->marked_ns = cabinet->sim.now_ns;
    }
}

/* Draws the length of a frame at random: 4 to 20 ms, or up to 3 s for one frame in fifty. */
static void draw_frame(struct cabinet *cabinet)
{
    const bool is_slow = draw(&cabinet->seed) % 50u == 0;
    const uint64_t frame_ns = is_slow ? between(&cabinet->seed, 20 * MS, 3000 * MS)
                                      : between(&cabinet->seed, 4 * MS, 20 * MS);
    if (frame_ns > cabinet->result.longest_frame_ns) {
        cabinet->result.longest_frame_ns = frame_ns;
    }
    cabinet->due_ns = cabinet->sim.now_ns + frame_ns;
}

/* Draws the delays of one wake-up of the GPIO thread at random. One time in eight the thread starts
 * late, but soon enough that the kernel's queue cannot overflow. The queue of 16 edges lasts for 25
 * ms, and the queue of 64 edges for 100 ms. The kernel's interrupt thread is up to 0.3 ms late, and
 * one time in sixteen up to 6 ms. */
static void stall(struct cabinet *cabinet)
{
    cabinet->sim.late_max_ns = draw(&cabinet->seed) % 16u == 0 ? 6 * MS : 300 * US;
    if (draw(&cabinet->seed) % 8u == 0) {
        const uint64_t stall_ns = between(&cabinet->seed, 100 * US, cabinet->stall_max_ns);
        if (stall_ns > cabinet->result.longest_stall_ns) {
            cabinet->result.longest_stall_ns = stall_ns;
        }
        gpio_lines_sim_pass(&cabinet->sim, stall_ns);
    }
}

struct rain_result coin_rain(const struct rain_config *config)
{
    static struct cabinet cabinet;
    struct gpio_wire wires[GPIO_ROLE_COUNT] = { [GPIO_COIN] = { .wired = 1, .name = "COIN" } };
    memset(&cabinet, 0, sizeof cabinet);
    cabinet.rain = (struct coin_rain){ .left = config->coins, .seed = config->seed };
    cabinet.seed = config->seed ^ 0x5157u;
    gpio_lines_sim_init(&cabinet.sim,
                        (struct gpio_sim_script){ .next = next_edge, .self = &cabinet.rain },
                        (uint32_t)config->seed | 1u);
    cabinet.sim.late_min_ns = 10 * US;
    cabinet.stall_max_ns = config->is_second ? 100 * MS : 25 * MS;
    cabinet.sim.is_numbered = config->is_second;
    cabinet.sim.queue_size = config->is_second ? 64 : 16;
    gpio_thread_open(&cabinet.gpio, gpio_lines_sim_device(&cabinet.sim), wires,
                     gpio_lines_sim_clock(&cabinet.sim));
    while (cabinet.sim.has_next || cabinet.sim.now_ns < cabinet.rain.time_ns + 4000 * MS) {
        stall(&cabinet);
        gpio_thread_step(&cabinet.gpio);
        if (cabinet.sim.now_ns >= cabinet.due_ns) {
            poll(&cabinet);
            draw_frame(&cabinet);
        }
    }
    poll(&cabinet);
    struct rain_result result = cabinet.result;
    result.coins = cabinet.rain.coins;
    result.knocks = cabinet.rain.knocks;
    result.jams = cabinet.rain.jams;
    result.sparks = cabinet.rain.sparks;
    result.doubtful = cabinet.gpio.total.doubtful;
    result.edges = cabinet.rain.edges;
    result.dropped = cabinet.sim.dropped;
    result.blinks = cabinet.gpio.inputs[GPIO_COIN].blinks;
    result.time_ns = cabinet.sim.now_ns;
    gpio_thread_close(&cabinet.gpio);
    return result;
}
