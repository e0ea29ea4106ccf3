// Space parted by the faces of operands: a General Fuse of a solid for each of their regions and of their sheets.
//
// OpenCASCADE says which parts and faces each argument became; parts that two arguments have in common are there
// once.
#include <BOPAlgo_Builder.hxx>
#include <BRepGProp.hxx>
#include <BRep_Builder.hxx>
#include <GProp_GProps.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS_Compound.hxx>
#include <limits>

#include "bench/peers/built_in.h"
#include "bench/peers/occt_arguments.h"

namespace cnrg::bench {
namespace {

/// Of one argument of the fuse.
struct Origin {
  std::size_t operand;
  std::uint32_t region;  ///< 0: sheets
  TopoDS_Shape shape;
};

std::vector<Origin> origins_of(const std::vector<ParcelledOperand>& operands) {
  std::vector<Origin> origins;
  for (std::size_t k = 0; k < operands.size(); ++k) {
    const auto add = [&](std::uint32_t region, const Model& model) {
      for (const TopoDS_Shape& shape : occt_arguments(model)) origins.push_back({k, region, shape});
    };
    for (std::uint32_t r = 0; r < operands[k].regions.size(); ++r) add(r + 1, operands[k].regions[r].solid);
    add(0, operands[k].sheets);
  }
  return origins;
}

class ArrangementMaker {
 public:
  ArrangementMaker(BOPAlgo_Builder& fuse, TopoDS_Shape parted, const std::vector<ParcelledOperand>& operands)
      : fuse_(fuse), parted_(std::move(parted)), operands_(operands) {}

  Arrangement run(const std::vector<Origin>& origins) {
    add_parts();
    for (const Origin& origin : origins) {
      each_image(origin, TopAbs_SOLID, solids_, [&](int part) { enter(part, origin); });
      each_image(origin, TopAbs_FACE, faces_,
                 [&](int face) { arrangement_.faces[face - 1].of[origin.operand] = 1; });
    }
    return std::move(arrangement_);
  }

 private:
  /// The first one is all that lies outside of solids.
  void add_parts() {
    TopExp::MapShapes(parted_, TopAbs_SOLID, solids_);
    arrangement_.parts.push_back({outside_of_all(), std::numeric_limits<double>::infinity()});
    for (int i = 1; i <= solids_.Extent(); ++i) {
      GProp_GProps properties;
      BRepGProp::VolumeProperties(solids_(i), properties);
      arrangement_.parts.push_back({outside_of_all(), properties.Mass()});
      for (TopExp_Explorer faces(solids_(i), TopAbs_FACE); faces.More(); faces.Next())
        add_side(faces.Current(), static_cast<std::size_t>(i));
    }
  }

  /// What is in no solid of an operand is in its region that lies outside of one.
  std::vector<std::uint32_t> outside_of_all() const {
    std::vector<std::uint32_t> regions;
    for (const ParcelledOperand& operand : operands_) {
      regions.push_back(0);
      for (std::uint32_t r = 0; r < operand.regions.size(); ++r)
        if (operand.regions[r].outside) regions.back() = r + 1;
    }
    return regions;
  }

  /// A face that hangs in a part has no sides.
  void add_side(const TopoDS_Shape& face, std::size_t part) {
    if (face.Orientation() != TopAbs_FORWARD && face.Orientation() != TopAbs_REVERSED) return;
    const int known = faces_.Extent(), number = faces_.Add(face);
    if (number > known) {
      GProp_GProps properties;
      BRepGProp::SurfaceProperties(face, properties);
      arrangement_.faces.push_back({{part, 0}, std::vector<char>(operands_.size()), properties.Mass()});
      return;
    }
    auto& parts = arrangement_.faces[number - 1].parts;
    if (parts[1] != 0) throw Refusal("output", "a face of the result has more than two sides");
    parts[1] = part;
  }

  /// What became of the argument's shapes of a type, as places in a map.
  template <class Visit>
  void each_image(const Origin& origin, TopAbs_ShapeEnum type, const TopTools_IndexedMapOfShape& map,
                  Visit visit) {
    TopTools_IndexedMapOfShape shapes;
    TopExp::MapShapes(origin.shape, type, shapes);
    for (int i = 1; i <= shapes.Extent(); ++i) {
      const TopTools_ListOfShape& images = fuse_.Modified(shapes(i));
      const auto look_up = [&](const TopoDS_Shape& image) {
        if (const int place = map.FindIndex(image); place != 0) visit(place);
      };
      if (images.IsEmpty() && !fuse_.IsDeleted(shapes(i))) look_up(shapes(i));
      for (const TopoDS_Shape& image : images) look_up(image);
    }
  }

  /// A part of a solid is in its region, or no longer in the region that lies outside.
  void enter(int part, const Origin& origin) {
    std::uint32_t& region = arrangement_.parts[part].regions[origin.operand];
    if (!operands_[origin.operand].regions[origin.region - 1].outside) region = origin.region;
    else if (region == origin.region) region = 0;
  }

  BOPAlgo_Builder& fuse_;
  const TopoDS_Shape parted_;
  const std::vector<ParcelledOperand>& operands_;
  TopTools_IndexedMapOfShape solids_, faces_;
  Arrangement arrangement_;
};

/// A fuse takes two arguments or more; fewer are parted already.
TopoDS_Shape parted_space(BOPAlgo_Builder& fuse, const std::vector<Origin>& origins) {
  BRep_Builder builder;
  TopoDS_Compound whole;
  builder.MakeCompound(whole);
  for (const Origin& origin : origins) {
    builder.Add(whole, origin.shape);
    fuse.AddArgument(origin.shape);
  }
  if (origins.size() < 2) return whole;
  fuse.Perform();
  require_no_occt_errors(fuse, "General Fuse");
  return fuse.Shape();
}

}  // namespace

Arrangement arranged_by_occt(const std::vector<ParcelledOperand>& operands) {
  const std::vector<Origin> origins = guarded_occt("input", [&] { return origins_of(operands); });
  BOPAlgo_Builder fuse;
  fuse.SetNonDestructive(true);
  const TopoDS_Shape shape = guarded_occt("General Fuse", [&] { return parted_space(fuse, origins); });
  return guarded_occt("output", [&] { return ArrangementMaker(fuse, shape, operands).run(origins); });
}

}  // namespace cnrg::bench
