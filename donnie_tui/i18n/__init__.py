"""Codes become sentences here, in English, Portuguese and Spanish, and nowhere else."""
