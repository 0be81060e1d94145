#define DOCTEST_CONFIG_IMPLEMENT_WITH_MAIN
#define DOCTEST_CONFIG_IMPLEMENT  // the header may have been included before, precompiled
#include <doctest/doctest.h>
