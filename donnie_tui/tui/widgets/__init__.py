"""One widget a file. They get values and post messages; they never call each other."""
