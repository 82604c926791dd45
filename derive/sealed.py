"""A seal behind the content of a file shows that it is whole: neither cut off, nor changed, nor foreign."""

from hashlib import sha256

SEAL = b"flexel sha256 "  # behind the content, then the digest of the content


def seal_of(content: bytes) -> bytes:
    """The seal of a content."""
    return SEAL + sha256(content).digest()


def has_seal(data: bytes) -> bool:
    """Whether there is a seal, broken or not."""
    end = _end(data)
    return end > 0 and data[end : end + len(SEAL)] == SEAL


def is_whole(data: bytes) -> bool:
    """Whether there is a seal, and it is that of the content."""
    end = _end(data)
    return has_seal(data) and sha256(data[:end]).digest() == data[end + len(SEAL) :]


def _end(data: bytes) -> int:
    """Where the content of sealed data ends."""
    return len(data) - len(SEAL) - sha256().digest_size
