// STEP: products and colours are put on what the transfer has made of the parts; see the header.
//
// OpenCASCADE's documents (XCAF) would carry names and colours, too, and bring a viewer with its libraries into
// every process. Nor is a file written here: the text goes to who calls, and appears at its place when it is
// whole.
#include "csg/exports/occt_write.h"

#include <APIHeaderSection_MakeHeader.hxx>
#include <BRepTools.hxx>
#include <Interface_Static.hxx>
#include <Quantity_Color.hxx>
#include <STEPConstruct_Part.hxx>
#include <STEPConstruct_Styles.hxx>
#include <STEPControl_Writer.hxx>
#include <StepData_Protocol.hxx>
#include <StepData_StepModel.hxx>
#include <StepData_StepWriter.hxx>
#include <StepGeom_Placement.hxx>
#include <StepRepr_RepresentationItem.hxx>
#include <StepShape_ShapeDefinitionRepresentation.hxx>
#include <StepShape_ShapeRepresentation.hxx>
#include <StepVisual_Colour.hxx>
#include <StepVisual_MechanicalDesignGeometricPresentationRepresentation.hxx>
#include <StepVisual_PresentationStyleAssignment.hxx>
#include <StepVisual_StyledItem.hxx>
#include <TCollection_HAsciiString.hxx>
#include <TopExp_Explorer.hxx>
#include <TransferBRep.hxx>
#include <TransferBRep_ShapeMapper.hxx>
#include <Transfer_FinderProcess.hxx>
#include <XSControl_TransferWriter.hxx>
#include <XSControl_WorkSession.hxx>
#include <algorithm>
#include <cstdio>
#include <sstream>

#include "kernel/base/error.h"

namespace cnrg::occt {
namespace {

/// How many bytes the character at a place of a UTF-8 text has, line ends in it left out; 0 if it is none. `code`
/// is its number.
std::size_t character(const std::string& text, std::size_t at, std::uint32_t& code) {
  const auto lead = static_cast<unsigned char>(text[at]);
  const std::size_t n = lead < 0x80 ? 1 : lead >= 0xf0 ? 4 : lead >= 0xe0 ? 3 : lead >= 0xc0 ? 2 : 0;
  code = n < 2 ? lead : lead & (0xffu >> (n + 1));
  std::size_t end = at + 1;
  for (std::size_t k = 1; k < n; ++k, ++end) {
    while (end < text.size() && text[end] == '\n') ++end;
    if (end >= text.size() || (static_cast<unsigned char>(text[end]) & 0xc0u) != 0x80) return 0;
    code = code << 6 | (static_cast<unsigned char>(text[end]) & 0x3fu);
  }
  return n == 0 ? 0 : end - at;
}

/// Without control characters and bytes that are no UTF-8.
std::string cleaned(const std::string& name) {
  std::string result;
  std::uint32_t code = 0;
  for (std::size_t i = 0; i < name.size();) {
    const std::size_t n = character(name, i, code);
    result += n == 0 || code < 0x20 || code == 0x7f ? "?" : name.substr(i, n);
    i += std::max<std::size_t>(n, 1);
  }
  return result;
}

/// Characters beyond ASCII as ISO 10303-21 has them, one run of them at a time. OpenCASCADE would double the
/// backslashes of such in a name.
std::string encoded(const std::string& file) {
  std::string result;
  std::size_t width = 0;  // of the characters in a run
  std::uint32_t code = 0;
  for (std::size_t i = 0; i < file.size();) {
    const std::size_t n = character(file, i, code);
    require(n != 0, "exports: a STEP text that is no UTF-8");
    const std::size_t wide = n == 1 ? 0 : code > 0xffff ? 8 : 4;
    if (wide != width) {
      if (width != 0) result += "\\X0\\";
      if (wide != 0) result += wide == 8 ? "\\X4\\" : "\\X2\\";
    }
    width = wide;
    if (wide == 0) {
      result += file[i];
    } else {
      char text[16];
      std::snprintf(text, sizeof text, "%0*X", static_cast<int>(wide), unsigned{code});
      result += text;
    }
    i += n;
  }
  return result;
}

Handle(TCollection_HAsciiString) text_of(const std::string& name) {
  return new TCollection_HAsciiString(cleaned(name).c_str());
}

Quantity_Color color_of(const std::string& hex) {
  unsigned red = 0, green = 0, blue = 0;
  require(std::sscanf(hex.c_str(), "#%2x%2x%2x", &red, &green, &blue) == 3, "exports: a colour that is none");
  const auto part = [](unsigned x) { return static_cast<double>(x) / 255; };
  return {part(red), part(green), part(blue), Quantity_TOC_sRGB};
}

/// Collects the styles that were added in `made`. OpenCASCADE 7.8 asks for the model, too.
template <class Styles, class Made>
void collect(Styles& styles, const Handle(StepRepr_RepresentationContext) & context, Made& made,
             Handle(StepData_StepModel) model) {
  if constexpr (requires { styles.CreateMDGPR(context, made, model); }) styles.CreateMDGPR(context, made, model);
  else styles.CreateMDGPR(context, made);
}

class StepMaker {
 public:
  StepMaker(const CadParts& parts, const CadModelMade& model) : parts_(parts), model_(model) {}

  std::string run() {
    STEPControl_Writer writer;  // whose making makes the settings
    Interface_Static::SetCVal("write.step.unit", "MM");
    Interface_Static::SetCVal("write.step.product.name",
                              cleaned(parts_.name.empty() ? "result" : parts_.name).c_str());
    Interface_Static::SetIVal("write.step.assembly", 1);
    if (writer.Transfer(model_.whole, STEPControl_AsIs) != IFSelect_RetDone)
      throw InputError("OpenCASCADE cannot make STEP entities of the result");
    session_ = writer.WS();
    transfer_ = session_->TransferWriter()->FinderProcess();
    name_whole();
    for (const CadPart& part : model_.parts) name(part);
    return print(writer.Model());
  }

