"""What a learner has chosen, what is remembered from one start to the next, and where that lies."""
