# Two commands for a fresh machine: `make run` and `make test`.
# Each makes its own environment in .venv first; only Python 3.11 with its venv module is needed.

PYTHON ?= python3
BIN := .venv/bin

.PHONY: run test install dev bench clean

run: install
	@$(BIN)/donnie $(ARGS)

install: .venv/installed

test: .venv/developed
	@./check

dev: .venv/developed

bench: .venv/developed
	@for each in benchmarks/[a-z]*.py; do echo "== $$each"; $(BIN)/python $$each || exit 1; done

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

clean:
	rm -rf .venv
