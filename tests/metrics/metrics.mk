# metrics.mk -- measures of the structure and the comments of the C code.

## metrics: measures of structure, comments and formatting with their bounds; lists what misses a bound
metrics:
	@python3 tests/metrics/metrics.py --build $(BUILD)

.PHONY: metrics
