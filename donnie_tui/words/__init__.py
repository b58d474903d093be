"""What a typed word does to robots, teams and sound, and how it is answered: in both front ends alike."""
