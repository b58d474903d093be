"""Widgets: they get values and post messages, and never call each other."""
