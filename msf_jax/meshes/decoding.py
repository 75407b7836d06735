"""The text of files of other programs: one decoder and one splitting into lines for all text formats."""

import codecs

MARKS = {  # encoding of each byte-order mark; UTF-32's begins as UTF-16's, so it is first
    codecs.BOM_UTF8: "utf-8",
    codecs.BOM_UTF32_LE: "utf-32-le",
    codecs.BOM_UTF32_BE: "utf-32-be",
    codecs.BOM_UTF16_LE: "utf-16-le",
    codecs.BOM_UTF16_BE: "utf-16-be",
}


def decoded(content: bytes) -> str:
    """The text in ``content``: as its byte-order mark says, else UTF-8, else Latin-1.

    Raises:
        ValueError: it is no text; the message says what it has.
    """
    for mark, encoding in MARKS.items():
        if content.startswith(mark):
            return content[len(mark) :].decode(encoding)
    if b"\0" in content:
        raise ValueError("it is no text, or UTF-16 without a byte-order mark: save it as UTF-8")
    try:
        return content.decode()
    except UnicodeDecodeError:
        return content.decode("latin-1")  # only comments and names can differ: numbers are ASCII


def has_mark(content: bytes) -> bool:
    """Whether ``content`` begins with a byte-order mark."""
    return content.startswith(tuple(MARKS))


def lines_of(text: str) -> list[str]:
    """The lines of ``text``. `str.splitlines` would also split at characters that may be in a comment or a name."""
    return text.replace("\r\n", "\n").replace("\r", "\n").split("\n")
