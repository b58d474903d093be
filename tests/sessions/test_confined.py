"""``donnie --confined FOLDER``: nothing of a session leaves the folder, and every refusal is a sentence."""

from __future__ import annotations

import os
import signal
import subprocess
import sys
from pathlib import Path

import pytest

from devices.serial_ports import allow_only
from donnie_tui.cli import front_end
from donnie_tui.cli.main import main
from donnie_tui.process.confinement import Confinement, confine
from donnie_tui.settings import folders
from donnie_tui.settings.settings import SessionLimits, limits_of
from tests.conftest import ROOT
from tests.sessions.command import COMMAND, QUIET, donnie, environment
from tests.sessions.learner import CTRL_Z, DOWN, UP, Learner, until
from tests.timeouts import TIMEOUT

pytestmark = pytest.mark.slow

SECRET = "SPEAK 4711\n"
WORLD = 'include "donnie.inc"\n{more}\ndonnie( pose [ 0 0 0 90 ] )\n'


@pytest.fixture
def ana(tmp_path: Path) -> Path:
    """The folder of a pupil. A link in it leads to a file of the teacher, which is next to it."""
    (tmp_path / "secret.gd").write_text(SECRET)
    folder = tmp_path / "ana"
    folder.mkdir()
    (folder / "mine.gd").write_text("FW 1\n")
    (folder / "link.gd").symlink_to("../secret.gd")
    (folder / "way").symlink_to("..")
    return folder


def outside(folder: Path) -> dict[str, str]:
    """All files next to the pupil's folder, with what is in them."""
    return {
        str(each): each.read_text()
        for each in folder.parent.rglob("*")
        if each.is_file() and not each.is_relative_to(folder)
    }


NAMES = [
    "../secret.gd",
    "link.gd",
    "way/secret.gd",
    "{}/secret.gd",
    "/proc/self/root{}/secret.gd",
    "../new.gd",
]


# --- typed words


@pytest.mark.parametrize("name", ["../new", "way/new", "{}/new", "../secret.gd", "link.gd"])
def test_a_world_is_saved_in_the_folder_only(ana: Path, name: str) -> None:
    before = outside(ana)
    typed = f"PUT box 4 6\nSAVE WORLD {name.format(ana.parent)}\nSAVE WORLD mine\n"

    done = donnie(
        ana, "--linear", "--world", "first_room", "--confined", str(ana), *QUIET, typed=typed
    ).stdout.decode()

    assert "is not in your folder. Stay in it." in done
    assert "World saved as mine.world." in done
    assert outside(ana) == before
    assert 'box( name "box"' in (ana / "mine.world").read_text()


def test_a_world_that_is_not_saved_is_kept_where_the_learner_can_open_it(ana: Path) -> None:
    before = outside(ana)
    options = ("--linear", "--confined", str(ana), *QUIET)

    done = donnie(ana, "--world", "bigbob7", *options, typed="PUT box red 4 60 AS treasure\n").stdout.decode()

    assert f"Your world is kept as {ana / 'unsaved.world'}." in done
    assert outside(ana) == before
    again = donnie(ana, *options, typed=f"WORLD {ana / 'unsaved.world'}\nMAP\n").stdout.decode()
    assert "Treasure, box, red: " in again


def test_no_word_of_the_linear_mode_reads_or_writes_outside(ana: Path) -> None:
    words = ["OPEN", "SAVE", "SAVE AS", "SAVE LOG", "REPORT LIST", "REPORT MAP", "WORLD", "WORLDS"]
    names = [each.format(ana.parent) for each in NAMES]
    lines = ["FW 2", *(f"{word} {name}" for word in words for name in names), "SAVE coração.gd", "QUIT"]
    before = outside(ana)

    done = donnie(ana.parent, "--linear", "--confined", "ana", *QUIET, typed="\n".join(lines) + "\n")
    said = done.stdout.decode().splitlines()

    assert said.count("Saved coração.gd, 1 line.") == 1
    for name in names:
        assert said.count(f"{name} is not in your folder. Stay in it.") == len(words), name
    assert outside(ana) == before
    assert "4711" not in done.stdout.decode()
    assert (ana / "coração.gd").read_text() == "FW 2\n"


