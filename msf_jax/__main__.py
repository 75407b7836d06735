"""``python -m msf_jax``: the command line."""

from msf_jax.app.cli import command

if __name__ == "__main__":
    command()
