"""The command line: arguments in, exit codes out. A contract; changes are for the changelog."""
