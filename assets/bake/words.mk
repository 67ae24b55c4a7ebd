# words.mk -- bakes assets/words/refused.txt into a constant table of the core.

WORDS_OBJ := $(BUILD)/bake_host/assets/bake/words.o $(BUILD)/bake_host/core/game/ranking/name_normalize.o
GENERATED_CORE_OBJ += $(BUILD)/generated/refused_words.o
BUILD_CC ?= cc

generated: $(BUILD)/generated/refused_words.c

$(BUILD)/bake_words: $(WORDS_OBJ) $(BUILD)/bake_host/core/base/printable.o
	$(call step,LINK,$@)
	$(Q)$(BUILD_CC) -o $@ $^

$(WORDS_OBJ): $(BUILD)/bake_host/%.o: %.c
	@mkdir -p $(@D)
	$(call step,CC,$< (for the bake))
	$(Q)$(BUILD_CC) -std=c17 -O2 -g $(WARN) -D_GNU_SOURCE -I. $(DEP_FLAGS) -c -o $@ $<

$(BUILD)/generated/refused_words.c: assets/words/refused.txt $(BUILD)/bake_words
	@mkdir -p $(@D)
	$(call step,BAKE,$<)
	$(Q)$(BUILD)/bake_words $< $@

$(BUILD)/generated/refused_words.o: $(BUILD)/generated/refused_words.c $(FOUND_TOOLS)
	$(call step,CC,$<)
	$(Q)$(CC) $(CORE_CFLAGS) $(DEP_FLAGS) -c -o $@ $<
