// How a picture is asked for in words: `cut` is `x=5`, `camera` is `30,20`, as on the command line and in Python.
//
// Who reads options knows neither files nor trees; a fault names the option as the person wrote it.
#pragma once

#include <string>

#include "csg/picture/draw.h"
#include "csg/picture/paint.h"

namespace cnrg {

/// What the option `color-by` takes: `{material,region,...}`.
std::string color_choices();

/// How one panel of a picture is drawn.
struct PanelOptions {
  std::string caption;
  bool has_caption = false;
  bool ghosts = false;
  DrawOptions draw;
};

/// What people call an option: `--color-by` on the command line, `color_by` as an argument of a function.
class OptionNames {
 public:
  explicit OptionNames(bool of_command_line) : of_command_line_(of_command_line) {}
  std::string operator()(const std::string& option) const;

 private:
  bool of_command_line_;
};

/// Sets an option of panels: camera, cut (more than once), explode, opacity, ghosts (any value), color-by, labels,
/// caption. Throws InputError for another option, and for a value that is not what it takes.
void set_option(PanelOptions& panel, const std::string& option, const std::string& value,
                const OptionNames& names);
/// `640x480`.
PictureSize picture_size(const std::string& value, const OptionNames& names);
/// Throws InputError for options that exclude each other.
void check_options(const PanelOptions& panel, const OptionNames& names);

}  // namespace cnrg
