"""What a program uses: a chute, its solution, its ends, and itself as a function."""