STARTED = ("subprocess.Popen", "os.system", "os.exec", "os.fork", "os.forkpty", "os.posix_spawn", "os.spawn")
NOTES_STARTS = f"""
import os, sys
def note(event, arguments):
    if event in {STARTED!r}:
        with open(os.environ["STARTS"], "a") as file:
            file.write(event + " " + repr(arguments) + "\\n")
sys.addaudithook(note)
"""
"""What Python imports by itself at its start, where it finds it."""


def test_a_session_of_a_forced_command_starts_no_process(ana: Path, tmp_path: Path) -> None:
    """No voice, no sound and no guard: over SSH no one hears them, and there is no real robot."""
    (tmp_path / "site").mkdir()
    (tmp_path / "site/sitecustomize.py").write_text(NOTES_STARTS)
    path = os.pathsep.join((str(tmp_path / "site"), os.environ.get("PYTHONPATH", "")))
    changes = {"PYTHONPATH": path, "STARTS": str(tmp_path / "starts"), "SSH_CONNECTION": "1 2 3 4"}
    words = [
        "FW 1",
        "SPEAK 1",
        "",
        "LOG",
        "REPORT MAP",
        "SAVE LOG a",
        "HELP",
        "DOCTOR",
        "VOICE",
        "MAP",
        "QUIT",
    ]

    typed = "\n".join(words) + "\n"
    done = donnie(ana, "--linear", "--confined", str(ana), typed=typed, changes=changes)
    again = donnie(ana, "run", "mine.gd", "--confined", str(ana), changes=changes)

    assert b"I walked 1 step forward." in done.stdout
    assert b"I walked 1 step forward." in again.stdout
    assert not (tmp_path / "starts").exists(), (tmp_path / "starts").read_text()


def test_the_note_of_started_processes_notes_them(tmp_path: Path) -> None:
    """Otherwise the test before could not fail."""
    (tmp_path / "sitecustomize.py").write_text(NOTES_STARTS)
    changes = {"PYTHONPATH": str(tmp_path), "STARTS": str(tmp_path / "starts")}
    subprocess.run(
        [sys.executable, "-c", "import subprocess; subprocess.run(['true'])"], env={**os.environ, **changes}
    )

    assert "true" in (tmp_path / "starts").read_text()


@pytest.mark.parametrize("word", ["OPEN", "SAVE AS", "SAVE LOG", "REPORT LIST", "WORLD"])
@pytest.mark.parametrize("name", [".bashrc", ".ssh/authorized_keys", ".donnie/settings.toml"])
def test_hidden_files_are_refused(ana: Path, word: str, name: str) -> None:
    (ana / ".bashrc").write_text("true\n")
    (ana / ".ssh").mkdir()

    done = donnie(ana, "--linear", "--confined", ".", *QUIET, typed=f"FW 2\nWHERE\n{word} {name}\nQUIT\n")

    added = {"SAVE LOG": ".txt", "REPORT LIST": ".html"}.get(word, "")
    refused = name if name.endswith(".toml") else f"{name}{added}"
    assert f"{refused} is hidden. Begin without a dot." in done.stdout.decode().splitlines()
    assert (ana / ".bashrc").read_text() == "true\n"
    assert not (ana / ".ssh" / "authorized_keys").exists()


def test_a_relative_name_is_in_the_folder_wherever_the_session_begins(ana: Path) -> None:
    done = donnie(
        ana.parent, "--linear", "--confined", str(ana), "mine.gd", *QUIET, typed="RUN\nSAVE AS b.gd\n"
    )

    assert "I walked 1 step forward." in done.stdout.decode()
    assert (ana / "b.gd").exists()


