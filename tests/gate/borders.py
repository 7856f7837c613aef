"""Who may include whom: the borders between the folders, as docs/design/README.md draws them.

A file belongs to the longest row whose folder holds it. It may include its own row's folders, and those that the row
names; of what it names, a longer row that is not named itself is left out ("ipc" allows nothing of "ipc/model").
"""
import pathlib
import re

LANGUAGES = ("channels/fanuc", "channels/sinumerik", "channels/fagor")
FANUC_FAMILY = ("channels/fanuc", "channels/nct", "channels/mefi")
# what the interpreters' languages are made of: no language, no process, no check among it
ENGINE = ("channels", "channels/engine", "channels/text", "channels/state", "channels/pipeline", "channels/corners",
          "channels/compensation", "channels/cycles")
MODEL = ("ipc", "ipc/model")

BORDERS = {
    "ipc": ("ipc",),
    "ipc/model": MODEL,
    # the cyclic process: no channel, no store, no screen; its motion and its board of waits know nothing of a machine
    "kernel": (*MODEL, "kernel", "kernel/motion", "kernel/waits/waits.hpp"),
    "kernel/motion": ("ipc", "kernel/motion"),
    "kernel/waits/waits.hpp": MODEL,
    "kernel/waits/waits.cpp": (*MODEL, "kernel/waits/waits.hpp"),
    "kernel/supervisor": (*MODEL, "kernel/supervisor", "kernel/waits/waits.hpp"),
    "toolmgmt": (*MODEL, "toolmgmt"),
    # a language knows what all are made of, and no other one; fanuc, nct and mefi are one family with one table of codes
    "channels": (*MODEL, *ENGINE, "channels/check", "channels/process", "channels/hold", "channels/records", "channels/path",
                 *LANGUAGES, "channels/nct", "channels/mefi"),
    **{f"channels/{folder}": (*MODEL, *ENGINE) for folder in ("engine", "state", "pipeline", "corners", "compensation", "cycles")},
    "channels/text": (*MODEL, "channels/text"),
    "channels/path": (*MODEL, "channels/path"),
    **{f"channels/{folder}": (*MODEL, *ENGINE, "channels/check", "channels/process", "channels/hold", "channels/records",
                              "channels/path") for folder in ("check", "process", "hold", "records")},
    **{language: (*MODEL, *ENGINE, language) for language in LANGUAGES},
    **{relative: (*MODEL, *ENGINE, *FANUC_FAMILY) for relative in FANUC_FAMILY},
    # the model of the screens knows no widget, a widget no screen, a screen not the window that shows it
    "hmi": (*MODEL, "hmi"),
    "hmi/text": (*MODEL, "hmi/text"),
    "hmi/contour": (*MODEL, "hmi/contour"),
    "hmi/machine": (*MODEL, "hmi/machine", "hmi/text", "hmi/contour"),
    "hmi/widgets": (*MODEL, "hmi/widgets", "hmi/machine", "hmi/text", "hmi/contour"),
    "hmi/screens": (*MODEL, "hmi/screens", "hmi/widgets", "hmi/machine", "hmi/text", "hmi/contour"),
    "hmi/app": (*MODEL, "hmi", "hmi/app", "hmi/screens", "hmi/widgets", "hmi/machine", "hmi/text", "hmi/contour"),
}
INCLUDE = re.compile(r'^\s*#include "([^"]+)"', re.MULTILINE)


def row_of(path):
    """The longest row that holds this file: 'kernel/waits/waits.hpp' -> 'kernel'."""
    holders = [row for row in BORDERS if path == row or path.startswith(row + "/")]
    return max(holders, key=len, default=None)


def allowed(path, included):
    """May this file include that one (both from the top folder)?"""
    row = row_of(path)
    if row is None:
        return True
    target = row_of(included)
    return any(included == name or (included.startswith(name + "/") and target in (name, None)) or target == name for name in BORDERS[row])


def crossings(top):
    """'file includes file' for each include over a border that has no gate there."""
    top = pathlib.Path(top)
    found = []
    for folder in ("ipc", "kernel", "channels", "toolmgmt", "hmi"):
        for path in sorted((top / folder).rglob("*")):
            if path.suffix not in (".hpp", ".cpp", ".h"):
                continue
            name = path.relative_to(top).as_posix()
            for included in INCLUDE.findall(path.read_text(encoding="utf-8")):
                if (top / included).is_file() and not allowed(name, included):
                    found.append(f"{name} includes {included}")
    return found
