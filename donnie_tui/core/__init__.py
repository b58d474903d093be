"""What Donnie does, without a screen and without hardware: programs run, and everything is an event."""
