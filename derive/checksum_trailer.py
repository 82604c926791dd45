"""Appends a checksum to the content of a file, which shows that it is whole: not cut off, changed or foreign."""

from hashlib import sha256

MARK = b"flexel sha256 "  # starts the trailer; the digest of the content follows


def trailer_of(content: bytes) -> bytes:
    """Return the checksum trailer of a content."""
    return MARK + sha256(content).digest()


def has_trailer(data: bytes) -> bool:
    """Whether there is a trailer, valid or not."""
    end = _end(data)
    return end > 0 and data[end : end + len(MARK)] == MARK


def is_whole(data: bytes) -> bool:
    """Whether there is a trailer, and its checksum is that of the content."""
    end = _end(data)
    return has_trailer(data) and sha256(data[:end]).digest() == data[end + len(MARK) :]


def content_in(data: bytes) -> bytes:
    """Return the content in front of the trailer."""
    return data[: _end(data)]


def _end(data: bytes) -> int:
    """Return the length of the content in front of a trailer."""
    return len(data) - len(MARK) - sha256().digest_size
