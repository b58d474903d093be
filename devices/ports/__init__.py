"""The borders of the house: protocols and values, standard library only."""
