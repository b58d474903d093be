"""Command line, variables, file, defaults: the strongest valid value wins, and its source is known."""

import errno
import os
import tomllib
from collections.abc import Callable
from pathlib import Path

import pytest

from donnie_tui.core.program_files import DocumentError
from donnie_tui.i18n.words import Words
from donnie_tui.settings import folders
from donnie_tui.settings.folders import account_settings_file, settings_file, state_path
from donnie_tui.settings.parsing import PORT_WANTED, colours_text, read_file, remember, with_setting
from donnie_tui.settings.settings import (
    BY_KEY,
    KEYS,
    BadLimitsError,
    BadOption,
    Settings,
    SettingSource,
    language_of,
    limits_of,
    resolve,
)
from tests.traced_memory import traced


def test_without_any_source_the_defaults_count() -> None:
    settings, notices = resolve({}, {}, {})

    assert settings == Settings()
    assert notices == ()


def test_speech_on_is_the_built_in_voice() -> None:
    """``speech = auto / on / off``."""
    assert resolve({}, {}, {"speech": "on"})[0].speech == "tts"
    assert resolve({"speech": "ON"}, {}, {})[0].speech == "tts"
    assert resolve({}, {}, {"speech": "off"})[0].speech == "off"


@pytest.mark.parametrize(
    ("options", "variables", "file", "speed", "source"),
    [
        ({"speed": "2"}, {"DONNIE_SPEED": "3"}, {"speed": 4}, 2.0, SettingSource.OPTION),
        ({}, {"DONNIE_SPEED": "3"}, {"speed": 4}, 3.0, SettingSource.ENVIRONMENT),
        ({}, {}, {"speed": 4}, 4.0, SettingSource.FILE),
        ({}, {"DONNIE_SPEED": ""}, {"speed": "max"}, None, SettingSource.FILE),
        ({}, {"DONNIE_SPEED": "fast"}, {"speed": 4}, 4.0, SettingSource.FILE),
        ({}, {"DONNIE_SPEED": "fast"}, {"speed": []}, 5.0, SettingSource.DEFAULT),
    ],
)
def test_the_strongest_valid_source_wins(
    options: dict[str, str],
    variables: dict[str, str],
    file: dict[str, object],
    speed: float | None,
    source: SettingSource,
) -> None:
    settings, _ = resolve(options, variables, file)

    assert (settings.speed, settings.source_of("speed")) == (speed, source)


@pytest.mark.parametrize(
    ("key", "value"),
    [
        ("speed", "fast"),
        ("speed", "0"),
        ("speed", "-1"),
        ("speed", "nan"),
        ("speed", "inf"),
        ("speed", ""),
        ("seed", "-1"),
        ("seed", "1e3"),
        ("seed", "9" * 5000),
        ("lang", "fr"),
        ("sound", "loud"),
        ("speech", "shout"),
        ("verbosity", "5"),
        ("world", ""),
        ("world", "a\0b"),
    ],
)
def test_a_bad_value_is_an_error_on_the_command_line_and_a_notice_elsewhere(key: str, value: str) -> None:
    with pytest.raises(BadOption):
        resolve({key: value}, {}, {})

    settings, notices = resolve({}, {}, {key: value})
    assert settings == Settings()
    codes = [notice.code.removesuffix("-values") for notice in notices]
    assert codes == ["setting-not-understood"]


@pytest.mark.parametrize(
    ("key", "text", "value"),
    [
        ("speed", "0,5", 0.5),
        ("speed", "MAX", None),
        ("lang", "pt-BR", "pt"),
        ("lang", "ES", "es"),
        ("sound", "off", False),
        ("linear", "yes", True),
        ("seed", "7", 7),
        ("verbosity", "Brief", "brief"),
    ],
)
def test_values_are_read_as_people_write_them(key: str, text: str, value: object) -> None:
    settings, _ = resolve({key: text}, {}, {})

    assert getattr(settings, next(each.name for each in KEYS if each.key == key)) == value


