"""The robot of a session: chosen, searched for, connected; simulated, real, or a simulated board."""
