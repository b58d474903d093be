"""Speech through speech-dispatcher's socket."""

from __future__ import annotations

import contextlib
import itertools
import re
import select
import socket
from collections.abc import Callable, Iterator
from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st
from msgspec.structs import replace

from devices.audio import speech_dispatcher as conversation
from devices.audio.speech_dispatcher import (
    ConnectionLost,
    Mailbox,
    SsipConnection,
    SsipSpeaker,
    ssip_settings,
)
from devices.audio.speech_queue import QueueResult
from devices.audio.ssip import (
    SsipAddress,
    SsipEvent,
    SsipEventKind,
    SsipProtocolError,
    SsipReader,
    SsipReply,
    encode_text,
    find_address,
    is_reachable,
    message_of,
    parse_address,
)
from devices.ports.audio import AudioNotice, NoticeCode, Urgency, Utterance, VoiceSettings
from donnie_tui.outlets.audible import spoken_languages
from tests.unit.ssip.server import Server

STREAM = b"208 OK CLIENT NAME SET\r\n225-21\r\n225 OK MESSAGE QUEUED\r\n702-21\r\n702-1\r\n702 END\r\n"


FAST = VoiceSettings(450, chosen=frozenset({"words_per_minute"}))


def say(words: str, urgency: Urgency = Urgency.PROGRAM, language: str = "en") -> Utterance:
    return Utterance(words, urgency, language)


# --- the protocol


@given(st.lists(st.integers(0, len(STREAM)), max_size=12))
def test_any_chunking_gives_the_same_answers(cuts: list[int]) -> None:
    places = [0, *sorted(cuts), len(STREAM)]
    reader = SsipReader()
    answers = [
        answer for begin, end in itertools.pairwise(places) for answer in reader.feed(STREAM[begin:end])
    ]
    assert answers == [
        SsipReply(208, ()),
        SsipReply(225, ("21",)),
        SsipEvent(SsipEventKind.END, "21"),
    ]


@given(st.binary(max_size=300))
def test_garbage_raises_a_protocol_error_or_nothing(data: bytes) -> None:
    with contextlib.suppress(SsipProtocolError):
        list(SsipReader().feed(data))


def test_a_server_that_never_ends_its_line_is_refused() -> None:
    reader = SsipReader()
    with pytest.raises(SsipProtocolError):
        for _ in range(10):
            list(reader.feed(b"2" * 1000))


@pytest.mark.parametrize("line", [b"x", b"20 OK", b"2080 OK", b"208:OK", b"", b"abc OK"])
def test_a_line_that_is_no_answer_is_refused(line: bytes) -> None:
    with pytest.raises(SsipProtocolError):
        list(SsipReader().feed(line + b"\r\n"))


@pytest.mark.parametrize(
    ("sent", "answer"),
    [
        (b"699 x", SsipReply(699, ())),
        (b"701-7\n701 x", SsipEvent(SsipEventKind.BEGIN, "7")),
        (b"702-7\n702-1\n702 x", SsipEvent(SsipEventKind.END, "7")),
        (b"703-7\n703 x", SsipEvent(SsipEventKind.CANCEL, "7")),
        (b"700-7\n700 x", None),
        (b"704-7\n704 x", None),
        (b"702 x", None),
    ],
)
def test_answers_from_seven_hundred_on_are_events(sent: bytes, answer: object) -> None:
    assert list(SsipReader().feed(sent + b"\n")) == ([] if answer is None else [answer])


@pytest.mark.parametrize("lines", [4_096, 4_097])
def test_a_line_or_an_answer_may_be_as_long_as_allowed(lines: int) -> None:
    line, answer = SsipReader(), SsipReader()
    list(answer.feed(b"225-x\n" * lines))
    if lines == 4_096:
        list(line.feed(b"2" * lines))
        assert list(answer.feed(b"225 OK\n")) == [SsipReply(225, ("x",) * lines)]
    else:
        for reader, data in ((line, b"2" * lines), (answer, b"225 OK\n")):
            with pytest.raises(SsipProtocolError):
                list(reader.feed(data))