@pytest.mark.parametrize(
    ("environment", "language"),
    [
        ({}, "en"),
        ({"LANG": "pt_BR.UTF-8"}, "pt"),
        ({"LANG": "es_AR.UTF-8", "LC_ALL": "C"}, "en"),
        ({"LANG": "en_GB", "LC_MESSAGES": "es_ES"}, "es"),
        ({"LANG": "pt_PT", "LC_ALL": ""}, "pt"),
        ({"LANG": "fr_FR"}, "en"),
    ],
)
def test_the_language_follows_the_locale(environment: dict[str, str], language: str) -> None:
    assert language_of(environment) == language


def test_an_unknown_word_in_the_file_is_reported() -> None:
    _, notices = resolve({}, {}, {"spede": 3})

    assert [(notice.code, notice.values["name"]) for notice in notices] == [("setting-unknown", "spede")]


# --- the file


@pytest.fixture
def environment(tmp_path: Path) -> dict[str, str]:
    return {"XDG_CONFIG_HOME": str(tmp_path), "HOME": str(tmp_path / "home")}


def write(environment: dict[str, str], data: bytes) -> Path:
    path = Path(settings_file(environment))
    path.parent.mkdir(parents=True)
    path.write_bytes(data)
    return path


def test_a_missing_file_is_no_problem(environment: dict[str, str]) -> None:
    assert read_file(account_settings_file(environment)) == ({}, ())


def test_the_file_is_toml(environment: dict[str, str]) -> None:
    write(environment, b'\xef\xbb\xbflang = "es"\nsound = false\n')

    assert read_file(account_settings_file(environment)) == ({"lang": "es", "sound": False}, ())


@pytest.mark.parametrize(
    ("data", "code"),
    [
        (b"lang = \n", "settings-file-damaged"),
        (b'a = 1\nlang = "es', "settings-file-damaged"),
        (b"\xff\xfe\0\0", "settings-file-unreadable"),
        (b"a = " + b"[" * 9000, "settings-file-damaged"),
        (b"a." * 49_000 + b"a = 1", "settings-file-damaged"),
        (b"#" * 200_000, "settings-file-too-large"),
    ],
)
def test_a_damaged_file_is_reported_and_not_used(environment: dict[str, str], data: bytes, code: str) -> None:
    write(environment, data)

    settings, notices = read_file(account_settings_file(environment))

    assert settings == {}
    assert [notice.code for notice in notices] == [code]


def test_a_huge_file_is_refused_before_it_takes_memory(environment: dict[str, str]) -> None:
    write(environment, b"")
    os.truncate(settings_file(environment), 50_000_000)
    with traced() as peak:
        assert [each.code for each in read_file(account_settings_file(environment))[1]] == [
            "settings-file-too-large"
        ]

    assert peak() < 5_000_000


def test_a_folder_in_its_place_is_reported(environment: dict[str, str]) -> None:
    Path(settings_file(environment)).mkdir(parents=True)

    assert [notice.code for notice in read_file(account_settings_file(environment))[1]] == [
        "settings-file-unreadable"
    ]


def test_a_saved_setting_is_read_again_and_the_rest_of_the_file_stays(environment: dict[str, str]) -> None:
    path = write(environment, b'# mine\nlang = "es"\nspeed = 2\n')

    remember("lang", "pt", environment)
    remember("linear", True, environment)

    assert path.read_text() == '# mine\nlang = "pt"\nspeed = 2\nlinear = true\n'
    assert read_file(account_settings_file(environment))[0] == {"lang": "pt", "speed": 2, "linear": True}


def test_a_setting_that_can_not_be_saved_is_reported(environment: dict[str, str]) -> None:
    Path(environment["XDG_CONFIG_HOME"], "donnie").write_text("a file, not a folder")

    with pytest.raises(DocumentError) as problem:
        remember("lang", "pt", environment)
    assert problem.value.reason == "File exists"


@pytest.mark.parametrize("text", ["", "a = 1", "a = 1\n", "[table]\nb = 2\n", "lang='x' # y\n[t]\n"])
@pytest.mark.parametrize("value", ['C:\\worlds\\"mine".world', "open_floor", "a\n\tb\x1b\x7f é 🤖"])
def test_a_saved_setting_keeps_any_file_valid(text: str, value: str) -> None:
    changed = tomllib.loads(with_setting(text, "world", value))

    assert changed["world"] == value
    assert {**changed, "world": 0} == {**tomllib.loads(text), "world": 0}


