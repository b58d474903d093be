"""Which robot a session has: chosen, looked for, connected to; simulated, real, or a simulated board."""
