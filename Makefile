# Two commands for a fresh machine: `make run` and `make test`. `make test-all` also runs the slow tests.
# Each makes its own environment in .venv first; only Python 3.11 with its venv module is needed.

PYTHON ?= python3
BIN := .venv/bin

.PHONY: run test test-all install dev bench fuzz mutants sentences clean

run: install .venv/compiled
	@$(BIN)/donnie $(ARGS)

install: .venv/installed

test: .venv/developed
	@./check

test-all: test
	@./check --slow

dev: .venv/developed

mutants: .venv/developed
	@$(BIN)/python -m pip install --quiet --disable-pip-version-check --group mutants
	@$(BIN)/python -m tests.tools.mutants --seed $(or $(SEED),1) --count $(or $(COUNT),150) $(ARGS)

fuzz: .venv/developed
	@$(BIN)/python -m tests.tools.fuzz --seed $(or $(SEED),1) --count $(or $(COUNT),1000) $(ARGS)

bench: .venv/developed
	@for each in benchmarks/[a-z]*.py; do echo "== $$each"; $(BIN)/python $$each || exit 1; done

# Every sentence with real values, for a review by ear: a page for each language in build/sentences.
sentences: .venv/developed .venv/compiled
	@$(BIN)/python -m tests.tools.sentences $(ARGS)

.venv/bin/python:
	@$(PYTHON) -c 'import sys; sys.exit(sys.version_info < (3, 11) and "Donnie needs Python 3.11 or later; name one with: make run PYTHON=python3.11")'
	@$(PYTHON) -m venv .venv

.venv/installed: .venv/bin/python pyproject.toml
	@echo "Installing Donnie into .venv, once."
	@$(BIN)/python -m pip install --quiet --disable-pip-version-check --editable .
	@touch $@

.venv/developed: .venv/installed
	@$(BIN)/python -m pip install --quiet --disable-pip-version-check 'pip>=25.1'
	@$(BIN)/python -m pip install --quiet --disable-pip-version-check --group dev
	@touch $@

# The sentences and words of all languages, as Donnie loads them.
.venv/compiled: .venv/installed $(wildcard donnie_tui/i18n/locales/*/*.po donnie_tui/i18n/locales/*/*.toml)
	@$(BIN)/python -m donnie_tui.i18n.translations compile
	@touch $@

clean:
	rm -rf .venv