@pytest.mark.parametrize(
    ("platform", "environment", "path"),
    [
        ("linux", {"HOME": "/h"}, "/h/.config/donnie/settings.toml"),
        ("linux", {"HOME": "/h", "XDG_CONFIG_HOME": "/x"}, "/x/donnie/settings.toml"),
        ("linux", {"HOME": "/h", "XDG_CONFIG_HOME": "relative"}, "/h/.config/donnie/settings.toml"),
        ("darwin", {"HOME": "/h"}, "/h/Library/Application Support/donnie/settings.toml"),
        ("win32", {"APPDATA": "C:/A"}, "C:/A/donnie/settings.toml"),
    ],
)
def test_each_platform_has_its_place(platform: str, environment: dict[str, str], path: str) -> None:
    assert settings_file(environment, platform) == path


@pytest.mark.parametrize(
    ("platform", "path"),
    [
        ("linux", "/etc/donnie/settings.toml"),
        ("darwin", "/Library/Application Support/donnie/settings.toml"),
        ("win32", r"C:\ProgramData\donnie/settings.toml"),
    ],
)
def test_a_whole_machine_has_settings_too(platform: str, path: str) -> None:
    assert folders.machine_settings_file(platform) == path


@pytest.mark.parametrize(
    ("platform", "environment", "state"),
    [
        ("linux", {"HOME": "/h"}, "/h/.local/state/donnie"),
        ("linux", {"HOME": "/h", "XDG_STATE_HOME": "/x"}, "/x/donnie"),
        ("linux", {"USERPROFILE": "/u"}, "/u/.local/state/donnie"),
        ("linux", {}, ".local/state/donnie"),
        ("darwin", {"HOME": "/h", "XDG_STATE_HOME": "/x"}, "/h/Library/Application Support/donnie"),
        ("win32", {"USERPROFILE": "C:/u"}, "C:/u/AppData/Roaming/donnie"),
        ("win32", {"USERPROFILE": "C:/u", "APPDATA": "C:/a"}, "C:/a/donnie"),
    ],
)
def test_state_has_a_folder_of_its_own(platform: str, environment: dict[str, str], state: str) -> None:
    assert Path(state_path(environment, platform)) == Path(state)


def test_a_confined_session_keeps_settings_and_state_in_its_folder_but_has_the_sounds_of_its_account() -> (
    None
):
    home = {"HOME": "/h"}
    folders.keep_in("/f/.donnie")
    try:
        assert folders.settings_file(home, "linux") == "/f/.donnie/settings.toml"
        assert folders.account_settings_file(home, "linux") == "/h/.config/donnie/settings.toml"
        assert folders.own_sounds(home, "linux") == Path("/h/.config/donnie/sounds")
        assert folders.state_path(home, "linux") == "/f/.donnie"
    finally:
        folders.keep_in(None)


def test_what_an_earlier_version_kept_is_found_by_its_name() -> None:
    kept = folders.UNSAVED, folders.UNSAVED_WORLD, folders.BREAKPOINTS, folders.PROGRESS, folders.RECENT
    assert kept == ("unsaved", "unsaved.world", "breakpoints.txt", "challenges.txt", "recent.txt")
    assert (folders.MARKER, folders.VOICE_MARKER) == ("tour-was-offered", "voice-was-announced")


def test_what_was_announced_is_announced_again_after_any_change(tmp_path: Path) -> None:
    folder = str(tmp_path / "state" / "donnie")
    said = ("on", "one", "on", "on", "o")
    assert [folders.is_new_decision(folder, each) for each in said] == [True, True, True, False, True]
    (tmp_path / "file").write_text("")
    assert folders.is_new_decision(str(tmp_path / "file"), "on")
    assert folders.offers_tour(folder, {"DONNIE_TOUR": " Off "}) is False
    assert folders.offers_tour(folder, {"DONNIE_TOUR": "on"}) is True
    assert (tmp_path / "state" / "donnie" / "tour-was-offered").stat().st_mode & 0o777 == 0o600


