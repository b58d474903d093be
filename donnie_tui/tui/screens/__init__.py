"""What fills the terminal: the workplace, the help, and the questions in front of them."""
