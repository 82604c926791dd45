# flexel: `make demo` and `make test` need a Debian with make, gcc, python3-dev and python3-venv; the rest is fetched.
# Every target is quick when nothing has changed: stamps in the virtual environments remember what was installed.

PYTHON ?= python3
VENV ?= .venv
VENV_LINT ?= .venv-lint
VENV_BENCH ?= .venv-bench
VENV_OLDEST ?= .venv-oldest
VENV_NEWEST ?= .venv-newest
VENV_LOCK ?= .venv-lock
OUT ?= out
BENCH ?=
MARKS ?= not campaign and not long
TESTS ?= tests
PYTEST ?= -n 2 --dist loadfile --no-loadscope-reorder --durations=10
PORTABLE ?= 1
QUOTED ?= bicycle warping cardan cylinder slider-crank flexures rope contact hoist vehicle motorcycle tolerances stability-map
TYPED := build/typed
# The elements of the bicycle; `make check` derives all, `flexel verify` checks all.
DEMONSTRATED := beam3 body hinge norm wheel

# Kernels and engine with every access to memory checked: the tests that call most of them, published systems.
SANITIZED := build/sanitized
SANITIZE ?= --durations=5 tests/engine tests/integration/test_threads.py tests/mechanics tests/linear
SANITIZE_SYSTEMS ?= bicycle vehicle contact
SANITIZER := address,undefined
SANITIZE_JSON ?= $(OUT)/report/sanitize.json

# What `make report` runs before it writes the page, and the models of the property campaign.
PARTS ?= bench verify reproduce campaign sanitize
MODELS ?= 200
SEED ?= 1
REPORT := tools/write_report.py --models $(MODELS) --seed $(SEED) --from $(OUT)/report --out $(OUT)/report.html

# What depends on other packages: files, pictures, frames, sparse matrices, integrators, worker processes.
OLDEST_TREE := build/oldest
OLDEST ?= -n 2 --durations=5 -m "not slow and not campaign" tests/base tests/engine tests/results tests/statics tests/linear \
  tests/mechanics tests/view tests/sweeps tests/integration tests/cli/test_cli_run.py

