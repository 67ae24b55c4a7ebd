# mutants.mk -- checks whether the unit tests detect small faults in the modules for money, devices
# and the game.

MUTANT_SEED ?= 1
MUTANT_SRC ?= $(call sources,core/game) $(call sources,platform/store) $(DRIVER_SRC)

## test/mutants: Count which of COUNT=200 random faults the unit tests detect
mutants: COUNT ?= 200
mutants:
	@board/setup.sh test
	@tests/mutants/mutants.sh $(BUILD)/mutants $(COUNT) $(MUTANT_SEED) $(MUTANT_SRC)

.PHONY: mutants
