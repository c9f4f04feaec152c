"""Settings of the process."""

from __future__ import annotations

import os

from calyx import _calyx


def configure(*, threads: int = 0, cache: str | os.PathLike[str] | None = None) -> None:
    """Sets the resources of later runs in this process.

    `threads` is the number of threads that runs share; 0 is one per core. The results do not depend
    on it.

    `cache` is the directory of the structure cache, in which static condensations of gear bodies
    are stored for other processes and later runs; "off" disables it. None is the cache of the
    command `calyx`: the directory in the environment variable CALYX_CACHE, or one in the user's
    cache directory. Cached files are trusted.
    """
    if threads < 0:
        raise ValueError(f"threads is {threads}: give a positive number, or 0 for one per core")
    _calyx.configure(threads, None if cache is None else os.fspath(cache))
