"""A plotly figure as one page that needs no network, small: plotly and the data are compressed, the browser unpacks.

Arrays are kept as bytes, each once, behind a header in JSON that says where. What the sliders and the menu of the
figure do is done by a form, which fits on a phone.
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

ALIGNED = 8  # bytes: typed arrays begin at multiples of their items' size
NOT_SHOWN = ("sliders", "updatemenus", "title", "template")  # of the layout: the page has its own


def page_of(figure: "Figure", title: str, subtitle: str) -> str:
    """The page. ``layout.meta`` of the figure says how far to be away, for all of it to be in view: see `page`."""
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
    """The length of a header in four bytes, the header, and the arrays that it speaks of."""
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
    """Whole numbers in as few bytes as hold them, but none in eight, which JavaScript has no plain array for."""
    if values.dtype.kind == "f":
        return values.astype(values.dtype.newbyteorder("<"))
    largest = int(values.max(initial=0))
    return values.astype("<u2" if largest < 2**16 else "<u4")
