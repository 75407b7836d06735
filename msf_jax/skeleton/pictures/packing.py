"""A plotly figure as one small page that needs no network: plotly and the data are compressed, and the browser unpacks.

Each array is stored once, as bytes. A JSON header before them has their offsets. A form replaces the sliders and the
menu of the figure, because it fits on a phone.
"""

import base64
import gzip
import html
import json
from importlib import resources
from typing import TYPE_CHECKING, Any

import numpy as np

if TYPE_CHECKING:
    from plotly.graph_objects import Figure

ALIGNED = 8  # bytes: arrays begin at multiples of this, because JavaScript's typed arrays must be aligned
NOT_SHOWN = ("sliders", "updatemenus", "title", "template")  # parts of the layout that the page replaces


def page_of(figure: "Figure", title: str, subtitle: str) -> str:
    """The HTML of the page. ``layout.meta`` of the figure has the camera's distance, see `page`."""
    from plotly.offline import get_plotlyjs

    layout = figure.layout.to_plotly_json()
    controls = {"sliders": layout.get("sliders", []), "menus": layout.get("updatemenus", [])}
    shown = {key: value for key, value in layout.items() if key not in NOT_SHOWN}
    layout = {**shown, "margin": {"l": 0, "r": 0, "t": 0, "b": 0}}
    data = {"data": [trace.to_plotly_json() for trace in figure.data], "layout": layout, "controls": controls}
    fields = {"title": title, "subtitle": subtitle}
    fields |= {"plotly": _packed(get_plotlyjs().encode()), "data": _packed(_blob(data | {"name": title}))}
    text = resources.files("msf_jax.skeleton.pictures").joinpath("page.html").read_text("utf-8")
    for name, value in fields.items():
        text = text.replace(f"@{name}@", html.escape(value))
    return text


def _packed(content: bytes) -> str:
    return base64.b64encode(gzip.compress(content, 9, mtime=0)).decode()


def _blob(content: Any) -> bytes:
    """The length of the header in four bytes, the header, and the arrays."""
    place: dict[tuple[str, bytes], int] = {}
    size = 0

    def without_arrays(value: Any) -> Any:
        nonlocal size
        if isinstance(value, dict):
            return {key: without_arrays(part) for key, part in value.items()}
        if isinstance(value, np.ndarray) and value.dtype.kind in "iuf":
            small = np.ascontiguousarray(_narrow(value))
            key = (small.dtype.str, small.tobytes())
            if key not in place:
                place[key] = size
                size += -(-len(key[1]) // ALIGNED) * ALIGNED
            return {"array": small.dtype.name, "at": place[key], "num": small.size}
        if isinstance(value, list | tuple | np.ndarray):
            return [without_arrays(part) for part in value]
        return value.item() if isinstance(value, np.generic) else value

    header = json.dumps(without_arrays(content), allow_nan=False).encode()
    header += b" " * (-(len(header) + 4) % ALIGNED)
    parts = [data + bytes(-len(data) % ALIGNED) for _, data in place]
    return len(header).to_bytes(4, "little") + header + b"".join(parts)


def _narrow(values: np.ndarray) -> np.ndarray:
    """Integers in two or four bytes (JavaScript has no plain array of eight), real numbers in little-endian order."""
    if values.dtype.kind == "f":
        return values.astype(values.dtype.newbyteorder("<"))
    largest = int(values.max(initial=0))
    return values.astype("<u2" if largest < 2**16 else "<u4")
