import tempfile
import unittest
from pathlib import Path

from names import House

ROOT = Path(__file__).resolve().parents[2]


def faults(files):
    """Of a house of these files; a text is in the namespace cnrg, from line 2 on, unless it begins with a comment."""
    with tempfile.TemporaryDirectory() as root:
        for file, text in files.items():
            path = Path(root, file)
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text(text if text.startswith("//") else f"namespace cnrg {{\n{text}\n}}  // namespace cnrg\n")
        return list(House(root, ["kernel", "csg"]).faults())


def hidden(text):
    return "namespace {\n" + text + "\n}"


class OfTheHouse(unittest.TestCase):
    def test_a_name_stands_for_one_thing(self):
        house = House(ROOT, ["kernel", "csg", "bench", "tests"])
        self.assertEqual("\n".join(house.faults()), "")
        # It reads: what most rooms are made of.
        self.assertGreater(len(house.includes), 800)
        for kind, least in (("type", 1000), ("function", 4000), ("variable", 400), ("alias", 200)):
            self.assertGreater(sum(n.kind == kind for n in house.names), least, kind)


class OfAProgram(unittest.TestCase):
    def test_two_classes_of_one_name_are_found(self):
        box = "struct Box {\n  int lo, hi;\n};"
        self.assertEqual(faults({"kernel/refine/box.h": box, "csg/picture/labels.h": "class Box final : Base {\n};"}),
                         ["cnrg::Box is defined in more than one file: kernel/refine/box.h:2, csg/picture/labels.h:2"])
        self.assertEqual(faults({"kernel/refine/box.h": box, "csg/weld/box.cpp": "enum class Box { a };"}),
                         ["cnrg::Box is defined in more than one file: kernel/refine/box.h:2, csg/weld/box.cpp:2"])

    def test_a_name_in_another_namespace_or_class_is_another_one(self):
        self.assertEqual(faults({"kernel/a/a.h": "struct Box {};\nstruct Model {\n  struct Part {};\n};",
                                 "csg/b/b.h": "namespace b {\nstruct Box {};\n}\nclass Box;\nstruct Part {};"}), [])

    def test_inline_functions_and_constants_are_found(self):
        found = faults({
            "kernel/a/a.h": "inline int size(const Box& b) { return 1; }\ninline constexpr int kMost = 1;",
            "csg/b/b.h": "inline int size(const Box& other) { return 2; }\ninline constexpr int kMost = 2;"})
        self.assertEqual([f.split(" ")[0] for f in found], ["cnrg::kMost", "cnrg::size"])
        self.assertEqual(faults({"kernel/a/a.h": "int size(const Box& b);",
                                 "kernel/a/a.cpp": "int size(const Box& other) { return 1; }"}), [])


