"""Codes become sentences here, in each language that has a folder in ``locales``, and nowhere else."""
