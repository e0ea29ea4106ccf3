"""Each leaf of the tree file has its function, with its keys; so have operators and attributes."""
import inspect
import json
import os
import re
import tempfile
import unittest
import warnings
from fractions import Fraction
from pathlib import Path

import cnrg

PAGE = (Path(os.environ["CNRG_SOURCES"]) / "csg" / "FORMATS.md").read_text()


def bytes_of(node):
    """The exact `.json` of a node."""
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "result.json"
        node.evaluate().write(path)
        return path.read_bytes()


def keys_of_leaves():
    """Of each leaf its keys, as the tables of the page have them."""
    leaves = PAGE[PAGE.index("\n## Leaves") : PAGE.index("\n## Materials")]
    keys, leaf = {}, None
    for line in leaves.splitlines():
        cells = [cell.strip() for cell in line.strip("|").split("|")]
        if len(cells) < 4 or cells[0].startswith("---"):
            continue
        if cells[0] == "leaf":
            leaf = ""
        elif cells[0] in ("part", "fill", "key", "file"):
            leaf = None
        elif leaf is not None:
            leaf = cells[0].strip("`") or leaf
            keys.setdefault(leaf, set()).update(re.findall(r"`(\w+)`", cells[1]))
    return keys


class Leaves(unittest.TestCase):
    def test_each_leaf_has_a_function_with_its_keys(self):
        found = keys_of_leaves()
        self.assertGreater(len(found), 20)
        for leaf, keys in found.items():
            with self.subTest(leaf=leaf):
                if leaf in ("step", "brep", "cnrg"):  # files, by `load`
                    continue
                has = {name.rstrip("_") for name in inspect.signature(getattr(cnrg, leaf)).parameters}
                if leaf == "mesh":
                    keys -= {"file", "coordinates"}  # by `load`
                self.assertLessEqual(keys, has)

    def test_load_takes_the_keys_of_files(self):
        keys = keys_of_leaves()
        wanted = (keys["step"] | keys["brep"] | keys["mesh"]) - {"file", "points", "faces"}
        source = inspect.getsource(cnrg.load)
        for key in wanted:
            self.assertIn(f'"{key}"', source)

    def test_each_operator_and_attribute_is_there(self):
        operators = PAGE[PAGE.index("\n### Operators") : PAGE.index("\n### Attributes")]
        table = [line for line in operators[: operators.index("| part")].splitlines() if line.startswith("| `")]
        names = {name for line in table for name in re.findall(r"`(\w+)`", line.split("|")[1])}
        self.assertGreater(len(names), 10)
        for name in names - {"repeat", "csg"}:  # Python has loops; files are by `load`
            self.assertTrue(hasattr(cnrg, name) or hasattr(cnrg.Node, name), name)
        attributes = PAGE[PAGE.index("\n### Attributes") : PAGE.index("\n## Leaves")]
        for line in attributes.splitlines():
            if line.startswith("| `") and not line.startswith("| `within`"):  # of `below` and `above`
                name = line.split("|")[1].strip(" `")
                box = cnrg.box([0, 0, 0], [1, 1, 1])
                node = box.boundary() if name == "each" else box | box.translate([1, 0, 0]) if name == "blend" else box
                value = {
                    "material": "rock", "name": "a", "dominance": 1, "regularize": True, "simplify": "points", "each": True,
                    "translate": [1, 0, 0], "rotate": {"axis": [0, 0, 1], "degrees": 90}, "scale": 2,
                    "mirror": {"normal": [1, 0, 0]}, "matrix": [[1, 0, 0, 5], [0, 1, 0, 0], [0, 0, 1, 0]],
                    "attributes": {"diameter": 25, "section": "round"}, "blend": "linear",
                    "size": "1/4",
                }[name]
                self.assertIn(f"{name}: ", node.with_(**{name: value}).to_yaml())

    def test_numbers_and_texts_of_attributes_stay_what_they_are(self):
        said = {"a": 25, "b": 0.1, "c": Fraction(1, 3), "d": "25", "e": "1/3 of it", "f g": "true"}
        bolt = cnrg.polyline([[0, 0, 0], [0, 0, 1]], attributes=said, name="bolt", material="steel")
        text = bolt.to_yaml()
        again = cnrg.parse(text).result
        self.assertEqual(again.to_yaml(), text)
        properties = json.loads(bytes_of(again))["attributes"][0]["properties"]
        self.assertEqual(properties["a"], {"number": "25"})
        self.assertEqual(properties["b"], {"number": str(Fraction(0.1))})
        self.assertEqual(properties["c"], {"number": "1/3"})
        self.assertEqual([properties[key] for key in ("d", "e", "f g")], ["25", "1/3 of it", "true"])
        self.assertEqual(bytes_of(again), bytes_of(bolt))
        for wrong in (3, [("a", 1)], {"a": None}, {"a": [1]}, {"a": float("nan")}, {"name": "b"}):
            with self.assertRaises((TypeError, cnrg.InputError)):
                bolt.with_(attributes=wrong)

    def test_a_misspelt_key_is_told_with_the_one_that_is_meant(self):
        with self.assertRaisesRegex(TypeError, "did you mean 'segments'"):
            cnrg.cylinder([0, 0, 0], [0, 0, 1], 1, segment=8)

    def test_an_open_mesh_is_told_of(self):
        with warnings.catch_warnings(record=True) as seen:
            warnings.simplefilter("always")
            cnrg.mesh([[0, 0, 0], [1, 0, 0], [0, 1, 0]], [[0, 1, 2]]).evaluate()
        self.assertIn("surface without regions", str(seen[0].message))
        self.assertIs(seen[0].category, cnrg.Notice)

    def test_every_public_name_has_words(self):
        for name in cnrg.__all__:
            thing = getattr(cnrg, name)
            self.assertTrue(inspect.getdoc(thing), name)
            if inspect.isclass(thing):
                for member, value in vars(thing).items():
                    if not member.startswith("_") and callable(value):
                        self.assertTrue(inspect.getdoc(value), f"{name}.{member}")


if __name__ == "__main__":
    unittest.main()
