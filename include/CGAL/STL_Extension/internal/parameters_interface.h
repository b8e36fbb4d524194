// no include guard: X-macro file, included three times by Named_function_parameters.h
//
// Copyright (c) 2026 The authors of Curvature_aware_simplification_3.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Appends this package's named parameters to CGAL's own list. In CGAL itself, the lines between
// the two markers below are simply added to the file of the same name, and this file disappears.

#if defined(__GNUC__)
#pragma GCC system_header // #include_next is an extension, which -Wpedantic would report
#endif

// When two copies of this package are on the include path (a source tree and an installation), the
// outermost appends, the inner one passes through.
#ifndef CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_IN_PARAMETERS_INTERFACE
#define CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_IN_PARAMETERS_INTERFACE

#if defined(CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_NEXT_PARAMETERS_INTERFACE)
// compilers without #include_next: CMakeLists.txt defines this to the path of CGAL's file
#include CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_NEXT_PARAMETERS_INTERFACE
#else
#include_next <CGAL/STL_Extension/internal/parameters_interface.h>
#endif

// which clang-format would take for one statement:
// clang-format off
// begin: Curvature_aware_simplification_3
CGAL_add_named_parameter(curvature_weight_t, curvature_weight, curvature_weight)
CGAL_add_named_parameter(curvature_dependence_t, curvature_dependence, curvature_dependence)
CGAL_add_named_parameter(adaptivity_t, adaptivity, adaptivity)
CGAL_add_named_parameter(number_of_neighbors_t, number_of_neighbors, number_of_neighbors)
CGAL_add_named_parameter(repulsion_weight_t, repulsion_weight, repulsion_weight)
CGAL_add_named_parameter(recompute_curvature_t, recompute_curvature, recompute_curvature)
CGAL_add_named_parameter(settings_of_the_paper_t, settings_of_the_paper, settings_of_the_paper)
CGAL_add_named_parameter(simplification_report_t, simplification_report, simplification_report)
// end: Curvature_aware_simplification_3
// clang-format on

#undef CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_IN_PARAMETERS_INTERFACE
#else
#include_next <CGAL/STL_Extension/internal/parameters_interface.h>
#endif

// tells the public headers that the list above is the one that was read
#ifndef CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_NAMED_PARAMETERS
#define CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_NAMED_PARAMETERS 1
#endif
