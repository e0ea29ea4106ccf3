// The commands. Each throws what the libraries throw; main.cpp turns that into messages and exit statuses.
#pragma once

#include <string>
#include <vector>

#include "csg/app/panels.h"
#include "csg/evaluate/evaluate.h"
#include "csg/mesh/surface_triangles.h"
#include "csg/mesh/tetrahedra.h"
#include "csg/tree/tree.h"

namespace cnrg::app {

// What all commands have that read a tree: how it is read, and `finer`, every curved leaf is that many times finer
// than the tree says.

struct EvalArguments {
  std::string tree;
  std::vector<std::string> nodes;
  std::vector<std::string> files;
  std::string select;    ///< criteria of `select`: files show what is picked; empty: all
  PictureWords picture;  ///< options of pictures, and `--node`, in their order
  bool trace = false, raw = false, topology = false, list = false, quiet = false, json = false;
  bool snap = false;        ///< said, though it is the rule
  bool no_snap = false;     ///< files of doubles as they are rounded
  bool binary = false;      ///< .stl and .ply in their binary forms
  bool one_group = false;   ///< .msh with the first group of each element alone
  bool parameters = false;  ///< .json and .vtu with the parameters of patches
  bool certify = false;     ///< uncertain crossings of curved patches are an error
  bool no_certify = false;  ///< nothing is asked of them
  std::string join;         ///< features nearer than this number are joined; empty: none are
  Refining refining = Refining::chosen;
  int threads = 0, finer = 1;
  ReadOptions reading;
};
/// `cnrg eval`: a row per node, a file per `-o`.
int run_eval(const EvalArguments& arguments);

struct CheckArguments {
  std::string tree, node;
  std::string features;  ///< a number: all below it; `true`: the smallest; empty: none are listed
  int threads = 0, finer = 1;
  ReadOptions reading;
};
/// `cnrg check`: reads and validates only; with `features`, evaluates and lists what is small.
int run_check(const CheckArguments& arguments);

struct LocateArguments {
  std::string tree, node;
  bool parameters = false, material = false;
  int threads = 0, finer = 1;
  ReadOptions reading;
};
/// `cnrg locate`: the cell that holds each point of standard input; with `parameters` also its place on patches
/// and curves of leaves, with `material` what it is made of.
int run_locate(const LocateArguments& arguments);

struct ExplainArguments {
  std::string tree, node, cell, point;  ///< one of cell and point is empty
  int threads = 0, finer = 1;
  ReadOptions reading;
};
/// `cnrg explain`: the way of a cell, or of what holds a point, through the tree.
int run_explain(const ExplainArguments& arguments);

struct ViewArguments {
  std::string tree, file;
  std::vector<std::string> nodes;
  bool open = false, watch = false, quiet = false;
  bool certify = false;  ///< as of `eval`
  int threads = 0, finer = 1;
  ReadOptions reading;
};
/// `cnrg view`: a page of all nodes for a browser. With `watch` it ends when somebody ends it.
int run_view(const ViewArguments& arguments);

struct MeshArguments {
  std::string tree, node;
  std::vector<std::string> files;
  TetrahedraOptions options;
  bool snap = false, no_snap = false, quiet = false;     ///< as of `eval`
  bool certify = false, no_certify = false;              ///< as of `eval`
  bool surface = false;                                  ///< triangles on faces, segments on edges, no tetrahedra
  bool quads = false;                                    ///< of `surface`: triangles merged by pairs
  bool one_group = false;                                ///< as of `eval`
  std::size_t max_points = SurfaceOptions{}.max_points;  ///< of `surface`
  std::string join;                                      ///< as of `eval`
  std::string chord;  ///< facets of curved faces become fewer within this distance; empty: they do not
  int threads = 0, finer = 1;
  ReadOptions reading;
};
/// `cnrg mesh`: tetrahedra of the result, a file per `-o`, a row per region.
int run_mesh(const MeshArguments& arguments);

struct CompareArguments {
  std::string a, b, node_a, node_b;
  std::vector<std::string> ignored;  ///< components, materials, names, attributes, features
  bool quiet = false;
  int threads = 0, finer = 1;
  ReadOptions reading;
};
/// `cnrg compare`: what two trees differ in; kDone if they mean the same, else kDifferent.
int run_compare(const CompareArguments& arguments);

/// `cnrg tables`: the tables as the code has them.
int run_tables();

/// `cnrg schema`: the JSON schema of a tree file; with `tables`, its keys in Markdown.
int run_schema(bool tables);

}  // namespace cnrg::app
