# paper.mk -- draws the figures of the paper for visual inspection, and computes its tension.

PAPER_CURVES := $(BUILD)/tests/paper/curves
PAPER_MEMBRANE := $(BUILD)/tests/paper/membrane

## picture/paper-figures: Plot tear time, force and holes of the paper in build/paper/
paper-figures:
	@board/setup.sh dev
	+@$(MAKE) --no-print-directory -j$(JOBS) $(PAPER_CURVES)
	@mkdir -p $(BUILD)/paper
	@$(PAPER_CURVES) tear >$(BUILD)/paper/tear.tsv
	@$(PAPER_CURVES) force >$(BUILD)/paper/force.tsv
	@$(PAPER_CURVES) holes $(BUILD)/paper
	@gnuplot -e "dir='$(BUILD)/paper'" tests/paper/plots.gp
	@ls $(BUILD)/paper/*.svg $(BUILD)/paper/*.png

$(PAPER_CURVES): %: %.o $(BUILD)/ctl.a $(BUILD)/shell.a $(BUILD)/core.a
	$(call step,LINK,$@)
	$(Q)$(CC) $(OPT) -g -o $@ $^ $(HOST_LIBS)

## measure/bench-membrane: Compute the tension of paper under a load by finite elements
bench-membrane:
	+@$(MAKE) --no-print-directory -j$(JOBS) $(PAPER_MEMBRANE)
	@$(PAPER_MEMBRANE)

$(PAPER_MEMBRANE): %: %.o $(BUILD)/core.a
	$(call step,LINK,$@)
	$(Q)$(CC) $(OPT) -g -o $@ $^ -lm

.PHONY: paper-figures bench-membrane
