# species.mk -- bakes assets/species/*.txt into constant tables of the core.

SPECIES := wakin
SPECIES_PARTS := species species_read species_shape species_loft species_write
SPECIES_OBJ := $(SPECIES_PARTS:%=$(BUILD)/assets/bake/%.o)
GENERATED_CORE_OBJ += $(SPECIES:%=$(BUILD)/generated/species_%.o)
BUILD_CC ?= cc
SPECIES_CFLAGS := -std=c17 -O2 -g $(WARN) -ffp-contract=off -D_GNU_SOURCE -I.

generated: $(SPECIES:%=$(BUILD)/generated/species_%.c)

$(BUILD)/bake_species: $(SPECIES_OBJ)
	$(call step,LINK,$@)
	$(Q)$(BUILD_CC) -o $@ $^ -lm

$(SPECIES_OBJ): $(BUILD)/assets/bake/%.o: assets/bake/%.c
	@mkdir -p $(@D)
	$(call step,CC,$<)
	$(Q)$(BUILD_CC) $(SPECIES_CFLAGS) $(DEP_FLAGS) -c -o $@ $<

$(BUILD)/generated/species_%.c: assets/species/%.txt $(BUILD)/bake_species
	@mkdir -p $(@D)
	$(call step,BAKE,$<)
	$(Q)$(BUILD)/bake_species $< $@

$(BUILD)/generated/species_%.o: $(BUILD)/generated/species_%.c
	$(call step,CC,$<)
	$(Q)$(CC) $(CORE_CFLAGS) $(DEP_FLAGS) -c -o $@ $<

## species-sheet: each species' growth from four sides, in build/species_NAME.png, for makers
species-sheet: $(SPECIES:%=$(BUILD)/species_%.png)

$(BUILD)/species_%.png: $(BUILD)/species_sheet_%
	$< $@

$(BUILD)/species_sheet_%: assets/bake/species_sheet.c $(BUILD)/generated/species_%.o $(BUILD)/core.a
	$(call step,CC,$<)
	$(Q)$(BUILD_CC) $(SPECIES_CFLAGS) -DSPECIES=species_$* $(DEP_FLAGS) -o $@ $^ -lm

.PHONY: species-sheet