def test_a_line_with_a_full_stop_does_not_end_the_message() -> None:
    assert encode_text("") == b"\r\n.\r\n"
    assert encode_text("one\n.\n.x") == b"one\r\n..\r\n..x\r\n.\r\n"


def test_a_refused_message_has_no_number() -> None:
    assert message_of(SsipReply(225, ("7",))) == "7"
    assert message_of(SsipReply(312, ("7",))) is None
    assert message_of(SsipReply(225, ())) is None
    assert [SsipReply(code, ()).is_ok for code in (199, 200, 299, 300)] == [False, True, True, False]


def test_rate_pitch_and_volume_use_the_whole_range() -> None:
    usual = VoiceSettings(chosen=frozenset({"words_per_minute", "pitch", "volume"}))
    loud, low = replace(usual, words_per_minute=10_000, pitch=100), replace(usual, pitch=0, volume=0.5)
    assert ssip_settings(usual) == {"RATE": 0, "PITCH": 0, "VOLUME": 100}
    assert ssip_settings(loud) == {"RATE": 100, "PITCH": 100, "VOLUME": 100}
    assert ssip_settings(low) == {"RATE": 0, "PITCH": -100, "VOLUME": 0}
    assert ssip_settings(replace(usual, words_per_minute=80, volume=0.0)) == {
        "RATE": -100, "PITCH": 0, "VOLUME": -100,
    }  # fmt: skip


def test_settings_that_the_learner_did_not_choose_are_left_to_the_server() -> None:
    assert ssip_settings(VoiceSettings(450, 100, 0.5, chosen=frozenset({"pitch"}))) == {"PITCH": 100}
    assert ssip_settings(VoiceSettings(punctuation="all")) == {}


# --- the address


@pytest.mark.parametrize(
    ("given_address", "meant"),
    [
        ("unix_socket:/run/x.sock", SsipAddress(path="/run/x.sock")),
        ("inet_socket:localhost:6561", SsipAddress(host="localhost", port=6561)),
        ("inet_socket:robot", SsipAddress(host="robot", port=6560)),
        ("inet_socket:robot:65535", SsipAddress(host="robot", port=65535)),
        ("inet_socket:robot:1", SsipAddress(host="robot", port=1)),
        ("inet_socket::6561", SsipAddress(host="127.0.0.1", port=6561)),
        ("inet_socket:", SsipAddress(host="127.0.0.1", port=6560)),
        ("inet_socket:::1:6561", SsipAddress(host="::1", port=6561)),
        ("inet_socket:robot:65536", None),
        ("inet_socket:robot:0", None),
        ("inet_socket:robot:port", None),
        ("unix_socket:", None),
        ("pigeon:home", None),
    ],
)
def test_an_address_is_parsed_as_by_speech_dispatchers_clients(
    given_address: str, meant: SsipAddress | None
) -> None:
    assert parse_address(given_address) == meant


def test_the_socket_of_this_user_is_found(tmp_path: Path) -> None:
    variables = {"XDG_RUNTIME_DIR": str(tmp_path)}
    assert find_address(variables) is None
    socket_file = tmp_path / "speech-dispatcher" / "speechd.sock"
    socket_file.parent.mkdir()
    socket_file.touch()
    assert find_address(variables) == SsipAddress(path=str(socket_file))
    assert find_address({**variables, "SPEECHD_ADDRESS": "unix_socket:/x"}) == SsipAddress(path="/x")


def test_a_folder_without_permission_has_no_socket(tmp_path: Path) -> None:
    """As after ``su``, which leaves the variable at another user's folder; here the system refuses a name."""
    assert find_address({"XDG_RUNTIME_DIR": f"{tmp_path}/{'x' * 300}"}) is None


