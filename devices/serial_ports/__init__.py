"""Serial ports: opening, classifying faults, listing, and resetting the board behind one."""
