#include "tests/campaign/families/families.h"

namespace cnrg::campaign {

Families every_family() {
  Families families;
  add_cubes(families);
  add_nef(families);
  add_values(families);
  add_transforms(families);
  add_volumes(families);
  add_places(families);
  add_betti(families);
  add_moved(families);
  return families;
}

}  // namespace cnrg::campaign