class OfARoom(unittest.TestCase):
    def check_two(self, one, other):
        self.assertEqual(faults({"csg/mesh/a.cpp": hidden(one), "csg/mesh/b.cpp": hidden("\n" + other)}),
                         ["`same` is in more than one file of csg/mesh: csg/mesh/a.cpp:3, csg/mesh/b.cpp:4"])
        self.assertEqual(faults({"csg/mesh/a.cpp": hidden(one), "csg/weld/b.cpp": hidden(other)}), [])

    def test_a_hidden_name_in_two_files_of_a_room_is_found(self):
        self.check_two("constexpr int same = 1;", "constexpr int same = 1;")
        self.check_two("struct same {};", "template <class T>\nclass same {\n};")
        self.check_two("int same(const Vector& a) { return 1; }", "template <class T>\nT same(double x) { return x; }")
        self.check_two("using same = int;", "using same = long;")
        self.check_two("const std::array<int, 2> same{{1, 2}};", "std::map<int, std::set<int>> same;")

    def test_static_functions_and_constants_outside_of_it_are_hidden_too(self):
        self.assertEqual(len(faults({"csg/mesh/a.cpp": "static int same() { return 1; }",
                                     "csg/mesh/b.cpp": hidden("int same = 1;")})), 1)
        self.assertEqual(len(faults({"csg/mesh/a.cpp": "constexpr int same = 1;",
                                     "csg/mesh/b.cpp": "const int same = 1;"})), 1)

    def test_aliases_of_one_type_are_one(self):
        header = {"csg/mesh/mesh.h": "struct Mesh {\n  using Index = std::uint32_t;\n};\n"
                                     "struct Plc {\n  using Index = Mesh::Index;\n};"}
        self.assertEqual(faults(header | {"csg/mesh/a.cpp": hidden("using Index = Mesh::Index;"),
                                          "csg/mesh/b.cpp": hidden("using Index = Plc::Index;"),
                                          "csg/mesh/c.cpp": hidden("using Index = std::uint32_t;")}), [])
        self.assertEqual(len(faults(header | {"csg/mesh/a.cpp": hidden("using Index = Mesh::Index;"),
                                              "csg/mesh/b.cpp": hidden("using Index = std::uint64_t;")})), 1)

    def test_what_hides_a_name_of_a_header_is_found_where_the_room_sees_it(self):
        header = {"kernel/base/vectors.h": "double length(const Vector& a);\nVector operator+(const Vector& a, int b);"}
        sees = {"csg/mesh/b.cpp": '// that\n#include "csg/mesh/mesh.h"\n', "csg/mesh/mesh.h":
                '// that\n#include "kernel/base/vectors.h"\n'}
        for text, name in (("double length(int of) { return of; }", "length"), ("struct length {};", "length"),
                           ("Cell operator+(const Cell& a, const Cell& b) { return a; }", "operator+")):
            self.assertEqual(faults(header | {"csg/mesh/a.cpp": hidden(text)}), [])
            found = faults(header | sees | {"csg/mesh/a.cpp": hidden(text)})
            self.assertEqual(len(found), 1, text)
            self.assertTrue(found[0].startswith(f"`{name}` hides what the room sees: csg/mesh/a.cpp:3, "), found)

    def test_names_of_the_namespaces_around_are_hidden_too(self):
        inside = hidden("int text(double x) { return 1; }")
        files = {"csg/app/a.cpp": f'#include "csg/text/a.h"\nnamespace app {{\n{inside}\n}}'}
        self.assertEqual(len(faults(files | {"csg/text/a.h": "int text(const Rational& x);"})), 1)
        self.assertEqual(faults(files | {"csg/text/a.h": "namespace text {\nint text(const Rational& x);\n}"}), [])

    def test_a_global_name_meets_those_of_a_namespace_that_a_file_uses(self):
        files = {"csg/mesh/a.cpp": "// a\n" + hidden("int same() { return 1; }\n"),
                 "csg/mesh/b.cpp": hidden("int same() { return 2; }")}
        self.assertEqual(faults(files), [])
        files["csg/mesh/a.cpp"] += "\nusing namespace cnrg;\n"
        self.assertEqual(len(faults(files)), 1)

    def test_a_name_of_two_namespaces_that_are_used_is_ambiguous(self):
        files = {"csg/mesh/a.cpp": '// a\n#include "csg/mesh/a.h"\nusing namespace cnrg;\nusing namespace cnrg::test;\n',
                 "csg/mesh/b.cpp": '// b\n#include "csg/mesh/b.h"\n', "csg/mesh/a.h": "struct Scratch {};"}
        self.assertEqual(faults(files | {"csg/mesh/b.h": "namespace test {\nint scratch();\n}"}), [])
        self.assertEqual(faults(files | {"csg/mesh/b.h": "// b\nnamespace cnrg::test {\nclass Scratch {};\n}"}),
                         ["`Scratch` is ambiguous in csg/mesh: csg/mesh/a.h:2, csg/mesh/b.h:3"])

    def test_it_reads_on_behind_what_is_hard_to_read(self):
        hard = ['const char* const text = R"({{{)"; // {{', "/* { */ int digits = 1'000'000;", "#define OPEN {\\\n {",
                "A::A(int b) : b_{b}, c_(b) {\n  if (b) {\n  }\n}", "void f(B b = {}) {}", "char c = '{', d = '\\'';",
                "const auto g = [](int x) { return x; };", "std::vector<int> list{1, {2}};",
                "A& A::operator=(const A& b) { return *this; }", "template <>\nstruct std::hash<A> {\n};",
                "bool operator==(const A& a, const A& b) { return true; }", 'extern "C" {\nint h();\n}',
                "enum E : int { kA, kB };", "template <class T>\n  requires Small<T>\nint k(T t) {\n  return 1;\n}",
                "namespace fs = std::filesystem;", "struct A::Inner {\n  int x;\n};",
                "int m(int (*n)(int)) noexcept {\n  return 1;\n}"]
        for text in hard:
            with self.subTest(text):
                self.assertEqual(len(faults({"csg/mesh/a.cpp": text + "\n" + hidden("int same = 1;"),
                                             "csg/mesh/b.cpp": hidden("int same = 1;")})), 1)


if __name__ == "__main__":
    unittest.main()
