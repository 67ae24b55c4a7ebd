# soak.mk -- simulates full tanks for minutes and checks that no body passes through another.

SOAK_BIN := $(BUILD)/tests/soak/soak
SOAK_OBJ := $(BUILD)/tests/soak/apart.o $(BUILD)/tests/soak/drag.o $(BUILD)/platform/cpu.o

## test/soak: Simulate 10 minutes of each full tank; SECONDS=n for less
soak: $(SOAK_BIN)
	@$(SOAK_BIN) $(or $(SECONDS),600)

$(SOAK_BIN): $(BUILD)/tests/soak/soak.o $(SOAK_OBJ) $(BUILD)/tests/unit/support/panic.o $(BUILD)/core.a
	$(call step,LINK,$@)
	$(Q)$(CC) $(OPT) -g -o $@ $^ -lcmocka -lm

# `make test` runs the same program for some seconds (test_soak.sh).
tests: $(SOAK_BIN)

.PHONY: soak

WEEK_BIN := $(BUILD)/tests/soak/week

## test/soak-week: Simulate a festival week (an hour); HOURS=n for less
soak-week:
	+@$(MAKE) --no-print-directory -j$(JOBS) $(WEEK_BIN)
	@$(WEEK_BIN) $(or $(HOURS),168)

$(WEEK_BIN): $(BUILD)/tests/soak/week.o $(BUILD)/shell.a $(BUILD)/core.a
	$(call step,LINK,$@)
	$(Q)$(CC) $(OPT) -g -o $@ $^ $(HOST_LIBS)

.PHONY: soak-week