def test_the_tour_is_offered_once_whether_or_not_its_folder_was_there(tmp_path: Path) -> None:
    folder = str(tmp_path / "state" / "donnie")
    assert [folders.offers_tour(folder, {}) for _ in range(2)] == [True, False]
    (tmp_path / "file").write_text("")
    assert [folders.offers_tour(str(tmp_path / "file" / "x"), {}) for _ in range(2)] == [True, True]


@pytest.mark.parametrize(
    ("make", "reason"),
    [
        (lambda path: path.mkdir(), os.strerror(errno.EISDIR)),
        (lambda path: path.write_bytes(b"\xff"), "'utf-8' codec can't decode byte 0xff in position 0: "),
    ],
)
def test_a_file_in_which_no_setting_can_be_saved_is_named_with_the_reason(
    tmp_path: Path, make: Callable[[Path], object], reason: str
) -> None:
    path = tmp_path / "donnie" / "settings.toml"
    path.parent.mkdir()
    make(path)
    with pytest.raises(DocumentError) as failed:
        remember("lang", "pt", {"XDG_CONFIG_HOME": str(tmp_path)})

    assert (failed.value.code, failed.value.path) == ("file-unwritable", str(path))
    assert failed.value.reason.startswith(reason)


def test_the_folders_of_worlds_default_to_those_of_stage() -> None:
    stage = {"STAGEPATH": os.pathsep.join(("/opt/stage", "", "~/worlds"))}

    def of(variables: dict[str, str], file: dict[str, object]) -> tuple[str, ...]:
        return resolve({}, variables, file)[0].world_folders

    assert of(stage, {}) == ("/opt/stage", str(Path("~/worlds").expanduser()))
    assert of({**stage, "DONNIE_WORLDS": "/mine"}, {}) == ("/mine",)
    assert of({}, {"worlds": "/a" + os.pathsep + "~no-such-user/b"}) == (
        "/a",
        "~no-such-user/b",
    )
    assert of({"DONNIE_WORLDS": os.pathsep}, {}) == ()


@pytest.mark.parametrize(
    ("key", "ending"),
    [
        (
            "robot",
            "It takes sim, serial, serial:DEVICE, serial:socket://HOST:PORT, serial:rfc2217:"
            "//HOST:PORT, double, player://HOST:PORT/INDEX.",
        ),
        ("theme", "It takes one of dark, light, contrast, terminal."),
        ("rate", "It takes 80-450."),
        ("belt_steps", "For example: 5 10 20."),
    ],
)
def test_a_wrong_variable_is_reported_with_its_words_or_its_form(key: str, ending: str) -> None:
    _, (notice,) = resolve({}, {f"DONNIE_{key.upper()}": "bogus"}, {})

    assert Words()(notice.code, **notice.values).endswith(ending)


# --- the colours of a camera


def test_colours_are_ranges_of_hue_saturation_and_value() -> None:
    """A hue may go on through 0; the word may be of any language."""
    text = "red 170-8 50-255 60-255, AZUL 90-120 32-255 48-255"

    settings, _ = resolve({}, {}, {"colours": text})

    assert settings.colours == {"red": (170, 8, 50, 255, 60, 255), "blue": (90, 120, 32, 255, 48, 255)}
    assert colours_text(settings.colours) == text.replace("AZUL", "blue")


@pytest.mark.parametrize(
    "text",
    [
        "",
        "red",
        "red 1-2 3-4",
        "red 1-2 3-4 5-6 7-8",
        "red 0-180 0-255 0-255",
        "red 0-10 0-256 0-255",
        "red 0-10 200-100 0-255",
        "colour 0-10 0-255 0-255",
        "red 0-x 0-255 0-255",
        "red 1-2-3 0-255 0-255",
        "red 0-10 0-255 0-255,",
    ],
)
def test_colours_that_are_no_ranges_are_refused(text: str) -> None:
    settings, notices = resolve({}, {}, {"colours": text})

    assert settings.colours is None
    assert [each.code for each in notices] == ["setting-not-understood-example"]


@pytest.mark.parametrize(
    ("text", "view"), [("60", 60), ("53,5", 53.5), ("19", None), ("151", None), ("nan", None)]
)
def test_a_view_is_between_20_and_150_degrees(text: str, view: float | None) -> None:
    assert resolve({}, {}, {"camera_view": text})[0].camera_view == view


