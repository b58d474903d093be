"""GoDonnie: its text, its meaning and how a program of it runs. It knows robots only by the bearings of their sensors."""
