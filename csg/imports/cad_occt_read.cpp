// STEP and BREP files through OpenCASCADE.
//
// OpenCASCADE keeps settings for all of a process, reports to its default messenger, which prints, and throws its
// own exceptions. The process is a child that reads one file (cad_occt_child.cpp), so nothing has to be put back.
//
// STEP: lengths are converted to a unit that OpenCASCADE is told before the transfer: that of the file, so that
// coordinates stay as they are written, or the one that the tree asks for. Names of solids are found by what the
// entities of the file became: that of the solid itself, else that of the product that it is (part) of. The
// documents of OpenCASCADE (XCAF) would tell them, too, and bring a viewer with its libraries into every process.
#include <BRepTools.hxx>
#include <BRep_Builder.hxx>
#include <Interface_Check.hxx>
#include <Interface_CheckIterator.hxx>
#include <Interface_InterfaceModel.hxx>
#include <Interface_Static.hxx>
#include <STEPControl_Reader.hxx>
#include <Standard_Failure.hxx>
#include <Standard_OutOfMemory.hxx>
#include <Standard_Version.hxx>
#include <StepBasic_Product.hxx>
#include <StepBasic_ProductDefinition.hxx>
#include <StepBasic_ProductDefinitionFormation.hxx>
#include <StepShape_SolidModel.hxx>
#include <TColStd_SequenceOfAsciiString.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS_Iterator.hxx>
#include <TransferBRep.hxx>
#include <Transfer_TransientProcess.hxx>
#include <XSControl_TransferReader.hxx>
#include <XSControl_WorkSession.hxx>
#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <map>
#include <new>
#include <set>
#include <sstream>

#include "csg/imports/cad_occt.h"
#include "csg/leaves/leaf.h"
#include "csg/text/plugin.h"
#include "kernel/base/error.h"

namespace cnrg {
namespace occt {
namespace {

/// A unit as OpenCASCADE's setting calls it, and as STEP files do.
struct Unit {
  const char *name, *setting;
  std::vector<std::string> in_files;
};
const std::vector<Unit>& units() {
  static const std::vector<Unit> list{{"um", "UM", {"micrometre"}},        {"mm", "MM", {"millimetre"}},
                                      {"cm", "CM", {"centimetre"}},        {"m", "M", {"metre"}},
                                      {"km", "KM", {"kilometre"}},         {"in", "INCH", {"inch", "in"}},
                                      {"ft", "FT", {"foot", "feet", "ft"}}};
  return list;
}

/// The setting for the unit of the model.
std::string unit_of(const CadShape& shape, STEPControl_Reader& reader) {
  for (const Unit& unit : units()) {
    if (shape.unit == unit.name) return unit.setting;
  }
  TColStd_SequenceOfAsciiString lengths, angles, solid_angles;
  reader.FileUnits(lengths, angles, solid_angles);
  std::set<std::string> named;
  for (TCollection_AsciiString name : lengths) {
    name.LowerCase();
    named.insert(name.ToCString());
  }
  if (named.empty()) return "MM";  // what OpenCASCADE takes numbers without a unit for
  if (named.size() == 1) {
    for (const Unit& unit : units()) {
      if (std::find(unit.in_files.begin(), unit.in_files.end(), *named.begin()) != unit.in_files.end())
        return unit.setting;
    }
  }
  std::string list;
  for (const std::string& name : named) list += (list.empty() ? "" : ", ") + name;
  throw InputError(cad_subject(shape) + "its " +
                   (named.size() == 1 ? "unit of length is " : "units of length are ") + list +
                   ": say which one the model has, for example `unit: mm`");
}

/// The names of the solids of a file that was transferred. A shape is the same in all places of an assembly.
class Names {
 public:
  explicit Names(const STEPControl_Reader& reader) : transfer_(reader.WS()->TransferReader()->TransientProcess()) {
    const Handle(Interface_InterfaceModel) model = reader.WS()->Model();
    for (int i = 1; i <= model->NbEntities(); ++i) {
      const Handle(Standard_Transient) entity = model->Value(i);
      if (const auto solid = Handle(StepShape_SolidModel)::DownCast(entity)) add_solid(solid);
      if (const auto product = Handle(StepBasic_ProductDefinition)::DownCast(entity)) add_product(product);
    }
  }

