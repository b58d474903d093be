"""GoDonnie: its text, its meaning, how its programs run. Of robots it knows the bearings of their sensors."""
