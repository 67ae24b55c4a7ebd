# replay.mk -- simulates the same half-minute with every compiler and optimization level, and
# compares it with the golden hashes.

VARIANTS := gcc-O0 gcc-O2 gcc-O3 clang-O0 clang-O2 clang-O3
VARIANT_BIN := $(VARIANTS:%=$(BUILD)/variants/%/state_hash) $(BUILD)/variants/sanitized/state_hash
VARIANT_CORE = $(CORE_SRC) $(WIDE_SRC:%.c=%_8.c) $(GENERATED_CORE_OBJ:$(BUILD)/%.o=%.c)
VARIANT_FLAGS := $(subst $(OPT) -g,,$(CORE_CFLAGS)) -w
# Expanded in the rules of variant NAME, which is $(1).
VARIANT_FOUND = $(FOUND_TOOLS) $(if $(filter clang%,$(1)),$(FOUND_CLANG))

# $(call variant,NAME,COMPILER AND LEVEL) compiles the whole core again in its own folder.
define variant
$(BUILD)/variants/$(1)/state_hash: $$(VARIANT_CORE:%.c=$(BUILD)/variants/$(1)/%.o) \
                                   $(BUILD)/variants/$(1)/tests/replay/state_hash.o
	$$(Q)$(2) -o $$@ $$^

$(BUILD)/variants/$(1)/generated/%.o: $(BUILD)/generated/%.c $(VARIANT_FOUND) | generated
	@mkdir -p $$(@D)
	$$(Q)$(2) $$(VARIANT_FLAGS) $$(DEP_FLAGS) -c -o $$@ $$<

$(BUILD)/variants/$(1)/core/%.o: core/%.c $(VARIANT_FOUND) | generated
	@mkdir -p $$(@D)
	$$(Q)$(2) $$(VARIANT_FLAGS) $$(DEP_FLAGS) -c -o $$@ $$<

$(BUILD)/variants/$(1)/core/%_8.o: core/%.c $(VARIANT_FOUND) | generated
	@mkdir -p $$(@D)
	$$(Q)$(2) $$(VARIANT_FLAGS) $$(WIDE_CFLAGS) $$(DEP_FLAGS) -c -o $$@ $$<

$(BUILD)/variants/$(1)/tests/replay/state_hash.o: tests/replay/state_hash.c $(VARIANT_FOUND) | generated
	@mkdir -p $$(@D)
	$$(call step,CC,the core with $(1))
	$$(Q)$(2) -std=c17 -I. -I$(BUILD)/generated -ffp-contract=off $$(DEP_FLAGS) -c -o $$@ $$<
endef

$(foreach v,$(VARIANTS),$(eval $(call variant,$(v),$(subst -O, -O,$(v)))))
# Undefined behaviour is a bug even if it does not change a hash yet.
SANITIZE := gcc -O1 -g -fsanitize=address,undefined,float-cast-overflow -fno-sanitize-recover=all
$(eval $(call variant,sanitized,$(SANITIZE)))

# `make unit` compares the core of its own compiler and processor with the golden hashes (compare_core.sh).
$(BUILD)/tests/replay/state_hash: $(BUILD)/tests/replay/state_hash.o $(BUILD)/core.a
	$(call step,LINK,$@)
	$(Q)$(CC) $(OPT) -g -o $@ $^ -lm

## test/golden: Accept the core's present state hashes after an intended change
golden: $(BUILD)/variants/gcc-O2/state_hash
	$< > tests/replay/golden.txt
	@git --no-pager diff --stat -- tests/replay/golden.txt 2>/dev/null || true

.PHONY: golden
