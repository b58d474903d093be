"""The full screen: editor, map, log and command line. The only package that knows Textual."""
