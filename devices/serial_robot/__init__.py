"""The original robot on its serial connection as a ``Robot`` of the port: in steps and compass degrees."""
