"""The language GoDonnie: text, syntax tree, mistakes, compiled programs."""
