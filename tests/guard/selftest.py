#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""The guards themselves: each is run on small trees with one fault, and must find exactly that fault."""

import os
import subprocess
import sys
import tempfile
import unittest

HERE = os.path.dirname(os.path.abspath(__file__))
SPDX = "// SPDX-License-Identifier: MIT\n"
HASH_SPDX = "# SPDX-License-Identifier: MIT\n"


def run_guard(name, files):
    """Writes `files` (path -> text or bytes) as a project and runs a guard on it. Returns (exit code, output)."""
    with tempfile.TemporaryDirectory() as root:
        for path, content in {"CMakeLists.txt": HASH_SPDX, **files}.items():
            target = os.path.join(root, path)
            os.makedirs(os.path.dirname(target), exist_ok=True)
            with open(target, "wb") as file:
                file.write(content if isinstance(content, bytes) else content.encode("utf-8"))
        result = subprocess.run([sys.executable, "-B", os.path.join(HERE, name + ".py"), root],
                                capture_output=True, text=True)
        return result.returncode, result.stdout + result.stderr


class GuardCase(unittest.TestCase):
    def assert_clean(self, guard, files):
        code, output = run_guard(guard, files)
        self.assertEqual(code, 0, output)

    def assert_fault(self, guard, files, *words):
        code, output = run_guard(guard, files)
        self.assertEqual(code, 1, output)
        self.assertIn("1 faults", output)
        for word in words:
            self.assertIn(word, output)


class Floors(GuardCase):
    def test_lower_floors_and_doors_are_allowed(self):
        self.assert_clean("floors", {
            "src/motion/sample.cpp": '#include "motion/sample.hpp"\n#include "animal/animal.hpp"\n#include <glm/glm.hpp>\n',
            "src/cli/main.cpp": '#include <CLI/CLI.hpp>\n#include <iostream>\n#include "bake/bake.hpp"\n',
            "src/loader/open.c": '#include "posepack/loader.h"\n#include "format/bytes.h"\n',
            "include/posepack/loader.h": '#include <stdint.h>\n#include "posepack/format.h"\n',
        })

    def test_each_rule_is_held(self):
        cases = [
            ("src/motion/a.cpp", '#include "measure/error.hpp"\n', "floor below 3"),
            ("src/palette/a.cpp", '#include "vat/vat.hpp"\n', "floor below 4"),
            ("src/loader/a.c", '#include "base/text.hpp"\n', "only format/"),
            ("src/base/a.cpp", '#include "posepack/loader.h"\n', "neither the format nor the loader"),
            ("src/base/a.cpp", '#include "text.hpp"\n', "expected the room"),
            ("src/bake/a.cpp", "#include <tiny_gltf.h>\n", "enters by animal"),
            ("src/bake/a.cpp", "#include <OpenEXR/ImfOutputFile.h>\n", "enters by output"),
            ("src/bake/a.cpp", "#include <CLI/CLI.hpp>\n", "enters by cli"),
            ("src/recipe/a.cpp", "#include <nettle/sha2.h>\n", "enters by base"),
            ("src/recipe/a.cpp", "#include <glm/glm.hpp>\n", "glm"),
            ("src/bake/a.cpp", "#include <iostream>\n", "belongs to cli"),
            ("src/measure/a.cpp", '#include "base/text.hpp"\nvoid f() { std::printf("x"); }\n', "does not print"),
            ("include/posepack/a.h", "#include <glm/glm.hpp>\n", "C's own headers"),
            ("src/newroom/a.cpp", '#include "base/text.hpp"\n', "no floor yet"),
        ]
        for path, text, words in cases:
            with self.subTest(path=path, text=text):
                self.assert_fault("floors", {path: text, "src/cli/other.cpp": '#include "base/text.hpp"\n'}, path, words)

    def test_a_header_with_a_door_in_it_is_private(self):
        door = {"src/animal/door.hpp": "#include <tiny_gltf.h>\n"}
        self.assert_clean("floors", {**door, "src/animal/a.cpp": '#include "animal/door.hpp"\n'})
        self.assert_fault("floors", {**door, "src/motion/a.cpp": '#include "animal/door.hpp"\n'}, "private to animal")

    def test_the_table_of_rooms_is_whole(self):
        sys.path.insert(0, HERE)
        from floors import FLOORS
        code = {"src/cli/other.cpp": '#include "base/text.hpp"\n'}
        lines = {room: f"| {floor} | `{room}` | what it does |\n" for room, floor in FLOORS.items()}
        self.assert_clean("floors", {**code, "CONTRIBUTING.md": "".join(lines.values())})
        for changed, words in [({"fit": ""}, "fit on floor 5, found None"), ({"fit": "| 4 | `fit` | |\n"}, "found 4"),
                               ({"extra": "| 3 | `attic` | |\n"}, "attic on floor None")]:
            text = "".join({**lines, **changed}.values())
            self.assert_fault("floors", {**code, "CONTRIBUTING.md": text}, "CONTRIBUTING.md", words)

    def test_comments_and_strings_are_not_code(self):
        self.assert_clean("floors", {
            "src/base/a.cpp": '// #include <iostream>\n#include <string>\n/* printf( */ const char* k = "printf(";\n'})

    def test_nothing_to_look_at_is_a_fault(self):
        code, output = run_guard("floors", {})
        self.assertEqual(code, 1, output)
        self.assertIn("found none", output)


