#include "tests/cad/models.h"

#include <BOPAlgo_Builder.hxx>
#include <BRepAlgoAPI_Cut.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepTools.hxx>
#include <BRep_Builder.hxx>
#include <Interface_Static.hxx>
#include <Message.hxx>
#include <Message_Messenger.hxx>
#include <STEPCAFControl_Writer.hxx>
#include <STEPControl_Writer.hxx>
#include <TDataStd_Name.hxx>
#include <TDocStd_Document.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS_Compound.hxx>
#include <TopoDS_Shell.hxx>
#include <XCAFDoc_DocumentTool.hxx>
#include <XCAFDoc_ShapeTool.hxx>
#include <algorithm>
#include <gp_Ax2.hxx>
#include <gp_Trsf.hxx>

#include "tests/catch.h"

namespace cnrg::cad {

TopoDS_Shape box(const gp_Pnt& low, const gp_Pnt& high) { return BRepPrimAPI_MakeBox(low, high).Shape(); }

TopoDS_Shape bored_box() {
  return cut(box({0, 0, 0}, {4, 4, 2}), BRepPrimAPI_MakeCylinder(gp_Ax2({2, 2, -1}, {0, 0, 1}), 1, 4).Shape());
}

TopoDS_Shape compound(const std::vector<TopoDS_Shape>& parts) {
  TopoDS_Compound result;
  const BRep_Builder builder;
  builder.MakeCompound(result);
  for (const TopoDS_Shape& part : parts) builder.Add(result, part);
  return result;
}

TopoDS_Shape cut(const TopoDS_Shape& outer, const TopoDS_Shape& inner) {
  return BRepAlgoAPI_Cut(outer, inner).Shape();
}

TopoDS_Shape glued(const std::vector<TopoDS_Shape>& solids) {
  BOPAlgo_Builder fuse;
  for (const TopoDS_Shape& solid : solids) fuse.AddArgument(solid);
  fuse.Perform();
  REQUIRE_FALSE(fuse.HasErrors());
  return fuse.Shape();
}

TopoDS_Shape shell_of(const TopoDS_Shape& shape, const std::vector<int>& without) {
  TopTools_IndexedMapOfShape faces;
  TopExp::MapShapes(shape, TopAbs_FACE, faces);
  TopoDS_Shell shell;
  const BRep_Builder builder;
  builder.MakeShell(shell);
  for (int f = 0; f < faces.Extent(); ++f) {
    if (std::find(without.begin(), without.end(), f) == without.end()) builder.Add(shell, faces(f + 1));
  }
  return shell;
}

TopoDS_Shape moved(const TopoDS_Shape& shape, double dx, double dy, double dz) {
  gp_Trsf by;
  by.SetTranslation(gp_Vec(dx, dy, dz));
  return shape.Moved(TopLoc_Location(by));
}

void write_brep(const TopoDS_Shape& shape, const std::string& path) {
  REQUIRE(BRepTools::Write(shape, path.c_str()));
}

void write_step(const TopoDS_Shape& shape, const std::string& path, const std::string& unit) {
  Message::DefaultMessenger()->ChangePrinters().Clear();
  STEPControl_Writer writer;
  REQUIRE(Interface_Static::SetCVal("write.step.unit", unit.c_str()));
  REQUIRE(writer.Transfer(shape, STEPControl_AsIs) == IFSelect_RetDone);
  REQUIRE(writer.Write(path.c_str()) == IFSelect_RetDone);
  REQUIRE(Interface_Static::SetCVal("write.step.unit", "MM"));
}

void write_assembly(const std::vector<std::pair<std::string, TopoDS_Shape>>& parts,
                    const std::vector<std::vector<double>>& offsets, const std::string& path) {
  Message::DefaultMessenger()->ChangePrinters().Clear();
  const Handle(TDocStd_Document) document = new TDocStd_Document("BinXCAF");
  const Handle(XCAFDoc_ShapeTool) tool = XCAFDoc_DocumentTool::ShapeTool(document->Main());
  const TDF_Label assembly = tool->NewShape();
  TDataStd_Name::Set(assembly, "assembly");
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const TDF_Label part = tool->AddShape(parts[i].second, false);
    TDataStd_Name::Set(part, parts[i].first.c_str());
    for (const double dx : offsets[i]) {
      gp_Trsf by;
      by.SetTranslation(gp_Vec(dx, 0, 0));
      tool->AddComponent(assembly, part, TopLoc_Location(by));
    }
  }
  tool->UpdateAssemblies();
  STEPCAFControl_Writer writer;
  writer.SetNameMode(true);
  REQUIRE(writer.Transfer(document));
  REQUIRE(writer.Write(path.c_str()) == IFSelect_RetDone);
}

}  // namespace cnrg::cad
