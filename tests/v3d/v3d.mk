# v3d.mk -- measures of what the GPU of a Raspberry Pi (V3D) would do with a frame.

GL_TRACE := $(BUILD)/tests/v3d/gl_trace.so
$(GL_TRACE): tests/v3d/gl_trace.c
	$(call step,LINK,$@)
	@mkdir -p $(@D)
	$(Q)$(CC) -std=c17 -O1 -Wall -Wextra -shared -fPIC -o $@ $<
