# files.mk -- libFuzzer tests for the files of the data folder and the configuration, under the
# address and undefined-behaviour sanitizers. The core that these files start is instrumented as
# well.

FILE_TARGETS := replay graph conf usb tail entries
FILE_BIN := $(FILE_TARGETS:%=$(FUZZ)/file_%)
FILE_SRC := $(CORE_SRC) $(wildcard platform/replay/*.c platform/store/graph_*.c platform/store/sqlite/*.c \
    platform/config/*.c) $(patsubst %,platform/%.c,os/file os/number os/log os/panic setting_text) \
    drivers/usb/usb_choice.c tests/fuzz/scratch.c tests/fuzz/try_game.c
FILE_GENERATED = $(patsubst $(BUILD)/%,$(FUZZ)/%,$(GENERATED_CORE_OBJ) $(filter %/ledger_sql.o,$(GENERATED_OBJ)))

## test/fuzz-files: Fuzz replays, graphs, configuration and ledger; FUZZ_SECONDS=30
fuzz-files:
	@board/setup.sh dev
	+@$(MAKE) --no-print-directory -j$(JOBS) $(FILE_BIN) $(FUZZ)/file_seeds
	@MAX_LEN=8192 tests/fuzz/fuzz_targets.sh file $(FUZZ) $(FUZZ_SECONDS) $(FILE_TARGETS)

$(FUZZ)/files.a: $(FILE_SRC:%.c=$(FUZZ)/%.o) $(WIDE_SRC:%.c=$(FUZZ)/%_8.o) $(FILE_GENERATED)
	$(call step,AR,$@)
	@rm -f $@
	$(Q)$(AR) rcsP $@ $^

$(FILE_BIN): $(FUZZ)/file_%: $(FUZZ)/tests/fuzz/file_%.o $(FUZZ)/files.a $(FUZZ)/devices.a
	$(call step,LINK,$@)
	$(Q)$(FUZZ_CC) -fsanitize=fuzzer,address,undefined -o $@ $^ -lsqlite3 -lm

# The kiosk's own writers make the seeds, so that the seeds always have the current version.
$(FUZZ)/file_seeds: $(BUILD)/tests/fuzz/file_seeds.o $(BUILD)/platform/panic_core.o $(BUILD)/shell.a $(BUILD)/core.a
	$(call step,LINK,$@)
	$(Q)$(CC) $(OPT) -g -o $@ $^ $(HOST_LIBS)

$(FUZZ)/core/%_8.o: core/%.c $(FOUND_TOOLS) $(FOUND_CLANG)
	@mkdir -p $(@D)
	$(call step,CC,$< (8 lanes, to be fuzzed))
	$(Q)$(FUZZ_CC) $(FUZZ_CFLAGS) $(WIDE_CFLAGS) $(DEP_FLAGS) -c -o $@ $<

$(FUZZ)/generated/%.o: $(BUILD)/generated/%.c $(FOUND) $(FOUND_CLANG) | generated
	@mkdir -p $(@D)
	$(Q)$(FUZZ_CC) $(FUZZ_CFLAGS) $(DEP_FLAGS) -c -o $@ $<

.PHONY: fuzz-files
.SECONDARY: $(FILE_TARGETS:%=$(FUZZ)/tests/fuzz/file_%.o) $(BUILD)/tests/fuzz/file_seeds.o