def test_a_file_without_a_server_is_not_reachable(tmp_path: Path) -> None:
    (tmp_path / "s").touch()
    assert not is_reachable(SsipAddress(path=str(tmp_path / "s")))
    assert not is_reachable(None)


# --- the speaker


@pytest.fixture
def server(tmp_path: Path) -> Iterator[Server]:
    made = Server(tmp_path)
    yield made
    made.close()


def test_a_server_is_reachable(server: Server) -> None:
    assert is_reachable(server.address)


def test_sentences_are_sent_in_order_in_their_languages_after_the_readers(server: Server) -> None:
    speaker = SsipSpeaker(server.address, lambda _: None, languages=spoken_languages())
    speaker.say(say("I walked 3 steps."))
    speaker.say(say("x=-3"))
    speaker.say(say("Andei 3 passos.", language="pt"))
    assert speaker.wait_until_quiet(10)
    speaker.close()
    assert server.texts == ["I walked 3 steps.", "x equals minus 3", "Andei 3 passos."]
    assert server.wait_for(command="QUIT")
    assert re.fullmatch(r"SET SELF CLIENT_NAME \w+:donnie:main", server.commands[0])
    assert server.commands[1:4] == [
        *("SET SELF PRIORITY MESSAGE", "SET SELF NOTIFICATION END ON", "SET SELF NOTIFICATION CANCEL ON")
    ]
    assert server.commands[-2:] == ["CANCEL SELF", "QUIT"]
    assert [each for each in server.commands if "LANGUAGE" in each] == [
        "SET SELF LANGUAGE en",
        "SET SELF LANGUAGE pt",
    ]


def test_a_chosen_rate_is_sent_to_the_server(server: Server) -> None:
    speaker = SsipSpeaker(server.address, lambda _: None, FAST)
    speaker.say(say("Hello."))
    assert speaker.wait_until_quiet(10)
    speaker.close()
    assert "SET SELF RATE 100" in server.commands


def test_a_changed_voice_is_sent_between_two_sentences(
    tmp_path: Path,
) -> None:
    server = Server(tmp_path)
    speaker = SsipSpeaker(server.address, lambda _: None, languages=spoken_languages())
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


def test_silence_cancels_the_sentence_and_drops_the_others(tmp_path: Path) -> None:
    server = Server(tmp_path, reports_end=False)
    speaker = SsipSpeaker(server.address, lambda _: None, languages=spoken_languages())
    speaker.say(say("First."))
    speaker.say(say("Second."))
    assert server.wait_for(texts=1)
    assert not speaker.wait_until_quiet(0)
    speaker.silence_speech()
    assert server.wait_for(command="CANCEL SELF")
    assert speaker.wait_until_quiet(10)
    assert server.texts == ["First."]
    speaker.close()


def test_an_interrupted_sentence_is_said_again_by_the_next_server(tmp_path: Path) -> None:
    server = Server(tmp_path, hangs_up_after=5)
    notices: list[AudioNotice] = []
    speaker = SsipSpeaker(server.address, notices.append)
    speaker.say(say("Hello."))
    assert server.wait_for(connections=3)
    assert speaker.wait_until_quiet(10)
    speaker.close()
    assert [notice.code for notice in notices] == [NoticeCode.SSIP_LOST]


def test_a_sentence_that_was_silenced_before_the_server_was_lost_is_not_said_again() -> None:
    mailbox = Mailbox()
    mailbox.offer(say("First."), 0.0)
    assert mailbox.take() == say("First.")
    mailbox.silence()
    mailbox.put_back()
    assert mailbox.take() is None
    assert mailbox.wait_until_quiet(0)


@pytest.mark.parametrize(
    ("spoken", "urgency", "ends"),
    [
        (Urgency.PROGRESS, Urgency.ALERT, True),
        (Urgency.PROGRAM, Urgency.ALERT, False),
        (Urgency.PROGRESS, Urgency.PROGRAM, False),
        (None, Urgency.ALERT, False),
    ],
)
def test_an_alert_ends_progress_that_is_being_said(
    spoken: Urgency | None, urgency: Urgency, ends: bool
) -> None:
    mailbox = Mailbox()
    if spoken is not None:
        mailbox.offer(say("First.", spoken), 0.0)
        mailbox.take()

    mailbox.offer(say("Second.", urgency), 1.0)

    assert mailbox.take_silence() is ends
    assert not mailbox.take_silence()


