// Compiles the precompiled header of the tests, and holds nothing itself.
