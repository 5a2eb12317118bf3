# SPDX-License-Identifier: MIT
#
# invcal. A C compiler and make are all that `make demo` and `make test` need.

CC     ?= cc
AR     ?= ar
STD    ?= c99
CFLAGS ?= -O1
BUILD  ?= build
# Where `make install` puts everything, below DESTDIR.
PREFIX ?= /usr/local
# The folder of unity.h and unity.c: the tests build with any Unity.
UNITY  ?= tests/unity

include port/options.mk
$(foreach path,BUILD UNITY,$(call check_path,$(path)))
$(call check_options,CFLAGS,$(CFLAGS))
$(if $(filter INVCAL_DOUBLE,$(call options_set,$(CFLAGS))),$(error CFLAGS: INVCAL_DOUBLE is not chosen there: \
    there is a library for each number type, libinvcal.a in float and libinvcal_double.a in double))

# In other locales awk and printf write 1,5 for 1.5, and sort uses another order.
export LC_NUMERIC := C
export LC_COLLATE := C
unexport LC_ALL

WARNINGS := -Wall -Wextra -Wconversion -Wdouble-promotion -Wshadow -pedantic
# No contraction (fused multiply-add), for the same bits on every machine. No errno: the square root of a
# negative number is just a NaN.
FLAGS     = -std=$(STD) -ffp-contract=off -fno-math-errno $(WARNINGS) $(CFLAGS) -Iinclude

SOURCES := $(wildcard src/*/*.c)
HOST    := $(wildcard port/host/*.c port/host/*/*.c)
SUITES  := $(patsubst tests/unit/%.c,%,$(wildcard tests/unit/test_*.c))
TOOL_SUITES := $(patsubst tests/tool/%.c,%,$(wildcard tests/tool/test_*.c))
DATA    := $(wildcard tests/data/*_positions.csv)
# Where a compiler does not write what an object depends on, such as tcc, each depends on every header.
TRACK   := $(shell $(CC) -MM -MP -x c /dev/null > /dev/null 2>&1 && echo -MMD -MP)
HEADERS := $(if $(TRACK),,$(wildcard include/invcal/*.h src/*/*.h port/*.h port/host/*/*.h tests/*.h tests/*/*.h))
# With ASSERT=1, programming errors abort (INVCAL_ASSERT).
ASSERT_FLAGS := $(if $(ASSERT),-DINVCAL_CONFIG_HEADER='"assert_config.h"' -Itests/unit)
# The degree of thermal.h, for the library and its tests; without DEGREE, its default.
DEGREE_FLAGS := $(if $(DEGREE),-DINVCAL_THERMAL_DEGREE=$(DEGREE))
# By default the unit tests compile quickly, draw a tenth of their samples, and skip what takes long. LONG=1 runs all
# of it, in double, too; make check sets it, in build folders of its own.
SHORT_FLAGS := $(if $(LONG),,-Og -DTEST_SHORT=10)
TYPES ?= float $(if $(LONG),double)
# make V=1 shows the commands.
Q := $(if $(V),,@)

# What the objects of each kind were compiled with. UNITY and LONG are for the tests.
library_words = $(CC) $(AR) $(FLAGS) $(DEGREE_FLAGS) $(ASSERT_FLAGS) $(UNITY)
tool_words    = $(CC) $(TOOL_COMPILER_FLAGS) $(TOOL_FLAGS) $(ASSERT_FLAGS) $(UNITY)
tests_words   = $(SHORT_FLAGS)
page_words    = $(WASM) $(TOOL_FLAGS)

.DEFAULT_GOAL := all
.DELETE_ON_ERROR:
.SECONDARY:
.PHONY: help all install uninstall demo web test check check-web windows targets builds firmware size bench schema pages manual derived \
    rules coverage mutation fuzz misuse proof numerics check-gates check-shells reference fleet format deps \
    package packages check-packages dist clean

help: ## this list
	@awk -F ':.*## ' '/^[a-z-]+:.*## / { printf "make %-14s %s\n", $$1, $$2 }' $(MAKEFILE_LIST)

