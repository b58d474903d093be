"""The vibration belt on its serial connection."""
