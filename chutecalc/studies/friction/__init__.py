"""The paper's friction study."""