class Libm(GuardCase):
    def test_exact_functions_are_allowed(self):
        self.assert_clean("libm", {
            "src/motion/a.cpp": "#include <cmath>\n// std::sin(x)\ndouble f(double x) { return std::sqrt(std::floor(x)); }\n"
                                "double g(T t) { return t.pow(3) + base::exp(1) + my_log(2); }\n",
            "src/bake/doctor.cpp": "double f(double x) { return std::log(x); }\n"})

    def test_inexact_ones_are_not(self):
        for call in ("std::sin(x)", "std::atan2(x, 1.0)", "glm::acos(x)", "sinf(x)", "pow (x, 2)", "std::fma(x, x, x)"):
            with self.subTest(call=call):
                self.assert_fault("libm", {"src/palette/a.cpp": f"double f(double x) {{ return {call}; }}\n"},
                                  "src/palette/a.cpp:1")


class Headers(GuardCase):
    def test_headers_that_stand_alone(self):
        self.assert_clean("headers", {
            "src/base/a.hpp": "#pragma once\n#include <string>\nstd::string f();\n",
            "include/posepack/a.h": "#ifndef A_H\n#define A_H\n#include <stdint.h>\nextern uint32_t a;\n#endif\n"})

    def test_missing_includes_and_guards(self):
        self.assert_fault("headers", {"src/base/a.hpp": "#pragma once\nstd::string f();\n"}, "src/base/a.hpp")
        self.assert_fault("headers", {"src/base/a.hpp": "struct A {};\n"}, "redefinition")


class Freestanding(GuardCase):
    def test_memory_functions_only(self):
        self.assert_clean("freestanding", {
            "src/loader/a.c": "#include <string.h>\nvoid f(char* a, const char* b);\n"
                              "void f(char* a, const char* b) { memcpy(a, b, 9); }\n"})

    def test_library_calls_and_writable_data(self):
        code, output = run_guard("freestanding", {
            "src/loader/a.c": "#include <stdlib.h>\nint g(int a);\nint g(int a) { return a ? abs(a) : rand(); }\n"})
        self.assertEqual(code, 1, output)
        self.assertIn("found rand", output)
        code, output = run_guard("freestanding", {
            "src/loader/a.c": "int next(void);\nint next(void) { static int n = 3; return ++n; }\n"})
        self.assertEqual(code, 1, output)
        self.assertIn("writable data", output)


class Tree(GuardCase):
    def test_clean_tree(self):
        self.assert_clean("tree", {"src/base/a.cpp": SPDX, "dev": "#!/bin/sh\n" + HASH_SPDX, "p.png": b"\x89PNG\xff\xfe"})

    def test_each_rule_is_held(self):
        home = "/" + "home/someone/models"
        self.assert_fault("tree", {"src/base/a.cpp": "int a;\n"}, "SPDX")
        self.assert_fault("tree", {"big.bin": b"\xff" * 1_000_001}, "1,000,001")
        self.assert_fault("tree", {"docs/a.md": f"see {home}\n"}, "one machine")
        self.assert_fault("tree", {"a/package-lock.json": '{"resolved": "' + 'https://x"}\n'}, "registry")


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
