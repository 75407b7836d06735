"""Everything that reads or edits connectivity, in NumPy and SciPy only."""
