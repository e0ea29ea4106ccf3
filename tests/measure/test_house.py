"""The measures of the house, of houses whose measures are known."""
import unittest

import house


class Measures(unittest.TestCase):
    def test_lines_of_rooms_and_parts_and_words_of_pages(self):
        rooms, measures, large = house.measure({
            "kernel/exact/a.h": "1\n2\n", "kernel/exact/b.cpp": "1\n", "csg/app/deep/c.cpp": "1\n" * 601,
            "kernel/cnrg.h": "1\n", "csg/app/x.py": "no\n", "papers/p.cpp": "no\n", "README.md": "two words\n"})
        self.assertEqual(rooms, {"kernel/exact": 3, "csg/app": 601, "kernel": 1})
        self.assertEqual(measures["lines of kernel and csg"], 605)
        self.assertEqual(measures["words of pages"], 2)
        self.assertEqual(measures["files above 600 lines"], 1)
        self.assertEqual(large, [(601, "csg/app/deep/c.cpp")])

    def test_lines_of_classes_are_from_head_to_bracket(self):
        source = ("class Ahead;\nenum class Kind { a };\n// class Comment {\n"
                  "template <class T>\nclass A final : public B<T> {\n  void f() {\n    \"}\";\n  }\n\n  struct In {\n"
                  "    int i;\n  };\n};\n")
        self.assertEqual(dict(house.lines_of_classes(source)), {"A": 10, "In": 3})
        body = "  int i;\n"
        for lines, above in ((248, 0), (249, 1)):
            measures = house.measure({"csg/a/a.cpp": "struct A {\n" + body * lines + "};\n"})[1]
            self.assertEqual(measures["classes above 250 lines"], above)

    def test_a_measure_above_its_limit_and_a_limit_that_rose_are_named(self):
        self.assertEqual(list(house.faults({"words": 5}, {"words": 5}, [{"words": 6}, {}])), [])
        self.assertEqual(list(house.faults({"words": 6}, {"words": 5}, [])), ["words: 6, the limit is 5"])
        self.assertEqual(list(house.faults({"words": 5}, {"words": 7}, [{"words": 6}])),
                         ["words: the limit rose from 6 to 7"])
        self.assertIn("without a limit", list(house.faults({"words": 5}, {}, []))[0])

    def test_lines_and_words_have_room_to_move_and_what_is_large_has_none(self):
        self.assertEqual([house.needed("lines of csg", n) for n in (0, 500, 501, 95998)], [1000, 1000, 2000, 97000])
        self.assertEqual(house.needed("classes above 250 lines", 42), 42)
        self.assertEqual(house.needed("files above 600 lines", 5), 5)

    def test_the_table_has_rooms_limits_and_what_is_large(self):
        rows = "\n".join(house.table({"csg/app": 3, "csg": 1}, {"lines of csg": 4}, {"lines of csg": 9}, [(601, "a.cpp")]))
        self.assertIn("lines of csg/app        3", rows)
        self.assertRegex(rows, r"lines of csg +4 +9\n")
        self.assertIn("601  a.cpp", rows)


if __name__ == "__main__":
    unittest.main()
