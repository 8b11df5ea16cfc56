"""Folders for temporary files. None outlives its command, not even one that is interrupted.

But on Windows a file that is still open then stays in the folder of the system.
"""

_FOLDERS: set[str] = set()
"""All that are there."""


def scratch_folder() -> str:
    """Return a new folder, which is there until :func:`remove_scratch`.

    Raises:
        OSError: there is no room for one.
    """
    from tempfile import mkdtemp  # not before: --help loads this module

    folder = mkdtemp(prefix="chutecalc-")
    _FOLDERS.add(folder)
    return folder


def remove_scratch() -> None:
    """Remove all folders for temporary files, with what is in them."""
    for folder in list(_FOLDERS):
        from shutil import rmtree  # which tempfile has loaded

        rmtree(folder, ignore_errors=True)
        _FOLDERS.discard(folder)
