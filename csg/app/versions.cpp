#include "csg/app/versions.h"

#include <CGAL/version.h>
#include <gmp.h>
#include <mpfr.h>
#include <tbb/version.h>

#include <algorithm>
#include <boost/version.hpp>

#include "csg/imports/mesh_file.h"

namespace cnrg::app {

std::string version_text(const std::string& program, std::span<const Plugin* const> plugins) {
  std::string boost = BOOST_LIB_VERSION;
  std::replace(boost.begin(), boost.end(), '_', '.');
  std::string text = program + " " + CNRG_VERSION + "\nCGAL " + CGAL_VERSION_STR + "\nGMP " + gmp_version +
                     "\nMPFR " + mpfr_get_version() + "\nBoost " + boost + "\noneTBB " + TBB_runtime_version() +
                     "\nyaml-cpp " + CNRG_YAML_VERSION + "\n" + vtp_library();
  for (const Plugin* plugin : plugins) {
    const std::string fault = plugin_fault(*plugin);
    text += "\n" + (fault.empty() ? plugin_version(*plugin) : fault);
  }
  return text;
}

}  // namespace cnrg::app