GREETED = b"208 OK\r\n" * 4
ACCEPTED = b"208 OK LANGUAGE\r\n230 OK RECEIVING DATA\r\n225-7\r\n225 OK MESSAGE QUEUED\r\n"


class Connected:
    """A connection whose server has answered already, that server, and their clock."""

    def __init__(self, mailbox: Mailbox, answers: bytes = b"") -> None:
        self.now = 100.0
        self.missing: list[float] = []
        ours, self.server = socket.socketpair()
        self.server.sendall(answers)
        self.connection = SsipConnection(
            ours, mailbox, lambda: self.now, lambda: self.missing.append(self.now)
        )

    def do_next(self, now: float = 100.0) -> None:
        self.now = now
        self.connection._do_next()


def test_a_missing_end_is_reported_ten_seconds_after_the_slowest_voice_is_done() -> None:
    """A fifth of a second a character."""
    mailbox = Mailbox()
    mailbox.offer(say("Hello."), 0.0)
    it = Connected(mailbox, ACCEPTED)
    for now in (100.0, 100.0, 111.19):
        it.do_next(now)
        assert mailbox.speaking == say("Hello.")
    it.do_next(111.2)

    assert mailbox.speaking is None
    assert it.missing == [111.2]


@pytest.mark.parametrize(
    ("event", "is_over"),
    [
        (b"701-7\r\n701 BEGIN\r\n", False),
        (b"702-7\r\n702 END\r\n", True),
        (b"703-7\r\n703 CANCELED\r\n", True),
        (b"702-6\r\n702 END\r\n", False),
    ],
)
def test_a_sentence_is_over_when_its_own_message_has_ended(event: bytes, is_over: bool) -> None:
    mailbox = Mailbox()
    mailbox.offer(say("Hello."), 0.0)
    it = Connected(mailbox, ACCEPTED + event)
    for _ in range(2):
        it.do_next()

    assert (mailbox.speaking is None) is is_over


@pytest.mark.parametrize("text", ["Hello.", ""])
def test_a_sentence_that_is_refused_or_empty_is_over(text: str) -> None:
    mailbox = Mailbox()
    mailbox.offer(say("Hello."), 0.0)
    it = Connected(mailbox, b"208 OK\r\n300 NO\r\n")
    it.connection._speakable = lambda _: text
    it.do_next()
    it.connection._server.sendall(b"|")

    assert it.server.recv(100).removesuffix(b"|") == (b"SET SELF LANGUAGE en\r\nSPEAK\r\n" if text else b"")
    assert mailbox.speaking is None


def test_a_server_that_does_not_answer_for_three_seconds_is_lost() -> None:
    it = Connected(Mailbox())
    times = iter((100.0, 102.99, 102.99, 103.0))
    it.connection._now = lambda: next(times)
    with pytest.raises(ConnectionLost):
        it.connection.run("ada")

    assert next(times, None) is None
    assert it.server.recv(100) == b"SET SELF CLIENT_NAME ada:donnie:main\r\n"


def test_a_server_that_hangs_up_is_lost() -> None:
    it = Connected(Mailbox())
    it.server.close()

    with pytest.raises(ConnectionLost):
        it.connection._wait(None)


def test_a_closed_mailbox_ends_the_connection_with_a_farewell() -> None:
    mailbox = Mailbox()
    mailbox.close()
    it = Connected(mailbox, GREETED + b"210 OK CANCELED\r\n")
    it.connection.run("ada")

    assert it.server.recv(1000).endswith(b"CANCEL SELF\r\nQUIT\r\n")


# --- the mailbox


