"""What comes out of a session besides its printed lines: voice and cues, the belt, and files."""
