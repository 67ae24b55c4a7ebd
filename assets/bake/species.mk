# species.mk -- bakes assets/species/*.txt into constant tables of the core.

SPECIES := wakin kurodai shimafugu kuroanago hirame ray mebachi
# Varieties of the goldfish, which are only drawn (platform/render/textures.h). The core's table does not
# contain them, so they change no state hash.
VARIETIES := demekin ryukin
# The sources of bake_species: all files of core/morph and platform/species without library.c,
# which depends on the table that this file bakes.
SPECIES_PARTS := assets/bake/species \
    $(patsubst %.c,%,$(filter-out %/library.c,$(wildcard platform/species/*.c))) \
    $(patsubst %.c,%,$(wildcard core/morph/*.c)) \
    core/base/fmath core/base/printable core/base/vec platform/os/file \
    platform/os/print
# Compiled for the building machine, separately from the kiosk's objects.
SPECIES_OBJ := $(SPECIES_PARTS:%=$(BUILD)/bake_host/%.o)
GENERATED_OBJ += $(VARIETIES:%=$(BUILD)/generated/species_%.o)
GENERATED_CORE_OBJ += $(SPECIES:%=$(BUILD)/generated/species_%.o) $(BUILD)/generated/species_table.o
BUILD_CC ?= cc
SPECIES_CFLAGS := -std=c17 -O2 -g $(WARN) -ffp-contract=off -D_GNU_SOURCE -I.

generated: $(SPECIES:%=$(BUILD)/generated/species_%.c) $(VARIETIES:%=$(BUILD)/generated/species_%.c) $(BUILD)/generated/species_table.c

$(BUILD)/bake_species: $(SPECIES_OBJ)
	$(call step,LINK,$@)
	$(Q)$(BUILD_CC) -o $@ $^ -lm

$(SPECIES_OBJ): $(BUILD)/bake_host/%.o: %.c
	@mkdir -p $(@D)
	$(call step,CC,$< (for the bake))
	$(Q)$(BUILD_CC) $(SPECIES_CFLAGS) $(DEP_FLAGS) -c -o $@ $<

$(BUILD)/generated/species_%.c: assets/species/%.txt $(BUILD)/bake_species
	@mkdir -p $(@D)
	$(call step,BAKE,$<)
	$(Q)$(BUILD)/bake_species $< $@

$(BUILD)/generated/species_table.c: assets/bake/species.mk
	@mkdir -p $(@D)
	$(Q){ echo '#include "core/morph/species.h"'; \
	    $(foreach s,$(SPECIES),echo 'extern const struct species species_$(s);';) \
	    echo 'const struct species *const species_table[] = {'; \
	    $(foreach s,$(SPECIES),echo '    &species_$(s),';) echo '};'; \
	    echo '_Static_assert($(words $(SPECIES)) <= SPECIES_BUILT_IN, "raise SPECIES_BUILT_IN in core/morph/species.h");'; \
	    echo 'const uint32_t species_table_count = $(words $(SPECIES));'; } > $@

$(BUILD)/generated/species_%.o: $(BUILD)/generated/species_%.c $(FOUND_TOOLS)
	$(call step,CC,$<)
	$(Q)$(CC) $(CORE_CFLAGS) $(DEP_FLAGS) -c -o $@ $<

## picture/species-sheet: Draw each species' growth from three sides in build/
species-sheet: $(SPECIES:%=$(BUILD)/species_%.png)

$(BUILD)/species_%.png: $(BUILD)/kingyoctl
	$(call step,DRAW,$@)
	$(Q)$(BUILD)/kingyoctl morph export $* --sheet $@

.PHONY: species-sheet
