// CAD models made by OpenCASCADE and written to files, for the tests of the leaves that read them.
#pragma once

#include <TopoDS_Shape.hxx>
#include <gp_Pnt.hxx>
#include <string>
#include <utility>
#include <vector>

namespace cnrg::cad {

TopoDS_Shape box(const gp_Pnt& low, const gp_Pnt& high);
/// The 4 x 4 x 2 box with a bore of radius 1 through its middle along z.
TopoDS_Shape bored_box();
TopoDS_Shape compound(const std::vector<TopoDS_Shape>& parts);
/// A solid of `outer` with the solid `inner` cut out.
TopoDS_Shape cut(const TopoDS_Shape& outer, const TopoDS_Shape& inner);
/// Parts fused so that they share the faces in which they touch; each stays a solid.
TopoDS_Shape glued(const std::vector<TopoDS_Shape>& solids);
/// A shell of the faces of a shape but for some of them, by their numbers from 0.
TopoDS_Shape shell_of(const TopoDS_Shape& shape, const std::vector<int>& without);
TopoDS_Shape moved(const TopoDS_Shape& shape, double dx, double dy, double dz);

void write_brep(const TopoDS_Shape& shape, const std::string& path);
/// `unit` as OpenCASCADE's setting write.step.unit has it; numbers of the shape are millimetres.
void write_step(const TopoDS_Shape& shape, const std::string& path, const std::string& unit = "MM");
/// An assembly: each part is a product of its name, instanced at offsets in x.
void write_assembly(const std::vector<std::pair<std::string, TopoDS_Shape>>& parts,
                    const std::vector<std::vector<double>>& offsets, const std::string& path);

}  // namespace cnrg::cad
