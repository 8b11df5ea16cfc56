"""Where independent tasks run: in threads of this process, or on the workers of a Dask scheduler."""

from collections.abc import Callable, Iterator
from concurrent.futures import Executor, ThreadPoolExecutor
from contextlib import contextmanager
from importlib import import_module
from typing import Any, NamedTuple, Protocol

from chutecalc.errors import UsageError
from chutecalc.extras import DASK, require_extra
from chutecalc.runtime import cores

CONNECT_TIMEOUT = 5.0
"""Time after which a scheduler counts as not there, s."""


class Workers(NamedTuple):
    """What runs tasks."""

    executor: Executor
    """Takes tasks, as of :mod:`concurrent.futures`."""
    shared: Callable[[Any], Any]
    """Returns an argument that many tasks have, as they take it: it goes to each worker once."""


class Pool(Protocol):
    """Where tasks run."""

    @property
    def at_once(self) -> int:
        """How many tasks run at once."""

    def workers(self) -> Any:
        """Return a context that gives :class:`Workers`, and gives up the tasks that have not begun when it ends."""


class Threads:
    """Threads of this process.

    >>> with Threads(2).workers() as workers:
    ...     workers.executor.submit(pow, 2, 5).result()
    32
    """

    def __init__(self, jobs: int | None = None) -> None:
        """Take how many there are to be.

        Args:
            jobs: number of threads; one for each core by default.
        """
        self.at_once = jobs or cores()

    @contextmanager
    def workers(self) -> Iterator[Workers]:
        """Yield the threads."""
        with ThreadPoolExecutor(self.at_once) as executor:
            try:
                yield Workers(executor, lambda item: item)
            finally:
                executor.shutdown(wait=False, cancel_futures=True)


class Dask:
    """The workers of a Dask scheduler. A task whose worker is lost runs again on another one."""

    def __init__(self, address: str) -> None:
        """Connect to a scheduler, whose workers need the same version of chutecalc.

        Args:
            address: of the scheduler, such as ``tcp://10.0.0.1:8786``.

        Raises:
            ExtraMissingError: Dask is not installed.
            UsageError: there is no scheduler, it has no workers, or they have another chutecalc.
        """
        require_extra("--dask", DASK)
        client: Any = import_module("distributed").Client
        try:
            self.client: Any = client(address, timeout=CONNECT_TIMEOUT, set_as_default=False)
        except (OSError, ValueError, TypeError) as error:
            raise UsageError(
                f"--dask {address}: there is no Dask scheduler ({error}). Start one with dask scheduler, and workers"
                " with dask worker ADDRESS."
            ) from None
        try:
            found = self.client.run(_version)
        except Exception as error:  # whatever a worker's Python raises
            raise UsageError(f"--dask {address}: its workers cannot import chutecalc: {error}") from None
        if not found:
            raise UsageError(f"--dask {address}: the scheduler has no workers. Start some: dask worker {address}")
        others = {version for version in found.values() if version != _version()}
        if others:
            raise UsageError(
                f"--dask {address}: workers have chutecalc {', '.join(sorted(others))}, and this is {_version()}."
                " Install the same version everywhere."
            )

    @property
    def at_once(self) -> int:
        """How many tasks run at once on the workers that there are now; those that come later take tasks too."""
        return sum(self.client.nthreads().values())

    @contextmanager
    def workers(self) -> Iterator[Workers]:
        """Yield the workers."""
        executor = self.client.get_executor(pure=False)
        try:
            yield Workers(executor, self._shared)
        finally:
            executor.shutdown(wait=False)

    def close(self) -> None:
        """Disconnect from the scheduler; a command does so at its end."""
        self.client.close()

    def _shared(self, item: Any) -> Any:
        """Return an item as the result of a task, which workers take from each other, and make again if it is lost."""
        return self.client.submit(_same, item, pure=False)


def pool_of(jobs: int | None, dask: str | None) -> Pool:
    """Return where tasks run.

    Args:
        jobs: number of threads; one for each core by default.
        dask: address of a Dask scheduler, instead of threads.

    Raises:
        UsageError: both are given, or there is no such scheduler.
        ExtraMissingError: Dask is not installed.
    """
    if dask is None:
        return Threads(jobs)
    if jobs is not None:
        raise UsageError("--jobs are threads of this process, and --dask has workers of its own: give one of them")
    return Dask(dask)


def _same(item: Any) -> Any:
    """Return what is given."""
    return item


def _version() -> str:
    """Return the version of chutecalc in the process that is asked."""
    import chutecalc

    return chutecalc.__version__
