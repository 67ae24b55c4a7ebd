# tests.mk -- builds and runs the tests of `make test`. tests/README.md describes the structure of
# the tests.

RESULTS := $(BUILD)/results

# The folders below tests/unit are those of the sources. support/ has the code that several tests
# share.
UNIT_SRC := $(filter %.c,$(foreach file,$(call sources,tests/unit),$(if $(filter test_%,$(notdir $(file))),$(file))))
# A test that includes only core headers links only the core, which proves that the core needs
# nothing else.
UNIT_SHELL_SRC := $(if $(UNIT_SRC),$(shell grep -lE '"(platform|drivers|board)/' $(UNIT_SRC)))
UNIT_CORE_SRC := $(filter-out $(UNIT_SHELL_SRC),$(UNIT_SRC))
UNIT_SHELL := $(UNIT_SHELL_SRC:%.c=$(BUILD)/%)
UNIT_CORE := $(UNIT_CORE_SRC:%.c=$(BUILD)/%)
UNIT := $(UNIT_CORE) $(UNIT_SHELL)

E2E_BIN := $(BUILD)/tests/e2e/scoop_fish $(BUILD)/tests/e2e/ask_to_close $(BUILD)/tests/e2e/manager
# tests/vm/state_writer prints the state of the kiosk from its recording.
E2E := $(E2E_BIN) $(BUILD)/tests/vm/state_writer

-include tests/replay/replay.mk tests/golden/golden.mk tests/gltf/gltf.mk tests/gpio/gpio.mk tests/usb/usb.mk tests/hid/hid.mk

# Tests that use the whole machine run alone, after the tests that only compute (tests/run.sh).
TEST_SCRIPTS := $(wildcard tests/boundaries/test_*.sh tests/replay/test_*.sh tests/bake/test_*.sh \
    tests/soak/test_*.sh tests/ctl/test_*.sh tests/fuzz/test_*.sh \
    tests/hid/test_*.sh tests/board/test_*.sh tests/power/test_*.sh tests/mutants/test_*.sh \
    tests/metrics/test_*.sh tests/v3d/test_*.sh)
TEST_ALONE := $(wildcard tests/e2e/test_*.sh)
TEST_PROGRAMS := $(UNIT) $(GPIO_TEST) $(TEST_SCRIPTS) $(TEST_ALONE:%=@%)
ifneq ($(ONLY),)
TEST_PROGRAMS := $(foreach program,$(TEST_PROGRAMS),$(if $(findstring $(ONLY),$(notdir $(program))),$(program)))
endif

## test/test: Set up, build and run all tests; ONLY=import runs tests of that name
test:
	@board/setup.sh test
	+@$(MAKE) --no-print-directory -j$(JOBS) tests
	+@$(MAKE) --no-print-directory run-tests

# A separate make process, because the list of tests depends on the packages that the set-up
# installed.
run-tests:
	@BUILD=$(BUILD) tests/run.sh $(RESULTS) $(TEST_PROGRAMS)

## build/tests: Build what `make test` runs without running it
tests: build $(UNIT) $(GPIO_TEST) $(E2E) $(VARIANT_BIN) $(BUILD)/core.o $(BUILD)/tests/ctl/check_trace \
    $(BUILD)/tests/bench/technique $(BUILD)/tests/bench/day/bench_day $(BUILD)/tests/bench/players/hints \
    $(BUILD)/tests/power/power \
    $(BUILD)/tests/render/shot $(BUILD)/tests/v3d/gl_trace.so

## test/check: Run boundaries, tests and sizes, as before each commit
check: boundaries
	+@$(MAKE) --no-print-directory test
	+@$(MAKE) --no-print-directory sizes

## test/unit: Run unit tests; ONLY=tank runs test_tank*; ARCH=arm64 emulates a board
ifneq ($(FOREIGN),)
unit:
	@$(cross) unit
