"""The borders between Donnie and its devices: protocols and values."""
