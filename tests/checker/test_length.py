# SPDX-License-Identifier: MIT
"""How much of the checker there is to read: the table in docs/certificate.md is what length.py counts, and, with --long, no proof comes by a
function that is not counted for its kind of claim."""
import argparse
import pathlib
import subprocess
import sys
import tempfile
import unittest

parser = argparse.ArgumentParser()
parser.add_argument("--checker", required=True, type=pathlib.Path)
parser.add_argument("--program", help="that writes certificates")
parser.add_argument("--long", action="store_true", help="prove one of each kind, and look at what the proofs come by")
known, rest = parser.parse_known_args()
sys.path.insert(0, str(known.checker))
import certificate  # noqa: E402
import check  # noqa: E402
import length  # noqa: E402

MOST_LINES = 1000
LONGER = {"density": 1260, "limit_density": 1290}  # kinds of a few rows that need more, and how much more they may grow to
EACH_KIND = {
    "transfer": ("contact.area n=2 load=1/10 G=3 --digits 6", "limit.area_constant G=3 --digits 6",
                 "limit.scale load=1/10 tolerance=1/100 G=3"),
    "distributions": ("contact.density n=2 p=1/2 load=1/10 G=3 --digits 4", "contact.exceedance n=2 p=1/2 load=1/10 G=3 --digits 4",
                      "segments.density n=2 a=1/10 load=1/10 G=3 --digits 4"),
    "full_contact": ("contact.area n=2 load=1/10 G=3/2 --digits 3", "contact.exceedance n=2 p=1 load=1/10 G=3/2 --digits 3"),
    "limits": ("limit.exceedance p=1/2 G=3 --digits 3", "limit.force p=1/2 G=3 --digits 3", "limit.density p=1/2 G=3 --digits 3",
               "limit.segments a=1/10 G=3 --digits 3", "limit.distance n=1 p=1/10 load=1/100 G=10 --digits 3"),
    "poisson": ("limit.area_constant G=3/2 --digits 2", "limit.exceedance p=1/2 G=2 --digits 1", "limit.force p=1/2 G=2 --digits 1",
                "limit.segments a=1/10 G=2 --digits 1"),
    "second_eigenvalue": ("limit.gap G=10 --digits 4", ),
    "density": ("contact.density n=2 p=1 load=1/10 G=3/2 --digits 2", "contact.density n=3 p=1 load=2 G=3/2 --digits 1"),
    "limit_density": ("limit.density p=1/2 G=2 --digits 1", ),
}
ROWS_OF_A_TABLE = 3


def came_by(proof):
    """what is called of checker/ meanwhile"""
    calls, owner = set(), length.owners()

    def called(frame, event, _):
        if event == "call":
            calls.add((frame.f_code.co_filename, frame.f_code.co_firstlineno))
    sys.setprofile(called)
    try:
        proof()
    finally:
        sys.setprofile(None)
    places = {(pathlib.Path(file).resolve(), line) for file, line in calls}
    return {owner[place] for place in places & {*owner}}


class Length(unittest.TestCase):
    def test_no_kind_is_longer_than_it_says(self):
        kinds, code = length.needed()
        self.assertEqual({*kinds}, {*length.TITLES})
        for kind, parts in kinds.items():
            with self.subTest(kind):
                count = sum(code[part] for part in parts)
                self.assertTrue(500 < count <= LONGER.get(kind, MOST_LINES), count)

    def test_the_page_has_what_is_counted(self):
        page = (length.ROOT / "docs" / "certificate.md").read_text()
        self.assertIn(f"Files of rows take {length.of_rows()} lines more", page)
        self.assertIn(length.page(), page, "tests/checker/length.py prints another table")

    @unittest.skipUnless(known.long, "of the campaign")
    def test_proofs_come_by_no_more(self):
        kinds, _ = length.needed()
        self.assertEqual({*EACH_KIND}, {*kinds} - {"closed_forms"})
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder) / "certificate"
            for kind, claim in ((kind, claim) for kind, claims in EACH_KIND.items() for claim in claims):
                with self.subTest(kind, claim=claim):
                    subprocess.run([known.program, "certificate", *claim.split(), "--out", path], check=True)

                    def proof():
                        made = certificate.Certificate(path)
                        certificate.Replay(made, 1, made.count)
                    parts = came_by(proof)
                    self.assertGreater(len(parts), 30)
                    self.assertEqual(parts - kinds[kind], set())
                    path.unlink()

    @unittest.skipUnless(known.long, "of the campaign")
    def test_closed_forms_come_by_no_more(self):
        kinds, _ = length.needed()
        for path in sorted(length.TABLES.glob("*.txt")):
            if path.stem in length.CONFIRMED_BY:
                continue
            header, rows = check.read(path)
            form = check.scale_one.FORMS[header["quantity"]]
            with self.subTest(path.stem):
                parts = came_by(lambda: [check.verdict(form, row, header["inputs"]) for row in rows[:ROWS_OF_A_TABLE]])  # noqa: B023
                self.assertEqual(parts - kinds["closed_forms"], set())


if __name__ == "__main__":
    unittest.main(argv=[sys.argv[0], *rest])
