// `cnrg tables` and `cnrg --version`.
#include "csg/operators/tables.h"

#include <CGAL/version.h>
#include <gmp.h>
#include <mpfr.h>
#include <tbb/version.h>

#include <algorithm>
#include <boost/version.hpp>
#include <iostream>

#include "csg/app/commands.h"
#include "csg/app/exit_status.h"
#include "csg/imports/cad_model.h"

namespace cnrg::app {

int run_tables() {
  std::cout << tables_markdown() << std::flush;
  return kDone;
}

std::string version_text() {
  std::string boost = BOOST_LIB_VERSION;
  std::replace(boost.begin(), boost.end(), '_', '.');
  const std::string cad = cad_library();
  return std::string("cnrg ") + CNRG_VERSION + "\nCGAL " + CGAL_VERSION_STR + "\nGMP " + gmp_version + "\nMPFR " +
         mpfr_get_version() + "\nBoost " + boost + "\noneTBB " + TBB_runtime_version() + "\nyaml-cpp " +
         CNRG_YAML_VERSION + "\nTetGen " + CNRG_TETGEN_VERSION + "\n" +
         (cad.empty() ? "without OpenCASCADE: STEP and BREP files are neither read nor written" : cad);
}

}  // namespace cnrg::app
