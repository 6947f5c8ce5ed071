# Everything that a fresh machine needs is Python 3.11, 3.12 or 3.13 with its venv module.
# A target that needs the environment makes it first, with the locked versions.

SHELL := /bin/bash
VENV ?= .venv
BIN := $(VENV)/bin
JOBS ?= 2
PEERS := ros_jazzy ros_kilted smollm2 libero
EPISODES ?= 200
SEED ?= 0
# Suites of `make evaluate`; QUICK=1 cuts every run of `make report` short.
SUITES ?= pick
QUICK ?=
SENTENCE ?= pick up the red cup on the table
# Tests begin a few hundred processes: without kept bytecode each of them compiles this project anew.
export PYTHONDONTWRITEBYTECODE :=

# The first interpreter of a supported version; names that are only shims of absent versions fail the probe.
FIND_PYTHON = for p in $(PYTHON) python3.11 python3.12 python3.13 python3; do \
	"$$p" -c 'import sys, venv, ensurepip; sys.exit(not (3, 11) <= sys.version_info[:2] <= (3, 13))' \
	2>/dev/null && { command -v "$$p"; break; }; done

export OMP_NUM_THREADS := 1
export PIP_DISABLE_PIP_VERSION_CHECK := 1

.PHONY: setup run test test-peers check requirements evaluate benchmark report reference lock build clean

setup: $(VENV)/.dev-stamp $(VENV)/.warm-stamp  ## the environment with everything that development needs

$(BIN)/python:
	@python="$$($(FIND_PYTHON))"; \
	if [ -z "$$python" ]; then \
		echo "No Python 3.11, 3.12 or 3.13 with its venv module was found." >&2; \
		echo "Install one (Debian: apt-get install python3 python3-venv) or name it: make PYTHON=/path/to/python" >&2; \
		exit 2; \
	fi; \
	echo "making $(VENV) with $$python"; \
	"$$python" -m venv $(VENV)

$(VENV)/.run-stamp: requirements.lock pyproject.toml | $(BIN)/python
	$(BIN)/python -m pip install --quiet -r requirements.lock -c requirements-dev.lock setuptools
	$(BIN)/python -m pip install --quiet --no-deps --no-build-isolation --editable .
	@touch $@

# Compiled before the first run, and before several test processes would all compile the same.
$(VENV)/.warm-stamp: $(VENV)/.run-stamp $(shell find kinematics -name '*.py')
	$(BIN)/executive doctor --warm
	@touch $@

$(VENV)/.dev-stamp: requirements-dev.lock $(VENV)/.run-stamp
	$(BIN)/python -m pip install --quiet -r requirements-dev.lock
	@touch $@

run: $(VENV)/.warm-stamp  ## the main job
	$(BIN)/executive run "$(SENTENCE)"

test: $(VENV)/.dev-stamp $(VENV)/.warm-stamp  ## every test but those of the architecture, which `make check` runs
	$(BIN)/python -m pytest -n $(JOBS) --dist worksteal --ignore tests/architecture

test-peers: $(VENV)/.dev-stamp $(VENV)/.warm-stamp  ## tests against other programs: rclpy, an MCP client, a browser
	-$(BIN)/python -m tools.benchmark.peers $(PEERS)  # one that cannot be installed is named and left out
	@# the wheel compiles all there is for minutes, while the others mostly wait for a robot in real time
	@nice -n 10 $(BIN)/python -m pytest --peers tests/peers/test_wheel.py & wheel=$$!; \
	trap 'kill $$wheel 2>/dev/null' EXIT; \
	$(BIN)/python -m pytest --peers tests/peers --ignore tests/peers/test_wheel.py; others=$$?; \
	wait $$wheel && exit $$others

check: $(VENV)/.dev-stamp  ## style, types, layers, architecture
	$(BIN)/ruff check .
	$(BIN)/mypy
	$(BIN)/lint-imports --no-logo
	$(BIN)/python -m pytest -q tests/architecture

requirements: $(VENV)/.dev-stamp $(VENV)/.warm-stamp  ## which requirements are proven by a test, which are not
	-$(BIN)/python -m tools.benchmark.peers $(PEERS)
	$(BIN)/python -m tools.documents.requirements_report --jobs $(JOBS)

evaluate: $(VENV)/.dev-stamp $(VENV)/.warm-stamp  ## random episodes, judged by the simulator's truth; their pages are made anew
	$(BIN)/python -m tools.report --only $(SUITES) --episodes $(EPISODES) --seed $(SEED) --jobs $(JOBS)

benchmark: $(VENV)/.dev-stamp $(VENV)/.warm-stamp  ## every part beside its peers, and its page
	-$(BIN)/python -m tools.benchmark.peers  # a peer that cannot be installed is named and left out
	$(BIN)/python -m tools.report --only benchmarks scaling

report: $(VENV)/.dev-stamp $(VENV)/.warm-stamp  ## all that is claimed, measured anew: docs/measured is made whole; hours
	-$(BIN)/python -m tools.benchmark.peers
	$(BIN)/python -m tools.report $(if $(QUICK),--quick) --seed $(SEED) --jobs $(JOBS)

reference: $(VENV)/.dev-stamp  ## the pages of the docs that are made from the code
	$(BIN)/python -m tools.documents.reference
	$(BIN)/python -m tools.documents.lifecycle_table
	$(BIN)/python -m tools.documents.schemas

lock: $(VENV)/.dev-stamp  ## resolve the dependencies anew
	$(BIN)/pip-compile --quiet --upgrade $(LOCK_OPTIONS) --extra dev --output-file requirements-dev.lock pyproject.toml
	$(BIN)/pip-compile --quiet --upgrade $(LOCK_OPTIONS) --constraint requirements-dev.lock \
		--output-file requirements.lock pyproject.toml

LOCK_OPTIONS = --strip-extras --allow-unsafe --no-emit-index-url --no-emit-find-links --no-header --no-annotate

build: $(VENV)/.dev-stamp  ## the wheel
	$(BIN)/python -m build --wheel

clean:
	rm -rf $(VENV) build dist *.egg-info .pytest_cache .mypy_cache .ruff_cache .import_linter_cache
