# This file is part of OpenCV project.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://opencv.org/license.html.
"""One run at a time for each output."""
import os
from contextlib import contextmanager
from typing import Any, Iterator

fcntl: Any
try:
    import fcntl
except ImportError:  # Windows, where nothing is refused
    fcntl = None


@contextmanager
def alone(output: str, store: str) -> Iterator[None]:
    """Refuses to go on while another run has the store of this output, which two would spoil. The system lets go of the
    lock of a process that dies."""
    os.makedirs(os.path.dirname(store), exist_ok=True)
    if fcntl is None:
        yield
        return
    name = store + ".lock"
    file = _take(name)
    if file < 0:
        raise ValueError("output must not be what another run writes, as %s is: wait for it, or stop it" % output)
    try:
        yield
    finally:
        os.remove(name)  # before others can have the lock: they see that the file is another one
        os.close(file)


def _take(name: str) -> int:
    """The open file with the lock; -1 if another run has it."""
    while True:
        file = os.open(name, os.O_RDWR | os.O_CREAT, 0o666)
        try:
            fcntl.flock(file, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except BlockingIOError:
            os.close(file)
            return -1
        except OSError:  # a file system without locks
            return file
        if _is(file, name):
            return file
        os.close(file)


def _is(file: int, name: str) -> bool:
    """Whether the open file still has this name: the run that had the lock removes it."""
    try:
        return os.path.samestat(os.fstat(file), os.stat(name))
    except FileNotFoundError:
        return False