# --- defaults and names


def test_what_counts_where_nothing_is_chosen() -> None:
    defaults = {
        "world": "first_room",
        "robot": "sim",
        "language": "en",
        "speed": 5.0,
        "seed": 0,
        "speech": "auto",
        "sound": True,
        "speak": "here",
        "rate": 180,
        "pitch": 50,
        "volume": 100,
        "punctuation": "some",
        "key_echo": "none",
        "cues": {},
        "wait_for_speech": False,
        "verbosity": "normal",
        "profile": "auto",
        "reset_line": "auto",
        "theme": "dark",
        "mouse": True,
        "motion": "full",
        "completion": True,
        "trail": True,
        "rays": True,
        "goals": True,
        "keys": "",
        "page": "rest",
        "prompt": "short",
        "hold": "off",
        "editor": "own",
        "enter": "waits",
        "progress": "10",
        "clock": "off",
        "free": "dot",
        "tour": True,
        "log": False,
        "world_folders": (),
        "allowed_folders": (),
        "sources": {},
        "notices": (),
    }
    rest = {each for each in Settings.__struct_fields__ if getattr(Settings(), each) is None}

    assert {
        each: getattr(Settings(), each) for each in Settings.__struct_fields__ if each not in rest
    } == defaults
    assert rest == {
        "events",
        "record",
        "belt",
        "belt_steps",
        "belt_columns",
        "wheel_radius",
        "axle_length",
        "sonars",
        "bumpers",
        "motors",
        "encoders",
        "head",
        "camera",
        "camera_view",
        "colours",
        "linear",
        "plain",
        "served",
    }


def test_a_start_without_a_pace_of_its_own_has_the_one_that_it_is_given() -> None:
    assert resolve({}, {}, {}, default_speed=None)[0].speed is None
    assert resolve({"speed": "2"}, {}, {}, default_speed=None)[0].speed == 2.0


@pytest.mark.parametrize(
    ("key", "option", "variable", "wanted", "code"),
    [
        ("belt_steps", "--belt-steps", "DONNIE_BELT_STEPS", "5 10 20", "-example"),
        ("theme", "--theme", "DONNIE_THEME", "dark, light, contrast, terminal", "-values"),
        ("rate", "--rate", "DONNIE_RATE", "80-450", ""),
    ],
)
def test_each_setting_has_its_names_and_says_what_it_can_be(
    key: str, option: str, variable: str, wanted: str, code: str
) -> None:
    found = BY_KEY[key]
    assert (found.option, found.variable, found.wanted) == (option, variable, wanted)
    _, (in_file,) = resolve({}, {}, {key: "~" * 50})
    _, (in_variable,) = resolve({}, {variable: "~" * 50}, {})
    values = {"value": "~" * 39 + "…", "wanted": wanted}
    assert (in_file.code, in_file.values) == (f"setting-not-understood{code}", {"name": key, **values})
    assert (in_variable.code, in_variable.values) == (
        f"variable-not-understood{code}",
        {"name": variable, **values},
    )
    with pytest.raises(BadOption) as bad:
        resolve({key: "~"}, {}, {})
    option = f"--{key.replace('_', '-')}"
    assert bad.value.values == {"option": option, "value": "~", "wanted": wanted}


