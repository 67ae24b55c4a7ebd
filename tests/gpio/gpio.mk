# gpio.mk -- coins by the million, and both libgpiods.

BENCH_COINS := $(BUILD)/tests/gpio/bench_coins
COINS ?= 1000000

## bench-coins: COINS (1,000,000) simulated coins with bounce at random frame loads: none lost, none doubled; build/bench_coins.tsv
bench-coins:
	+@$(MAKE) --no-print-directory -j$(JOBS) $(BENCH_COINS)
	@$(BENCH_COINS) $(COINS) $(BUILD)/bench_coins.tsv

$(BENCH_COINS): $(BENCH_COINS).o $(BUILD)/tests/gpio/coin_rain.o $(BUILD)/shell.a $(BUILD)/core.a
	$(call step,LINK,$@)
	$(Q)$(CC) $(OPT) -g -o $@ $^ $(HOST_LIBS)

$(BUILD)/tests/unit/test_coin_rain: $(BUILD)/tests/gpio/coin_rain.o

.PHONY: bench-coins
