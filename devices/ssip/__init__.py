"""Speech through speech-dispatcher's socket (SSIP), beside Orca and not over it."""