else
# ONLY=golden runs the comparison of the core with the golden hashes alone.
UNIT_GOLDEN := $(if $(filter $(ONLY)%,golden),tests/replay/compare_core.sh)
unit: $(foreach test,$(UNIT),$(if $(filter test_$(ONLY)%,$(notdir $(test))),$(test))) \
      $(if $(UNIT_GOLDEN),$(BUILD)/tests/replay/state_hash)
	@BUILD=$(BUILD) tests/run.sh $(RESULTS) $(filter-out %/state_hash,$^) $(UNIT_GOLDEN)
endif

## test/test-e2e: Run the end-to-end tests: virtual screen, real kiosk, real pointer
test-e2e:
	@board/setup.sh test
	+@$(MAKE) --no-print-directory -j$(JOBS) build $(E2E)
	@BUILD=$(BUILD) tests/run.sh $(RESULTS) $(TEST_ALONE)

## test/test-fresh: Run `make run` and `make test` on minimal Debian 12 and 13 roots
test-fresh:
	@board/setup.sh dev
	@BUILD=$(BUILD) tests/fresh/fresh.sh $(RELEASES)

$(UNIT_CORE): %: %.o $(BUILD)/tests/unit/support/panic.o $(BUILD)/core.a
	$(call step,LINK,$@)
	$(Q)$(CC) $(OPT) -g -o $@ $(filter %.o,$^) $(filter %.a,$^) -lcmocka -lm

# The test compares the SIMD functions of both widths with the scalar functions (core/base/simd.h).
$(BUILD)/tests/unit/core/base/test_simd.o: BASE_CFLAGS += -Wno-psabi
$(BUILD)/tests/unit/core/base/test_simd_wide.o: BASE_CFLAGS += -Wno-psabi \
    $(if $(filter x86_64%,$(MACHINE)),$(WIDE_CFLAGS))

$(UNIT_SHELL): %: %.o $(BUILD)/tests/unit/support/panic.o $(BUILD)/ctl.a $(BUILD)/shell.a $(BUILD)/core.a
	$(call step,LINK,$@)
	$(Q)$(CC) $(OPT) -g $(TRAP) -o $@ $(filter %.o,$^) $(filter %.a,$^) -lcmocka $(HOST_LIBS)

# The statistics of the technique bench (tests/bench/technique.c) are part of the bench only.
$(BUILD)/tests/unit/bench/test_statistics: $(BUILD)/tests/bench/statistics.o

# The simulated players and their targets are part of `make bench-players` only.
$(BUILD)/tests/unit/bench/test_goals: $(BUILD)/tests/bench/players/goals.o $(BUILD)/tests/bench/statistics.o
$(BUILD)/tests/unit/bench/test_sim_player: $(BUILD)/tests/bench/players/sim_player.o $(BUILD)/tests/bench/players/habits.o

# The visitors and the queue of a simulated day are part of `make bench-day` only.
$(BUILD)/tests/unit/bench/test_day: $(patsubst %,$(BUILD)/tests/bench/%.o,day/visitor day/day day/report progress)

# The test uses the same list of screens as the gallery.
$(BUILD)/tests/unit/platform/render/ui/test_ui_all_screens: $(BUILD)/tests/golden/screens.o $(BUILD)/tests/render/shot_menu.o

# A simulated card whose calls fail.
$(BUILD)/tests/unit/platform/store/test_storage_card: $(BUILD)/tests/power/tape.o $(BUILD)/tests/power/fault.o
$(BUILD)/tests/unit/platform/store/test_storage_card: TRAP := -Wl,--wrap=access

# Wraps the allocations of our own objects. Allocations inside libraries are not wrapped.
$(BUILD)/tests/unit/platform/kiosk/test_own_memory: TRAP := -Wl,--wrap=malloc,--wrap=calloc,--wrap=realloc \
    -Wl,--wrap=strdup,--wrap=fopen

