#pragma once
#include <cstdlib>
namespace CGAL { namespace Curvature_aware_simplification_3 { namespace internal {
inline double tune(const char* name, double v) { const char* e = std::getenv(name); return e ? std::atof(e) : v; }
} } }
#define TUNE(name, value) static const double name = tune(#name, value)
