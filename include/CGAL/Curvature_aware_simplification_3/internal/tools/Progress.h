// Copyright (c) 2026 The authors of Curvature_aware_simplification_3.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_TOOLS_PROGRESS_H
#define CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_TOOLS_PROGRESS_H

#include <functional>

namespace CGAL {
namespace Curvature_aware_simplification_3 {
namespace internal {

// Thrown through the stages when the user's callback returned false; never leaves the package.
struct Cancelled
{};

// A part [begin, end] of the progress that the user's callback sees.
//
// `Point_set_processing_3::internal::Callback_wrapper` is not used here: in parallel it calls the
// callback on a thread of its own, where an exception thrown by the callback ends the program. Here
// the callback runs on the calling thread, between blocks of a loop, so that it may throw, draw to
// a user interface, or access its own data without a lock.
class Progress
{
public:
  explicit Progress(const std::function<bool(double)>& callback) : Progress(callback, 0., 1.) {}
  explicit Progress(std::function<bool(double)>&&) = delete; // it is referred to

  bool is_observed() const { return static_cast<bool>(m_callback); }

  // `fraction` of this part is done
  void report(double fraction) const
  {
    if (is_observed() && !m_callback(position(fraction)))
      throw Cancelled();
  }

  // the part of this part from `begin` to `end`, both in [0, 1]
  Progress part(double begin, double end) const
  {
    return Progress(m_callback, position(begin), position(end));
  }

  // the part of the i-th of n equal steps
  Progress step(std::size_t i, std::size_t n) const
  {
    return part(static_cast<double>(i) / static_cast<double>(n),
                static_cast<double>(i + 1) / static_cast<double>(n));
  }

private:
  Progress(const std::function<bool(double)>& callback, double begin, double end)
    : m_callback(callback), m_begin(begin), m_end(end)
  {}

  // exact for 0 and 1, so that rounding cannot let the progress fall from one part to the next
  double position(double fraction) const
  {
    return fraction < 1. ? m_begin + fraction * (m_end - m_begin) : m_end;
  }

  const std::function<bool(double)>& m_callback;
  double m_begin;
  double m_end;
};

} // namespace internal
} // namespace Curvature_aware_simplification_3
} // namespace CGAL

#endif // CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_TOOLS_PROGRESS_H
