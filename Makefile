# Short commands. PRESET=dev|release|audit|asan|tsan|coverage|bench (CMakePresets.json).
PRESET ?= release
DEMO ?= examples/tuff_wall/model.toml
STUDY ?= examples/tuff_wall/study.toml
BUILD := build/$(PRESET)
# Instruction sets that kernels are built for: all, or native, those of this machine alone (cmake/kernels.cmake).
KERNELS ?= all
SOURCES = $(shell find include src apps tests benchmarks -name '*.h' -o -name '*.cpp')

.PHONY: all help setup build demo wasm test test-long fuzz sanitize bench docs site web studio format check install package clean
all: build

help:            ## this list
	@sed -n 's/^\([a-z-]*\): .*## */\1\t/p' $(MAKEFILE_LIST)

setup:           ## install the missing packages of deps/apt.txt
	@tools/setup

configure: setup
	@cmake --preset $(PRESET) -DWYTHE_KERNELS=$(KERNELS) >build-configure.log 2>&1 \
	  || { cat build-configure.log; rm -f build-configure.log; exit 1; }
	@rm -f build-configure.log

build: configure ## compile: build/<preset>/wythe
	@cmake --build --preset $(PRESET)

demo: KERNELS = native
demo: configure  ## run one wall, then 24 samples of its study; says where the reports are
	@cmake --build --preset $(PRESET) --target wythe_cli
	$(BUILD)/wythe run $(DEMO) --out $(BUILD)/demo
	@rm -rf $(BUILD)/demo_campaign
	$(BUILD)/wythe campaign $(STUDY) --out $(BUILD)/demo_campaign --samples 24
	@echo "open $(BUILD)/demo/report.html and $(BUILD)/demo_campaign/report.html"

wasm: setup      ## the engine for browsers and Node: build/wasm/package (Emscripten, deps/wasm.txt)
	@tools/setup deps/wasm.txt
	@cmake --preset wasm >build-configure.log 2>&1 || { cat build-configure.log; rm -f build-configure.log; exit 1; }
	@rm -f build-configure.log
	@cmake --build --preset wasm

test: wasm       ## build and run every test; last line: N passed, N failed
	@tools/run_tests --preset $(PRESET)

test-long: setup ## the tests that are too dear for each change; docs/testing.md
	@tools/run_tests --preset $(PRESET) --long

fuzz:            ## feed every reader with what libFuzzer makes up, a minute each (tools/fuzz)
	@tools/fuzz

sanitize: setup  ## tests of C++ and of the command line under address, undefined and thread sanitizers, two hours; docs/testing.md
	@tools/sanitize

bench: configure ## kernels, campaigns and scaling: benchmarks/results/<machine>/<date>.json, then tools/bench page
	@cmake --build --preset $(PRESET) --target wythe_bench fall_bench wythe_cli
	tools/bench run --build $(BUILD)

docs: configure  ## write docs/reference from the specs' descriptions and the program's help, and the types of answers
	@cmake --build --preset $(PRESET) --target wythe_reference wythe_cli wythe_python
	$(BUILD)/wythe_reference docs/reference web/src/headers
	tools/command_line $(BUILD)/wythe docs/reference/command_line.md
	PYTHONPATH=$(BUILD)/python tools/answer_types python/wythe/answers.py

site:            ## build/site: these pages as a site, offline, and the studio where it is built; packages: deps/site.txt
	@tools/setup deps/site.txt
	@tools/site

web: setup       ## build the report viewer: src/report/assets/viewer.html
	@cd web && npm ci --no-audit --no-fund && npm run build

studio: wasm     ## build the page to draw walls on: build/studio.html, and for build/wasm/package
	@cd web && npm ci --no-audit --no-fund && npx tsc && STUDIO_OUT=../build/wasm/page npx vite build --config vite.studio.config.js
	@node apps/wasm/page.mjs build/wasm/page/studio.html build/wasm build/studio.html build/wasm/package

format:          ## clang-format all C++
	clang-format -i $(SOURCES)

check: configure ## layers, sizes, words, format, clang-tidy
	tools/check_layers
	tools/check_sizes
	tools/check_words
	tools/check_format
	run-clang-tidy -quiet -p $(BUILD) '/(src|apps)/' >$(BUILD)/tidy.txt 2>&1 \
	  || { grep -E 'warning:|error:' $(BUILD)/tidy.txt; exit 1; }

package: setup   ## build/package: Debian packages of the last commit: program, library, headers, Python module, studio
	@tools/setup deps/package.txt
	rm -rf build/package && mkdir -p build/package/wythe
	git archive HEAD | tar x -C build/package/wythe
	@if command -v em++ >/dev/null; then $(MAKE) studio && install -D -m 644 build/studio.html build/package/wythe/build/studio.html; \
	  else echo "no Emscripten (deps/wasm.txt): the packages get no studio"; fi
	cd build/package/wythe && PATH=/usr/sbin:/usr/bin:/sbin:/bin DEB_BUILD_OPTIONS="noautodbgsym $(DEB_BUILD_OPTIONS)" dpkg-buildpackage -us -uc -b
	rm -rf build/package/wythe
	lintian --allow-root --fail-on=error,warning --suppress-tags=initial-upload-closes-no-bugs build/package/*.changes

install: build   ## install to PREFIX (default /usr/local)
	cmake --install $(BUILD) --prefix $(or $(PREFIX),/usr/local)

clean:           ## remove every build
	rm -rf build
