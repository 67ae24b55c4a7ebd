# power.mk -- the plug is pulled, at every write.

POWER := $(BUILD)/tests/power/power
CUTS ?= 50000

## test-power: pulls the plug at every write and sync of a busy festival hour, CUTS (50,000) times in all: nothing promised is lost or doubled
test-power:
	+@$(MAKE) --no-print-directory -j$(JOBS) $(POWER)
	@$(POWER) --cuts $(CUTS)

$(POWER): $(addprefix $(BUILD)/tests/power/,power.o cutter.o go_on.o tape.o disk.o disk_cut.o hour.o books.o) \
    $(BUILD)/shell.a $(BUILD)/core.a
	$(call step,LINK,$@)
	$(Q)$(CC) $(OPT) -g -o $@ $^ $(HOST_LIBS)

.PHONY: test-power

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

$(CARD): $(addprefix $(BUILD)/tests/power/,card.o tape.o) $(BUILD)/shell.a $(BUILD)/core.a
	$(call step,LINK,$@)
	$(Q)$(CC) $(OPT) -g -o $@ $^ $(HOST_LIBS)

.PHONY: bench-card
