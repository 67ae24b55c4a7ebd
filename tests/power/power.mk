# power.mk -- the plug is pulled, at every write.

POWER := $(BUILD)/tests/power/power
CUTS ?= 50000
LIVES_POWER ?= 600

## test-power: pulls the plug at every write and sync of a busy festival hour, CUTS (50,000) times in all, and in LIVES_POWER (600) short lives whose syncs, writes, truncations and renames fail: nothing promised is lost or doubled
test-power:
	+@$(MAKE) --no-print-directory -j$(JOBS) $(POWER)
	@$(POWER) --cuts $(CUTS) --lives $(LIVES_POWER)

$(POWER): $(addprefix $(BUILD)/tests/power/,power.o lives.o cutter.o go_on.o tape.o fault.o disk.o disk_cut.o hour.o books.o) $(BUILD)/platform/panic_core.o \
    $(BUILD)/shell.a $(BUILD)/core.a
	$(call step,LINK,$@)
	$(Q)$(CC) $(OPT) -g -o $@ $^ $(HOST_LIBS)

.PHONY: test-power

LIVES ?= 100
PRELOAD := $(BUILD)/tests/power/preload.so
JUDGE := $(BUILD)/tests/power/judge

## test-faults: LIVES (100) real kiosks whose syncs, writes, truncations and renames fail by seed, killed twice each, the power cut at several places: what their status reported as safe is there
test-faults:
	@board/setup.sh test
	+@$(MAKE) --no-print-directory -j$(JOBS) $(BUILD)/kingyo $(BUILD)/kingyoctl $(PRELOAD) $(JUDGE)
	@BUILD=$(BUILD) tests/power/kiosk_lives.sh $(LIVES)

# Whole in one library: it shares nothing with the kiosk that it is loaded into.
PRELOAD_SRC := $(addprefix tests/power/,preload.c kiosk_tape.c tape.c fault.c) core/base/rng.c
$(PRELOAD): $(PRELOAD_SRC) $(wildcard tests/power/*.h)
	@mkdir -p $(@D)
	$(call step,LINK,$@)
	$(Q)$(CC) $(HOST_CFLAGS) -fPIC -shared -o $@ $(PRELOAD_SRC) -lpthread

$(JUDGE): $(addprefix $(BUILD)/tests/power/,judge.o kiosk_tape.o cutter.o go_on.o tape.o fault.o disk.o disk_cut.o hour.o books.o) $(BUILD)/platform/panic_core.o \
    $(BUILD)/shell.a $(BUILD)/core.a
	$(call step,LINK,$@)
	$(Q)$(CC) $(OPT) -g -o $@ $^ $(HOST_LIBS)

.PHONY: test-faults

## bench-journals: each of SQLite's journals under the same quarter of an hour and 4,000 power cuts: its writes and syncs, and what it loses
bench-journals:
	+@$(MAKE) --no-print-directory -j$(JOBS) $(POWER)
	@for journal in 'DELETE FULL' 'DELETE EXTRA' 'TRUNCATE FULL' 'PERSIST FULL' 'WAL NORMAL' 'WAL FULL'; do \
	  echo "$$journal"; $(POWER) --cuts 4000 --frames 54000 --journal "$$journal" | grep -E 'operations|cuts in'; done; true

.PHONY: bench-journals

CARD := $(BUILD)/tests/power/card

## bench-card: the frame loop while its card is slow, full or read-only: the longest frame, ticks dropped, the slot
bench-card:
	+@$(MAKE) --no-print-directory -j$(JOBS) $(CARD)
	@$(CARD)

$(CARD): $(addprefix $(BUILD)/tests/power/,card.o tape.o fault.o) $(BUILD)/shell.a $(BUILD)/core.a
	$(call step,LINK,$@)
	$(Q)$(CC) $(OPT) -g -o $@ $^ $(HOST_LIBS)

.PHONY: bench-card
