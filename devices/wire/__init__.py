"""The protocol of the robot's serial connection, byte by byte, without a port, a thread or a clock.

Bytes and times come in as values, and bytes go out as values, so every rule can be tested without hardware.
"""
