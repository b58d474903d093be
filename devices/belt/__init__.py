"""The vibrating belt on its serial line: frames, when they are sent, the line, and a simulated board."""
