#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""bindings/api.json holds every declaration and comment of a header. Anything unknown in the header is an error."""
import sys
import unittest

import header  # puts bindings/ on the path

import c_header
import make_api
from const_functions import const_functions

BEFORE = """#ifndef HRBFNPR_H
#define HRBFNPR_H
#include <stdint.h>
/*
 * ======
 * 1  THINGS to make   [P 1]
 * ======
 */
enum { HRBFNPR_VERSION_MAJOR = 1, HRBFNPR_VERSION_MINOR = 2, HRBFNPR_VERSION_PATCH = 3, HRBFNPR_ABI_VERSION = 4 };
typedef struct hrbfnpr_thing hrbfnpr_thing;
typedef int32_t hrbfnpr_status;
"""
LINE = BEFORE.count("\n") + 1  # the first line of a text after it
AFTER = "\n#endif /* HRBFNPR_H */\n"


def made(text):
    return make_api.make(BEFORE + text + AFTER)


class Documents(unittest.TestCase):
    def test_versions_and_sections_are_read(self):
        api = made("")
        self.assertEqual((api["version"], api["abi_version"]), ("1.2.3", 4))
        self.assertEqual(api["sections"], [{"number": 1, "title": "THINGS to make [P 1]", "text": ""}])
        self.assertEqual(api["order"],
                         [["enum", "HRBFNPR"], ["handle", "hrbfnpr_thing"], ["typedef", "hrbfnpr_status"]])

    def test_comments_belong_to_their_declarations(self):
        api = made("""
/* Of the section. */

/* Of the enum,
 *   indented. */
enum {
    HRBFNPR_KIND_A = 1, /* behind
                           on two lines */
    /* Above. */
    HRBFNPR_KIND_B = 2
};
typedef struct hrbfnpr_pair {
    /* Of both. */
    double a; /* the first */
    double b;
} hrbfnpr_pair;
/* Above a function. */
HRBFNPR_API void hrbfnpr_f(void); /* and behind it */
HRBFNPR_API void hrbfnpr_g(void);

HRBFNPR_API void hrbfnpr_h(void);""")
        self.assertEqual(api["sections"][0]["text"], "Of the section.")
        kinds = api["constants"][1]
        self.assertEqual(kinds["doc"], "Of the enum,\n  indented.")
        self.assertEqual([constant["doc"] for constant in kinds["constants"]], ["behind on two lines", "Above."])
        fields = api["structs"][0]["fields"]
        self.assertEqual([(field["doc"], field.get("heading")) for field in fields],
                         [("the first", "Of both."), ("", None)])
        self.assertEqual([(function["doc"], function.get("see")) for function in api["functions"]],
                         [("Above a function.\n\nand behind it", None), ("", "hrbfnpr_f"), ("", None)])

    def test_values_are_computed(self):
        constants = made("""
enum { HRBFNPR_A_X = 1 << 3, HRBFNPR_A_Y = HRBFNPR_A_X | 0x10u, HRBFNPR_A_Z = -(2 + 1) * 2 };""")
        self.assertEqual([constant["value"] for constant in constants["constants"][1]["constants"]], [8, 24, -6])

    def test_prefixes_are_named_by_the_comments(self):
        api = made("""enum { HRBFNPR_MAKE_WITH_A = 1, HRBFNPR_MAKE_WITH_B = 2 };
enum { HRBFNPR_LONE_FLAG = 1 };
enum { HRBFNPR_HUE_RED = 1, HRBFNPR_HUE_RUST = 2 };
typedef struct hrbfnpr_desc { uint32_t flags; /* HRBFNPR_MAKE_..., or-ed */
} hrbfnpr_desc;""")
        self.assertEqual([group["prefix"] for group in api["constants"][1:]],
                         ["HRBFNPR_MAKE", "HRBFNPR_LONE", "HRBFNPR_HUE"])
        self.assertEqual(api["structs"][0]["fields"][0]["constants"], "HRBFNPR_MAKE")

    def test_pointer_types_keep_const_at_each_level(self):
        api = made("HRBFNPR_API const char* hrbfnpr_f(const hrbfnpr_thing* const* a, hrbfnpr_thing** b, double c);")
        parameters = api["functions"][0]["parameters"]
        self.assertEqual([(one["type"]["c"], one["type"]["pointers"], one["type"]["const"]) for one in parameters],
                         [("const hrbfnpr_thing* const*", ["const", "const"], True),
                          ("hrbfnpr_thing**", ["mutable", "mutable"], False), ("double", [], False)])

    def test_layouts_follow_the_data_model(self):
        api = made("""typedef struct hrbfnpr_inner { uint8_t a; double b; } hrbfnpr_inner;
typedef void (*hrbfnpr_back_fn)(void* user);
typedef struct hrbfnpr_outer {
    void (*call)(int32_t count);
    hrbfnpr_inner inner[2][3];
    hrbfnpr_back_fn back;
    char end;
} hrbfnpr_outer;""")
        outer = api["structs"][1]
        self.assertEqual({model: [whole["size"], whole["align"]] for model, whole in outer["layout"].items()},
                         {"lp64": [120, 8], "ilp32": [112, 8], "i386": [84, 4]})
        self.assertEqual([field["layout"]["i386"]["offset"] for field in outer["fields"]], [0, 4, 76, 80])
        self.assertEqual([field["layout"]["ilp32"]["offset"] for field in outer["fields"]], [0, 8, 104, 108])
        self.assertEqual([field["array"] for field in outer["fields"]], [[], [2, 3], [], []])

    def test_functions_know_their_noun_and_their_handles(self):
        api = made("""typedef struct hrbfnpr_thing_part { int32_t a; } hrbfnpr_thing_part;
typedef struct hrbfnpr_tool hrbfnpr_tool;
HRBFNPR_API void hrbfnpr_thing_look(const hrbfnpr_thing* thing);
HRBFNPR_API void hrbfnpr_thing_turn(hrbfnpr_thing* thing);
HRBFNPR_API void hrbfnpr_thing_part_with(const hrbfnpr_thing* thing, hrbfnpr_tool* tool);
HRBFNPR_API void hrbfnpr_make(hrbfnpr_thing** out);""")
        self.assertEqual([(one["noun"], one["concurrent"]) for one in api["functions"]],
                         [("hrbfnpr_thing", True), ("hrbfnpr_thing", False),
                          ("hrbfnpr_thing_part", False), (None, True)])
        self.assertEqual([tuple(one) for one in const_functions(api)],
                         [("hrbfnpr_thing_look", ["thing"], []), ("hrbfnpr_thing_part_with", ["thing"], ["tool"])])

    def test_the_output_is_valid_json(self):
        import json

        api = made("/* \\ \" é */\nenum { HRBFNPR_A_X = 1 };")
        self.assertEqual(json.loads(make_api.dump(api)), api)


