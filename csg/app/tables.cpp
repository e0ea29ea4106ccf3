// `cnrg tables`.
#include "csg/operators/tables.h"

#include <iostream>

#include "csg/app/commands.h"
#include "csg/app/exit_status.h"

namespace cnrg::app {

int run_tables() {
  std::cout << tables_markdown() << std::flush;
  return kDone;
}

}  // namespace cnrg::app
