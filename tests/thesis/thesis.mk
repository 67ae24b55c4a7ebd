# thesis.mk -- repeats the experiments of the 2013 thesis with our tank, and those of the 2005
# thesis with our species.

THESIS := $(BUILD)/tests/thesis
THESIS_BIN := $(THESIS)/pictures $(THESIS)/table $(THESIS)/curves $(THESIS)/gaps $(THESIS)/stages

## picture/thesis-figures: Repeat the figures of both theses in build/thesis/ and -2005/
thesis-figures:
	@board/setup.sh run dev
	+@$(MAKE) --no-print-directory -j$(JOBS) $(BUILD)/kingyoctl $(THESIS_BIN)
	@BUILD=$(BUILD) tests/thesis/figures_2005.sh
	@BUILD=$(BUILD) tests/thesis/figures.sh

## picture/thesis-figures-2005: Repeat the figures of the 2005 thesis only
thesis-figures-2005:
	@board/setup.sh run dev
	+@$(MAKE) --no-print-directory -j$(JOBS) $(BUILD)/kingyoctl $(THESIS)/stages
	@BUILD=$(BUILD) tests/thesis/figures_2005.sh

$(THESIS)/pictures $(THESIS)/table: $(THESIS)/easel.o
$(THESIS)/curves $(THESIS)/gaps $(THESIS)/stages: $(BUILD)/platform/panic_core.o

$(THESIS_BIN): %: %.o $(BUILD)/ctl.a $(BUILD)/shell.a $(BUILD)/core.a
	$(call step,LINK,$@)
	$(Q)$(CC) $(OPT) -g -o $@ $(filter %.o,$^) $(filter %.a,$^) $(HOST_LIBS)

.PHONY: thesis-figures thesis-figures-2005
