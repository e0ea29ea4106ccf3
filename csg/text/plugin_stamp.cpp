// The stamp of a plug-in: the build that it belongs to, which the program compares with its own.
#include "csg/text/plugin.h"

CNRG_PLUGIN_EXPORT const char* cnrg_plugin_stamp() { return CNRG_PLUGIN_STAMP; }
