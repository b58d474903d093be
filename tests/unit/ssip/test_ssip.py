"""Speech through speech-dispatcher's socket."""

from __future__ import annotations

import contextlib
import itertools
from collections.abc import Iterator
from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st

from devices.audio_worker.notices import AudioNotice, NoticeCode
from devices.ports.audio import Urgency, Utterance
from devices.ports.values import replace
from devices.speech.dispatcher import Address, find_address, is_reachable, parse_address
from devices.speech.voices import VoiceSettings
from devices.ssip import conversation
from devices.ssip.mailbox import Mailbox
from devices.ssip.protocol import Event, EventKind, NotSsip, Reader, Reply, message_of, text
from devices.ssip.speaker import SsipSpeaker, ssip_settings
from tests.unit.ssip.server import Server

STREAM = b"208 OK CLIENT NAME SET\r\n225-21\r\n225 OK MESSAGE QUEUED\r\n702-21\r\n702-1\r\n702 END\r\n"


FAST = VoiceSettings(450, chosen=frozenset({"words_per_minute"}))


def say(words: str, urgency: Urgency = Urgency.PROGRAM, language: str = "en") -> Utterance:
    return Utterance(words, urgency, language)


# --- the protocol


@given(st.lists(st.integers(0, len(STREAM)), max_size=12))
def test_any_chunking_gives_the_same_answers(cuts: list[int]) -> None:
    places = [0, *sorted(cuts), len(STREAM)]
    reader = Reader()
    answers = [
        answer for begin, end in itertools.pairwise(places) for answer in reader.feed(STREAM[begin:end])
    ]
    assert answers == [
        Reply(208, ()),
        Reply(225, ("21",)),
        Event(EventKind.END, "21"),
    ]


@given(st.binary(max_size=300))
def test_garbage_is_no_ssip_or_nothing_and_never_anything_else(data: bytes) -> None:
    with contextlib.suppress(NotSsip):
        list(Reader().feed(data))


def test_a_server_that_never_ends_its_line_is_none() -> None:
    reader = Reader()
    with pytest.raises(NotSsip):
        for _ in range(10):
            list(reader.feed(b"2" * 1000))


def test_a_line_with_a_full_stop_does_not_end_the_message() -> None:
    assert text("one\n.\n.x") == b"one\r\n..\r\n..x\r\n.\r\n"


def test_a_refused_message_has_no_number() -> None:
    assert message_of(Reply(225, ("7",))) == "7"
    assert message_of(Reply(312, ("7",))) is None


def test_rate_pitch_and_volume_go_from_end_to_end() -> None:
    usual = VoiceSettings(chosen=frozenset({"words_per_minute", "pitch", "volume"}))
    loud, low = replace(usual, words_per_minute=10_000, pitch=100), replace(usual, pitch=0, volume=0.5)
    assert ssip_settings(usual) == {"RATE": 0, "PITCH": 0, "VOLUME": 100}
    assert ssip_settings(loud) == {"RATE": 100, "PITCH": 100, "VOLUME": 100}
    assert ssip_settings(low) == {"RATE": 0, "PITCH": -100, "VOLUME": 0}
    assert ssip_settings(replace(usual, words_per_minute=80, volume=0.0)) == {
        "RATE": -100, "PITCH": 0, "VOLUME": -100,
    }  # fmt: skip


def test_what_nobody_chose_of_a_voice_is_left_to_the_server() -> None:
    assert ssip_settings(VoiceSettings(450, 100, 0.5, chosen=frozenset({"pitch"}))) == {"PITCH": 100}
    assert ssip_settings(VoiceSettings(punctuation="all")) == {}


# --- the address


@pytest.mark.parametrize(
    ("given_address", "meant"),
    [
        ("unix_socket:/run/x.sock", Address(path="/run/x.sock")),
        ("inet_socket:localhost:6561", Address(host="localhost", port=6561)),
        ("inet_socket:robot", Address(host="robot", port=6560)),
        ("inet_socket:robot:99999", None),
        ("unix_socket:", None),
        ("pigeon:home", None),
    ],
)
def test_an_address_is_read_as_speech_dispatchers_clients_do(
    given_address: str, meant: Address | None
) -> None:
    assert parse_address(given_address) == meant


def test_the_socket_of_this_user_is_found(tmp_path: Path) -> None:
    variables = {"XDG_RUNTIME_DIR": str(tmp_path)}
    assert find_address(variables) is None
    socket_file = tmp_path / "speech-dispatcher" / "speechd.sock"
    socket_file.parent.mkdir()
    socket_file.touch()
    assert find_address(variables) == Address(path=str(socket_file))
    assert find_address({**variables, "SPEECHD_ADDRESS": "unix_socket:/x"}) == Address(path="/x")


def test_a_folder_that_nobody_may_look_into_has_no_socket(tmp_path: Path) -> None:
    """As after ``su``, which leaves the variable at another user's; here the system refuses a name."""
    assert find_address({"XDG_RUNTIME_DIR": f"{tmp_path}/{'x' * 300}"}) is None


