"""The linear mode: plain lines for screen readers, braille and scripts. It never reaches Textual."""
