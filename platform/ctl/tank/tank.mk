# tank.mk -- compiles `kingyoctl tank` and the core below it for 131,072 fish.
#
# The kiosk has room for 2,048 fish (core/tank/tank.h). The command is one object with a copy of the
# tank of its own: only its entry is a global symbol, so that both sizes exist in one program. The rule
# fails when that object would use a function of the core that was compiled for the kiosk's size.

MANY := $(BUILD)/many
MANY_CFLAGS := -DTANK_FISH_MAX=131072u
MANY_SRC := $(foreach part,base tank morph poi,$(call sources,core/$(part)))
MANY_OBJ = $(MANY_SRC:%.c=$(MANY)/%.o) $(filter $(MANY_SRC:%.c=$(MANY)/%_8.o),$(WIDE_SRC:%.c=$(MANY)/%_8.o))
MANY_TANK_SRC := $(call sources,platform/ctl/tank)
OBJCOPY ?= objcopy
NM ?= nm

$(MANY)/tank.o: $(MANY_TANK_SRC:%.c=$(MANY)/%.o) $(MANY_OBJ) $(GENERATED_CORE_OBJ) $(BUILD)/core.a
	$(call step,LINK,$@)
	$(Q)$(LD) -r -o $@ $(filter-out %.a,$^)
	$(Q)$(OBJCOPY) --keep-global-symbol=ctl_tank $@
	$(Q)! $(NM) -u $@ | awk '{ print $$2 }' | grep -wFf <($(NM) -g --defined-only $(BUILD)/core.a | \
	    awk 'NF == 3 && $$3 != "core_panic" { print $$3 }') || \
	    { echo 'tank.o: these functions of the core are compiled for 2,048 fish' >&2; rm -f $@; exit 1; }

$(MANY)/platform/%.o: platform/%.c $(FOUND) | generated
	@mkdir -p $(@D)
	$(call step,CC,$< (many fish))
	$(Q)$(CC) $(HOST_CFLAGS) $(MANY_CFLAGS) $(DEP_FLAGS) -c -o $@ $<

$(MANY)/core/%.o: core/%.c $(FOUND_TOOLS) | generated
	@mkdir -p $(@D)
	$(call step,CC,$< (many fish))
	$(Q)$(CC) $(CORE_CFLAGS) $(MANY_CFLAGS) $(DEP_FLAGS) -c -o $@ $<

$(MANY)/core/%_8.o: core/%.c $(FOUND_TOOLS) | generated
	@mkdir -p $(@D)
	$(call step,CC,$< (many fish, 8 lanes))
	$(Q)$(CC) $(CORE_CFLAGS) $(WIDE_CFLAGS) $(MANY_CFLAGS) $(DEP_FLAGS) -c -o $@ $<
