"""The settings that the screen has kept."""

import tomllib


def kept(tmp_path) -> dict:
    return tomllib.loads((tmp_path / "config" / "donnie" / "settings.toml").read_text())