all: $(BUILD)/float/libinvcal.a $(BUILD)/double/libinvcal.a $(BUILD)/invcal ## both libraries and the tool

# What is installed where under PREFIX, FROM:TO. The float and the double library have different names;
# they share the headers, which invcal.pc and invcal-double.pc configure.
INSTALLED := $(BUILD)/invcal:bin/invcal $(BUILD)/invcal.1:share/man/man1/invcal.1 \
    port/host/invcal.bash:share/bash-completion/completions/invcal \
    port/host/schema.json:share/invcal/schema.json \
    $(BUILD)/float/libinvcal.a:lib/libinvcal.a $(BUILD)/double/libinvcal.a:lib/libinvcal_double.a \
    $(BUILD)/invcal.pc:lib/pkgconfig/invcal.pc \
    $(BUILD)/invcal-double.pc:lib/pkgconfig/invcal-double.pc \
    $(foreach header,$(wildcard include/invcal/*.h),$(header):$(header))
# As typed, whatever is special to make or a shell.
into = into=$(call quoted,$(value DESTDIR)$(value PREFIX))

install: all $(BUILD)/invcal.1 pkg-config ## tool, manual, completion, schema; libraries, headers, .pc (PREFIX=, DESTDIR=)
	$(Q)$(into); for pair in $(INSTALLED); do \
	    to=$$into/$${pair#*:}; mkdir -p "$${to%/*}" && \
	    install -m 644 "$${pair%:*}" "$$to" || exit; \
	done && chmod 755 "$$into/bin/invcal"

uninstall: ## remove what install put there
	$(Q)$(into); for pair in $(INSTALLED); do rm -f "$$into/$${pair#*:}"; done; \
	    rmdir "$$into/include/invcal" "$$into/share/invcal" 2> /dev/null || true

# Made every time, as they contain the prefix and the options of the libraries.
CHOICES = $(foreach w,$(call option_words,$(CFLAGS) $(DEGREE_FLAGS)),$(if $(findstring -DINVCAL_ASSERT,$(w)),,$(w)))
.PHONY: pkg-config
pkg-config:
	@mkdir -p $(BUILD)
	$(Q)for name in invcal invcal-double; do \
	    sh port/pkg-config/pc.sh $$name $(call quoted,$(value PREFIX)) $(call quoted,$(CHOICES)) > $(BUILD)/$$name.pc || exit; \
	done

demo: $(BUILD)/invcal ## from a raw log to calibrated readings; then a real sensor's positions
	@echo 'A simulated MPU-6050 at 2 g, carried by hand through 18 orientations, 5 seconds in each:'
	@echo
	$(BUILD)/invcal simulate --plan edges --truth $(BUILD)/demo-truth.json \
	    > $(BUILD)/demo-log.csv
	$(BUILD)/invcal calibrate $(BUILD)/demo-log.csv --sensor mpu6050:2g \
	    --out $(BUILD)/demo-cal.json
	@awk -F '[][,]' '/"offset"/ { printf "The true offsets, unknown to the tool: %.2f %.2f %.2f counts.\n", \
	    $$2, $$3, $$4 }' $(BUILD)/demo-truth.json
	@echo
	$(BUILD)/invcal apply $(BUILD)/demo-cal.json $(BUILD)/demo-log.csv \
	    > $(BUILD)/demo-calibrated.csv
	@sed -n '1,4p' $(BUILD)/demo-log.csv; echo '... becomes'; sed -n '1,4p' $(BUILD)/demo-calibrated.csv
	@echo
	@echo 'Xsens MTi, 38 rest positions by hand, raw counts; "factory" is its maker'"'"'s calibration.'
	@echo
	$(BUILD)/invcal calibrate tests/data/xsens_mti_positions.csv --positions \
	    --gravity 9.81744 --zero 33123,33276,32360 \
	    --lsb 0.002409639,0.002421308,0.002409639 --nominal-name factory

# ---- the library and its tests, once for each number type: build/float, build/double ----------

define variant
$(BUILD)/$(1)/%.o: %.c $(BUILD)/words/library $(HEADERS)
	@mkdir -p $$(@D)
	$(Q)$$(CC) $$(FLAGS) -DINVCAL_DOUBLE=$(2) $(DEGREE_FLAGS) $$(EXTRA) $(TRACK) -c $$< -o $$@

# Sections: a program's linker with --gc-sections drops what it does not call.
$(BUILD)/$(1)/src/%.o: EXTRA += -ffunction-sections -fdata-sections $(ASSERT_FLAGS)

$(BUILD)/$(1)/libinvcal.a: $(SOURCES:%.c=$(BUILD)/$(1)/%.o)
	$(Q)rm -f $$@ && $$(AR) rcs $$@ $$^

$(BUILD)/$(1)/unity.o: $(UNITY)/unity.c $(UNITY)/unity.h $(BUILD)/words/library
	@mkdir -p $$(@D)
	$(Q)$$(CC) $$(FLAGS) -DUNITY_INCLUDE_DOUBLE -DUNITY_STRICT -I$(UNITY) -c $$< -o $$@

$(BUILD)/$(1)/tests/unit/%.o: EXTRA += -DUNITY_INCLUDE_DOUBLE -DUNITY_STRICT -I$(UNITY) \
    -Isrc -Itests/unit -Itests/reference -I$(BUILD) $(SHORT_FLAGS)
$(SUITES:%=$(BUILD)/$(1)/tests/unit/%.o): $(BUILD)/words/tests | $(BUILD)/positions.h

$(BUILD)/$(1)/test_%: $(BUILD)/$(1)/tests/unit/test_%.o $(BUILD)/$(1)/tests/unit/support.o \
    $(BUILD)/$(1)/unity.o $(BUILD)/$(1)/libinvcal.a
	$(Q)$$(CC) $$(FLAGS) $$^ -lm -o $$@
endef
$(eval $(call variant,float,0))
$(eval $(call variant,double,1))

# Prints the bits of everything that the library computes, to be compared with those of the targets.
DIGEST := $(patsubst %.c,$(BUILD)/float/%.o,$(wildcard tests/digest/*.c))
$(DIGEST) $(BUILD)/float/port/hosted/board.o: EXTRA += -Iport -Isrc -Itests/reference -I$(BUILD)
$(BUILD)/float/tests/digest/calibrations.o: | $(BUILD)/positions.h
$(BUILD)/float/digest: $(DIGEST) $(BUILD)/float/port/hosted/board.o $(BUILD)/float/libinvcal.a
	$(Q)$(CC) $(FLAGS) $^ -lm -o $@

# The position means as C arrays, for targets without files.
$(BUILD)/positions.h: tests/data/to_c.awk $(DATA)
	@mkdir -p $(@D)
	$(Q)awk -f $^ > $@

# The host tool: the library in double, with more positions and averaging times than on a device, and quadratics in
# temperature. The library's options in CFLAGS do not apply to it.
TOOL_FLAGS = -DINVCAL_DOUBLE=1 -DINVCAL_MAX_POSITIONS=64 -DINVCAL_ALLAN_TAUS=31 \
    -DINVCAL_PRIVATE_OVERLAP=4096 -DINVCAL_THERMAL_DEGREE=2 -DINVCAL_MAX_SEGMENTS=1000 -Iport/host -Isrc
TOOL_COMPILER_FLAGS = $(filter-out $(CHOICES),$(subst -D INVCAL_,-DINVCAL_,$(FLAGS)))
$(BUILD)/tool/%.o: %.c $(BUILD)/words/tool $(HEADERS)
	@mkdir -p $(@D)
	$(Q)$(CC) $(TOOL_COMPILER_FLAGS) $(TOOL_FLAGS) $(ASSERT_FLAGS) $(EXTRA) $(TRACK) -c $< -o $@

$(BUILD)/invcal: $(HOST:%.c=$(BUILD)/tool/%.o) $(SOURCES:%.c=$(BUILD)/tool/%.o)
	$(Q)$(CC) $(FLAGS) $^ -lm -o $@

# For Windows, with MinGW-w64: port/windows supplies the POSIX functions that it lacks.
$(BUILD)/invcal.exe: $(BUILD)/words/tool $(HOST) $(SOURCES) $(wildcard include/invcal/*.h src/*/*.h port/host/*/*.h port/windows/*.[ch] port/windows/*/*.h)
	$(call need,x86_64-w64-mingw32-gcc)
	@mkdir -p $(@D)
	$(Q)x86_64-w64-mingw32-gcc -std=$(STD) -O2 -ffp-contract=off -fno-math-errno -Wall -Wextra -Iinclude $(TOOL_FLAGS) \
	    -D__USE_MINGW_ANSI_STDIO=1 -Iport/windows -include port/windows/posix.h \
	    $(HOST) $(SOURCES) port/windows/posix.c -static -s -o $@

windows: $(BUILD)/invcal.exe ## build/invcal.exe, the tool for Windows, with MinGW-w64

# The tool's unit tests.
$(BUILD)/tool/tool.a: $(filter-out %/main.o,$(HOST:%.c=$(BUILD)/tool/%.o)) $(SOURCES:%.c=$(BUILD)/tool/%.o)
	$(Q)rm -f $@ && $(AR) qcs $@ $^
$(BUILD)/tool/tests/%.o: EXTRA += -DUNITY_INCLUDE_DOUBLE -DUNITY_STRICT -I$(UNITY) \
    -Itests/unit -Itests/reference
$(BUILD)/tool/test_%: $(BUILD)/tool/tests/tool/test_%.o $(BUILD)/tool/tests/unit/support.o \
    $(BUILD)/double/unity.o $(BUILD)/tool/tool.a
	$(Q)$(CC) $(FLAGS) $^ -lm -o $@

# The man page, made from the tool's own help.
$(BUILD)/invcal.1: port/host/man.sh $(BUILD)/invcal
	$(Q)sh $^ > $@

# ---- the page: port/web ------------------------------------------------------------------------

# As WebAssembly: the library, and the tool without the terminal of watch.
WASM = clang-19 --target=wasm32-wasi -Oz -std=$(STD) -ffp-contract=off -fno-math-errno -Iinclude -Wl,--strip-all
# wasi-libc has no command that `need` could look for.
need_wasm = @for file in /usr/include/wasm32-wasi/stdio.h $$(clang-19 -print-resource-dir)/lib/wasi/libclang_rt.builtins-wasm32.a; do \
    [ -e "$$file" ] || { echo "$${file\#\#*/} is not installed: make deps" >&2; exit 1; }; done
WASM_HOST := $(filter-out $(patsubst %,port/host/watch/%.c,live wave interrupt screen),$(HOST))

$(BUILD)/web/live.wasm: port/web/live.c $(BUILD)/words/page $(SOURCES) $(wildcard include/invcal/*.h src/*/*.h)
	$(call need,clang-19)
	$(call need,wasm-ld-19)
	$(need_wasm)
	@mkdir -p $(@D)
	$(Q)$(WASM) $(WARNINGS) -Isrc -DINVCAL_DOUBLE=1 -DINVCAL_MAX_POSITIONS=64 -mexec-model=reactor -nostartfiles \
	    -Wl,--no-entry $(SOURCES) $< -o $@

$(BUILD)/web/tool.wasm: port/web/wasi.c $(BUILD)/words/page port/web/wasi.h $(WASM_HOST) $(SOURCES) \
    $(wildcard include/invcal/*.h src/*/*.h port/host/*/*.h)
	$(call need,clang-19)
	$(call need,wasm-ld-19)
	$(need_wasm)
	@mkdir -p $(@D)
	$(Q)$(WASM) $(TOOL_FLAGS) -Wno-deprecated-declarations -include port/web/wasi.h \
	    -D_WASI_EMULATED_SIGNAL -D_WASI_EMULATED_GETPID $(WASM_HOST) $(SOURCES) $< \
	    -Wl,--stack-first,-z,stack-size=1048576 -lwasi-emulated-signal -lwasi-emulated-getpid -o $@

# npm's packages, pinned by the lock file.
$(BUILD)/web/npm/node_modules/.package-lock.json: port/web/package.json port/web/package-lock.json
	$(call need,npm)
	@mkdir -p $(BUILD)/web/npm
	$(Q)cp $^ $(BUILD)/web/npm && cd $(BUILD)/web/npm && npm ci --silent --no-audit --no-fund && \
	    touch node_modules/.package-lock.json || { echo 'npm cannot install the packages of port/web/package.json' >&2; exit 1; }

$(BUILD)/invcal.html: $(BUILD)/web/live.wasm $(BUILD)/web/tool.wasm $(BUILD)/web/npm/node_modules/.package-lock.json \
    LICENSE $(wildcard port/web/*.js port/web/*.mjs port/web/*.html port/web/*.css port/web/*.txt)
	$(Q)node port/web/build.mjs $(BUILD) "$$(sh port/version.sh)"

web: $(BUILD)/invcal.html ## build/invcal.html: calibrate live in a browser, or drop a log; one file, no installation

# ---- tests ------------------------------------------------------------------------------------

# Stops with one line if a command is missing: $(call need,command)
need = @command -v $(1) > /dev/null || { echo '$(1) is not installed: make deps' >&2; exit 1; }
# In front of a gate: it must make as many checks as tests/floors.txt states, if all of it is run: $(call gate,NAME,PARTS)
gate = $(if $(strip $(2)),,sh tests/gate.sh '$(1)')

# PART=src: only the unit tests of the library, without building the tool. PART=host: everything else.
UNIT_TESTS := $(foreach type,$(TYPES),$(SUITES:%=$(BUILD)/$(type)/%))
TOOL_TESTS := $(TOOL_SUITES:%=$(BUILD)/tool/%) all
test: $(if $(filter host,$(PART)),,$(UNIT_TESTS)) $(if $(filter src,$(PART)),,$(TOOL_TESTS)) ## the tests with one compiler; make check also runs the long ones
	$(Q)CC=$(call quoted,$(CC)) CFLAGS=$(call quoted,$(CFLAGS)) UNITY="$(UNITY)" LONG="$(LONG)" PART="$(PART)" TYPES="$(TYPES)" sh tests/run.sh $(BUILD)

coverage: ## what the tests reach: lines, branches, MC/DC of src/, lines of the tool (PART=src, PART=host)
	$(call need,llvm-cov-19)
	$(Q)sh tests/gate.sh 'coverage $(PART)' sh tests/coverage.sh $(BUILD) $(PART)

check: schema ## all tests at full length under gcc and clang, C99 and C11; and with sanitizers
	$(Q)$(call gate,check,$(CONFIGURATION) $(ONLY)) sh tests/check.sh $(BUILD)/check

mutation: ## do the unit tests notice small changes to src/? (SAMPLE=, SEED=, ONLY=files, V=1)
	$(call need,python3)
	$(Q)CC=$(call quoted,$(CC)) sh tests/mutation.sh $(BUILD) $(or $(SAMPLE),150) $(or $(SEED),1) $(ONLY)

# All targets at full length come with all builds.
targets: $(BUILD)/float/digest $(if $(QUICK)$(TARGETS),,builds) ## the unit tests on emulated targets, and the same bits on all of them (QUICK=1)
	$(Q)QUICK="$(QUICK)" $(call gate,targets $(if $(QUICK),quick),$(TARGETS)) sh tests/targets.sh $(BUILD) $(TARGETS)

builds: $(BUILD)/float/digest ## the same bits from every build: sources, levels, compilers (BRIEF=1, ONLY='m4f .* -Os')
	$(Q)BRIEF="$(BRIEF)" ONLY="$(ONLY)" $(call gate,builds,$(ONLY) $(TARGETS)) sh tests/builds.sh $(BUILD) $(TARGETS)

firmware: ## run the example firmware on an emulated Cortex-M4F, and check what it prints
	$(call need,arm-none-eabi-gcc)
	$(call need,qemu-system-arm)
	$(Q)sh tests/gate.sh firmware sh tests/firmware.sh $(BUILD)/targets

size: ## flash, stack and structures on every target, against the budgets (V=1: every function)
	$(Q)V="$(V)" UPDATE="$(UPDATE)" TARGETS="$(TARGETS)" $(call gate,size,$(TARGETS)) sh tests/size.sh $(BUILD)/size

bench: ## instructions of each operation on emulated targets, against the budgets
	$(Q)UPDATE="$(UPDATE)" TARGETS="$(TARGETS)" $(call gate,bench,$(TARGETS)) sh tests/bench.sh $(BUILD)

rules: ## MISRA C:2012, clang-tidy, loop bounds, complexity (TOOL=1: of the tool, which takes minutes)
	$(Q)sh tests/gate.sh 'rules $(if $(TOOL),tool)' sh tests/rules.sh $(BUILD) $(if $(TOOL),tool)

SECONDS ?= 60
fuzz: ## fuzzers of the library and the tool with sanitizers (SECONDS=60 each, DOUBLE=1, KEEP=1)
	$(call need,clang-19)
	$(Q)DOUBLE="$(DOUBLE)" KEEP="$(KEEP)" sh tests/gate.sh fuzz sh tests/fuzz.sh $(BUILD) $(SECONDS)

misuse: ## every public function with arguments that it should not be given, under sanitizers
	$(Q)CC=$(call quoted,$(CC)) sh tests/gate.sh misuse sh tests/misuse.sh $(BUILD)

proof: ## no undefined behaviour in src/, proved by Frama-C/Eva (MODULES=..., DOUBLE=1, INT16=1)
	$(call need,frama-c)
	$(Q)DOUBLE="$(DOUBLE)" INT16="$(INT16)" $(call gate,proof $(if $(INT16),int16),$(MODULES)) sh tests/proof.sh $(BUILD) $(MODULES)

schema: $(BUILD)/invcal ## check the tool's JSON output against port/host/schema.json
	$(call need,python3)
	$(Q)sh tests/gate.sh schema sh tests/tool/schema.sh $(BUILD)/invcal $(BUILD)/tool

pages: $(BUILD)/invcal ## the reports in a browser: phone, desktop, paper; light and dark (PAGES=names; SELF=1: test the gate, too)
	$(call need,chromium)
	$(Q)sh tests/pages/set.sh $(BUILD)/invcal $(BUILD)/pages/of > $(BUILD)/pages.all
	$(Q)grep -E '/($(or $(PAGES),.*))[.](html|svg)$$' $(BUILD)/pages.all > $(BUILD)/pages.list
	$(Q)rm -f $(BUILD)/pages/chromium.log
	$(Q)$(if $(SELF),sh tests/pages.sh --self-test $(BUILD) &&) $(call gate,pages,$(PAGES)) sh tests/pages/all.sh $(BUILD)

check-web: $(BUILD)/invcal.html $(BUILD)/invcal $(BUILD)/float/digest ## the page in Chromium and Firefox; its numbers, bit by bit (WEB=names)
	$(call need,chromium)
	$(call need,firefox-esr)
	$(Q)$(call gate,check-web,$(WEB)) sh tests/web.sh $(BUILD) "$(WEB)"

manual: ## the headers and port/manual as HTML in build/manual; everything documented, no dead link
	$(call need,doxygen)
	$(Q)sh tests/gate.sh manual sh tests/manual.sh $(BUILD)

fleet: $(BUILD)/invcal ## the manual's fleet, with GNU parallel and with Apache Spark from PyPI in local mode
	$(call need,parallel)
	$(call need,java)
	$(Q)sh tests/gate.sh fleet sh tests/fleet/fleet.sh $(BUILD)

derived: $(BUILD)/invcal $(BUILD)/invcal.1 ## check layout, expected.h, man page, pictures, scripts, English
	$(call need,clang-format-19)
	$(call need,shellcheck)
	$(call need,python3)
	$(call need,man)
	$(call need,mandoc)
	$(Q)sh tests/gate.sh derived sh tests/derived.sh $(BUILD)

numerics: ## rounding errors, against 50 digits and the bounds of src/solve.h (COUNT=30000: ten minutes)
	$(call need,python3)
	$(Q)CC=$(call quoted,$(CC)) sh tests/gate.sh numerics sh tests/numerics.sh $(BUILD) $(COUNT)

check-shells: all ## the scripts of make test under dash, bash and busybox, with four kinds of awk (ONLY=names)
	$(call need,gawk)
	$(call need,original-awk)
	$(call need,busybox)
	$(Q)$(call gate,check-shells,$(ONLY)) env ONLY="$(ONLY)" sh tests/shells.sh $(BUILD)

check-gates: ## plant a bug for each gate in a copy, and check that the gate turns red (GATES=names)
	$(Q)$(call gate,check-gates,$(GATES)) sh tests/gates.sh $(BUILD) $(GATES)

reference: ## regenerate tests/reference/expected.h (needs python3)
	$(call need,python3)
	@mkdir -p $(BUILD)
	python3 tests/reference/reference.py tests/data > $(BUILD)/expected.h
	mv $(BUILD)/expected.h tests/reference/expected.h

format: ## format the sources by .clang-format (needs clang-format 19)
	$(call need,clang-format-19)
	sh tests/sources.sh c | xargs clang-format-19 -i

APT ?= apt-get
deps: ## install what these need besides a C compiler (Debian, root)
	$(APT) update
	$(APT) install -y --no-install-recommends gcc git clang-19 libclang-rt-19-dev llvm-19 \
	    clang-format-19 clang-tidy-19 cppcheck pmccabe frama-c-base python3 python3-jsonschema \
	    arduino-builder arduino-core-avr arduino-ctags python3-kconfiglib python3-yaml libxml2-utils \
	    python3-mpmath python3-gmpy2 shellcheck codespell man-db groff mandoc doxygen bash \
	    chromium fonts-dejavu-core poppler-utils g++ cmake pkg-config debootstrap \
	    gcc-arm-none-eabi libnewlib-arm-none-eabi qemu-system-arm gcc-avr avr-libc simavr libsimavr-dev \
	    gcc-riscv64-unknown-elf picolibc-riscv64-unknown-elf qemu-system-misc \
	    gcc-powerpc-linux-gnu libc6-dev-powerpc-cross qemu-user locales \
	    parallel default-jre-headless python3-venv \
	    gawk mawk original-awk busybox tcc \
	    lld-19 wasi-libc libclang-rt-19-dev-wasm32 firefox-esr zip unzip gcc-mingw-w64-x86-64 wine wine64
	command -v npm > /dev/null || $(APT) install -y --no-install-recommends nodejs npm

# As typed, too.
package_folder = $(call quoted,$(or $(value DEST),$(BUILD)/packages/$(PACKAGE)))
package: ## lay out a package, in build/packages/NAME unless DEST is given (PACKAGE=name, DEST=folder)
	$(Q)sh port/stage.sh "$(PACKAGE)" $(package_folder)
	@printf '%s is in %s\n' "$(PACKAGE)" $(package_folder)

packages: ## lay out all packages, in build/packages
	$(Q)rm -rf $(BUILD)/packages
	$(Q)for list in port/*/files; do name=$${list%/files}; name=$${name#port/}; \
	    sh port/stage.sh $$name $(BUILD)/packages/$$name || exit; done
	@echo "the packages are in $(BUILD)/packages"

check-packages: all $(BUILD)/invcal.1 ## use each package, C++ and the tarball as their users would (PACKAGES=names)
	$(Q)$(call gate,check-packages,$(PACKAGES)) sh tests/packages.sh $(BUILD) $(PACKAGES)

dist: ## build/dist: the last commit as a tarball, and its packages as zips; the same bytes each time
	$(call need,git)
	$(call need,zip)
	$(Q)sh port/dist.sh $(BUILD)

clean: ## remove build/
	rm -rf $(BUILD)

$(foreach kind,library tool tests page,$(eval $(call words_file,$(BUILD)/words/$(kind),$(kind)_words)))
-include $(shell find $(addprefix $(BUILD)/,float double tool) -name '*.d' 2>/dev/null)
