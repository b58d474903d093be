"""The simulated world: its files, its geometry, its robots. It knows nothing of languages and screens."""
