# fuzz.mk -- libFuzzer tests for the readers of users' files, under the address and
# undefined-behaviour sanitizers. A crash inside assimp ends that fuzzer early and is reported, but
# is not counted as a finding, because kingyoctl reads with assimp in a child process and reports
# the crash of the child in one line. Leaks are not checked, because assimp leaks memory that is
# freed when its child process ends.

FUZZ_SECONDS ?= 30
FUZZ := $(BUILD)/fuzz
FUZZ_TARGETS := text pack obj marks scene
FUZZ_CC := clang
FUZZ_CFLAGS := -std=c17 -O1 -g $(WARN) -ffp-contract=off -D_GNU_SOURCE $(ASSIMP) -I. -I$(BUILD)/generated \
    -fsanitize=fuzzer-no-link,address,undefined -fno-sanitize-recover=all
FUZZ_SRC := $(wildcard core/morph/*.c) core/base/fmath.c core/base/vec.c \
    core/base/printable.c platform/os/file.c platform/os/print.c \
    $(filter-out %/library.c,$(wildcard platform/species/*.c)) \
    $(filter-out %/refit_command.c,$(wildcard platform/ctl/import/*.c)) tests/fuzz/exercise.c tests/fuzz/meshes.c
FUZZ_OBJ := $(FUZZ_SRC:%.c=$(FUZZ)/%.o)
FUZZ_BIN := $(FUZZ_TARGETS:%=$(FUZZ)/fuzz_%)

## test/fuzz-morph: Fuzz species, OBJ, glTF and landmark files; FUZZ_SECONDS=30
fuzz-morph:
	@board/setup.sh dev
	+@$(MAKE) --no-print-directory -j$(JOBS) $(FUZZ_BIN)
	@mkdir -p $(FUZZ)/findings
	@for t in $(FUZZ_TARGETS); do \
	    mkdir -p $(FUZZ)/corpus/$$t; \
	    ASAN_OPTIONS=detect_leaks=0:allocator_may_return_null=1:max_allocation_size_mb=512 \
	    nice $(FUZZ)/fuzz_$$t -detect_leaks=0 -max_total_time=$(FUZZ_SECONDS) -timeout=60 -rss_limit_mb=2048 \
	        -max_len=65536 $$([ $$t = text ] && echo -dict=tests/fuzz/text.dict) -print_final_stats=1 -artifact_prefix=$(FUZZ)/findings/$$t- \
	        $(FUZZ)/corpus/$$t $$([ $$t = text ] && echo assets/species || echo tests/fuzz/corpus/$$t) \
	        >$(FUZZ)/$$t.log 2>&1; code=$$?; \
	    own=; if tests/fuzz/crash_is_in.sh libassimp $(FUZZ)/$$t.log; then own=1; code=0; fi; \
	    printf '  %-6s %9s executions, %5s edges, %s\n' $$t \
	        "$$(sed -n 's/^stat::number_of_executed_units: *//p' $(FUZZ)/$$t.log | tail -1)" \
	        "$$(sed -nE 's/.* cov: ([0-9]+).*/\1/p' $(FUZZ)/$$t.log | tail -1)" \
	        "$$([ -n "$$own" ] && echo "assimp itself fell, which kingyoctl's child process is for" || \
	            { [ $$code -eq 0 ] && echo 'no finding'; } || echo "exit $$code: see $(FUZZ)/$$t.log")"; \
	    [ $$code -eq 0 ] || exit 1; \
	done

# pack.c is compiled into its fuzzer, which repairs the head of a file with the CRC of pack.c.
$(FUZZ)/fuzz_pack: $(FUZZ)/tests/fuzz/fuzz_pack.o $(filter-out %/species/pack.o,$(FUZZ_OBJ))
$(filter-out %_pack,$(FUZZ_BIN)): $(FUZZ)/fuzz_%: $(FUZZ)/tests/fuzz/fuzz_%.o $(FUZZ_OBJ)
$(FUZZ_BIN):
	$(call step,LINK,$@)
	$(Q)$(FUZZ_CC) -fsanitize=fuzzer,address,undefined -o $@ $^ -lm

$(FUZZ)/%.o: %.c $(FOUND) $(FOUND_CLANG) | generated
	@mkdir -p $(@D)
	$(call step,CC,$< (to be fuzzed))
	$(Q)$(FUZZ_CC) $(FUZZ_CFLAGS) $(DEP_FLAGS) -c -o $@ $<

.PHONY: fuzz-morph
.SECONDARY: $(FUZZ_TARGETS:%=$(FUZZ)/tests/fuzz/fuzz_%.o)
