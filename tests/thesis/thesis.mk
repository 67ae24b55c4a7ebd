# thesis.mk -- the 2013 thesis' experiments, repeated with our tank.

THESIS := $(BUILD)/tests/thesis
THESIS_BIN := $(THESIS)/pictures $(THESIS)/table $(THESIS)/curves $(THESIS)/gaps

## thesis-figures: the 2013 thesis' figures and tables as pictures, CSV and a page, in build/thesis/
thesis-figures:
	@board/setup.sh run dev
	+@$(MAKE) --no-print-directory -j$(JOBS) $(BUILD)/kingyoctl $(THESIS_BIN)
	@BUILD=$(BUILD) tests/thesis/figures.sh

$(THESIS)/pictures $(THESIS)/table: $(THESIS)/easel.o
$(THESIS)/curves $(THESIS)/gaps: $(BUILD)/platform/panic.o

$(THESIS_BIN): %: %.o $(BUILD)/ctl.a $(BUILD)/shell.a $(BUILD)/core.a
	$(call step,LINK,$@)
	$(Q)$(CC) $(OPT) -g -o $@ $(filter %.o,$^) $(filter %.a,$^) $(HOST_LIBS)

.PHONY: thesis-figures
