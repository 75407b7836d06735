"""``python -m msf_jax``: the command line."""

import sys

from msf_jax.app.cli import main

if __name__ == "__main__":
    sys.exit(main())
