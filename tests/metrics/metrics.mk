# metrics.mk -- measures of the structure and the comments of the C code.

## measure/metrics: Measure structure, names and comments against their bounds
metrics:
	@board/setup.sh dev
	@python3 tests/metrics/metrics.py --build $(BUILD)

.PHONY: metrics
