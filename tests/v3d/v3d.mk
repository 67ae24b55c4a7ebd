# v3d.mk -- measures of what the GPU of a Raspberry Pi (V3D) would do with a frame.

GL_TRACE := $(BUILD)/tests/v3d/gl_trace.so
$(GL_TRACE): tests/v3d/gl_trace.c
	$(call step,LINK,$@)
	@mkdir -p $(@D)
	$(Q)$(CC) -std=c17 -O1 -Wall -Wextra -shared -fPIC -o $@ $<

## measure/bench-v3d: Estimate a frame on Raspberry Pi 4 and 5 (builds Mesa's compiler)
bench-v3d:
	@tests/v3d/build.sh $(BUILD)/v3d
	@tests/v3d/bench.sh $(BUILD)/v3d $(SCENES)

.PHONY: bench-v3d