def is_signalled(mailbox: Mailbox) -> bool:
    return bool(select.select([mailbox], [], [], 0)[0])


def test_one_sentence_is_taken_at_a_time() -> None:
    mailbox = Mailbox()
    for text in ("First.", "Second."):
        assert mailbox.offer(say(text), 0.0) is QueueResult.QUEUED
    assert mailbox.wait_for_work()
    assert (mailbox.take(), mailbox.take()) == (say("First."), None)
    assert mailbox.speaking == say("First.")
    mailbox.said()
    assert not mailbox.wait_until_quiet(0)
    assert (mailbox.speaking, mailbox.take()) == (None, say("Second."))
    assert not mailbox.wait_until_quiet(0)
    mailbox.said()
    assert mailbox.wait_until_quiet(0)


def test_settings_are_given_to_each_server_between_two_sentences() -> None:
    mailbox = Mailbox({"RATE": 5})
    assert mailbox.take_settings() == {}
    for _ in range(2):
        mailbox.connected()
        assert (mailbox.take_settings(), mailbox.take_settings()) == ({"RATE": 5}, {})
    mailbox.offer(say("Hello."), 0.0)
    mailbox.take()
    mailbox.set_settings({"PITCH": 7})
    assert mailbox.take_settings() == {}
    mailbox.said()
    assert mailbox.take_settings() == {"PITCH": 7}

    without = Mailbox()
    without.connected()
    assert without.take_settings() == {}


def test_a_closed_mailbox_is_empty_and_takes_nothing_more() -> None:
    mailbox = Mailbox()
    mailbox.offer(say("Hello."), 0.0)
    assert not mailbox.is_closed
    mailbox.close()

    assert mailbox.is_closed
    assert mailbox.offer(say("Too late."), 0.0) is QueueResult.REPEATED
    assert (mailbox.take(), mailbox.wait_for_work(), mailbox.wait_until_quiet(0)) == (None, False, True)


def test_a_lost_server_leaves_its_sentence_for_the_next_one() -> None:
    mailbox = Mailbox()
    mailbox.offer(say("Hello."), 0.0)
    mailbox.take()
    mailbox.put_back()

    assert mailbox.speaking is None
    assert mailbox.take() == say("Hello.")


@pytest.mark.parametrize(
    "call",
    [
        lambda mailbox: mailbox.offer(say("Hello."), 0.0),
        Mailbox.silence,
        Mailbox.close,
        lambda mailbox: mailbox.set_settings({}),
    ],
)
def test_whatever_another_thread_does_wakes_the_owner_once(call: Callable[[Mailbox], object]) -> None:
    mailbox = Mailbox()
    assert not is_signalled(mailbox)
    mailbox.clear_signal()
    call(mailbox)
    assert is_signalled(mailbox)
    mailbox.clear_signal()
    assert not is_signalled(mailbox)
    for _ in range(1000):
        mailbox.silence()  # its socket is full at some time


@pytest.mark.parametrize(
    ("login", "name"), [("ada", "ada"), ("a.d:a 7", "ada7"), (".", "donnie"), (None, "donnie")]
)
def test_the_server_knows_the_learner_by_the_letters_of_the_login(
    monkeypatch: pytest.MonkeyPatch, login: str | None, name: str
) -> None:
    def user() -> str:
        if login is None:
            raise KeyError
        return login

    monkeypatch.setattr("getpass.getuser", user)
    assert conversation._user() == name


def test_a_missing_server_is_reported_once_and_no_caller_waits(tmp_path: Path) -> None:
    notices: list[AudioNotice] = []
    speaker = SsipSpeaker(SsipAddress(path=str(tmp_path / "none")), notices.append)
    for number in range(1000):
        speaker.say(say(f"Sentence {number}."))
    assert speaker.wait_until_quiet(10)
    speaker.close()
    assert [notice.code for notice in notices] == [NoticeCode.SSIP_LOST]


