# mutants.mk -- whether the unit tests detect small faults in the modules that keep money, devices and the game.

COUNT ?= 200
SEED ?= 1
MUTANT_SRC ?= $(wildcard core/game/*.c platform/store/*.c) $(DRIVER_SRC)

## mutants: COUNT (200) random small faults by SEED (1) in core/game, drivers and platform/store against the unit tests
mutants:
	@board/setup.sh test
	@tests/mutants/mutants.sh $(BUILD)/mutants $(COUNT) $(SEED) $(MUTANT_SRC)

.PHONY: mutants
