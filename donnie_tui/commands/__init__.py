"""Everything that a learner can ask a front end for: each command is declared once and handled once."""
