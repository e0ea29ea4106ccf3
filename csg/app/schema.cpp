// `cnrg schema`.
#include "csg/tree/schema.h"

#include <iostream>

#include "csg/app/commands.h"
#include "csg/app/exit_status.h"
#include "csg/tree/forms.h"

namespace cnrg::app {

int run_schema(bool tables) {
  if (tables) std::cout << key_tables() << std::flush;
  else std::cout << tree_schema() << std::flush;
  return kDone;
}

}  // namespace cnrg::app
