"""Short talks with whatever is at the other end of a port: what are you, and stop.

A talk is pure: bytes and times in, bytes out. ``line`` is where one is held on a real port.
"""
