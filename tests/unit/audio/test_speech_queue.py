"""What is said next: the queue alone."""

from collections.abc import Callable

import pytest

from devices.audio.speech_queue import (
    REPEAT_WINDOW,
    SENTENCE_LIMIT,
    QueueResult,
    SentenceTracker,
    SpeechQueue,
    SpokenSentence,
    first_sentence,
    interrupts,
)
from devices.ports.audio import Urgency, Utterance


def utterance(text: str, urgency: Urgency = Urgency.PROGRAM, language: str = "en") -> Utterance:
    return Utterance(text, urgency, language)


def said_after(*offers: tuple[str, Urgency]) -> list[str]:
    """What is said, in order, when all of ``offers`` came at once."""
    queue = SpeechQueue()
    for text, urgency in offers:
        queue.offer(utterance(text, urgency), now=0.0)
    return drained(queue)


def drained(queue: SpeechQueue) -> list[str]:
    return [sentence.text for sentence in iter(queue.next, None)]


@pytest.mark.parametrize(
    ("offers", "said"),
    [
        pytest.param(
            [("h", Urgency.HINT), ("p", Urgency.PROGRESS), ("a", Urgency.ANSWER), ("!", Urgency.ALERT)],
            ["!", "a", "p", "h"],
            id="alerts, answers, progress, hints",
        ),
        pytest.param(
            [
                ("a1", Urgency.ANSWER),
                ("s1", Urgency.PROGRAM),
                ("a2", Urgency.ANSWER),
                ("s2", Urgency.PROGRAM),
            ],
            ["a1", "s1", "a2", "s2"],
            id="answers and SPEAK share one line",
        ),
        pytest.param(
            [("1 step", Urgency.PROGRESS), ("a", Urgency.ANSWER), ("2 steps", Urgency.PROGRESS)],
            ["a", "2 steps"],
            id="of progress the newest is kept",
        ),
        pytest.param(
            [("one", Urgency.PROGRAM), ("one", Urgency.PROGRAM)],
            ["one", "one"],
            id="SPEAK repeats itself as often as the program does",
        ),
        pytest.param(
            [("one", Urgency.ANSWER), ("one", Urgency.ANSWER)],
            ["one"],
            id="an answer at once again is said once",
        ),
        pytest.param(
            [("one", Urgency.PROGRAM), ("one", Urgency.ANSWER)],
            ["one", "one"],
            id="SPEAK silences no answer of the same words",
        ),
        pytest.param([("", Urgency.PROGRAM), (" \n ", Urgency.ALERT)], [], id="nothing is said for nothing"),
    ],
)
def test_the_order_of_utterances(offers: list[tuple[str, Urgency]], said: list[str]) -> None:
    assert said_after(*offers) == said


def test_the_same_text_is_said_again_after_half_a_second() -> None:
    queue = SpeechQueue()
    queue.offer(utterance("Wall.", Urgency.ALERT), now=0.0)

    assert queue.offer(utterance("Wall.", Urgency.ALERT), now=REPEAT_WINDOW - 0.01) is QueueResult.REPEATED
    assert queue.offer(utterance("Wall.", Urgency.ALERT), now=REPEAT_WINDOW) is QueueResult.QUEUED


def test_the_same_words_in_another_language_are_another_text() -> None:
    queue = SpeechQueue()
    queue.offer(utterance("No.", Urgency.ANSWER, "en"), now=0.0)

    assert queue.offer(utterance("No.", Urgency.ANSWER, "es"), now=0.0) is QueueResult.QUEUED


def test_what_was_silenced_may_be_said_again_at_once() -> None:
    queue = SpeechQueue()
    queue.offer(utterance("Wall.", Urgency.ALERT), now=0.0)
    queue.clear()

    assert drained(queue) == []
    assert queue.offer(utterance("Wall.", Urgency.ALERT), now=0.1) is QueueResult.QUEUED


def test_an_alert_waits_for_one_sentence_of_a_long_answer() -> None:
    queue = SpeechQueue()
    queue.offer(utterance("Facing north. Two boxes. One wall.", Urgency.ANSWER), now=0.0)
    first = queue.next()
    queue.offer(utterance("Stopped.", Urgency.ALERT), now=1.0)

    assert first == utterance("Facing north.", Urgency.ANSWER)
    assert drained(queue) == ["Stopped.", "Two boxes.", "One wall."]


def test_a_sentence_that_is_put_back_precedes_those_that_wait() -> None:
    queue = SpeechQueue()
    for text in ("one", "two"):
        queue.offer(utterance(text), now=0.0)
    taken = queue.next()
    assert taken is not None
    queue.put_back(taken)

    assert drained(queue) == ["one", "two"]


def test_a_thousand_times_speak_are_a_thousand_sentences_in_order() -> None:
    queue = SpeechQueue()
    texts = [f"number {number}" for number in range(1000)]
    for text in texts:
        assert queue.offer(utterance(text), now=0.0) is QueueResult.QUEUED

    assert drained(queue) == texts


