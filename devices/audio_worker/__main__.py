"""Starts the child's side: ``python -m devices.audio_worker DEVICE VOICE PARENT``, by ``process`` only."""

from devices.audio_worker.worker import main

if __name__ == "__main__":
    main()
