// Exceptions of the library become those of cnrg/errors.py, which know their place in a file.

#include "bind.h"

namespace cnrg::python {
namespace {

py::object decoded(const std::string& text, const char* otherwise) {
  return py::reinterpret_steal<py::object>(
      PyUnicode_DecodeUTF8(text.data(), static_cast<Py_ssize_t>(text.size()), otherwise));
}

/// An error of a class of cnrg/errors.py. Texts of files are UTF-8 here: what is not was escaped where the message
/// was made.
py::object error_of(const py::object& type, const Fault& fault) {
  return type(decoded(fault.message, "backslashreplace"), decoded(fault.file, "surrogateescape"), fault.at.line,
              fault.at.column);
}

/// Raises an error of a class of cnrg/errors.py, which `make` makes.
template <class Make>
void raise_made(const char* name, Make make) {
  try {
    const py::object type = py::module_::import("cnrg.errors").attr(name);
    const py::object error = make(type);
    PyErr_SetObject(type.ptr(), error.ptr());
  } catch (py::error_already_set& e) {
    e.restore();
  }
}
void raise(const char* name, const std::string& message) {
  raise_made(name, [&](const py::object& type) { return type(decoded(message, "backslashreplace")); });
}
void raise(const char* name, const Placed& placed) {
  raise_made(name, [&](const py::object& type) {
    const py::object error = error_of(type, placed.faults().front());
    py::list more;
    for (std::size_t i = 1; i < placed.faults().size(); ++i) more.append(error_of(type, placed.faults()[i]));
    error.attr("more") = py::tuple(more);
    return error;
  });
}

}  // namespace

void bind_errors(py::module_&) {
  py::register_exception_translator([](std::exception_ptr thrown) {
    try {
      if (thrown) std::rethrow_exception(thrown);
    } catch (const TreeError& e) {
      raise("InputError", static_cast<const Placed&>(e));
    } catch (const TreeFileError& e) {
      raise("FileError", static_cast<const Placed&>(e));
    } catch (const InputError& e) {
      raise("InputError", e.what());
    } catch (const FileError& e) {
      raise("FileError", e.what());
    } catch (const InvariantError& e) {
      raise("InvariantError", e.what());
    } catch (const Stopped&) {
      raise("Stopped", "the work was stopped");
    }
  });
}

}  // namespace cnrg::python