def test_huge_texts_are_refused_before_they_fill_the_memory() -> None:
    """Of one text 100 000 characters are said."""
    queue = SpeechQueue()
    huge = "a" * 1_500_000
    offers = [queue.offer(utterance(huge), now=0.0) for _ in range(3)]

    assert offers == [QueueResult.QUEUED, QueueResult.QUEUED, QueueResult.REFUSED]
    assert [len(sentence) for sentence in drained(queue)] == ([SENTENCE_LIMIT] * 333 + [100]) * 2


@pytest.mark.parametrize("empty", [drained, SpeechQueue.clear])
def test_two_million_characters_wait_and_others_when_these_are_said_or_dropped(
    empty: Callable[[SpeechQueue], object],
) -> None:
    queue = SpeechQueue()
    for _ in range(2):
        offers = [queue.offer(utterance(text), now=0.0) for text in ("a" * 1_999_999, "b", "c")]
        assert offers == [QueueResult.QUEUED, QueueResult.QUEUED, QueueResult.REFUSED]
        empty(queue)


@pytest.mark.parametrize(
    "text", ["." * 100_000, "!?" * 50_000, " " * 100_000 + "a", "a" + "\t" * 100_000 + "b"]
)
def test_a_long_row_of_signs_or_blanks_is_looked_through_once(text: str) -> None:
    """When each of them was tried as the beginning of the row, this took minutes."""
    assert len(first_sentence(text)[0]) <= SENTENCE_LIMIT


def test_an_alert_is_accepted_when_the_program_has_filled_the_queue() -> None:
    queue = SpeechQueue()
    while queue.offer(utterance("blah"), now=0.0) is QueueResult.QUEUED:
        pass

    assert queue.offer(utterance("Stopped.", Urgency.ALERT), now=0.0) is QueueResult.QUEUED
    assert queue.next() == utterance("Stopped.", Urgency.ALERT)


@pytest.mark.parametrize(
    ("text", "sentence", "rest"),
    [
        ("One.", "One.", ""),
        ("One. Two.", "One.", "Two."),
        ("Really?! Yes.", "Really?!", "Yes."),
        ('He said "go." Then', 'He said "go."', "Then"),
        ("3.5 steps", "3.5 steps", ""),
        ("line\nline", "line", "line"),
        ("  padded  ", "padded", ""),
        ("Position 1, 2; facing north", "Position 1, 2; facing north", ""),
        ("", "", ""),
        pytest.param("x" * 300, "x" * 300, "", id="300 letters"),
        pytest.param("x" * 301, "x" * 300, "x", id="301 letters"),
        pytest.param("x " + "y" * 300, "x", " " + "y" * 300, id="an early blank"),
        pytest.param("x" * 299 + " y", "x" * 299, " y", id="a late blank"),
        pytest.param("x" * 300 + " y", "x" * 300, " y", id="a blank too late"),
        pytest.param("x" * 299 + ". y", "x" * 299 + ".", " y", id="a late full stop"),
    ],
)
def test_where_a_sentence_ends(text: str, sentence: str, rest: str) -> None:
    assert first_sentence(text) == (sentence, rest)


def test_a_sentence_without_end_is_cut_between_words() -> None:
    sentence, rest = first_sentence("word " * 1000)

    assert len(sentence) <= SENTENCE_LIMIT
    assert sentence.endswith("word")
    assert rest.strip().startswith("word")


def test_nothing_is_lost_when_a_text_is_cut() -> None:
    text = "x" * 1000
    pieces = []
    while text:
        piece, text = first_sentence(text)
        pieces.append(piece)

    assert "".join(pieces) == "x" * 1000


@pytest.mark.parametrize("incoming", Urgency)
@pytest.mark.parametrize("speaking", Urgency)
def test_only_an_alert_interrupts_and_only_progress_and_hints_are_interrupted(
    incoming: Urgency, speaking: Urgency
) -> None:
    expected = incoming is Urgency.ALERT and speaking in {Urgency.PROGRESS, Urgency.HINT}

    assert interrupts(incoming, speaking) is expected


@pytest.mark.parametrize(
    ("urgency", "most"),
    [(Urgency.ALERT, 32), (Urgency.PROGRESS, 1), (Urgency.HINT, 8)],
    ids=lambda it: str(it),
)
def test_of_too_many_utterances_the_newest_wait(urgency: Urgency, most: int) -> None:
    queue = SpeechQueue()
    for number in range(most + 2):
        assert queue.offer(Utterance(f"{number}", urgency, "en"), number) is QueueResult.QUEUED

    assert len(queue) == most
    said = queue.next()
    assert said is not None
    assert said.text == "2"