def test_an_end_that_never_comes_means_no_sound(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(conversation, "END_SECONDS", 0.0)
    monkeypatch.setattr(conversation, "SECONDS_A_CHARACTER", 0.0)
    server = Server(tmp_path, reports_end=False)
    notices: list[AudioNotice] = []
    speaker = SsipSpeaker(server.address, notices.append)
    speaker.say(say("First."))
    speaker.say(say("Second."))
    assert server.wait_for(texts=2)
    assert speaker.wait_until_quiet(10)
    speaker.close()
    assert [notice.code for notice in notices] == [NoticeCode.SSIP_SILENT]


def test_closing_before_anything_was_said_starts_nothing(server: Server) -> None:
    speaker = SsipSpeaker(server.address, lambda _: None, languages=spoken_languages())
    speaker.close()
    speaker.say(say("Too late."))
    speaker.close()
    assert server.connections == 0


# --- each step alone


def test_a_server_has_a_quarter_of_a_second_to_accept(monkeypatch: pytest.MonkeyPatch) -> None:
    asked: list[object] = []
    here, there = socket.socketpair()

    def connect(place: object, timeout: float) -> socket.socket:
        asked.append((place, timeout))
        return here

    monkeypatch.setattr(socket, "create_connection", connect)
    assert is_reachable(SsipAddress(host="h", port=7))
    assert asked == [(("h", 7), 0.25)]
    assert here.fileno() == -1, "it is closed again"
    there.close()
    assert not is_reachable(None)


def test_a_connected_socket_has_the_timeout(server: Server) -> None:
    with contextlib.closing(server.address.connect(7.0)) as connected:
        assert connected.gettimeout() == 7.0


def test_an_owner_waits_until_there_is_something_to_say_or_no_more() -> None:
    box, waited = Mailbox(), list[object]()
    box._changed.wait_for = lambda is_over, *_: waited.append(bool(is_over()))  # type: ignore[method-assign]
    assert box.wait_for_work()
    box.offer(say("Hello."), 0.0)
    assert box.wait_for_work()
    box.close()
    assert not box.wait_for_work()
    assert waited == [False, True, True]


@pytest.mark.parametrize("is_silenced", [False, True])
def test_a_lost_sentence_is_put_back_unless_it_was_silenced(is_silenced: bool) -> None:
    box = Mailbox()
    box.offer(say("Hello."), 0.0)
    assert box.take() == box.speaking == say("Hello.")
    assert box.take() is None
    if is_silenced:
        box.silence()
    box.put_back()

    assert box.speaking is None
    assert box.take_silence() is False
    assert box.take() == (None if is_silenced else say("Hello."))


def test_a_silence_is_taken_once_and_only_while_something_is_said() -> None:
    box = Mailbox()
    box.silence()
    assert box.take_silence() is False
    box.offer(say("One."), 0.0)
    box.take()
    box.silence()
    assert not box.wait_until_quiet(0.0)
    box.silence()
    assert [box.take_silence(), box.take_silence()] == [True, False]
    box.said()
    assert box.wait_until_quiet(0.0)


def test_a_speaker_starts_one_thread_and_waits_a_second_for_its_end(monkeypatch: pytest.MonkeyPatch) -> None:
    made: list[tuple[object, ...]] = []

    class Thread:
        def __init__(self, *, target: object, name: str, daemon: bool) -> None:
            made.append((name, daemon))

        def start(self) -> None:
            made.append(("started",))

        def join(self, seconds: float) -> None:
            made.append(("joined", seconds))

    monkeypatch.setattr(conversation.threading, "Thread", Thread)
    speaker = SsipSpeaker(SsipAddress(path="/nowhere"), lambda _: None)
    assert not speaker.is_speaking
    for words in ("One.", "Two."):
        speaker.say(say(words))
    assert made == [("ssip", True), ("started",)]
    speaker._mailbox.take()
    assert speaker.is_speaking
    speaker.close()
    assert made[2:] == [("joined", 1.0)]