class Refusals(unittest.TestCase):
    def refused(self, text, line, words):
        with self.assertRaises(c_header.HeaderError) as caught:
            made(text)
        error = caught.exception
        self.assertEqual((error.line - LINE + 1, words in str(error)), (line, True), error)

    def test_unknown_syntax_is_reported_with_its_line(self):
        for text, line, words in [
            ("\nint32_t x;", 2, "not understood: int32_t"),
            ("\nHRBFNPR_API int32_t hrbfnpr_f(void) { }", 2, "expected ';'"),
            ("HRBFNPR_API\n  long hrbfnpr_f(void);", 2, "the type long"),
            ("HRBFNPR_API void hrbfnpr_f(int32_t);", 1, "a parameter's name"),
            ("HRBFNPR_API void hrbfnpr_f(int32_t a, ...);", 1, "not understood: ..."),
            ("HRBFNPR_API void hrbfnpr_f(double a[3]);", 1, "write a pointer"),
            ("HRBFNPR_API void hrbfnpr_f(hrbfnpr_thing a);", 1, "without a pointer"),
            ("HRBFNPR_API void hrbfnpr_f(const int32_t a);", 1, "const that no pointer"),
            ("HRBFNPR_API void hrbfnpr_f(int32_t a, int32_t a);", 1, "two parameters a"),
            ("HRBFNPR_API void f(void);", 1, "does not begin with hrbfnpr_"),
            ("HRBFNPR_API void hrbfnpr_f(void);\nHRBFNPR_API void hrbfnpr_f(void);", 2, "declared twice"),
            ("void hrbfnpr_f(void);", 1, "not understood: void"),
            ("struct hrbfnpr_s { int32_t a; };", 1, "not understood: struct"),
            ("typedef union hrbfnpr_u { int32_t a; } hrbfnpr_u;", 1, "the type union"),
            ("typedef enum { HRBFNPR_A_X = 1 } hrbfnpr_e;", 1, "the type enum"),
            ("typedef struct hrbfnpr_s {\n int32_t a : 3;\n} hrbfnpr_s;", 2, "not understood: :"),
            ("typedef struct hrbfnpr_s {\n int32_t a, b;\n} hrbfnpr_s;", 2, "expected ';'"),
            ("typedef struct hrbfnpr_s {\n int32_t a;\n int32_t a;\n} hrbfnpr_s;", 4, "two fields"),
            ("typedef struct hrbfnpr_s {\n int32_t a;\n} hrbfnpr_t;", 3, "expected 'hrbfnpr_s'"),
            ("typedef struct hrbfnpr_s {\n struct { int32_t a; } b;\n} hrbfnpr_s;", 2, "the type struct"),
            ("typedef struct hrbfnpr_s {\n double a[0];\n} hrbfnpr_s;", 2, "an array of 0"),
            ("typedef struct hrbfnpr_s hrbfnpr_t;", 1, "expected 'hrbfnpr_s'"),
            ("typedef void* hrbfnpr_p;", 1, "a typedef must be"),
            ("enum {\n HRBFNPR_A_X\n};", 3, "expected '='"),
            ("enum { HRBFNPR_A_X = HRBFNPR_NONE };", 1, "no constant expression: HRBFNPR_NONE"),
            ("enum { HRBFNPR_A_X = 0x80000000 };", 1, "is no int"),
            ("enum { HRBFNPR_A_X = 010 };", 1, "not understood: 010"),
            ("enum hrbfnpr_e { HRBFNPR_A_X = 1 };", 1, "expected '{'"),
            ("\n#define HRBFNPR_TWO 2", 2, "a directive that is not known"),
            ("\n#if 1\n#endif", 2, "a directive that is not known"),
            ("#ifdef __cplusplus\nint32_t x;\n#endif", 2, "expected '}'"),
            ("#if defined(_WIN32)\n#define HRBFNPR_OTHER\n#endif", 2, "expected a definition of HRBFNPR_API"),
            ("// words", 1, "not understood: // words"),
            ("\"words\"", 1, "not understood"),
        ]:
            with self.subTest(text):
                self.refused(text, line, words)

    def test_stray_comments_are_refused(self):
        for text, line in [
            ("typedef struct hrbfnpr_s { /* here? */\n int32_t a;\n} hrbfnpr_s;", 1),
            ("typedef struct hrbfnpr_s {\n int32_t a;\n\n /* here? */\n} hrbfnpr_s;", 4),
            ("typedef struct hrbfnpr_s {\n /* here? */\n\n int32_t a;\n} hrbfnpr_s;", 2),
            ("HRBFNPR_API void hrbfnpr_f(int32_t a, /* here? */\n int32_t b);", 1),
            ("HRBFNPR_API /* here? */ void hrbfnpr_f(void);", 1),
        ]:
            with self.subTest(text):
                self.refused(text, line, "a comment that belongs to nothing")
        self.refused("enum { HRBFNPR_A_X = 1, HRBFNPR_A_Y = 2, /* of both? */\n};", 1, "behind several")
        self.refused("/*\n * ====\n * NO NUMBER\n * ====\n */", 1, "a section without a number")

    def test_a_truncated_header_is_refused(self):
        text = header.HEADER.read_text(encoding="utf-8")
        for share in range(1, 10):
            with self.assertRaises(c_header.HeaderError):
                c_header.parse(text[:len(text) * share // 10])

    def test_two_enums_with_one_prefix_are_refused(self):
        self.refused("enum { HRBFNPR_A_X = 1, HRBFNPR_A_Y = 2 };\nenum { HRBFNPR_A_V = 1, HRBFNPR_A_W = 2 };", 2,
                     "a second enum of HRBFNPR_A_...")


class TheHeader(unittest.TestCase):
    """api.json holds all of include/hrbfnpr.h. The header is counted here without the parser."""

    def setUp(self):
        import re

        text = header.HEADER.read_text(encoding="utf-8")
        self.words = re.findall(r"\w+", re.sub(r"/\*.*?\*/", " ", text, flags=re.DOTALL))
        self.comments = re.findall(r"/\*.*?\*/", text, flags=re.DOTALL)
        self.api = header.description()

    def test_every_name_is_in_api_json(self):
        names = {word for word in self.words if word.startswith(("hrbfnpr_", "HRBFNPR_"))}
        names -= {"HRBFNPR_H", "HRBFNPR_API", "HRBFNPR_BUILD", "HRBFNPR_STATIC"}
        found = {entry["name"] for key in ("functions", "structs", "callbacks", "handles", "typedefs")
                 for entry in self.api[key]}
        found |= {constant["name"] for group in self.api["constants"] for constant in group["constants"]}
        self.assertEqual(found, names)
        self.assertEqual(len(self.api["functions"]), self.words.count("HRBFNPR_API") -
                         sum(1 for a, b in zip(self.words, self.words[1:]) if (a, b) == ("define", "HRBFNPR_API")))

    def test_every_word_of_a_comment_is_in_api_json(self):
        import re

        texts = []

        def collect(value):
            if isinstance(value, dict):
                texts.extend(str(value.get(key) or "") for key in ("doc", "heading", "text", "title"))
                value = list(value.values())
            for item in value if isinstance(value, list) else []:
                collect(item)

        collect(self.api)
        count = len(re.findall(r"\w+", " ".join(texts))) + len(self.api["sections"])  # sections also have a number
        inside = [comment for comment in self.comments if comment != "/* HRBFNPR_H */"]
        self.assertEqual(count, len(re.findall(r"\w+", " ".join(inside))))

    def test_functions_that_take_a_const_handle_are_listed(self):
        names = {function.name for function in const_functions(self.api)}
        self.assertIn("hrbfnpr_model_evaluate", names)
        self.assertNotIn("hrbfnpr_model_fit", names)
        for function in self.api["functions"]:
            if any("const" in parameter["type"]["c"] and parameter["type"]["kind"] == "handle"
                   for parameter in function["parameters"]):
                self.assertIn(function["name"], names)


if __name__ == "__main__":
    sys.exit(unittest.main())
