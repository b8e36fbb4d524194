// Copyright (c) 2026 The authors of Curvature_aware_simplification_3.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_TOOLS_STOPWATCH_H
#define CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_TOOLS_STOPWATCH_H

#include <CGAL/Real_timer.h>

namespace CGAL {
namespace Curvature_aware_simplification_3 {
namespace internal {

// Wall time of stages, one after the other
class Stopwatch
{
public:
  Stopwatch() { m_timer.start(); }

  // seconds since the last lap or the start
  double lap()
  {
    const double time = m_timer.time();
    m_timer.reset();
    return time;
  }

private:
  Real_timer m_timer;
};

} // namespace internal
} // namespace Curvature_aware_simplification_3
} // namespace CGAL

#endif // CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_TOOLS_STOPWATCH_H
