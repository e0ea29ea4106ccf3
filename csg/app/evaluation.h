// One way for all commands to read a tree and to evaluate it: with a progress bar, and with the warnings and notes
// about the tree on standard error.
#pragma once

#include <string>
#include <vector>

#include "csg/app/stopwatch.h"
#include "csg/evaluate/evaluate.h"
#include "csg/tree/tree.h"

namespace cnrg::app {

/// Reads a tree file, or for `-` standard input, and makes its curved leaves as fine as asked for. An exact
/// result, a mesh or a CAD model is a tree of one leaf.
Tree tree_of(const std::string& path, const ReadOptions& reading, int finer);

/// The tree of a command.
template <class Arguments>
Tree tree_of(const Arguments& arguments) {
  return tree_of(arguments.tree, arguments.reading, arguments.finer);
}

/// The node that an option names; the result where it is not given.
NodeId node_of(const Tree& tree, const std::string& name, const char* option = "--node");

/// No more threads than asked for until the program ends; 0: as many as there are.
void limit_threads(int threads);

/// Of the options --certify and --no-certify.
inline AskedProof asked_proof(bool certify, bool no_certify) {
  return certify ? AskedProof::to_the_end : no_certify ? AskedProof::none : AskedProof::within_budget;
}

/// Evaluates behind a progress bar and prints the diagnostics; `quiet`: no bar, warnings only. The clock is told
/// of the stages `leaves`, `refinement` and `nodes`.
Evaluation evaluate_in_view(const Tree& tree, EvaluateOptions options, bool quiet, StageClock* clock = nullptr);

/// Notices of the first places where curved patches of different leaves may not cross as their facets do. True if
/// there was anything to look at.
bool tell_uncertain(const Tree& tree, const Evaluation& evaluation, bool quiet);
/// Proves that there are none, or throws TreeError, with notices of the first ones.
bool require_certain(const Tree& tree, const Evaluation& evaluation, bool quiet);

/// Runs `work`; an InputError that it throws, such as of a format that cannot show the node, comes out as
/// TreeError at the node.
template <class Work>
auto at_node(const Tree& tree, NodeId node, Work work) {
  try {
    return work();
  } catch (const InputError& e) {
    throw TreeError(tree.file, tree.nodes[node].at, e.what());
  }
}

/// InputError when a file to be written is given twice, by whatever names: only one of the two could stay.
void require_distinct(const std::vector<std::string>& files);

/// Before the work: FileError when a file is to be written into a folder that is not there, InputError when it is
/// the tree or one that the tree reads, a slip that would destroy it.
void require_writable(const std::vector<std::string>& files, const Tree& tree);

/// Diagnostics on standard error; `quiet`: warnings only.
void print(const std::vector<Diagnostic>& diagnostics, bool quiet);

}  // namespace cnrg::app