def test_five_thousand_utterances_of_a_program_wait_and_no_more() -> None:
    queue = SpeechQueue()
    results = [queue.offer(Utterance("a", Urgency.PROGRAM, "en"), 0.0) for _ in range(5001)]

    assert results == [QueueResult.QUEUED] * 5000 + [QueueResult.REFUSED]
    assert queue.offer(Utterance("a", Urgency.ANSWER, "en"), 0.0) is QueueResult.REFUSED
    queue.next()
    assert queue.offer(Utterance("a", Urgency.PROGRAM, "en"), 0.0) is QueueResult.QUEUED


def test_sixty_four_texts_are_remembered_by_their_beginnings_and_their_length() -> None:
    queue = SpeechQueue()

    def offer(text: str, now: float = 0.0) -> QueueResult:
        return queue.offer(Utterance(text, Urgency.ANSWER, "en"), now)

    assert offer("x" * 500 + "a") is QueueResult.QUEUED
    assert offer("x" * 500 + "b") is QueueResult.REPEATED
    assert offer("x" * 500 + "bc") is QueueResult.QUEUED
    assert offer("x" * 499 + "ya") is QueueResult.QUEUED
    for number in range(62):
        offer(f"{number}")
    assert offer("61", 0.49) is QueueResult.REPEATED
    assert offer("x" * 501) is QueueResult.QUEUED  # forgotten
    assert offer("61", 0.5) is QueueResult.QUEUED


def test_a_sentence_is_given_to_two_workers_and_no_more() -> None:
    numbers = iter(range(1, 9))
    tracker = SentenceTracker(lambda: next(numbers))
    assert not tracker
    tracker.offer(Utterance("One. Two.", Urgency.PROGRESS, "en"), 0.0)
    tracker.current = tracker.take()

    assert tracker.current == SpokenSentence(1, Utterance("One.", Urgency.PROGRESS, "en"), 1)
    assert (tracker.is_current(1), tracker.is_current(2)) == (True, False)
    assert tracker.is_interrupted_by(Utterance("Stop!", Urgency.ALERT, "en"))
    assert not tracker.is_interrupted_by(Utterance("Two.", Urgency.PROGRESS, "en"))
    tracker.retry()
    tracker.current = tracker.take()
    assert tracker.current == SpokenSentence(2, Utterance("One.", Urgency.PROGRESS, "en"), 2)
    tracker.retry()
    following = tracker.take()
    assert following == SpokenSentence(3, Utterance("Two.", Urgency.PROGRESS, "en"), 1)
    assert tracker
    tracker.current = None
    assert not tracker
    assert (tracker.take(), tracker.is_current(3)) == (None, False)
    assert not tracker.is_interrupted_by(Utterance("Stop!", Urgency.ALERT, "en"))


def test_what_is_to_be_said_again_is_dropped_with_the_rest() -> None:
    tracker = SentenceTracker(lambda: 1)
    tracker.offer(Utterance("One. Two.", Urgency.ANSWER, "en"), 0.0)
    tracker.current = tracker.take()
    tracker.retry()
    tracker.current = None
    assert tracker

    tracker.clear()
    assert not tracker
    assert tracker.take() is None


def test_half_a_second_counts_from_when_the_text_was_said_last() -> None:
    queue = SpeechQueue()
    moments = (100.0, 100.49, 100.5, 100.99, 101.0)
    results = [queue.offer(utterance("Wall.", Urgency.ALERT), now) for now in moments]

    queued, repeated = QueueResult.QUEUED, QueueResult.REPEATED
    assert results == [queued, repeated, queued, repeated, queued]


def test_the_last_sixty_four_texts_are_remembered() -> None:
    queue = SpeechQueue()
    first, again = utterance("first", Urgency.ANSWER), utterance("again", Urgency.ANSWER)
    queue.offer(again, now=100.0)
    queue.offer(first, now=100.5)
    queue.offer(again, now=100.5)  # now it is newer than the first one
    for number in range(62):
        queue.offer(utterance(str(number), Urgency.ANSWER), now=100.6)
    assert queue.offer(first, now=100.7) is QueueResult.REPEATED
    queue.offer(utterance("one more", Urgency.ANSWER), now=100.7)

    assert queue.offer(again, now=100.7) is QueueResult.REPEATED
    assert queue.offer(first, now=100.7) is QueueResult.QUEUED


def test_a_sentence_is_waiting_being_said_or_to_be_said_again() -> None:
    numbers = iter(range(1, 9))
    tracker = SentenceTracker(lambda: next(numbers))
    assert not tracker
    tracker.offer(utterance("Hello."), 0.0)
    assert tracker
    tracker.current = tracker.take()
    assert tracker.current == SpokenSentence(1, utterance("Hello."), 1)
    assert tracker
    tracker.retry()
    tracker.current = None
    assert tracker
    tracker.current = tracker.take()
    assert tracker.current == SpokenSentence(2, utterance("Hello."), 2)
    tracker.retry()  # twice is enough
    tracker.current = None
    assert not tracker
    assert tracker.take() is None
