"""The world of a session: chosen by name or file, put into a recording and taken out of one."""
