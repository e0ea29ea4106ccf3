// `cnrg tables` and `cnrg schema`.
#include "csg/operators/tables.h"

#include <iostream>

#include "csg/app/commands.h"
#include "csg/app/exit_status.h"
#include "csg/tree/forms.h"

namespace cnrg::app {

int run_tables() {
  std::cout << tables_markdown() << std::flush;
  return kDone;
}

int run_schema(bool tables) {
  std::cout << (tables ? std::string(key_tables()) : tree_schema()) << std::flush;
  return kDone;
}

}  // namespace cnrg::app