  std::string of(const TopoDS_Shape& solid) const {
    const auto found = names_.find(solid.TShape().get());
    return found == names_.end() ? std::string() : found->second.text;
  }

 private:
  struct Name {
    std::string text;
    std::size_t solids;  ///< how many the named thing has; 0: it is a solid itself
  };

  static std::string text_of(const Handle(TCollection_HAsciiString) & name) {
    return name.IsNull() ? std::string() : std::string(name->ToCString());
  }

  /// Of two names of a solid, that of the thing with fewer solids stays: the part's and not the assembly's.
  void add(const TopoDS_Shape& solid, const Name& name) {
    if (name.text.empty()) return;
    const auto [place, fresh] = names_.try_emplace(solid.TShape().get(), name);
    if (!fresh && name.solids < place->second.solids) place->second = name;
  }

  void add_solid(const Handle(StepShape_SolidModel) & entity) {
    const TopoDS_Shape shape = TransferBRep::ShapeResult(transfer_, entity);
    if (!shape.IsNull() && shape.ShapeType() == TopAbs_SOLID) add(shape, {text_of(entity->Name()), 0});
  }

  void add_product(const Handle(StepBasic_ProductDefinition) & entity) {
    const TopoDS_Shape shape = TransferBRep::ShapeResult(transfer_, entity);
    if (shape.IsNull() || entity->Formation().IsNull() || entity->Formation()->OfProduct().IsNull()) return;
    const std::string text = text_of(entity->Formation()->OfProduct()->Name());
    if (text.empty()) return;
    std::vector<TopoDS_Shape> solids;  // each once, wherever it is
    std::set<const Standard_Transient*> met;
    for (TopExp_Explorer part(shape, TopAbs_SOLID); part.More(); part.Next()) {
      if (met.insert(part.Current().TShape().get()).second) solids.push_back(part.Current());
    }
    for (std::size_t i = 0; i < solids.size(); ++i) {
      add(solids[i], {solids.size() == 1 ? text : text + "." + std::to_string(i + 1), solids.size()});
    }
  }