def test_a_file_that_nobody_listens_at_is_not_reachable(tmp_path: Path) -> None:
    (tmp_path / "s").touch()
    assert not is_reachable(Address(path=str(tmp_path / "s")))
    assert not is_reachable(None)


# --- the speaker


@pytest.fixture
def server(tmp_path: Path) -> Iterator[Server]:
    made = Server(tmp_path)
    yield made
    made.close()


def test_a_server_is_reachable(server: Server) -> None:
    assert is_reachable(server.address)


def test_sentences_are_handed_over_in_order_in_their_languages_behind_the_reader(server: Server) -> None:
    speaker = SsipSpeaker(server.address, lambda _: None)
    speaker.say(say("I walked 3 steps."))
    speaker.say(say("x=-3"))
    speaker.say(say("Andei 3 passos.", language="pt"))
    assert speaker.wait_until_quiet(10)
    speaker.close()
    assert server.texts == ["I walked 3 steps.", "x equals minus 3", "Andei 3 passos."]
    assert "SET SELF PRIORITY MESSAGE" in server.commands
    assert [each for each in server.commands if "LANGUAGE" in each] == [
        "SET SELF LANGUAGE en",
        "SET SELF LANGUAGE pt",
    ]


def test_a_voice_that_was_chosen_is_asked_for_and_else_the_servers_is_left(server: Server) -> None:
    speaker = SsipSpeaker(server.address, lambda _: None, FAST)
    speaker.say(say("Hello."))
    assert speaker.wait_until_quiet(10)
    speaker.close()
    assert "SET SELF RATE 100" in server.commands


def test_a_voice_that_changes_is_asked_for_between_two_sentences_and_of_the_next_server(
    tmp_path: Path,
) -> None:
    server = Server(tmp_path)
    speaker = SsipSpeaker(server.address, lambda _: None)
    speaker.say(say("x=1"))
    assert speaker.wait_until_quiet(10)
    assert not any("RATE" in each for each in server.commands)
    speaker.set_voice(replace(FAST, punctuation="none"))
    speaker.say(say("x=2"))
    assert speaker.wait_until_quiet(10)
    speaker.close()
    assert "SET SELF RATE 100" in server.commands
    assert server.texts == ["x equals 1", "x=2"]
    server.close()


def test_silence_cancels_what_is_said_and_forgets_what_waits(tmp_path: Path) -> None:
    server = Server(tmp_path, tells_end=False)
    speaker = SsipSpeaker(server.address, lambda _: None)
    speaker.say(say("First."))
    speaker.say(say("Second."))
    assert server.wait_for(texts=1)
    assert not speaker.wait_until_quiet(0)
    speaker.silence()
    assert server.wait_for(command="CANCEL SELF")
    assert speaker.wait_until_quiet(10)
    assert server.texts == ["First."]
    speaker.close()


def test_what_was_cut_off_is_said_again_to_the_next_server(tmp_path: Path) -> None:
    server = Server(tmp_path, hangs_up_after=5)
    notices: list[AudioNotice] = []
    speaker = SsipSpeaker(server.address, notices.append)
    speaker.say(say("Hello."))
    assert server.wait_for(connections=3)
    assert speaker.wait_until_quiet(10)
    speaker.close()
    assert [notice.code for notice in notices] == [NoticeCode.SSIP_LOST]


def test_what_was_silenced_while_the_server_was_lost_is_not_said_again() -> None:
    mailbox = Mailbox()
    mailbox.offer(say("First."), 0.0)
    assert mailbox.take() == say("First.")
    mailbox.hush()
    mailbox.put_back()
    assert mailbox.take() is None
    assert mailbox.wait_until_quiet(0)


def test_a_missing_end_is_told_ten_seconds_after_the_slowest_voice_is_done() -> None:
    assert (conversation.END_SECONDS, conversation.SECONDS_A_CHARACTER) == (10.0, 0.2)


def test_without_a_server_it_is_told_once_and_nobody_waits(tmp_path: Path) -> None:
    notices: list[AudioNotice] = []
    speaker = SsipSpeaker(Address(path=str(tmp_path / "none")), notices.append)
    for number in range(1000):
        speaker.say(say(f"Sentence {number}."))
    assert speaker.wait_until_quiet(10)
    speaker.close()
    assert [notice.code for notice in notices] == [NoticeCode.SSIP_LOST]


def test_an_end_that_never_comes_means_no_sound(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(conversation, "END_SECONDS", 0.0)
    monkeypatch.setattr(conversation, "SECONDS_A_CHARACTER", 0.0)
    server = Server(tmp_path, tells_end=False)
    notices: list[AudioNotice] = []
    speaker = SsipSpeaker(server.address, notices.append)
    speaker.say(say("First."))
    speaker.say(say("Second."))
    assert server.wait_for(texts=2)
    assert speaker.wait_until_quiet(10)
    speaker.close()
    assert [notice.code for notice in notices] == [NoticeCode.SSIP_SILENT]


def test_closed_before_anything_was_said_it_started_nothing(server: Server) -> None:
    speaker = SsipSpeaker(server.address, lambda _: None)
    speaker.close()
    speaker.say(say("Too late."))
    speaker.close()
    assert server.connections == 0
