// `cnrg schema`.
#include "csg/tree/schema.h"

#include <iostream>

#include "csg/app/commands.h"
#include "csg/app/exit_status.h"

namespace cnrg::app {

int run_schema(bool tables) {
  std::cout << (tables ? key_tables() : tree_schema()) << std::flush;
  return kDone;
}

}  // namespace cnrg::app
