# hid.mk -- tests the code from raw reports to the pose of a controller, under the sanitizers.

## test/test-hid-sanitizers: Test mappings and controllers under the sanitizers
test-hid-sanitizers: $(BUILD)/core.a $(BUILD)/shell.a
	@BUILD=$(BUILD) CC='$(CC)' CFLAGS='$(BASE_CFLAGS) -O1 -Wno-maybe-uninitialized -D_GNU_SOURCE' \
	    tests/hid/sanitizers.sh

.PHONY: test-hid-sanitizers
