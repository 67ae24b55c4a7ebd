# tests.mk -- what `make test` builds and runs. tests/README.md says how the tests are arranged.

RESULTS := $(BUILD)/results

UNIT_SRC := $(wildcard tests/unit/test_*.c)
# A test that includes only the core links only the core, which is one more proof that it can.
UNIT_SHELL_SRC := $(if $(UNIT_SRC),$(shell grep -lE '"(platform|drivers|board)/' $(UNIT_SRC)))
UNIT_CORE_SRC := $(filter-out $(UNIT_SHELL_SRC),$(UNIT_SRC))
UNIT_SHELL := $(UNIT_SHELL_SRC:%.c=$(BUILD)/%)
UNIT_CORE := $(UNIT_CORE_SRC:%.c=$(BUILD)/%)
UNIT := $(UNIT_CORE) $(UNIT_SHELL)

$(UNIT_CORE): %: %.o $(BUILD)/tests/unit/panic.o $(BUILD)/core.a
	$(call step,LINK,$@)
	$(Q)$(CC) $(OPT) -g -o $@ $^ -lcmocka -lm

$(UNIT_SHELL): %: %.o $(BUILD)/tests/unit/panic.o $(BUILD)/shell.a $(BUILD)/core.a
	$(call step,LINK,$@)
	$(Q)$(CC) $(OPT) -g -o $@ $^ -lcmocka $(HOST_LIBS)

.SECONDARY: $(UNIT:%=%.o) $(BUILD)/tests/unit/panic.o

## unit: the unit tests alone; `make unit ONLY=tank` runs test_tank*
unit: $(filter $(BUILD)/tests/unit/test_$(ONLY)%,$(UNIT))
	@tests/run.sh $(RESULTS) $^

## boundaries: proves who may include and call whom, from the compiler's own output
boundaries: includes symbols
	@echo '  ok    the core stands alone, drivers see hal.h and contracts, only board/ and main wire'

includes: | generated
	@CC='$(CC)' BUILD='$(BUILD)' CORE_CFLAGS='$(CORE_CFLAGS)' HOST_CFLAGS='$(HOST_CFLAGS)' \
	    tests/boundaries/includes.sh

symbols: $(BUILD)/core.o
	@tests/boundaries/symbols.sh $<

$(BUILD)/core.o: $(CORE_OBJ)
	$(Q)$(LD) -r -o $@ $^

.PHONY: unit boundaries includes symbols