def test_the_history_the_copies_and_the_settings_are_kept_in_the_folder(ana: Path) -> None:
    """And they are found again at the next start."""
    before = outside(ana)
    learner = Learner(ana.parent, "--confined", "ana")
    learner.enters("SET page ask", "FW 29")
    learner.sees_prompt()
    until(lambda: any("FW 29" in each.read_text() for each in (ana / ".donnie/unsaved").glob("*.gd")))
    learner.child.kill(9)
    learner.child.wait()

    kept = {each.name for each in (ana / ".donnie").iterdir()}
    assert {"history", "unsaved", "settings.toml"} <= kept
    assert outside(ana) == before

    again = Learner(ana.parent, "--confined", "ana")
    again.enters("RECOVER")
    again.sees("Your program is back, 1 line.")
    again.sees_prompt()
    again.types(UP + UP)
    again.sees("FW 29")
    again.types(DOWN + DOWN)
    again.types("\x15SET page\r")
    again.sees("ask")


def test_a_program_that_was_rescued_with_a_file_outside_is_not_saved_there(ana: Path) -> None:
    """Its copy names the file; a pupil who can copy files into the folder may have written it."""
    copies = ana / ".donnie" / "unsaved"
    copies.mkdir(parents=True)
    for number, name in enumerate((ana.parent / "secret.gd", ana / ".bashrc")):
        (copies / f"unsaved-0-{number}.gd").write_text(f"-- What was not saved of the file: {name}\nFW 9\n")

    typed = "RECOVER\nSAVE\nRECOVER\nSAVE\n"
    done = donnie(ana.parent, "--linear", "--confined", "ana", *QUIET, typed=typed)

    said = done.stdout.decode()
    assert said.count(" is back, 1 line.") == 2
    assert "secret.gd is not in your folder. Stay in it." in said
    assert ".bashrc is hidden. Begin without a dot." in said
    assert (ana.parent / "secret.gd").read_text() == SECRET
    assert not (ana / ".bashrc").exists()


def test_control_z_has_no_effect_although_a_shell_is_above(ana: Path) -> None:
    learner = Learner(ana.parent, "--confined", "ana", is_job=True)
    learner.enters("WHERE")
    learner.sees_prompt()
    learner.types(CTRL_Z)
    learner.sees("Ctrl+Z has no effect here.")
    learner.enters("WHERE")
    learner.sees("Facing north.")


def test_control_z_has_no_effect_on_another_command_either(ana: Path) -> None:
    """It waits for a program at its standard input; this process is the shell above."""
    command = subprocess.Popen(
        [*COMMAND, "check", "-", "--confined", str(ana)],
        stdin=subprocess.PIPE,
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        cwd=ana,
        env=environment(ana),
        process_group=0,
    )
    until(lambda: caught(command.pid) >> (signal.SIGTSTP - 1) & 1)
    command.send_signal(signal.SIGTSTP)
    assert command.stderr is not None
    assert command.stderr.readline() == b"Ctrl+Z has no effect here.\n"

    command.communicate(b"FW 1\n", TIMEOUT)
    assert command.returncode == 0


def caught(process: int) -> int:
    """The signals that a process handles, a bit each."""
    status = Path(f"/proc/{process}/status").read_text()
    return int(status.partition("SigCgt:")[2].split()[0], 16)


# --- worlds


@pytest.mark.parametrize(
    ("more", "sentence"),
    [
        ('include "../teacher.inc"', "outside"),
        ('include "linked.inc"', "outside"),
        ('model( bitmap "../plan.png" )', "outside"),
        ('model( bitmap "linked.png" )', "outside"),
        ('include "/proc/self/root/etc/passwd"', "outside"),
        ('include "../not-there.inc"', "outside"),
    ],
)
def test_a_world_reads_nothing_outside(ana: Path, more: str, sentence: str) -> None:
    (ana.parent / "teacher.inc").write_text("define secret model ( )\n")
    (ana.parent / "plan.png").write_bytes(b"\x89PNG")
    (ana / "linked.inc").symlink_to("../teacher.inc")
    (ana / "linked.png").symlink_to("../plan.png")
    (ana / "my.world").write_text(WORLD.format(more=more))

    done = donnie(ana, "world", "my.world", "--confined", ".", *QUIET)

    assert done.returncode == 2
    assert sentence in done.stderr.decode()
    assert b"Traceback" not in done.stderr


