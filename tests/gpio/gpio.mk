# gpio.mk -- tests with a million coins, and with both releases of libgpiod.

BENCH_COINS := $(BUILD)/tests/gpio/bench_coins
COINS ?= 1000000

## measure/bench-coins: Count COINS=1000000 simulated coins with contact bounce and glitches
bench-coins:
	+@$(MAKE) --no-print-directory -j$(JOBS) $(BENCH_COINS)
	@$(BENCH_COINS) $(COINS) $(BUILD)/bench_coins.tsv

$(BENCH_COINS): $(BENCH_COINS).o $(BUILD)/tests/gpio/coin_rain.o $(BUILD)/shell.a $(BUILD)/core.a
	$(call step,LINK,$@)
	$(Q)$(CC) $(OPT) -g -o $@ $^ $(HOST_LIBS)

$(BUILD)/tests/unit/drivers/gpio/test_coin_rain: $(BUILD)/tests/gpio/coin_rain.o

# Tests the backend of this machine's libgpiod with a fake library. `make gpiod2` tests the backend
# of the other release.
GPIO_TEST = $(if $(filter-out 0,$(GPIOD)),$(BUILD)/tests/gpio/test_gpio_backend)
GPIO_TEST_WRAP := -Wl,--wrap=gpio_dev_next,--wrap=gpio_dev_end

$(BUILD)/tests/gpio/test_gpio_backend: $(addprefix $(BUILD)/tests/gpio/,test_gpio_backend.o \
    fake_board.o fake_gpiod$(GPIOD).o) $(BUILD)/tests/unit/support/panic.o $(BUILD)/shell.a
	$(call step,LINK,$@)
	$(Q)$(CC) $(OPT) -g $(GPIO_TEST_WRAP) -o $@ $^ -lcmocka -lpthread

## test/gpiod2: Test the libgpiod 2.x backend with the library of Debian 13
gpiod2:
	@board/setup.sh dev test
	@BUILD=$(BUILD) CC='$(CC)' CFLAGS='$(BASE_CFLAGS) -D_GNU_SOURCE' LDFLAGS='$(GPIO_TEST_WRAP)' \
	    tests/gpio/gpiod2.sh

## test/test-gpio-sanitizers: Test the GPIO thread and decoders under the sanitizers
test-gpio-sanitizers:
	@BUILD=$(BUILD) CC='$(CC)' CFLAGS='$(BASE_CFLAGS) -D_GNU_SOURCE' LDFLAGS='$(GPIO_TEST_WRAP)' \
	    GPIOD='$(GPIOD)' tests/gpio/sanitizers.sh

.PHONY: bench-coins gpiod2 test-gpio-sanitizers
