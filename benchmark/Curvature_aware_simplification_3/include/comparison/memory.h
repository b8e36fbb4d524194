#ifndef CURVATURE_AWARE_SIMPLIFICATION_3_COMPARISON_MEMORY_H
#define CURVATURE_AWARE_SIMPLIFICATION_3_COMPARISON_MEMORY_H

#include <fstream>
#include <string>

namespace comparison {

// A field of the process status in bytes; 0 where there is no such file
inline double status(const std::string& field)
{
  std::ifstream file("/proc/self/status");
  std::string word;
  double kilobytes = 0.;
  while (file >> word)
    if (word == field + ":" && file >> kilobytes)
      return 1024. * kilobytes;
  return 0.;
}

// Peak memory from now on is what VmHWM tells after this.
inline void reset_peak_memory()
{
  std::ofstream("/proc/self/clear_refs") << "5";
}

} // namespace comparison

#endif // CURVATURE_AWARE_SIMPLIFICATION_3_COMPARISON_MEMORY_H