def test_the_words_of_a_world_are_not_those_of_another_file(ana: Path) -> None:
    (ana.parent / "secret.toml").write_text('[en]\ntitle = "4711"\ndescription = "x"\ntask = "y"\n')
    (ana / "my.toml").symlink_to("../secret.toml")
    (ana / "my.world").write_text(WORLD.format(more=""))

    done = donnie(ana, "world", "my.world", "--confined", ".", *QUIET)
    recorded = donnie(
        ana, "run", "mine.gd", "--world", "my.world", "--record", "r", "--confined", ".", *QUIET
    )

    assert done.returncode == 0
    assert b"4711" not in done.stdout + done.stderr
    assert recorded.returncode == 2
    assert not (ana / "r").exists() or "4711" not in (ana / "r").read_text()


def test_a_world_in_the_folder_is_entered_recorded_and_replayed(ana: Path) -> None:
    (ana / "own.inc").write_text("# mine\n")
    (ana / "my.world").write_text(WORLD.format(more='include "own.inc"'))
    limits = ("--confined", ".", *QUIET)

    assert donnie(ana, "run", "mine.gd", "--world", "my.world", "--record", "r.rec", *limits).returncode == 0
    assert donnie(ana, "replay", "r.rec", "--check", *limits).returncode == 0
    assert donnie(ana, "replay", "r.rec", "--map", *limits).returncode == 0
    assert not [each for each in (ana / ".donnie").iterdir() if each.name.startswith("donnie-")]


# --- commands


COMMANDS = [
    "run {}",
    "-f {}",
    "run donnie={}",
    "check {}",
    "format {}",
    "format -w {}",
    "replay {}",
    "replay {} --check",
    "world {}",
    "world maze --svg {}",
    "world maze --brf {}",
    "run mine.gd --world {}",
    "run mine.gd --record {}",
    "run mine.gd --events {}",
    "run mine.gd --sound wav:{}",
    "check --world {} mine.gd",
    "challenge new {}",
    "challenge check first_walk mine.gd --csv {}",
    "challenge check first_walk mine.gd --feedback {}",
    "challenge check first_walk mine.gd --csv table.csv --feedback {}",
]