# Wraps core_init(), so that it can refuse the second core of the sweep.
$(BUILD)/tests/unit/platform/kiosk/recorder/test_pin_sweep: TRAP := -Wl,--wrap=core_init

# Wraps the system calls that read a live device.
$(BUILD)/tests/unit/platform/ctl/devices/test_hid_source: TRAP := -Wl,--wrap=open,--wrap=ioctl,--wrap=read

$(BUILD)/tests/e2e/scoop_fish: $(BUILD)/tests/e2e/scoop_fish.o $(BUILD)/tests/e2e/eye.o $(BUILD)/core.a
$(BUILD)/tests/e2e/ask_to_close: $(BUILD)/tests/e2e/ask_to_close.o
$(BUILD)/tests/e2e/manager: $(BUILD)/tests/e2e/manager.o
$(E2E_BIN):
	$(call step,LINK,$@)
	$(Q)$(CC) -o $@ $^ -lXtst -lX11 -lm

# check_trace shares no code with the programs that it checks.
$(BUILD)/tests/ctl/check_trace: $(BUILD)/tests/ctl/check_trace.o
	$(call step,LINK,$@)
	$(Q)$(CC) $(OPT) -g -o $@ $^ -lm

.SECONDARY: $(UNIT:%=%.o) $(BUILD)/tests/unit/support/panic.o

## test/boundaries: Check which folder includes and calls which
boundaries: includes symbols
	@echo '  ok    the core stands alone, drivers see hal.h and contracts, only board/ and main wire'

includes: | generated
	@CC='$(CC)' BUILD='$(BUILD)' CORE_CFLAGS='$(CORE_CFLAGS)' HOST_CFLAGS='$(HOST_CFLAGS)' \
	    tests/boundaries/includes.sh $(ONLY)

symbols: $(BUILD)/core.o
	@tests/boundaries/symbols.sh $<

$(BUILD)/core.o: $(CORE_OBJ)
	$(Q)$(LD) -r -o $@ $^

## measure/sizes: Print structs, code, constants and deepest stack frames of the core
sizes: $(BUILD)/tests/sizes $(BUILD)/core.o
	@tests/sizes.sh $(BUILD)

$(BUILD)/tests/sizes: $(BUILD)/tests/sizes.o
	$(Q)$(CC) -o $@ $^

# Debian 12 and Debian 13 both have this version. Other versions format some code differently.
FORMATTER := clang-format-19
TIDY := clang-tidy-19

## test/lint: Check format, line lengths, shell scripts, pages and the drawing
lint:
	@board/setup.sh dev
	@shellcheck --severity=warning $$(git ls-files '*.sh') .ci/run && echo '  ok    shellcheck'
	@tests/boundaries/columns.sh && echo '  ok    100 columns'
	@! $(MAKE) --no-print-directory help | LC_ALL=C.UTF-8 grep -E '^.{101,}' && echo '  ok    help in 100 columns'
	@tests/boundaries/pages.sh && echo '  ok    pages'
	@tests/boundaries/format.sh $(FORMATTER)
	+@$(MAKE) --no-print-directory -j$(JOBS) build
	@board/docs/architecture.py --check $(BUILD) $(ARCHITECTURE) && echo '  ok    architecture'

## test/tidy: Check the C code with clang-tidy (minutes); ONLY=FILE..., PART=1/4
tidy:
	@board/setup.sh dev test
	+@$(MAKE) --no-print-directory -j$(JOBS) generated compile_commands.json
	@PART='$(PART)' tests/boundaries/tidy.sh $(TIDY) $(ONLY)

## test/format: Rewrite all C files in the form of .clang-format
format:
	@board/setup.sh dev
	$(Q)git ls-files '*.[ch]' | xargs -P $(JOBS) -n 40 $(FORMATTER) -i

.PHONY: test run-tests tests check unit test-e2e test-fresh boundaries includes symbols sizes lint tidy format
