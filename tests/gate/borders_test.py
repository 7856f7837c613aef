#!/usr/bin/env python3
"""The borders between the folders hold, and a crossing is found."""
import pathlib
import tempfile
import unittest

import borders

TOP = pathlib.Path(__file__).resolve().parents[2]


class Borders(unittest.TestCase):
    def test_nobody_includes_over_a_border(self):
        self.assertEqual(borders.crossings(TOP), [])

    def test_each_row_is_a_folder_or_a_file(self):
        self.assertEqual([row for row in borders.BORDERS if not (TOP / row).exists()], [])

    def test_a_crossing_is_found(self):
        with tempfile.TemporaryDirectory() as scratch:
            top = pathlib.Path(scratch)
            files = {"ipc/image/a.hpp": "", "ipc/model/files/b.hpp": "", "kernel/tick/c.hpp": '#include "ipc/image/a.hpp"\n',
                     "channels/fagor/d.hpp": '#include "channels/fanuc/e.hpp"\n', "channels/fanuc/e.hpp": "",
                     "ipc/image/f.hpp": '#include "ipc/model/files/b.hpp"\n',
                     "hmi/machine/g.hpp": '#include "hmi/widgets/h.hpp"\n', "hmi/widgets/h.hpp": '#include "hmi/machine/g.hpp"\n'}
            for name, text in files.items():
                (top / name).parent.mkdir(parents=True, exist_ok=True)
                (top / name).write_text(text, encoding="utf-8")
            self.assertEqual(borders.crossings(top), ["ipc/image/f.hpp includes ipc/model/files/b.hpp",
                                                      "channels/fagor/d.hpp includes channels/fanuc/e.hpp",
                                                      "hmi/machine/g.hpp includes hmi/widgets/h.hpp"])


if __name__ == "__main__":
    unittest.main()
