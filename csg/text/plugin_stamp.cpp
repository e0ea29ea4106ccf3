// In each plug-in: of which build it is.
#include "csg/text/plugin.h"

CNRG_PLUGIN_EXPORT const char* cnrg_plugin_stamp() { return CNRG_PLUGIN_STAMP; }
