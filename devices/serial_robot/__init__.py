"""The original robot on its serial line, as the port wants a robot: in steps and compass degrees."""
