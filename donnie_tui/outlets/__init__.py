"""The outputs of a session besides printed lines: voice and cues, the belt, and files."""
