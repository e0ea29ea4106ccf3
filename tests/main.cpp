// The main program of all rooms, where Catch2 is version 2.
#define CATCH_CONFIG_MAIN
#include "tests/catch.h"
