"""What fills the terminal: the main screen, the help, and the dialogs in front of them."""
