"""The wire of the Player robot server, byte by byte, without a socket or a clock.

Bytes come in as values and go out as values, for a server and for a client alike.
"""
