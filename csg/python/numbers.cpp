#include "numbers.h"

#include <cmath>
#include <string>

namespace cnrg::python {
namespace {

constexpr std::size_t kMostDigits = 100'000;       // as in a tree file
constexpr std::size_t kMostIntegerBits = 332'193;  // of so many digits

[[noreturn]] void refuse(const std::string& what, const std::string& why) { throw InputError(what + ": " + why); }

/// What a Python object is, for messages; no code of its own is run.
std::string kind_of(const py::handle& value) { return Py_TYPE(value.ptr())->tp_name; }

Integer integer_of(const py::handle& value, const std::string& what) {
  const py::object index = py::reinterpret_steal<py::object>(PyNumber_Index(value.ptr()));
  if (!index) throw py::error_already_set();
  if (index.attr("bit_length")().cast<std::size_t>() > kMostIntegerBits)
    refuse(what, "a number of more than 100000 digits; give a shorter one");
  const py::object text = py::reinterpret_steal<py::object>(PyNumber_ToBase(index.ptr(), 16));
  if (!text) throw py::error_already_set();
  return Integer(text.cast<std::string>(), 0);  // 0x...
}

Rational ratio_of(const py::handle& numerator, const py::handle& denominator, const std::string& what) {
  const Integer below = integer_of(denominator, what);
  if (below == 0) refuse(what, "a fraction with the denominator 0");
  Rational value(integer_of(numerator, what), below);
  value.canonicalize();
  return value;
}

Rational rational_of(const std::string& text, const std::string& what) {
  if (text.size() > kMostDigits) refuse(what, "a number of more than 100000 characters; give a shorter one");
  std::optional<Rational> value = parse_rational(text);
  if (!value)
    refuse(what, "`" + text.substr(0, 40) + (text.size() > 40 ? "..." : "") +
                     "` is no number; write such as 12, -0.1, 1.5e-3 or 121/3");
  return std::move(*value);
}

bool is_a(const py::handle& value, const char* module, const char* name) {
  // Who has never imported the module has no such number.
  PyObject* const modules = PyImport_GetModuleDict();
  PyObject* const found = PyDict_GetItemString(modules, module);
  return found != nullptr && py::isinstance(value, py::handle(found).attr(name));
}

py::object fraction_class() {
  static py::handle type = py::object(py::module_::import("fractions").attr("Fraction")).release();
  return py::reinterpret_borrow<py::object>(type);
}

py::object to_int(const Integer& value) {
  const std::string text = value.get_str(16);
  PyObject* const made = PyLong_FromString(text.c_str(), nullptr, 16);
  if (made == nullptr) throw py::error_already_set();
  return py::reinterpret_steal<py::object>(made);
}

}  // namespace

py::object to_fraction(const Rational& value) {
  return fraction_class()(to_int(value.get_num()), to_int(value.get_den()));
}

py::object to_fraction(const std::optional<Rational>& value) {
  return value ? to_fraction(*value) : py::object(py::none());
}

py::tuple to_fractions(const RationalPoint& point) {
  return py::make_tuple(to_fraction(point[0]), to_fraction(point[1]), to_fraction(point[2]));
}

py::object to_fractions(const std::optional<RationalPoint>& point) {
  return point ? py::object(to_fractions(*point)) : py::object(py::none());
}

Rational to_rational(const py::handle& value, const std::string& what) {
  if (PyBool_Check(value.ptr())) throw py::type_error(what + ": a number is wanted, not a bool");
  if (PyLong_Check(value.ptr())) return Rational(integer_of(value, what));
  if (PyFloat_Check(value.ptr())) {
    const double number = PyFloat_AsDouble(value.ptr());
    if (!std::isfinite(number)) refuse(what, "a number that is not finite; give one that is");
    return from_double(number);
  }
  if (PyUnicode_Check(value.ptr())) {
    Py_ssize_t size = 0;
    const char* const text = PyUnicode_AsUTF8AndSize(value.ptr(), &size);
    if (text == nullptr) {  // half of a character
      PyErr_Clear();
      refuse(what, "the text is not Unicode, so it is no number");
    }
    return rational_of(std::string(text, static_cast<std::size_t>(size)), what);
  }
  if (is_a(value, "decimal", "Decimal")) return rational_of(py::str(value).cast<std::string>(), what);
  if (py::hasattr(value, "numerator") && py::hasattr(value, "denominator"))
    return ratio_of(value.attr("numerator"), value.attr("denominator"), what);
  if (py::hasattr(value, "as_integer_ratio")) {  // a float of numpy
    try {
      const auto ratio = value.attr("as_integer_ratio")().cast<py::tuple>();
      if (ratio.size() == 2) return ratio_of(ratio[0], ratio[1], what);
    } catch (py::error_already_set& e) {
      if (!e.matches(PyExc_ValueError) && !e.matches(PyExc_OverflowError)) throw;
    }
    refuse(what, "a number that is not finite; give one that is");
  }
  if (py::hasattr(value, "__index__")) return Rational(integer_of(value, what));
  throw py::type_error(what + ": a number is wanted (int, float, str, Fraction, Decimal), not " + kind_of(value));
}

RationalPoint to_rational_point(const py::handle& value, const std::string& what) {
  if (PyUnicode_Check(value.ptr()) || !PySequence_Check(value.ptr()) || py::len(value) != 3)
    throw py::type_error(what + ": a point is wanted, three numbers");
  const auto list = py::reinterpret_borrow<py::sequence>(value);
  return {to_rational(list[0], what), to_rational(list[1], what), to_rational(list[2], what)};
}

void bind_numbers(py::module_& module) {
  module.def(
      "number_text", [](const py::handle& value) { return to_string(to_rational(value, "a number")); },
      "The exact text `p` or `p/q` of a number.");
  module.def("fraction", [](const py::handle& value) { return to_fraction(to_rational(value, "a number")); });
}

}  // namespace cnrg::python
