"""The host wing: everything that reads or edits connectivity, in NumPy and SciPy only."""
