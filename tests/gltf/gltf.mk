# gltf.mk -- checks the glTF files of kingyoctl with other programs.

GLTF := $(BUILD)/gltf

## test/test-gltf: Check exported .glb files with Khronos' validator and three.js
test-gltf: build
	@board/setup.sh test gltf
	@command -v node >/dev/null && command -v npm >/dev/null || board/setup.sh node
	@BUILD=$(BUILD) tests/run.sh $(RESULTS) tests/gltf/test_gltf.sh

.PHONY: test-gltf
