# bake.mk -- creates textures, font and texts in build/generated/, once on the building machine.
# Each asset depends only on its own object files, so that a change of one source rebuilds one asset.

GENERATED := $(BUILD)/generated
BAKE_BUILD := $(BUILD)/assets/bake

# The bake tool runs on the building machine, even if CC compiles for another machine.
BUILD_CC ?= cc
BAKE_CFLAGS := -std=c17 -O2 -g $(WARN) -ffp-contract=off -D_GNU_SOURCE -I.
BAKE_PARTS := bake noise caustics patterns environment backdrop wood paper text font stb words
BAKE_OBJ := $(BAKE_PARTS:%=$(BAKE_BUILD)/%.o)

TEXT_FILES := assets/text/ja.txt assets/text/en.txt
TEXTURES := caustics patterns environment backdrop wood paper
BLOBS := $(TEXTURES:%=$(GENERATED)/%.bin) $(GENERATED)/font.bin
GENERATED_HEADERS := $(GENERATED)/assets.h $(GENERATED)/fonts.h $(GENERATED)/text_keys.h
GENERATED_OBJ += $(GENERATED)/blobs.o $(GENERATED)/fonts.o $(GENERATED)/text_table.o

generated: $(GENERATED_HEADERS)

$(BUILD)/bake: $(BAKE_OBJ) $(BUILD)/bake_host/core/base/printable.o \
    $(BUILD)/bake_host/core/game/ranking/name_normalize.o
	$(call step,LINK,$@)
	$(Q)$(BUILD_CC) -o $@ $^ -lm

$(BAKE_BUILD)/%.o: assets/bake/%.c
	@mkdir -p $(@D)
	$(call step,CC,$<)
	$(Q)$(BUILD_CC) $(BAKE_CFLAGS) -MMD -MP -c -o $@ $<

$(GENERATED)/%.bin: $(BAKE_BUILD)/%.o $(BAKE_BUILD)/noise.o | $(BUILD)/bake
	@mkdir -p $(@D)
	$(Q)$(BUILD)/bake $* $@

$(GENERATED)/assets.h: $(BAKE_BUILD)/bake.o | $(BUILD)/bake
	@mkdir -p $(@D)
	$(Q)$(BUILD)/bake header $@

$(GENERATED)/text_keys.h $(GENERATED)/text_table.c &: $(TEXT_FILES) $(BAKE_BUILD)/text.o | $(BUILD)/bake
	@mkdir -p $(@D)
	$(Q)$(BUILD)/bake text assets/text $(GENERATED)/text_keys.h $(GENERATED)/text_table.c

$(GENERATED)/font.bin $(GENERATED)/fonts.c $(GENERATED)/fonts.h &: \
    $(TEXT_FILES) assets/text/fonts.txt $(BAKE_BUILD)/font.o $(BAKE_BUILD)/text.o $(BAKE_BUILD)/stb.o | $(BUILD)/bake
	@mkdir -p $(@D)
	$(Q)$(BUILD)/bake font assets/text $(GENERATED)/font.bin $(GENERATED)/fonts.c $(GENERATED)/fonts.h

$(GENERATED)/blobs.o: assets/bake/blobs.S $(BLOBS) $(FOUND_TOOLS)
	$(call step,AS,$<)
	$(Q)$(CC) -Wa,-I$(GENERATED) -c -o $@ $<

$(GENERATED)/%.o: $(GENERATED)/%.c $(FOUND) | generated
	$(call step,CC,$<)
	$(Q)$(CC) $(HOST_CFLAGS) $(DEP_FLAGS) -c -o $@ $<
