"""The Python module as its users meet it. Run with the module's folder in PYTHONPATH."""
import doctest
import os
import re
import tempfile
import threading
import unittest
from pathlib import Path

import numpy as np
import tagmint

ROOT = Path(__file__).resolve().parents[2]


def picture_of(family, tag_id, scale=10, margin=50):
    cells = np.kron(family.cells(tag_id), np.ones((scale, scale), np.uint8))
    return np.pad(cells, margin, constant_values=255)


class Families(unittest.TestCase):
    def test_version_is_that_of_the_project(self):
        wanted = re.search(r"project\(tagmint VERSION ([0-9.]+)", (ROOT / "CMakeLists.txt").read_text())
        self.assertEqual(tagmint.__version__, wanted.group(1))

    def test_a_family_says_what_it_is(self):
        family = tagmint.family("tag36h11")
        self.assertIn("tag36h11", tagmint.family_names())
        self.assertEqual((len(family), family.bits, family.min_hamming, family.max_safe_errors), (587, 36, 11, 5))
        self.assertEqual((family.layout, family.width, family.width_at_border), ("classic:10", 10, 8))
        with self.assertRaisesRegex(IndexError, "587"):
            family.codeword(587)

    def test_codewords_are_looked_at_not_copied(self):
        family = tagmint.family("tag25h9")
        words = family.codewords()
        self.assertEqual(words.dtype, np.uint64)
        self.assertFalse(words.flags.owndata)
        self.assertFalse(words.flags.writeable)
        self.assertEqual(words.__array_interface__["data"], family.codewords().__array_interface__["data"])
        self.assertEqual([int(word) for word in words], [family.codeword(i) for i in range(len(family))])
        del family
        self.assertEqual(len(words), 35)

    def test_families_are_saved_and_read(self):
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "my.json")
            made = tagmint.generate("classic:8", 5, order="seed:7", complexity="rectangles:5", name="mine")
            made.save(path)
            again = tagmint.family(path)
            self.assertEqual((again.name, len(again)), ("mine", 30))  # as docs/api.md shows
            np.testing.assert_array_equal(again.codewords(), made.codewords())
            self.assertGreaterEqual(len(again.check()), 4)
        with self.assertRaisesRegex(tagmint.InputError, "did you mean 'tag36h11'"):
            tagmint.family("tag36h1")

    @unittest.skipUnless(os.environ.get("TAGMINT_SLOW_TESTS"), "takes a minute")
    def test_rotation_codes_are_generated(self):
        family = tagmint.generate_rotation_code("classic:8", 8)
        self.assertGreaterEqual(family.min_hamming, 8)
        family.check()

    def test_a_search_that_finds_nothing_says_so(self):
        with self.assertRaisesRegex(ValueError, "no code"):
            tagmint.generate_rotation_code("classic:7", 5)


class Decoding(unittest.TestCase):
    def test_errors_are_corrected(self):
        family = tagmint.family("tag36h11")
        match = tagmint.Decoder(family, max_errors=5).decode(family.codeword(40) ^ 0b10101)
        self.assertEqual((match.id, match.hamming, match.rotation), (40, 3, 0))
        self.assertIsNone(tagmint.Decoder(family).decode(family.codeword(40) ^ 0b10101))
        with self.assertRaises(ValueError):
            tagmint.Decoder(family, max_errors=6)
        with self.assertRaises(ValueError):
            tagmint.Decoder(family).decode(1 << 36)


