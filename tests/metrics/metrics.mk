# metrics.mk -- measures of the structure and the comments of the C code.

## measure/metrics: Measure structure, names and comments against their bounds
metrics:
	@board/setup.sh dev
	@python3 tests/metrics/metrics.py --build $(BUILD)

## measure/same-code: Check that COMMIT, a pure rename, leaves the object code as it was
same-code:
	@tests/metrics/same_code.sh $(COMMIT)

.PHONY: metrics same-code
