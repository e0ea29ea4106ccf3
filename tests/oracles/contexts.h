// A node alone and the same node in a larger tree: all that is said of it must be the same
// (csg/SEMANTICS.md#identities).
//
// A case is a subtree, whose last node is the one in question, and contexts: what else the file has, in which
// order its nodes and keys stand, what else is asked for, and how it is evaluated. Trees are kept as pieces of
// text, so that every key of a tree file can be drawn, and a failure is two files that one can hand to the
// program.
#pragma once

#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "csg/evaluate/evaluate.h"
#include "tests/scenes/scene.h"

namespace cnrg::properties {

/// A node of a tree file in pieces that can go one by one.
struct DrawnNode {
  std::string name;
  std::string op;     ///< `union`, `box`, ...
  std::string value;  ///< of a leaf; of an operator `@0` stands for its first operand; empty: a list
  std::vector<std::string> operands;  ///< names
  std::vector<std::string> keys;      ///< `material: rock`, ...
  bool in_place = false;              ///< written where its only user names it
};

enum class Setting : std::uint8_t {
  order,      ///< nodes and keys of the file in another order
  others,     ///< other leaves, near, touching, coplanar, far
  shares,     ///< other nodes over nodes of the subtree
  twins,      ///< leaves of the subtree once more, moved by whole numbers
  copies,     ///< the node once more, moved
  wrapped,    ///< operators on the node
  chain,      ///< the node as the first of a chain of Boolean nodes
  asked,      ///< nodes of the subtree are asked for, too, and each is evaluated by itself
  apart,      ///< every Boolean node that may be is refined by itself
  threads,    ///< two threads
  read_back,  ///< the node's file, read as a leaf, in a tree of its own or beside a box
  mixed,      ///< several of these
};
constexpr std::array<const char*, 12> kSettings{"order", "others", "shares", "twins",   "copies",    "wrapped",
                                                "chain", "asked",  "apart",  "threads", "read_back", "mixed"};

struct NodeContext {
  Setting setting = Setting::order;
  std::vector<DrawnNode> nodes;    ///< besides the subtree, operands before users; the last one is the result
  std::vector<std::string> asked;  ///< kept besides the node
  bool kept = true;                ///< the node is asked for; else it has rows and notices only
  std::uint64_t order = 0;         ///< of nodes and keys; 0: as they are drawn
  Refining refining = Refining::chosen;
  int threads = 1;
  bool raw = false;         ///< of `read_back`: cells as the refinement has them
  bool one_by_one = false;  ///< with the volumes of all regions each node is evaluated by itself
};

struct ContextCase {
  std::vector<std::string> materials;
  std::vector<DrawnNode> subtree;  ///< operands before users; the last one is the node in question
  std::vector<NodeContext> contexts;
  std::string format;  ///< an extension: the file that is compared besides the exact one
};

ContextCase random_context_case(std::uint64_t seed);
/// The tree of the subtree alone, and in a context.
std::string text_alone(const ContextCase& drawn);
std::string text_in(const ContextCase& drawn, const NodeContext& context);
/// All texts of a case, with what is told of each context.
std::string text_of(const ContextCase& drawn);
/// Cases with less in them.
std::vector<ContextCase> smaller(const ContextCase& drawn);

/// Where two trees tell different things of the node: `json /faces/*/origin` and the like, each with an example.
using Disagreements = std::map<std::string, std::string>;
/// By context. Throws TreeError if the subtree is refused alone; a context that is refused elsewhere than in the
/// subtree has no entry.
std::map<std::size_t, Disagreements> disagreements(const ContextCase& drawn);

/// The first disagreement that is not among the known ones, in words; empty if there is none, or if the subtree
/// is refused.
std::string context_failure(const ContextCase& drawn);

/// What is not meant to be the same: an aspect that begins so, of subtrees with one of the words, in one of the
/// settings.
struct KnownDisagreement {
  const char* aspect;
  std::vector<std::string> words;  ///< none: any subtree
  std::set<Setting> settings;      ///< none: any
};
bool is_known(const std::string& aspect, const NodeContext& context, const std::string& subtree);

}  // namespace cnrg::properties
