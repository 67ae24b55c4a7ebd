# hid.mk -- what leads a hand from raw reports, under the sanitizers.

## test/test-hand-sanitizers: Test mappings and controllers under the sanitizers
test-hand-sanitizers: $(BUILD)/core.a $(BUILD)/shell.a
	@BUILD=$(BUILD) CC='$(CC)' CFLAGS='$(BASE_CFLAGS) -O1 -Wno-maybe-uninitialized -D_GNU_SOURCE' \
	    tests/hid/sanitizers.sh

.PHONY: test-hand-sanitizers
