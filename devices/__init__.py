"""The ports of what Donnie can drive, and the devices that implement them."""
