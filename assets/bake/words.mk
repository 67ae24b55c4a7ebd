# words.mk -- bakes assets/words/refused.txt into a constant table of the core.

NORMALIZE_OBJ := $(BUILD)/bake_host/core/game/ranking/name_normalize.o
GENERATED_CORE_OBJ += $(BUILD)/generated/refused_words.o
BUILD_CC ?= cc

generated: $(BUILD)/generated/refused_words.c

$(NORMALIZE_OBJ): $(BUILD)/bake_host/%.o: %.c
	@mkdir -p $(@D)
	$(call step,CC,$< (for the bake))
	$(Q)$(BUILD_CC) -std=c17 -O2 -g $(WARN) -D_GNU_SOURCE -I. $(DEP_FLAGS) -c -o $@ $<

$(BUILD)/generated/refused_words.c: assets/words/refused.txt $(BAKE_BUILD)/words.o $(NORMALIZE_OBJ) | $(BUILD)/bake
	@mkdir -p $(@D)
	$(Q)$(BUILD)/bake words $< $@

$(BUILD)/generated/refused_words.o: $(BUILD)/generated/refused_words.c $(FOUND_TOOLS)
	$(call step,CC,$<)
	$(Q)$(CC) $(CORE_CFLAGS) $(DEP_FLAGS) -c -o $@ $<
