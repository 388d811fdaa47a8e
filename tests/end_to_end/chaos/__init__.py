"""Real programs on a network of the test's own, with seeded faults: what may fail, does; nothing may be lost by it."""
