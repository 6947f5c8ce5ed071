"""How fast the parts are: each figure with what it is compared to and the machine's noise."""
