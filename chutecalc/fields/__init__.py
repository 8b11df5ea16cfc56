"""Numbers with a unit and bounds, the tables of a spec that hold them, and their faults."""
