// Exceptions of the library become those of cnrg/errors.py, which know their place in a file.
#include <new>

#include "bind.h"

namespace cnrg::python {
namespace {

/// Raises a class of cnrg/errors.py.
void raise(const char* name, const std::string& message, const py::object& file = py::none(), int line = 0,
           int column = 0) {
  try {
    const py::object type = py::module_::import("cnrg.errors").attr(name);
    // Texts of files are UTF-8 here: what is not was escaped where the message was made.
    const py::object text = py::reinterpret_steal<py::object>(
        PyUnicode_DecodeUTF8(message.data(), static_cast<Py_ssize_t>(message.size()), "backslashreplace"));
    const py::object error = type(text, file, line == 0 ? py::none() : py::object(py::int_(line)),
                                  column == 0 ? py::none() : py::object(py::int_(column)));
    PyErr_SetObject(type.ptr(), error.ptr());
  } catch (py::error_already_set& e) {
    e.restore();
  }
}

}  // namespace

void bind_errors(py::module_&) {
  py::register_exception_translator([](std::exception_ptr thrown) {
    try {
      if (thrown) std::rethrow_exception(thrown);
    } catch (const TreeError& e) {
      const py::object file = py::reinterpret_steal<py::object>(
          PyUnicode_DecodeUTF8(e.file().data(), static_cast<Py_ssize_t>(e.file().size()), "surrogateescape"));
      raise("InputError", e.message(), file, e.line(), e.column());
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
