# power.mk -- simulates a power cut at every write.

POWER := $(BUILD)/tests/power/power
CUTS ?= 50000
TRIALS_POWER ?= 600

## test/test-power: Cut the power CUTS=50000 times; fail calls in TRIALS_POWER=600 runs
test-power:
	+@$(MAKE) --no-print-directory -j$(JOBS) $(POWER)
	@$(POWER) --cuts $(CUTS) --trials $(TRIALS_POWER)

$(POWER): $(addprefix $(BUILD)/tests/power/,power.o trials.o cutter.o resume.o tape.o fault.o disk.o disk_cut.o hour.o ledger_totals.o) $(BUILD)/platform/panic_core.o \
    $(BUILD)/shell.a $(BUILD)/core.a
	$(call step,LINK,$@)
	$(Q)$(CC) $(OPT) -g -o $@ $^ $(HOST_LIBS)

.PHONY: test-power

TRIALS ?= 100
PRELOAD := $(BUILD)/tests/power/preload.so
KIOSK_CHECK := $(BUILD)/tests/power/kiosk_check

## test/test-faults: Run TRIALS=100 real kiosks with failing calls; SEED=n
test-faults:
	@board/setup.sh test
	+@$(MAKE) --no-print-directory -j$(JOBS) $(BUILD)/kingyo $(BUILD)/kingyoctl $(PRELOAD) $(KIOSK_CHECK)
	@BUILD=$(BUILD) tests/power/kiosk_trials.sh $(TRIALS) $(SEED)

# The library is self-contained, because it must share no code with the kiosk that loads it.
PRELOAD_SRC := $(addprefix tests/power/,preload.c kiosk_tape.c tape.c fault.c) core/base/rng.c
$(PRELOAD): $(PRELOAD_SRC) $(wildcard tests/power/*.h) $(FOUND)
	@mkdir -p $(@D)
	$(call step,LINK,$@)
	$(Q)$(CC) $(HOST_CFLAGS) -fPIC -shared -o $@ $(PRELOAD_SRC) -lpthread

$(KIOSK_CHECK): $(addprefix $(BUILD)/tests/power/,kiosk_check.o kiosk_tape.o cutter.o resume.o tape.o fault.o disk.o disk_cut.o hour.o ledger_totals.o) $(BUILD)/platform/panic_core.o \
    $(BUILD)/shell.a $(BUILD)/core.a
	$(call step,LINK,$@)
	$(Q)$(CC) $(OPT) -g -o $@ $^ $(HOST_LIBS)

.PHONY: test-faults

## measure/bench-journals: Compare SQLite's journal modes: writes, syncs, losses
bench-journals:
	+@$(MAKE) --no-print-directory -j$(JOBS) $(POWER)
	@for journal in 'DELETE FULL' 'DELETE EXTRA' 'TRUNCATE FULL' 'PERSIST FULL' 'WAL NORMAL' 'WAL FULL'; do \
	  echo "$$journal"; $(POWER) --cuts 4000 --frames 54000 --journal "$$journal" | grep -E 'operations|cuts in'; done; true

.PHONY: bench-journals

CARD := $(BUILD)/tests/power/card

## measure/bench-card: Measure the frame loop with a slow, full or read-only card
bench-card:
	+@$(MAKE) --no-print-directory -j$(JOBS) $(CARD)
	@$(CARD)

$(CARD): $(addprefix $(BUILD)/tests/power/,card.o tape.o fault.o) $(BUILD)/shell.a $(BUILD)/core.a
	$(call step,LINK,$@)
	$(Q)$(CC) $(OPT) -g -o $@ $^ $(HOST_LIBS)

.PHONY: bench-card
