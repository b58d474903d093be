"""The audio worker: one process that keeps all sound away from the terminal and from the interpreter.

``factory`` makes what the rest of Donnie uses. ``conductor`` decides, ``service`` carries out, ``process``
holds the child; ``worker`` is the child's side, ``messages`` what the two say to each other.
"""