# The versions of all packages that are installed here; `make upgrade` writes them anew. LOCK= installs the newest.
LOCK ?= tools/lock.txt
INSTALL := install --quiet --disable-pip-version-check $(if $(LOCK),--constraint $(LOCK))
PIP := $(VENV)/bin/pip $(INSTALL)
SETUP := pyproject.toml setup.py $(LOCK)
SOURCES := $(SETUP) $(wildcard generated/*.[ch] runtime/engine/*.[ch] generated/build.py)
WARNINGS := -std=c11 -O2 -fopenmp-simd -DFLEXEL_NO_CLONES -Wall -Wextra -Wpedantic -Werror -Igenerated -Iruntime/engine

.PHONY: demo test test-all test-oldest test-newest test-machines upgrade landed sanitize bench report pages docs lint types check strict \
  wheel venv clean prerequisites

demo: $(VENV)/installed-plot
	$(VENV)/bin/flexel derive $(DEMONSTRATED)
	@$(MAKE) --no-print-directory $(VENV)/installed
	$(VENV)/bin/flexel verify $(DEMONSTRATED)
	$(VENV)/bin/flexel reproduce bicycle --out $(OUT)/bicycle
	@echo; echo "The pictures are in $(abspath $(OUT))/bicycle:"; ls $(OUT)/bicycle

# The tests of the viewer drive Chromium (Debian: chromium). Where it is missing, these tests are skipped, and the last lines
# say so. What is marked `long` takes as much time as all the rest, what is marked `campaign` more. Both, and the tests of what
# makes the pages (tools/tests), are left to `make test-all`.
test: $(VENV)/installed-test
	$(VENV)/bin/python -m pytest -m "$(MARKS)" $(PYTEST) $(TESTS)

# Everything that can be tested on this machine; STEPS="strict oldest" runs these alone. Takes hours.
test-all:
	.ci/all

# With the newest versions of all packages, of which tools/lock.txt knows nothing.
test-newest:
	$(MAKE) test LOCK= VENV=$(VENV_NEWEST)

# On what stands for other machines: kernels of BLAS for other processors, four busy processes beside the tests.
test-machines: $(VENV)/installed-test
	.ci/machines

# The newest versions of all packages for Python 3.11 to 3.14 become those of tools/lock.txt, and the tests run with them.
upgrade: | prerequisites
	$(PYTHON) -m venv $(VENV_LOCK)
	$(VENV_LOCK)/bin/pip install --quiet --disable-pip-version-check --upgrade uv
	$(VENV_LOCK)/bin/uv pip compile pyproject.toml --quiet --universal --python-version 3.11 --extra all --extra peers \
	  --upgrade --no-annotate --custom-compile-command "make upgrade" --output-file tools/lock.txt
	$(MAKE) test

# Whether the tree of the last commit has passed .ci/run on this machine.
landed:
	@grep -qx "$$(git rev-parse 'HEAD^{tree}')" "$${XDG_CACHE_HOME:-$$HOME/.cache}/flexel/ci-passed" \
	  && echo "HEAD has passed .ci/run" || { echo "HEAD has not passed .ci/run here" >&2; exit 1; }

# With the oldest versions of all packages that pyproject.toml admits; OLDEST="-n 2 -m 'not campaign'" runs all tests.
test-oldest: $(VENV_OLDEST)/needed
	FLEXEL_CFLAGS="-O1" $(VENV_OLDEST)/bin/python setup.py --quiet build --build-base $(OLDEST_TREE) \
	  --build-lib $(OLDEST_TREE)/lib
	$(VENV_OLDEST)/bin/python -c 'import sysconfig as s; open(s.get_path("purelib") + "/flexel.pth", "w").write("$(abspath \
	  $(OLDEST_TREE))/lib\n")'
	$(VENV_OLDEST)/bin/pip list
	$(VENV_OLDEST)/bin/python -m pytest $(OLDEST)

# Where memory is read or written outside what was claimed, or an operation has no meaning in C, the program stops and says
# where. The compiled files are in a tree of their own. Python's own memory is never given back: leaks are not looked for
# here, but in a program without Python (tests/engine/test_sanitizers.py), which also looks for races of threads. What ran
# and what was found is left in a file for `make report`.
sanitize: $(VENV)/installed-test
	FLEXEL_CFLAGS="-O1 -g1 -fno-omit-frame-pointer -fsanitize=$(SANITIZER) -fno-sanitize-recover=all" \
	  LDFLAGS="-fsanitize=$(SANITIZER)" $(VENV)/bin/python setup.py --quiet build --build-base $(SANITIZED) \
	  --build-lib $(SANITIZED)/lib
	@{ echo '$(VENV)/bin/python -m pytest -p no:xdist --durations=3 tests/engine/test_sanitizers.py'; \
	  echo '+$(VENV)/bin/python -m flexel verify'; \
	  for system in $(SANITIZE_SYSTEMS); do echo "+$(VENV)/bin/python -m flexel reproduce $$system"; done; \
	  echo '+$(VENV)/bin/python -m pytest -p no:xdist -m "not campaign" $(SANITIZE)'; \
	} | $(PYTHON) .ci/sanitized.py $(SANITIZE_JSON) $(abspath $(SANITIZED))/found \
	  PYTHONPATH=$(SANITIZED)/lib PYTHONMALLOC=malloc \
	  LD_PRELOAD="$$($(CC) -print-file-name=libasan.so) $$($(CC) -print-file-name=libstdc++.so)" \
	  ASAN_OPTIONS=detect_leaks=0:log_path=$(abspath $(SANITIZED))/found \
	  UBSAN_OPTIONS=print_stacktrace=1:log_path=$(abspath $(SANITIZED))/found

# One page about all that was checked, from a clean clone; out/report.html. It runs verify, all systems, a few rows of the
# benchmarks beside the other programs, a campaign of random models, and the sanitizers; PARTS="verify reproduce" runs
# these alone, and PARTS= writes the page from the files of earlier runs.
report: $(VENV)/installed-test $(VENV)/installed-plot $(if $(filter bench,$(PARTS)),$(VENV_BENCH)/installed-peers)
	status=0; $(if $(filter bench,$(PARTS)),$(VENV_BENCH)/bin/python $(REPORT) --run bench || status=$$?;) \
	  $(VENV)/bin/python $(REPORT) $(if $(filter-out bench,$(PARTS)),--run $(filter-out bench,$(PARTS))) && exit $$status

# What flexel costs, beside the other programs that can be installed; BENCH="cables_56 chain_40" measures these rows alone.
bench: $(VENV_BENCH)/installed-peers
	@mkdir -p $(OUT)
	$(VENV_BENCH)/bin/flexel bench $(BENCH) --json $(OUT)/bench.json --plot $(OUT)/bench.png

# Pages of docs/ and those that docs/pages.py writes about elements, laws and public names; a warning is an error.
# `make docs` also computes the numbers that pages quote again, of all systems but those that take a minute, which the tests
# compute.
docs: $(VENV)/installed-docs $(VENV)/installed-test
	$(VENV)/bin/python tools/quoted.py --check --run $(QUOTED)
	@$(MAKE) --no-print-directory pages

pages: $(VENV)/installed-docs
	$(VENV)/bin/python -m sphinx -W --keep-going -q docs docs/_build
	@echo "The documentation is $(abspath docs)/_build/index.html"

lint: $(VENV_LINT)/installed
	$(VENV_LINT)/bin/ruff check .
	$(VENV_LINT)/bin/ruff format --check .

# mypy cannot follow an editable install: it reads the package as a normal install lays it out. Then the scripts of tools/,
# which import it as users do, and the types of results in a user's program.
types: $(VENV_LINT)/installed
	rm -rf $(TYPED)
	$(VENV_LINT)/bin/python setup.py --quiet build_py --build-lib $(TYPED)
	cd $(TYPED) && MYPYPATH=. $(abspath $(VENV_LINT))/bin/mypy --config-file $(CURDIR)/pyproject.toml --strict -p flexel
	cd $(TYPED) && MYPYPATH=.:$(CURDIR)/tools $(abspath $(VENV_LINT))/bin/mypy --config-file $(CURDIR)/pyproject.toml --strict \
	  -p report -p bench $(patsubst tools/%.py,-m %,$(wildcard tools/*.py))
	$(VENV_LINT)/bin/python .ci/users_types.py $(TYPED)

check: $(VENV)/installed
	$(VENV)/bin/flexel derive --check

# All C with every warning an error; the kernels for complex numbers as well.
strict:
	printf '%s\n' generated/*.c runtime/engine/*.c | xargs -P 2 -n 1 $(CC) $(WARNINGS) -o /dev/null -c
	printf '%s\n' generated/*.c | xargs -P 2 -n 1 $(CC) $(WARNINGS) -Dreal='double complex' -fsyntax-only

# For every processor, where a build from source is for this one only; PORTABLE=0 makes a wheel for this one, too.
wheel: $(VENV)/builders
	rm -rf build dist
	FLEXEL_PORTABLE=$(PORTABLE) $(VENV)/bin/pip wheel --quiet --no-deps --no-build-isolation --wheel-dir dist .
	@ls dist

venv: $(VENV)/installed-test

clean:
	rm -rf build dist docs/_build docs/_generated $(OUT) $(VENV) $(VENV_LINT) $(VENV_BENCH) $(VENV_OLDEST) $(VENV_NEWEST) $(VENV_LOCK) *.egg-info .pytest_cache .mypy_cache .ruff_cache generated/_kernels*.so
	find . -name __pycache__ -type d -prune -exec rm -rf {} +

prerequisites:
	@missing=""; \
	command -v gcc >/dev/null || missing="$$missing gcc"; \
	if ! command -v $(PYTHON) >/dev/null; then missing="$$missing python3-dev python3-venv"; else \
	  $(PYTHON) -c 'import os, sys, sysconfig as s; sys.exit(not os.path.exists(s.get_path("include") + "/Python.h"))' \
	    || missing="$$missing python3-dev"; \
	  $(PYTHON) -c 'import ensurepip, venv' 2>/dev/null || missing="$$missing python3-venv"; fi; \
	if [ -n "$$missing" ]; then echo "Missing; as root:  apt-get install$$missing" >&2; exit 1; fi
	@$(PYTHON) -c 'import sys; sys.exit(sys.version_info < (3, 11) and "flexel needs Python 3.11 or newer: make PYTHON=...")'

$(VENV)/bin/python $(VENV_LINT)/bin/python $(VENV_BENCH)/bin/python $(VENV_OLDEST)/bin/python: %/bin/python: | prerequisites
	$(PYTHON) -m venv --clear $*

# What builds flexel, of the locked versions too: pip's isolated environments for building know no constraints.
$(VENV)/builders $(VENV_BENCH)/builders: %/builders: $(LOCK) | %/bin/python
	$*/bin/pip $(INSTALL) $$($(PYTHON) -c 'import tomllib; \
	  print(*tomllib.load(open("pyproject.toml", "rb"))["build-system"]["requires"])')
	@touch $@

# An editable install: compiles for this processor what no environment has compiled before (derive/object_files.py).
$(VENV)/installed: $(SOURCES) $(VENV)/builders
	$(PIP) --no-build-isolation --editable .
	@touch $@

# What an extra asks for, beside the installed package: nothing is compiled again.
$(VENV)/installed-%: $(VENV)/installed
	$(PIP) 'flexel[$*]'
	@touch $@

# An environment of its own: the other programs bring much, and may want other versions of it. One that cannot be
# installed is named, and is left out of the table. The list is that of the extra "peers".
$(VENV_BENCH)/installed-peers: $(SOURCES) $(VENV_BENCH)/builders
	$(VENV_BENCH)/bin/pip $(INSTALL) --no-build-isolation --editable '.[plot]'
	@$(PYTHON) -c 'import tomllib; t = tomllib.load(open("pyproject.toml", "rb")); \
	  print(*t["project"]["optional-dependencies"]["peers"], sep="\n")' | while read -r peer; do \
	  $(VENV_BENCH)/bin/pip $(INSTALL) "$$peer" \
	    || echo "bench: $$peer cannot be installed here; its column will say so" >&2; done
	@touch $@

$(VENV_OLDEST)/needed: pyproject.toml .ci/oldest.py | $(VENV_OLDEST)/bin/python
	$(PYTHON) .ci/oldest.py test > $(VENV_OLDEST)/needs.txt
	$(VENV_OLDEST)/bin/pip install --quiet --disable-pip-version-check --requirement $(VENV_OLDEST)/needs.txt
	@touch $@

# The tools and what they must see, without flexel itself: nothing to compile.
$(VENV_LINT)/installed: pyproject.toml $(LOCK) | $(VENV_LINT)/bin/python
	$(PYTHON) -c 'import tomllib; t = tomllib.load(open("pyproject.toml", "rb")); p = t["project"]; \
	  extras = p["optional-dependencies"]; needs = p["dependencies"] + extras["plot"] + extras["xarray"] + extras["lint"]; \
	  print(*needs, *t["build-system"]["requires"], sep="\n")' > $(VENV_LINT)/needs.txt
	$(VENV_LINT)/bin/pip $(INSTALL) --requirement $(VENV_LINT)/needs.txt
	@touch $@
