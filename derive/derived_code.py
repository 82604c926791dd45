"""Return C and specification of elements and laws: derived once, and kept in the user's cache by their definition.

The modules that derive are imported only where the cache has nothing: a program that uses a known element
starts without them.
"""

import logging
import pickle
import tempfile
import time
from pathlib import Path
from typing import cast

from flexel.derive.cache import (
    append_checksum,
    cache_directory,
    check_private,
    content_of,
    is_whole,
    writable_directory,
)
from flexel.derive.declare import Element, Law
from flexel.derive.definition_key import definition_key
from flexel.derive.shared_object import SYMBOL
from flexel.derive.spec import ElementSpec, LawSpec

log = logging.getLogger("flexel.compile")


def element_code(element: Element) -> tuple[str, ElementSpec]:
    """Return C and specification of an element; the table of its kernels is the global ``flexel_user``.

    Raises
    ------
    CacheError
        Others can write to the cache.
    """
    return cast(tuple[str, ElementSpec], _code(element))


def law_code(law: Law) -> tuple[str, LawSpec]:
    """Return C and specification of a law, as `element_code`."""
    return cast(tuple[str, LawSpec], _code(law))


def is_derived(declared: Element | Law) -> bool:
    """Whether the cache has the C of an element or a law."""
    return is_whole(cache_directory() / _file(declared))


def _file(declared: Element | Law) -> str:
    return f"{declared.name}-{definition_key(declared)}.derived"


def _code(declared: Element | Law) -> tuple[str, ElementSpec | LawSpec]:
    file = _file(declared)
    check_private(cache_directory())
    content = content_of(cache_directory() / file)
    if content is None:
        return _derived(declared, writable_directory() / file)
    log.info("the derivation of '%s' is in the cache: %s", declared.name, cache_directory() / file)
    found: tuple[str, ElementSpec | LawSpec] = pickle.loads(content)  # noqa: S301 (nobody else writes there)
    return found


def _derived(declared: Element | Law, kept: Path) -> tuple[str, ElementSpec | LawSpec]:
    from flexel.derive.emit.source import digest_of, element_source, laws_source
    from flexel.derive.emit.specification import element_spec, law_spec
    from flexel.derive.program.kernel_outputs import derive_element, derive_law

    begin = time.perf_counter()
    spec: ElementSpec | LawSpec
    if isinstance(declared, Element):
        derived = derive_element(declared)
        source = element_source(declared, derived, SYMBOL)
        spec = element_spec(declared, derived, digest_of(source))
    else:
        derived = derive_law(declared)
        source = laws_source([declared], [derived], SYMBOL)
        spec = law_spec(declared, derived, digest_of(source))
    with tempfile.TemporaryDirectory(dir=kept.parent) as folder:
        fresh = Path(folder) / kept.name
        fresh.write_bytes(pickle.dumps((source, spec)))
        append_checksum(fresh)
        fresh.replace(kept)  # atomic: another process may be doing the same
    log.info("'%s' derived in %.2f s", declared.name, time.perf_counter() - begin)
    return source, spec