@pytest.fixture
def here(ana: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """As ``ana``, with commands in this process."""
    monkeypatch.setenv("XDG_CONFIG_HOME", str(ana.parent / "config"))
    monkeypatch.setenv("XDG_STATE_HOME", str(ana.parent / "state"))
    monkeypatch.chdir(ana)
    monkeypatch.setattr("donnie_tui.cli.main._ignore_suspension", lambda _: None)
    return ana


@pytest.mark.parametrize("command", COMMANDS)
@pytest.mark.parametrize("how", ["option", "variable"])
def test_no_command_reads_or_writes_outside(
    here: Path, command: str, how: str, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    before = outside(here)
    if how == "variable":
        monkeypatch.setenv("DONNIE_CONFINED", str(here))
    limit = ["--confined", "."] if how == "option" else []
    for name in (each.format(here.parent) for each in NAMES):
        quiet = () if "wav:" in command else QUIET
        assert main([*command.format(name).split(), *limit, *quiet]) == 2, name
        out, err = capsys.readouterr()
        assert err.splitlines() == [f"{name} is not in your folder. Stay in it."]
        assert "4711" not in out
        assert not out or not command.startswith("challenge")

    assert outside(here) == before
    assert not (here / "table.csv").exists()


@pytest.mark.parametrize("name", [".x", "sub/.x", ".ssh"])
@pytest.mark.parametrize(
    "command",
    ["challenge new {}", "challenge check first_walk mine.gd --csv table.csv --feedback {}"],
)
def test_no_challenge_makes_or_fills_a_hidden_folder(
    here: Path, command: str, name: str, capsys: pytest.CaptureFixture[str]
) -> None:
    (here / ".ssh").mkdir()
    before = sorted(here.rglob("*"))

    assert main([*command.format(name).split(), "--confined", ".", "--lang", "en"]) == 2

    assert capsys.readouterr() == ("", f"{name} is hidden. Begin without a dot.\n")
    made = [each for each in sorted(here.rglob("*")) if ".donnie" not in each.parts]
    assert made == before


def test_no_answer_to_a_program_is_a_hidden_file(here: Path, capsys: pytest.CaptureFixture[str]) -> None:
    (here / ".profile.gd").write_text("FW 5\n")
    command = "challenge check first_walk .profile.gd --feedback . --confined . --lang en"

    assert main(command.split()) == 2

    assert capsys.readouterr() == ("", ".profile.txt is hidden. Begin without a dot.\n")
    assert not (here / ".profile.txt").exists()


def test_challenges_and_answers_are_made_in_the_folder(here: Path) -> None:
    (here / "sub").mkdir()
    for command in (
        "challenge new mine",
        "challenge test mine",
        "challenge check first_walk mine.gd --feedback sub/answers",
    ):
        assert main([*command.split(), "--confined", "."]) == ("check" in command), command

    assert (here / "sub" / "answers" / "mine.txt").is_file()


def test_a_folder_of_programs_is_checked_without_what_is_outside(
    here: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    (here / ".hidden.gd").write_text("FWD\n")

    assert main(["check", ".", "--confined", "."]) == 0
    checked, totals = capsys.readouterr().out.splitlines()
    assert checked == "mine.gd: no mistakes."
    assert totals == "1 program. 0 with mistakes, 1 without."


def test_confinement_can_only_be_narrowed(
    here: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    (here / "sub").mkdir()
    (here / "sub" / "in.gd").write_text("FW 1\n")
    monkeypatch.setenv("DONNIE_CONFINED", str(here))

    assert main(["run", "mine.gd", "--confined", str(here.parent), *QUIET]) == 2
    assert capsys.readouterr().err == f"{here.parent} is not in {here}.\n"
    assert main(["run", "in.gd", "--confined", "sub", *QUIET]) == 0
    assert main(["run", f"{here}/mine.gd", "--confined", f"{here}/sub", *QUIET]) == 2
    assert main(["run", "mine.gd", "--confined", "/", "--confined", ".", *QUIET]) == 2
    assert main(["run", "mine.gd", "--confined=/", "--confined", ".", *QUIET]) == 2
    assert "Give --confined only once." in capsys.readouterr().err


@pytest.mark.parametrize("value", ["", "none", "mine.gd", "~", "a\tb"])
def test_a_folder_that_can_not_be_used_prevents_the_start(
    here: Path, value: str, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    """Else a slip of the teacher would free the pupil."""
    monkeypatch.setattr("pwd.getpwuid", lambda _: type("Account", (), {"pw_dir": "/no/such/home"}))
    monkeypatch.setenv("DONNIE_CONFINED", value)

    assert main(["run", "mine.gd", *QUIET]) == 2
    assert ("make it first" if value else "takes FOLDER") in capsys.readouterr().err


def test_a_module_in_the_folder_is_not_imported(ana: Path) -> None:
    """The tests start ``python -m donnie_tui``, which looks for modules where it begins."""
    for name in ("pymunk", "PIL", "lark", "serial"):
        (ana / f"{name}.py").write_text(f"open({str(ana.parent / 'escaped')!r}, 'w')\n")

    done = donnie(ana, "run", "mine.gd", "--confined", ".", *QUIET, changes={"PYTHONPATH": str(ROOT)})

    assert (done.returncode, done.stderr) == (0, b"")
    assert not (ana.parent / "escaped").exists()


# --- the settings of the machine


@pytest.fixture
def machine(here: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """The settings file of the machine, which no variable moves."""
    etc = here.parent / "etc"
    etc.mkdir()
    monkeypatch.setattr(folders, "MACHINE_FOLDERS", {sys.platform: str(etc)})
    return etc / "settings.toml"


def test_the_settings_of_the_machine_confine_and_nothing_lifts_them(
    here: Path, machine: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    machine.write_text(f'confined = "{here}"\nlang = "pt"\n')
    assert main(["check", "../secret.gd"]) == 2
    assert capsys.readouterr().err == "../secret.gd não está na sua pasta. Fique nela.\n"

    (here / ".donnie").mkdir()
    (here / ".donnie" / "settings.toml").write_text('confined = "/"\ndevices = "/dev/tty"\nlang = "es"\n')
    assert main(["check", "../secret.gd"]) == 2
    assert capsys.readouterr().err.splitlines() == [
        "Solo quien enseña puede cambiar confined.",
        "Solo quien enseña puede cambiar devices.",
        "../secret.gd no está en tu carpeta. Quédate ahí.",
    ]

    monkeypatch.setenv("DONNIE_CONFINED", "/")
    assert main(["check", "mine.gd"]) == 2
    monkeypatch.delenv("DONNIE_CONFINED")
    for more in (["--confined", "/"], ["--devices", "/dev/tty"], ["--robot", "serial:/dev/tty"]):
        assert main(["run", "mine.gd", *more, *QUIET]) == 2


def test_an_account_is_confined_by_its_settings(here: Path, capsys: pytest.CaptureFixture[str]) -> None:
    account = here.parent / "config" / "donnie"
    account.mkdir(parents=True)
    (account / "settings.toml").write_text(f'confined = "{here}"\n')

    assert main(["check", "../secret.gd"]) == 2
    assert main(["check", "mine.gd"]) == 0


@pytest.mark.parametrize(
    "text", ["confined = \n", 'confined = "/no/such"\n', "confined = false\n", "confined = [1]\n"]
)
def test_damaged_settings_of_the_machine_prevent_the_start(
    here: Path, machine: Path, text: str, capsys: pytest.CaptureFixture[str]
) -> None:
    machine.write_text(text)

    assert main(["check", "mine.gd"]) == 2
    assert (
        "make it first" if "no/such" in text else "start" if text == "confined = \n" else "takes FOLDER"
    ) in capsys.readouterr().err


# --- devices


NOT_NAMED = "/dev/tty can't be used in this session. Your teacher can allow it: --devices."


def test_only_the_named_ports_can_be_used(
    here: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setenv("DONNIE_CONFINED", str(here))
    for command in (
        "run mine.gd --robot serial:/dev/tty",
        "stop /dev/tty",
        "calibrate --robot serial:/dev/tty",
    ):
        assert main([*command.split(), *QUIET]) == 2
        assert capsys.readouterr().err == f"{NOT_NAMED}\n"
    assert main(["devices", "/dev/tty"]) == 2
    assert NOT_NAMED in capsys.readouterr().out
    assert main(["run", "mine.gd", "--belt", "/dev/tty", *QUIET]) == 0
    assert capsys.readouterr().err.startswith("/dev/tty can't be used in this session. Your teacher can")

    assert main(["run", "mine.gd", "--devices", "/dev/none", "--robot", "serial:/dev/none", *QUIET]) == 2
    assert capsys.readouterr().err == "This session may not use /dev/none.\n"
    monkeypatch.setenv("DONNIE_DEVICES", "/dev/none")
    assert main(["run", "mine.gd", "--robot", "serial:/dev/none", *QUIET]) == 2
    assert capsys.readouterr().err.startswith("Nothing is plugged in at /dev/none.")


def test_a_page_has_the_folder_and_the_ports_of_the_command_that_serves_it(
    here: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Also those that a weaker source has named."""
    for name in ("DONNIE_CONFINED", "DONNIE_DEVICES"):
        monkeypatch.setenv(name, "")
        monkeypatch.delenv(name)
    confine(Confinement(str(here)))
    allow_only(["/dev/a", "/dev/b"])
    front_end._confine_pages()
    allow_only(None)

    account: dict[str, object] = {"devices": "/dev/a", "confined": str(here)}
    assert limits_of({}, os.environ, account, {}) == SessionLimits(str(here), ("/dev/a",))
    assert limits_of({}, os.environ, {}, {"devices": "/dev/b"}).devices == ("/dev/b",)


@pytest.mark.parametrize("address", ["spy:///dev/null?file=spied", "alt:///dev/null", "loop://", "LOOP://"])
@pytest.mark.parametrize("option", ["--belt", "--robot"])
def test_addresses_that_write_files_are_refused_everywhere(
    here: Path, address: str, option: str, capsys: pytest.CaptureFixture[str]
) -> None:
    value = address if option == "--belt" else f"serial:{address}"

    assert main(["run", "mine.gd", option, value, *QUIET]) == 2
    assert f"The option {option} can't be" in capsys.readouterr().err
    assert not (here / "spied").exists()
