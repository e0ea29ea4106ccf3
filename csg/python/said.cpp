#include "said.h"

#include "numbers.h"

namespace cnrg::python {

py::dict to_dict(const Properties& properties) {
  py::dict out;
  for (const auto& [key, value] : properties) {
    const Rational* number = std::get_if<Rational>(&value);
    out[text_of(key)] =
        number != nullptr ? to_fraction(*number) : py::object(text_of(std::get<std::string>(value)));
  }
  return out;
}

py::tuple said_of(const Owner& owner, const SaidTable& table) {
  py::list said, columns;
  for (const Attributes& a : table.said) {
    said.append(py::make_tuple(text_of(a.name), text_of(a.material.name()), to_dict(a.properties)));
  }
  for (const SaidTable::Column& column : table.columns) {
    py::list texts;
    for (const std::string& text : column.texts) texts.append(text_of(text));
    const py::array values = column.texts.empty() ? view(owner, column.numbers) : view(owner, column.places);
    columns.append(py::make_tuple(text_of(column.array), texts, values));
  }
  return py::make_tuple(said, columns);
}

}  // namespace cnrg::python