 private:
  const CadParts& parts_;
  const CadModelMade& model_;
  Handle(XSControl_WorkSession) session_;
  Handle(Transfer_FinderProcess) transfer_;
  std::map<std::pair<Component, int>, int> count_;

  bool find(const TopoDS_Shape& shape, STEPConstruct_Part& product) const {
    Handle(StepShape_ShapeDefinitionRepresentation) made;
    const Handle(TransferBRep_ShapeMapper) mapper = TransferBRep::ShapeMapper(transfer_, shape);
    if (!transfer_->FindTypedTransient(mapper, STANDARD_TYPE(StepShape_ShapeDefinitionRepresentation), made))
      return false;
    product.ReadSDR(made);
    return true;
  }

  void name_whole() const {
    STEPConstruct_Part product;
    if (!find(model_.whole, product)) return;
    const auto text = text_of(parts_.name.empty() ? "result" : parts_.name);
    product.SetPid(text);
    product.SetPname(text);
  }

  void name(const CadPart& part) {
    STEPConstruct_Part product;
    if (!find(part.shape, product)) throw InputError("OpenCASCADE makes no STEP product of a part of the result");
    const auto& [component, said] = part.of;
    const TopAbs_ShapeEnum type = part.shape.ShapeType();
    const bool solid = type == TopAbs_SOLID, wire = type == TopAbs_WIRE, point = type == TopAbs_COMPOUND;
    // A part of lower dimension is what is said of it, else its leaves; a component of its own is called so
    // itself.
    const bool by_leaves = !solid && parts_.called_as_leaves.at(component - 1) && !part.leaves.empty();
    CadParts::Attributes of = by_leaves ? CadParts::Attributes() : parts_.components.at(component - 1);
    if (said != FlatComplex::kNone) {
      const CadParts::Attributes& own = parts_.said.at(said);
      if (!own.name.empty()) of.name = own.name;
      if (!own.material.empty()) of.material = own.material, of.color = own.color;
    }
    std::string words = of.name.empty() && by_leaves ? names_of(part.leaves) : of.name;
    if (words.empty())
      words = (solid ? "region " : wire ? "wire " : point ? "points " : "sheet ") + std::to_string(number(part));
    product.SetPid(text_of(words));
    product.SetPname(text_of(words));
    if (!of.material.empty()) product.SetPdescription(text_of("material: " + of.material));
    if (!of.color.empty()) paint(product, color_of(of.color));
  }

  /// Such as `bolt` or `bolt + fault`.
  std::string names_of(const std::set<LeafId>& leaves) const {
    std::map<std::uint32_t, std::string> in_order;
    for (const LeafId leaf : leaves) {
      const LeafInfo& info = parts_.leaves.at(leaf.index());
      in_order.emplace(info.place, info.name);
    }
    std::string result;
    for (const auto& [place, name] : in_order) result += (result.empty() ? "" : " + ") + name;
    return result;
  }

  /// Of a region that of its component, of others one more than of the last one.
  int number(const CadPart& part) {
    if (part.shape.ShapeType() == TopAbs_SOLID) return static_cast<int>(part.of.first);
    const int type = part.shape.ShapeType() == TopAbs_WIRE ? 1 : part.shape.ShapeType() == TopAbs_COMPOUND ? 2 : 0;
    return ++count_[{0, type}];
  }

  void paint(STEPConstruct_Part& product, const Quantity_Color& color) const {
    STEPConstruct_Styles styles(session_);
    const Handle(StepShape_ShapeRepresentation) shape = product.SRValue();
    const Handle(StepVisual_Colour) encoded_color = STEPConstruct_Styles::EncodeColor(color);
    for (int i = 1; i <= shape->NbItems(); ++i) {
      const Handle(StepRepr_RepresentationItem) item = shape->ItemsValue(i);
      if (item->IsKind(STANDARD_TYPE(StepGeom_Placement))) continue;
      styles.AddStyle(item, styles.MakeColorPSA(item, encoded_color, encoded_color, nullptr, 0), nullptr);
    }
    Handle(StepVisual_MechanicalDesignGeometricPresentationRepresentation) made;
    collect(styles, shape->ContextOfItems(), made, Handle(StepData_StepModel)::DownCast(session_->Model()));
    if (!made.IsNull()) session_->Model()->AddWithRefs(made);
  }

  std::string print(const Handle(StepData_StepModel) & model) const {
    APIHeaderSection_MakeHeader header(model);
    header.SetName(text_of(parts_.name.empty() ? "result" : parts_.name));
    header.SetTimeStamp(new TCollection_HAsciiString("1970-01-01T00:00:00"));  // the same file for the same result
    header.SetAuthorValue(1, new TCollection_HAsciiString(""));
    header.SetOrganizationValue(1, new TCollection_HAsciiString(""));
    header.SetOriginatingSystem(new TCollection_HAsciiString("cnrg"));
    StepData_StepWriter writer(model);
    writer.SendModel(Handle(StepData_Protocol)::DownCast(session_->Protocol()));
    std::ostringstream text;
    if (!writer.Print(text)) throw InputError("OpenCASCADE cannot print the STEP entities of the result");
    return encoded(text.str());
  }
};

}  // namespace

std::string step_text(const CadParts& parts, const CadModelMade& model) { return StepMaker(parts, model).run(); }

std::string brep_text(const CadModelMade& model) {
  std::ostringstream text;
  BRepTools::Write(model.whole, text, false, false, TopTools_FormatVersion_VERSION_1);
  return text.str();
}

}  // namespace cnrg::occt
