# bench.mk -- the figures, one row each with the command that gives it.

BENCH_BIN := $(BUILD)/tests/bench/bench_start $(BUILD)/tests/bench/bench_latency $(BUILD)/tests/bench/bench_tank

## bench: frame time, start, memory, latency and sizes of this machine, as a table and build/bench.tsv
bench:
	@board/setup.sh test
	+@$(MAKE) --no-print-directory -j$(JOBS) build $(BENCH_BIN) $(E2E_BIN) $(BUILD)/tests/sizes $(BUILD)/core.o
	@BUILD=$(BUILD) tests/bench/bench.sh

$(BENCH_BIN): %: %.o $(BUILD)/shell.a $(BUILD)/core.a
	$(call step,LINK,$@)
	$(Q)$(CC) $(OPT) -g -o $@ $^ $(HOST_LIBS)

.PHONY: bench