ONE_OF: dict[str, object] = {}
"""Exactly the words that it says."""
NAMED, EXAMPLE, FORM = "-values", "-example", ""
SWITCH = {"on": True, "off": False}
READ = {
    "world": ("NAME_OR_FILE", FORM, {"maze": "maze"}),
    "worlds": (f"FOLDER{os.pathsep}FOLDER", FORM, {"/a": ("/a",)}),
    "allow": (f"FOLDER{os.pathsep}FOLDER", FORM, {"/a": ("/a",)}),
    "lang": ("en, pt, es", NAMED, {"es": "es"}),
    "speed": ("0.1-1000, max", FORM, {"max": None}),
    "seed": ("0, 1, 2 ...", FORM, {"7": 7}),
    "speech": ("auto, off, text, ssip, tts, robot", NAMED, ONE_OF),
    "sound": ("on, off, wav:FILE", NAMED, {"wav:a": "a"}),
    "speak": ("here, robot, both", NAMED, ONE_OF),
    "rate": ("80-450", FORM, {"200": 200}),
    "pitch": ("0-100", FORM, {"7": 7}),
    "volume": ("0-100", FORM, {"7": 7}),
    "punctuation": ("none, some, all", NAMED, ONE_OF),
    "key_echo": ("none, characters, words", NAMED, ONE_OF),
    "cues": ("NAME 0-100, NAME 0-100", FORM, {"bump 5": {"bump": 5}}),
    "wait_for_speech": ("on, off", NAMED, SWITCH),
    "verbosity": ("brief, normal, full", NAMED, ONE_OF),
    "events": ("FILE, -", FORM, {"-": "-"}),
    "record": ("FILE", FORM, {"a": "a"}),
    "belt": (PORT_WANTED, FORM, {"/dev/x": "/dev/x"}),
    "belt_columns": ("front 3, front-right 4, back 0 6", EXAMPLE, {"": {}}),
    "wheel_radius": ("0.001-1", FORM, {"0.5": 0.5}),
    "axle_length": ("0.001-1", FORM, {"0.5": 0.5}),
    "sonars": (
        "front-right front front-left back-left back back-right",
        EXAMPLE,
        {"none " * 6: (None,) * 6},
    ),
    "bumpers": ("front front front back back back", EXAMPLE, {"back " * 6: (False,) * 6}),
    "profile": ("auto, 2016, 2018", FORM, ONE_OF),
    "motors": ("normal reversed", EXAMPLE, {"normal reversed": (1, -1)}),
    "encoders": ("normal reversed", EXAMPLE, {"reversed normal": (-1, 1)}),
    "head": ("left, right", NAMED, ONE_OF),
    "camera": ("NUMBER, /dev/videoN, FILE, FOLDER", FORM, {"0": "0"}),
    "camera_view": ("20-150", FORM, {"20": 20.0}),
    "colours": (
        "red 121-11 32-255 87-255, green 56-99 169-255 17-255",
        EXAMPLE,
        {"red 1-2 3-4 5-6": {"red": (1, 2, 3, 4, 5, 6)}},
    ),
    "reset_line": ("auto, dtr, gpio:22, none", FORM, ONE_OF),
    "linear": ("on, off", NAMED, SWITCH),
    "page": ("rest, ask, off", NAMED, ONE_OF),
    "prompt": ("short, none, word, answer", NAMED, ONE_OF),
    "hold": ("off, on", NAMED, ONE_OF),
    "editor": ("own, plain", NAMED, ONE_OF),
    "enter": ("waits, runs", NAMED, ONE_OF),
    "progress": ("0-3600", FORM, {"5": "5"}),
    "clock": ("off, on", NAMED, ONE_OF),
    "free": ("dot, a-z", NAMED, {"f": "f"}),
    "tour": ("on, off", NAMED, SWITCH),
    "plain": ("on, off", NAMED, SWITCH),
    "mouse": ("on, off", NAMED, SWITCH),
    "motion": ("full, reduced", NAMED, ONE_OF),
    "completion": ("on, off", NAMED, SWITCH),
    "trail": ("on, off", NAMED, SWITCH),
    "rays": ("on, off", NAMED, SWITCH),
    "goals": ("on, off", NAMED, SWITCH),
    "keys": ("ACTION KEY, ACTION KEY", FORM, {"run F5": "run F5"}),
}
"""What a setting is said to be, how that is said, and texts with what they mean."""
FIELDS = {"worlds": "world_folders", "allow": "allowed_folders", "lang": "language"}


@pytest.mark.parametrize("key", READ)
def test_a_line_of_the_file_has_its_effect_or_an_answer_that_says_what_it_can_be(key: str) -> None:
    wanted, ending, texts = READ[key]
    for text, value in (texts or {each: each for each in wanted.split(", ")}).items():
        settings, notices = resolve({}, {}, {key: text})
        assert (getattr(settings, FIELDS.get(key, key)), notices) == (value, ())
    _, (notice,) = resolve({}, {}, {key: "\0"})
    assert (notice.code, notice.values["wanted"]) == (f"setting-not-understood{ending}", wanted)
    if ending == EXAMPLE:
        assert resolve({}, {}, {key: wanted})[1] == ()


