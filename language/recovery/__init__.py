"""All mistakes of form in a text: one for each thing that is wrong, and none for what follows from it.

Reads the tokens as the parser does, but goes on behind a mistake. How:
1. A word that is near to one that may stand there is told, and read as if it were that word.
2. Inside the head of a block (IF to THEN) the rest of the head is skipped and the block counts as opened,
   so that its END finds it.
3. Any other command is given up, and reading goes on where the next one can begin.
4. An END that does not fit is read so that the fewest mistakes follow.
5. Nothing is told about a command in which a character could not be read; that was told already.

``finder`` is the way in. ``reading`` is the place in the text that all others look at and move: ``commands``
where a command may begin, ``ends`` at ENDs and ELSE (``lone_ends`` tells an END alone from one over two
lines), ``within`` inside a command, ``arguments`` behind a
word that takes one, ``sensors`` behind one that was meant to. ``going_on`` finds where reading goes on.
"""
