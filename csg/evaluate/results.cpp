// A result from a kept value; it shares its data with the evaluation.
#include <algorithm>

#include "csg/certify/certificate.h"
#include "csg/evaluate/evaluate.h"
#include "csg/evaluate/leaf_numbers.h"
#include "csg/operators/node_value.h"
#include "csg/result/result_data.h"

namespace cnrg {
namespace {

Result result_of(const Evaluation& evaluation, const KeptValue& kept) {
  auto data = std::make_shared<Result::Data>();
  data->complex = evaluation.complex;
  data->value = kept.value;
  data->simplified = kept.simplified.share();
  data->parameters = evaluation.parameters;
  data->raw = evaluation.raw;
  data->volume_bound = kept.volume_bound;
  data->name({kept.name, evaluation.leaf_names, evaluation.materials});
  evaluation.leaves->tell(data->leaves);
  for (LeafInfo& leaf : data->leaves) leaf.place = LeafInfo::kNoPlace;
  std::uint32_t place = 0;
  for (const LeafId leaf : evaluation.leaves->in_order(evaluation.instances, kept.instance))
    data->leaves[leaf.index()].place = place++;
  for (std::size_t i = 0; i < kept.sizes.size(); ++i) data->leaves[kept.leaves[i].index()].size = kept.sizes[i];
  return Result(std::move(data));
}

}  // namespace

bool is_below(const Evaluation& evaluation, const KeptValue& kept, const UncertainPlace& place) {
  return std::ranges::all_of(place.nodes, [&](NodeId node) {
    return std::ranges::any_of(kept.leaves, [&](LeafId leaf) { return evaluation.leaves->node_of(leaf) == node; });
  });
}

Certificate certificate_of(const Evaluation& evaluation, NodeId node) {
  for (const Evaluation& other : evaluation.others) {
    if (other.kept.front().node == node) return certificate_of(other, node);
  }
  const KeptValue& kept = evaluation.value(node);
  if (!evaluation.certificate) return {};
  Certificate of = *evaluation.certificate;
  std::erase_if(of.places, [&](const UncertainPlace& place) { return !is_below(evaluation, kept, place); });
  std::erase_if(of.unknown, [&](NodeId leaf) {
    return std::ranges::none_of(kept.leaves, [&](LeafId one) { return evaluation.leaves->node_of(one) == leaf; });
  });
  return of;
}

const Group& KeptValue::group() const { return value->group(); }

Result Evaluation::result() const { return result_of(*this, kept.front()); }

Result Evaluation::result(NodeId node) const {
  for (const Evaluation& other : others) {
    if (other.kept.front().node == node) return other.result();
  }
  return result_of(*this, value(node));
}

Result Evaluation::result(const std::string& name) const {
  const auto is_it = [&](const KeptValue& k) { return k.name == name; };
  if (const auto it = std::find_if(kept.begin(), kept.end(), is_it); it != kept.end())
    return result_of(*this, *it);
  for (const Evaluation& other : others) {
    if (is_it(other.kept.front())) return other.result();
  }
  throw InputError("the node `" + name + "` was not kept; name it in EvaluateOptions::nodes");
}

}  // namespace cnrg
