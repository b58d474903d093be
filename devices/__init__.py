"""Everything that Donnie can be: the ports, and the devices that stand behind them."""