  Handle(Transfer_TransientProcess) transfer_;
  std::map<const Standard_Transient*, Name> names_;
};

/// What the transfer could not do, as a notice. OpenCASCADE takes a lack of memory for a fault of the file:
/// `errno`, 0 before the transfer, knows better.
void note_failures(const STEPControl_Reader& reader, CadFile& file) {
  Interface_CheckIterator checks = reader.WS()->TransferReader()->LastCheckList();
  std::size_t count = 0;
  std::string first;
  for (checks.Start(); checks.More(); checks.Next()) {
    const Handle(Interface_Check)& check = checks.Value();
    if (check->NbFails() == 0) continue;
    if (count++ == 0) first = "#" + std::to_string(checks.Number()) + ", " + check->CFail(1);
  }
  if (count == 0) return;
  if (errno == ENOMEM) throw std::bad_alloc();
  file.notices.push_back("OpenCASCADE could not transfer " + std::to_string(count) +
                         (count == 1 ? " entity" : " entities") + " of the file (" + first +
                         "): look whether anything is missing");
}

bool is_empty(const TopoDS_Shape& shape) {
  return shape.IsNull() || (shape.ShapeType() == TopAbs_COMPOUND && !TopoDS_Iterator(shape).More());
}

/// A BREP text is whole: OpenCASCADE's reader of one that is cut short may not end. Its last table says how many
/// entries it has, each ends with an asterisk, and the number of the shape itself follows.
bool is_complete(const std::string& brep) {
  const std::string title = "\nTShapes ";
  const std::size_t table = brep.find(title);
  if (table == std::string::npos) return false;
  const std::size_t count = std::strtoull(brep.c_str() + table + title.size(), nullptr, 10);
  const auto begin = brep.begin() + static_cast<std::ptrdiff_t>(table);
  return static_cast<std::size_t>(std::count(begin, brep.end(), '*')) == count &&
         brep.find_first_of("+-", brep.rfind('*')) != std::string::npos;
}

}  // namespace

CadFile read_step(const CadShape& shape, const std::string& content) {
  const std::size_t start = content.find_first_not_of(" \t\r\n");
  if (start == std::string::npos || content.compare(start, 12, "ISO-10303-21") != 0) {
    throw LeafFileError(shape.file, 1, 0, "this is no STEP file: it does not begin with ISO-10303-21; give one");
  }
  STEPControl_Reader reader;
  std::istringstream stream(content);
  if (reader.ReadStream(shape.file.c_str(), stream) != IFSelect_RetDone) {
    throw LeafFileError(shape.file, 0, 0,
                        "OpenCASCADE cannot read this STEP file: it may be cut short; write it "
                        "again");
  }
  require(Interface_Static::SetCVal("xstep.cascade.unit", unit_of(shape, reader).c_str()),
          "OpenCASCADE does not know its own unit of length");
  errno = 0;
  reader.TransferRoots();
  CadFile file;
  file.shape = reader.OneShape();
  note_failures(reader, file);
  if (is_empty(file.shape)) {
    throw InputError(cad_subject(shape) + "there are no shapes in it that OpenCASCADE can transfer" +
                     (file.notices.empty() ? "" : "; " + file.notices[0]) +
                     ": write the part as a boundary representation (AP203, AP214 or AP242)");
  }
  const Names names(reader);
  for (TopExp_Explorer part(file.shape, TopAbs_SOLID); part.More(); part.Next()) {
    file.solids.emplace_back(part.Current(), names.of(part.Current()));
  }
  return file;
}

CadFile read_brep(const CadShape& shape, const std::string& content) {
  if (content.substr(0, 200).find("CASCADE Topology V") == std::string::npos) {
    throw LeafFileError(shape.file, 1, 0,
                        "this is no BREP file as OpenCASCADE writes it in text: `CASCADE "
                        "Topology` is missing at its beginning; give one");
  }
  CadFile file;
  std::istringstream stream(content);
  if (is_complete(content)) BRepTools::Read(file.shape, stream, BRep_Builder());
  if (file.shape.IsNull()) {
    throw LeafFileError(shape.file, 0, 0,
                        "OpenCASCADE cannot read this BREP file: it may be cut short; write it "
                        "again");
  }
  if (is_empty(file.shape))
    throw InputError(cad_subject(shape) + "there are no shapes in it: write the part again");
  return file;
}

}  // namespace occt
}  // namespace cnrg

CNRG_PLUGIN_EXPORT void cnrg_cad_read(const cnrg::CadShape& shape, const std::string& content,
                                      cnrg::CadModel& model) {
  using namespace cnrg;
  try {
    const bool step = shape.format == CadShape::Format::step;
    model = occt::tessellate(shape, step ? occt::read_step(shape, content) : occt::read_brep(shape, content));
  } catch (const Standard_OutOfMemory&) {
    throw std::bad_alloc();
  } catch (const Standard_Failure& failure) {
    const std::string words = failure.GetMessageString() != nullptr ? failure.GetMessageString() : "";
    throw InputError(cad_subject(shape) + "OpenCASCADE fails with " + failure.DynamicType()->Name() +
                     (words.empty() ? "" : ", " + words) +
                     ": write the file again, or repair the part where it was "
                     "made");
  }
}

CNRG_PLUGIN_EXPORT const char* cnrg_cad_version() { return "OpenCASCADE " OCC_VERSION_COMPLETE; }
