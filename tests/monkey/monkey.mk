# monkey.mk -- random keys, pointer events, window sizes and plug events under the sanitizers.
# Clang compiles every object of the kiosk again with the sanitizers. The baked files contain only
# data and come from the normal build.

MONKEY := $(BUILD)/monkey
MONKEY_CC := clang
MONKEY_SAN := -fsanitize=address,undefined,float-cast-overflow -fno-sanitize-recover=all
MONKEY_CFLAGS = $(filter-out $(OPT) -g,$(BASE_CFLAGS)) -O1 -gline-tables-only $(MONKEY_SAN) \
    -D_GNU_SOURCE $(LIB_CFLAGS) -DKINGYO_BOARD=\"$(BOARD)\"
MONKEY_CORE_OBJ = $(CORE_SRC:%.c=$(MONKEY)/%.o) $(WIDE_SRC:%.c=$(MONKEY)/%_8.o)
MONKEY_SHELL_OBJ = $(patsubst %.c,$(MONKEY)/%.o,$(PLATFORM_SRC) $(KIOSK_SRC) $(DRIVER_SRC) $(BOARD_SRC))
MONKEY_OBJ = $(MONKEY_CORE_OBJ) $(filter-out %/main.o,$(MONKEY_SHELL_OBJ)) $(GENERATED_CORE_OBJ) $(GENERATED_OBJ)

## test/test-monkey: Send random input to a sanitizer build; SECONDS=60, SEED=n
test-monkey:
	@board/setup.sh dev
	+@$(MAKE) --no-print-directory -j$(JOBS) $(MONKEY)/monkey $(MONKEY)/kingyo $(BUILD)/tests/monkey/fingers
	@BUILD=$(BUILD) tests/monkey/monkey.sh $(or $(SECONDS),60) $(SEED)

$(MONKEY)/monkey: $(MONKEY)/tests/monkey/monkey.o $(MONKEY)/tests/monkey/random_step.o
$(MONKEY)/kingyo: $(MONKEY)/platform/kiosk/main.o
$(MONKEY)/monkey $(MONKEY)/kingyo: $(MONKEY_OBJ)
	$(call step,LINK,$@)
	$(Q)$(MONKEY_CC) $(MONKEY_SAN) -o $@ $^ $(HOST_LIBS)

$(MONKEY)/core/%.o $(MONKEY)/core/%_8.o: MONKEY_CFLAGS += -ffreestanding -fno-math-errno -Wno-psabi
$(MONKEY)/core/%_8.o: core/%.c $(FOUND) $(FOUND_CLANG) | generated
	@mkdir -p $(@D)
	$(call step,CC,$< (8 lanes, sanitized))
	$(Q)$(MONKEY_CC) $(MONKEY_CFLAGS) $(WIDE_CFLAGS) $(DEP_FLAGS) -c -o $@ $<

$(MONKEY)/%.o: %.c $(FOUND) $(FOUND_CLANG) | generated
	@mkdir -p $(@D)
	$(call step,CC,$< (sanitized))
	$(Q)$(MONKEY_CC) $(MONKEY_CFLAGS) $(DEP_FLAGS) -c -o $@ $<

$(BUILD)/tests/monkey/fingers: $(BUILD)/tests/monkey/fingers.o $(BUILD)/tests/monkey/random_step.o $(BUILD)/core.a
	$(call step,LINK,$@)
	$(Q)$(CC) -o $@ $^ -lXtst -lX11 -lm

.PHONY: test-monkey
