// Copyright (c) 2026 The authors of Curvature_aware_simplification_3.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_TOOLS_UNINITIALIZED_VECTOR_H
#define CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_TOOLS_UNINITIALIZED_VECTOR_H

#include <boost/core/noinit_adaptor.hpp>

#include <memory>
#include <vector>

namespace CGAL {
namespace Curvature_aware_simplification_3 {
namespace internal {

// For what is written by all threads: who writes first to memory that is new to the process waits
// for it. A std::vector writes zeros when it is made, on one thread.
template <typename T>
using Uninitialized_vector = std::vector<T, boost::noinit_adaptor<std::allocator<T>>>;

} // namespace internal
} // namespace Curvature_aware_simplification_3
} // namespace CGAL

#endif // CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_TOOLS_UNINITIALIZED_VECTOR_H
