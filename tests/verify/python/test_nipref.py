"""The package, as the venv of check.sh has it."""

import math
import tempfile
import unittest
from decimal import Decimal

import numpy as np

import nipref


class Quantities(unittest.TestCase):
    def test_values_have_the_shape_of_their_arguments(self):
        alpha = np.array([[0.5], [0.73], [2.0]])
        values = nipref.eval("un", alpha=alpha, young=[1.0, 2.0], poisson=0.3)
        self.assertEqual(values.shape, (3, 2))
        self.assertEqual(values[1, 1], nipref.eval("un", alpha=0.73, young=2, poisson=0.3))
        self.assertLess(abs(nipref.eval("I1", alpha=0.73, rtol=1e-6) - nipref.eval("I1", alpha=0.73)), 1e-6)

    def test_both_paths_agree(self):
        alpha = np.geomspace(1e-6, 20, 9)
        fast, ref = nipref.eval("I1", alpha=alpha), nipref.eval("I1", alpha=alpha, path="ref")
        np.testing.assert_allclose(fast, ref, rtol=1e-13)

    def test_the_reference_has_bounds_and_digits(self):
        found = nipref.ref("I1", alpha="0.73", digits=40)
        self.assertTrue(found.text.startswith("0.20699024464081926"))
        self.assertTrue(found.proven and found.met)
        self.assertLess(found.lower, Decimal(found.text))
        self.assertLess(found.upper - found.lower, Decimal("1e-39"))
        both = nipref.ref("I1", alpha=[0.73, 1.0])
        self.assertEqual(both.lower.shape, (2,))
        self.assertNotEqual(both.text[0], found.text)  # the double 0.73 is not the decimal

    def test_materials_and_choices_are_texts(self):
        solid = "standard-linear-solid(bulk=1, relaxation_time=2)"
        value = nipref.eval("Un", t=1, T=[2.0, 3.0], material=solid)
        self.assertEqual(value[0], nipref.eval("Un", t=1, T=2, material=solid))
        np.testing.assert_allclose(value, nipref.ref("Un", t="1", T=[2.0, 3.0], material=solid, digits=20).value, rtol=1e-13)

    def test_what_is_wrong_is_one_line(self):
        for call, says in ((lambda: nipref.eval("I8", alpha=1), "I8"), (lambda: nipref.eval("I1", alpha=0.0), "alpha"),
                           (lambda: nipref.eval("I1", beta=1), "beta"), (lambda: nipref.eval("I1"), "alpha"),
                           (lambda: nipref.eval("I1", alpha=[]), "empty"), (lambda: nipref.eval("I1", alpha="x"), "alpha"),
                           (lambda: nipref.eval("I1", alpha=1, path="slow"), "path"), (lambda: nipref.ref("I1", alpha=1, digits=3), "digits"),
                           (lambda: nipref.solve("no-such-scene"), "no-such-scene"), (lambda: nipref.golden("I8"), "I8"),
                           (lambda: nipref.solve("thick-frictionless", {"load.per_length": [-1, 0]}), "per_length")):
            with self.assertRaises(nipref.BadInput) as caught:
                call()
            self.assertIn(says, str(caught.exception))
            self.assertNotIn("\n", str(caught.exception))

    def test_all_are_listed(self):
        self.assertIn("sinh", nipref.quantities()["I1"])


class Contacts(unittest.TestCase):
    def test_a_sweep_is_arrays_with_errors(self):
        loads = np.array([[50.0], [100.0]])
        found = nipref.solve("thick-frictionless", {"load.per_length": loads, "material.poisson": [0.3, 0.4, 2.0]})
        length = found["contact_length"]
        self.assertEqual((length.value.shape, length.unit), ((2, 3), "length"))
        self.assertTrue(np.all(np.isnan(length.value[:, 2])) and "poisson" in found.refused[0, 2])
        self.assertTrue(np.all(length.error[:, :2] < 1e-9 * length.value[:, :2]) and length.met[0, 0] and not found.refused[0, 0])
        self.assertEqual(length.value[1, 0], nipref.solve("thick-frictionless", {"load.per_length": 100.0, "material.poisson": 0.3})
                         ["contact_length"].value)

    def test_profiles_and_fields_have_their_shapes(self):
        found = nipref.solve("inside-thick-frictionless", {"load.per_length": [50.0, 100.0]})
        stress = found["stress_across"]
        self.assertEqual(stress.value.shape, (2, len(found.field_depths), len(found.field_positions)))
        self.assertEqual(stress.error.shape, stress.value.shape)
        profile = nipref.solve("thick-frictionless", {"wanted": '["pressure"]', "profile.points": 5})
        self.assertEqual((profile["pressure"].value.shape, profile.positions.shape), ((5,), (5,)))

    def test_the_reference_solves(self):
        found = nipref.solve("thick-frictionless", {"wanted": '["contact_length"]'}, path="ref", digits=20)["contact_length"]
        self.assertTrue(found.proven and str(found.text).startswith("0.13"))
        fast = nipref.solve("thick-frictionless")["contact_length"]
        self.assertLessEqual(abs(found.value - fast.value), fast.error)


class Checks(unittest.TestCase):
    def test_a_function_is_graded(self):
        right = nipref.grade(lambda alpha: nipref.eval("I1", alpha=alpha), "I1", points=200)
        self.assertTrue(right["passed"] and right["max_error_ulp"] < 2)
        wrong = nipref.grade(lambda alpha: nipref.eval("I1", alpha=alpha) * (1 + 1e-12), "I1", points=200, alpha="0.1..1")
        self.assertFalse(wrong["passed"])
        self.assertTrue(nipref.grade(np.vectorize(math.atan), "I2", points=50, promise=1e17)["passed"])

    def test_golden_values_confirm(self):
        stored = nipref.golden("I1")
        errors = abs(nipref.eval("I1", alpha=stored["alpha"]) - stored["value"])
        self.assertTrue(np.all(errors <= 1e-15 * stored["scale"]))
        self.assertTrue(np.all(stored["bound"] < 1e-40) and stored["text"][0].startswith("0."))
        with tempfile.TemporaryDirectory() as folder:
            nipref._library.answer("golden", "export", "I1", "--format", "npy", "-o", folder + "/I1.npy")
            exported = np.load(folder + "/I1.npy")
        self.assertTrue(all(np.all(exported[name] == stored[name]) for name in ("alpha", "value")))
        self.assertTrue(np.all(exported["bound"] >= stored["bound"]) and np.all(exported["bound"] <= 1.01 * stored["bound"]))

    def test_golden_contacts_have_each_result_with_its_bound(self):
        stored = nipref.golden("contacts-frictionless")
        self.assertTrue(np.all(stored["load_bound"] < 1e-15 * stored["load"]))
        self.assertEqual(float(stored["load_text"][0]), stored["load"][0])
        one = nipref.solve("thick-frictionless", {"roller.radius": 1e6, "material.young": 1, "material.poisson": 0,
                                                  "load.per_length": stored["load"][0]})["contact_length"]
        self.assertAlmostEqual(one.value, stored["contact.length"][0], delta=one.error)

    def test_an_audit_finds_the_largest_error(self):
        row = nipref.audit("I1", points=200, alpha="0.1..1")
        self.assertTrue(row["passed"] and row["max_error_ulp"] < row["promise_ulp"])


if __name__ == "__main__":
    unittest.main()