def test_an_unknown_name_of_the_file_is_cut_and_true_and_false_are_on_and_off() -> None:
    settings, notices = resolve({}, {}, {"x" * 50: 1, "mouse": False, "linear": True, "page": 5})
    assert [each.values["name"] for each in notices] == ["x" * 39 + "…", "page"]
    assert (settings.mouse, settings.linear) == (False, True)
    settings, notices = resolve({}, {}, {"hold": True, "speech": True, "clock": False, "theme": True})
    assert (settings.hold, settings.speech, settings.clock) == ("on", "tts", "off")
    assert [each.values["value"] for each in notices] == ["on"]


@pytest.mark.parametrize("key", ["record", "world", "allow", "speed"])
def test_a_list_in_the_file_is_reported_and_not_used(key: str) -> None:
    settings, (notice,) = resolve({}, {}, {key: ["x", "y"]})

    assert settings == resolve({}, {}, {})[0]
    assert notice.values["value"] == "['x', 'y']"


# --- what a teacher allows


def test_a_weaker_source_can_only_limit_a_session_more(tmp_path: Path) -> None:
    school, lesson, other = tmp_path / "school", tmp_path / "school" / "lesson", tmp_path / "schools"
    for each in (lesson, other):
        each.mkdir(parents=True)

    def limits(*sources: dict[str, str]) -> tuple[str | None, tuple[str, ...] | None]:
        found = limits_of(*sources)  # type: ignore[arg-type]
        return found.folder, found.devices

    long = {"name": "devices", "value": "x://" + "y" * 35 + "…", "wanted": PORT_WANTED}
    missing = str(tmp_path / "none")
    at_school, in_lesson = {"confined": str(school)}, {"confined": str(lesson)}
    assert limits({}, {}, {}, {}) == (None, None)
    assert limits({}, {}, {}, at_school) == (str(school), ())
    assert limits({}, {"DONNIE_CONFINED": str(school)}, {}, in_lesson) == (str(lesson), ())
    assert limits({"devices": "a,b"}, {"DONNIE_DEVICES": "b"}, {}, {}) == (None, ("b",))
    assert limits({"devices": "a"}, {}, {}, at_school) == (str(school), ("a",))
    assert limits({**at_school, "devices": "a"}, {}, {}, {"devices": "a"}) == (str(school), ("a",))
    assert limits({"devices": ""}, {}, at_school, {}) == (str(school), ())
    for sources, code, values in (
        *(
            ((at_school, {}, {}, {"confined": path}), "confined-wider", {"path": path, "folder": str(school)})
            for path in (str(tmp_path), str(other))
        ),
        ((at_school, {}, {}, {"devices": "a"}), "devices-wider", {"port": "a"}),
        (({"devices": "a"}, {}, {"devices": "a,c"}, {}), "devices-wider", {"port": "c"}),
        (({"confined": missing}, {}, {}, {}), "confined-no-folder", {"path": missing}),
        (
            ({"confined": [1]}, {}, {}, {}),
            "limit-not-understood",
            {"name": "confined", "value": "[1]", "wanted": "FOLDER"},
        ),
        (({"devices": "x://" + "y" * 50}, {}, {}, {}), "limit-not-understood", long),
    ):
        with pytest.raises(BadLimitsError) as wrong:
            limits_of(*sources)
        assert (wrong.value.code, wrong.value.values) == (code, values)


def test_a_tilde_is_the_home_of_the_account(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    import pwd

    home = pwd.getpwuid(os.getuid()).pw_dir
    monkeypatch.setenv("HOME", str(tmp_path))
    assert limits_of({"confined": "~"}, {}, {}, {}).folder == os.path.realpath(home)
    assert limits_of({"confined": "~/"}, {}, {}, {}).folder == os.path.realpath(home)
    with pytest.raises(BadLimitsError):
        limits_of({"confined": "~x"}, {}, {}, {})