class Detection(unittest.TestCase):
    def setUp(self):
        self.family = tagmint.family("tag36h11")
        self.image = picture_of(self.family, 7)
        self.detector = tagmint.Detector([self.family])

    def test_a_tag_is_found_where_it_was_drawn(self):
        (tag,) = self.detector.detect(self.image)
        self.assertEqual((tag.family, tag.id, tag.hamming), ("tag36h11", 7, 0))
        np.testing.assert_allclose(tag.center, [100, 100], atol=0.1)
        np.testing.assert_allclose(tag.corners, [[60, 140], [140, 140], [140, 60], [60, 60]], atol=0.1)
        corner = tag.homography @ [-1, -1, 1]
        np.testing.assert_allclose(corner[:2] / corner[2], tag.corners[3], atol=1e-6)

    def test_arrays_look_into_the_detection(self):
        (tag,) = self.detector.detect(self.image)
        corners = tag.corners
        self.assertFalse(corners.flags.owndata or corners.flags.writeable)
        del tag
        self.assertEqual(corners.shape, (4, 2))

    def test_any_strides_and_colours(self):
        wide = np.full((200, 300), 255, np.uint8)
        wide[:, 40:240] = self.image
        upside = np.ascontiguousarray(self.image[::-1])[::-1]  # negative stride
        colour = np.repeat(self.image[:, :, None], 3, axis=2)
        every_second = np.repeat(self.image, 2, axis=1)[:, ::2]
        for image in (wide[:, 40:240], upside, colour, every_second):
            (tag,) = self.detector.detect(image)
            np.testing.assert_allclose(tag.center, [100, 100], atol=0.1)

    def test_what_is_no_image_is_refused(self):
        for wrong in (self.image.astype(float), self.image[0], np.zeros((9, 9, 4), np.uint8)):
            with self.assertRaises(ValueError):
                self.detector.detect(wrong)
        self.assertEqual(self.detector.detect(np.zeros((0, 0), np.uint8)), [])
        with self.assertRaises(ValueError):
            tagmint.Detector([])

    def test_detectors_work_side_by_side(self):
        found = [None] * 4

        def work(i):
            detector = tagmint.Detector([tagmint.Decoder(self.family)])
            found[i] = [detector.detect(picture_of(self.family, i))[0].id for _ in range(20)]

        threads = [threading.Thread(target=work, args=(i,)) for i in range(4)]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        self.assertEqual(found, [[i] * 20 for i in range(4)])

    def test_the_interpreter_runs_while_a_picture_is_searched(self):
        """The lock is free during detect(): another thread counts on meanwhile."""
        large = np.tile(self.image, (20, 20))
        steps, done = [0], threading.Event()

        def search():
            self.detector.detect(large)
            done.set()

        thread = threading.Thread(target=search)
        import sys
        interval = sys.getswitchinterval()
        sys.setswitchinterval(1000)  # nobody gives the lock away but who releases it
        try:
            thread.start()
            while not done.is_set():
                steps[0] += 1
                done.wait(0.0001)
        finally:
            sys.setswitchinterval(interval)
        thread.join()
        self.assertGreater(steps[0], 1)


class Poses(unittest.TestCase):
    def test_a_frontal_tag_is_where_it_is(self):
        camera = tagmint.Camera(400, 400, 100, 100)
        corners = [[60, 140], [140, 140], [140, 60], [60, 60]]
        estimate = tagmint.estimate_pose(corners, camera, 0.1)
        np.testing.assert_allclose(estimate.best.t, [0, 0, 0.5], atol=1e-6)
        np.testing.assert_allclose(estimate.best.R, np.eye(3), atol=1e-6)
        family = tagmint.family("tag36h11")
        (tag,) = tagmint.Detector([family]).detect(picture_of(family, 7))
        of_tag = tagmint.estimate_pose(tag, camera, 0.1)
        np.testing.assert_allclose(of_tag.best.t, [0, 0, 0.5], atol=2e-3)
        with self.assertRaises(ValueError):
            tagmint.Camera(0, 400, 100, 100)
        with self.assertRaises(ValueError):
            tagmint.estimate_pose([[1, 2]], camera, 0.1)


class Sheets(unittest.TestCase):
    def test_sheets_have_their_size_and_pages(self):
        family = tagmint.family("tag36h11")
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "tags.svg")
            self.assertEqual(tagmint.sheet(family, path, edge_mm=40, ids=[0, 1, 2]), 1)
            self.assertRegex(Path(path).read_text(), r'width="210mm" height="297mm"')
            pages = tagmint.sheet(family, os.path.join(folder, "tags.pdf"), edge_mm=40, ids=range(40))
            self.assertGreater(pages, 1)
            with self.assertRaisesRegex(ValueError, "pages"):
                tagmint.sheet(family, path, edge_mm=40, ids=range(40))
            with self.assertRaises(tagmint.DoesNotFit):
                tagmint.sheet(family, path, edge_mm=400, ids=[0])
            with self.assertRaises(tagmint.OutputError):
                tagmint.sheet(family, os.path.join(folder, "none", "tags.pdf"), edge_mm=40)
            self.assertEqual(sorted(os.listdir(folder)), ["tags.pdf", "tags.svg"])


def load_tests(_loader, tests, _pattern):
    tests.addTests(doctest.DocTestSuite(tagmint))
    return tests


if __name__ == "__main__":
    unittest.main()
