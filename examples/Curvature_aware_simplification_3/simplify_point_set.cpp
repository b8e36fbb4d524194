// Command-line tool: simplifies a point set file. `simplify_point_set --help` tells how.

#include <CGAL/Point_set_3.h>
#include <CGAL/Point_set_3/IO.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/curvature_aware_random_simplify_point_set.h>
#include <CGAL/curvature_aware_simplify_point_set.h>

#include <boost/algorithm/string/case_conv.hpp>
#include <boost/algorithm/string/join.hpp>
#include <boost/program_options.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iostream>
#include <iterator>
#include <new>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <string>
#include <system_error>
#include <vector>

#ifdef _WIN32
#include <io.h>
#define isatty _isatty
#define fileno _fileno
#else
#include <unistd.h>
#endif

using Kernel = CGAL::Simple_cartesian<double>;
using Point_set = CGAL::Point_set_3<Kernel::Point_3>;
using Concurrency_tag = CGAL::Parallel_if_available_tag;
namespace fs = std::filesystem;
namespace po = boost::program_options;

struct Options
{
  std::string input;
  std::string output;
  double percentage;
  std::optional<long long> count;
  double adaptivity;
  long long neighbors;
  long long iterations;
  bool settings_of_the_paper;
  double curvature_weight;
  double curvature_dependence;
  std::optional<double> radius;
  unsigned long long seed;
  bool subset;
  bool quiet;
};

// What a user can mend: reported in one line, without more.
struct Error : std::runtime_error
{
  using std::runtime_error::runtime_error;
};

std::optional<Options> read_options(int argc, char* argv[])
{
  Options options;
  po::options_description visible("Options");
  visible.add_options()("help,h", "show this text and exit")(
      "percentage,p", po::value(&options.percentage)->default_value(5.),
      "percentage of points to return, above 0 and at most 100")(
      "count,n", po::value<long long>(), "number of points to return, instead of the percentage")(
      "adaptivity,a", po::value(&options.adaptivity)->default_value(2. / 3., "0.667"),
      "dependence of the density on the curvature, from 0 to 1; 0: uniform")(
      "neighbors,k", po::value(&options.neighbors)->default_value(16),
      "number of neighbors that tell outliers and curvature; more for large clusters of outliers")(
      "iterations,i", po::value(&options.iterations)->default_value(10),
      "number of iterations of the relaxation")(
      "seed,s", po::value(&options.seed)->default_value(0), "seed of the random numbers")(
      "subset", po::bool_switch(&options.subset),
      "select points of the input with all their properties, and do not move them; without, "
      "normals, colors and other properties are not written")(
      "quiet,q", po::bool_switch(&options.quiet), "print nothing but errors");
  po::options_description paper("With the settings of the paper");
  paper.add_options()("paper", po::bool_switch(&options.settings_of_the_paper),
                      "the literal method of the paper, for comparison")(
      "curvature-weight,w", po::value(&options.curvature_weight)->default_value(0.75),
      "weight of the curvature in the selection, from 0 to 1; also with --subset")(
      "curvature-dependence,d", po::value(&options.curvature_dependence)->default_value(2.),
      "dependence of the relaxation on the curvature, at least 0; 0: none")(
      "radius,r", po::value<double>(),
      "radius of the neighborhoods, in the unit of the file; default: twice the spacing of the "
      "output");
  visible.add(paper);
  po::options_description all;
  all.add(visible).add_options()("input", po::value(&options.input)->required())(
      "output", po::value(&options.output)->required());
  po::positional_options_description positions;
  positions.add("input", 1).add("output", 1);

  try
  {
    po::variables_map values;
    po::store(po::command_line_parser(argc, argv).options(all).positional(positions).run(), values);
    if (values.count("help") != 0)
    {
      std::cout
          << "Usage: simplify_point_set [options] INPUT OUTPUT\n\n"
          << "Simplifies a point set: dense where the surface bends, sparse where it is flat.\n"
          << "Formats by extension: ply, xyz, off"
#ifdef CGAL_LINKED_WITH_LASLIB
          << ", las"
#endif
          << "; INPUT also pwn. Of a mesh, the vertices are taken.\n\n"
          << visible;
      return std::nullopt;
    }
    po::notify(values);
    if (values.count("count") != 0)
      options.count = values["count"].as<long long>();
    if (values.count("radius") != 0)
      options.radius = values["radius"].as<double>();
    const auto is_given = [&](const char* name) {
      return values.count(name) != 0 && !values[name].defaulted();
    };
    if (is_given("curvature-weight") && !options.settings_of_the_paper && !options.subset)
      throw Error("--curvature-weight needs --paper or --subset; see simplify_point_set --help");
    if (is_given("iterations") && options.subset)
      throw Error(
          "--iterations needs points that move, without --subset; see simplify_point_set --help");
    for (const char* name : {"curvature-dependence", "radius"})
      if (is_given(name) && (!options.settings_of_the_paper || options.subset))
        throw Error(std::string("--") + name +
                    " needs --paper without --subset; see simplify_point_set --help");
  }
  catch (const po::error& error)
  {
    throw Error(std::string(error.what()) + "; see simplify_point_set --help");
  }
  return options;
}

std::string extension(const std::string& filename)
{
  const std::string with_point =
      boost::algorithm::to_lower_copy(fs::path(filename).extension().string());
  return with_point.empty() ? with_point : with_point.substr(1);
}

bool is_supported(const std::string& extension)
{
#ifdef CGAL_LINKED_WITH_LASLIB
  if (extension == "las")
    return true;
#endif
  return extension == "ply" || extension == "xyz" || extension == "off";
}

Point_set read(const std::string& filename)
{
  if (!is_supported(extension(filename)) && extension(filename) != "pwn")
    throw Error("cannot read " + filename + ": unknown format '" + extension(filename) + "'");
  if (!std::ifstream(filename, std::ios::binary).good() || fs::is_directory(filename))
    throw Error("cannot open " + filename);

  // CGAL's readers print what is wrong to std::cerr; its first line becomes part of our message.
  std::ostringstream details;
  std::streambuf* const standard_error = std::cerr.rdbuf(details.rdbuf());
  Point_set points;
  bool is_read = false;
  try
  {
    is_read = CGAL::IO::read_point_set(filename, points);
  }
  catch (const std::bad_alloc&) // is no matter of the file's format
  {
    std::cerr.rdbuf(standard_error);
    throw;
  }
  catch (...)
  {}
  std::cerr.rdbuf(standard_error);

  if (!is_read)
  {
    const std::string text = details.str();
    const std::string line = text.substr(0, text.find('\n'));
    throw Error("cannot read " + filename + (line.empty() ? "" : ": " + line));
  }
  if (points.is_empty())
    throw Error(filename + " holds no points");
  return points;
}

// Fails before the work rather than after it.
void check_output(const std::string& filename)
{
  if (!is_supported(extension(filename)))
    throw Error("cannot write " + filename + ": unknown format '" + extension(filename) + "'");
  const fs::path folder = fs::absolute(filename).parent_path();
  if (!fs::is_directory(folder))
    throw Error("cannot write " + filename + ": no folder " + folder.string());
  if (fs::is_directory(filename))
    throw Error("cannot write " + filename + ": it is a folder");
}

// Text in full precision; ply as binary
bool write(std::ostream& stream, const std::string& format, Point_set& points)
{
  const auto precision = CGAL::parameters::stream_precision(17);
  if (format == "ply")
  {
    CGAL::IO::set_binary_mode(stream);
    return CGAL::IO::write_PLY(stream, points);
  }
#ifdef CGAL_LINKED_WITH_LASLIB
  if (format == "las")
    return CGAL::IO::write_LAS(stream, points);
#endif
  if (!points.has_normal_map())
  {
    // as a plain range: CGAL 5.5 reads the normals of a Point_set_3 in any case
    const std::vector<Kernel::Point_3> range(points.points().begin(), points.points().end());
    return format == "off" ? CGAL::IO::write_OFF(stream, range, precision)
                           : CGAL::IO::write_XYZ(stream, range, precision);
  }
  return format == "off" ? CGAL::IO::write_OFF(stream, points, precision)
                         : CGAL::IO::write_XYZ(stream, points, precision);
}

// What a link leads to, whether it is there yet or not
fs::path target_of(fs::path path)
{
  while (fs::is_symlink(path) && !fs::exists(path))
    path = path.parent_path() / fs::read_symlink(path);
  return fs::exists(path) ? fs::canonical(path) : path;
}

// Writes beside the output and renames, so that there is the whole file or none. What a link leads
// to is replaced, and not the link; a file that is there keeps its permissions.
void write(const std::string& filename, Point_set& points)
{
  const fs::path path = target_of(filename);
  const fs::path partial = fs::path(path).replace_filename("." + path.stem().string() + ".partial" +
                                                           path.extension().string());
  std::error_code failure;
  bool is_written = false;
  {
    std::ofstream stream(partial, std::ios::binary);
    is_written = write(stream, extension(filename), points);
    stream.flush();
    is_written = is_written && stream.good();
  }
  if (is_written && fs::exists(path))
    fs::permissions(partial, fs::status(path).permissions(), failure);
  if (is_written)
    fs::rename(partial, path, failure);
  if (!is_written || failure)
  {
    fs::remove(partial, failure);
    throw Error("cannot write " + filename);
  }
}

// One line that grows, for people who watch
bool show_progress(double progress)
{
  const std::size_t length = 50;
  const std::size_t done = static_cast<std::size_t>(progress * length);
  std::cerr << "\r[" << std::string(done, '#') << std::string(length - done, '.') << "] "
            << std::lround(100. * progress) << " %" << (progress < 1. ? "" : "\n") << std::flush;
  return true;
}

void print(const CGAL::Curvature_aware_simplification_report& report)
{
  std::cout << "spacing    " << report.output_spacing << "\n"
            << "depth step " << report.depth_step << "\n"
            << "merged     " << report.number_of_merged_points << "\n"
            << "outliers   " << report.number_of_outliers << "\n"
            << "noise      " << report.noise_level << "\n"
            << "time of\n"
            << "  sorting    " << report.sorting_time << " s\n"
            << "  features   " << report.features_time << " s\n"
            << "  outliers   " << report.outliers_time << " s\n"
            << "  noise      " << report.noise_time << " s\n"
            << "  smoothing  " << report.smoothing_time << " s\n"
            << "  selection  " << report.selection_time << " s\n"
            << "  relaxation " << report.relaxation_time << " s\n"
            << "  projection " << report.projection_time << " s\n";
}

// What the file tells of the points besides where they are
std::string other_properties(const Point_set& points)
{
  std::vector<std::string> names = points.properties();
  names.erase(
      std::remove_if(names.begin(), names.end(),
                     [](const std::string& name) { return name == "index" || name == "point"; }),
      names.end());
  return boost::algorithm::join(names, ", ");
}

template <typename NamedParameters>
Point_set simplify(const Point_set& points, const Options& options, const NamedParameters& np)
{
  Point_set output;
  if (options.subset)
  {
    std::vector<Point_set::Index> selected;
    CGAL::curvature_aware_random_simplify_point_set<Concurrency_tag>(
        points, std::back_inserter(selected), np);
    output.copy_properties(points);
    for (const Point_set::Index& index : selected)
      output.insert(points, index);
    return output;
  }

  CGAL::Curvature_aware_simplification_report report;
  const auto with_report = np.simplification_report(std::ref(report));
  if (options.radius)
    CGAL::curvature_aware_simplify_point_set<Concurrency_tag>(
        points, output.point_back_inserter(), with_report.neighbor_radius(*options.radius));
  else
    CGAL::curvature_aware_simplify_point_set<Concurrency_tag>(points, output.point_back_inserter(),
                                                              with_report);
  if (!options.quiet)
    print(report);
  return output;
}

void run(const Options& options)
{
  check_output(options.output);
  const Point_set points = read(options.input);
  if (!options.quiet)
    std::cout << "points     " << points.size() << std::endl;
  const std::string others = other_properties(points);
  if (!options.quiet && !options.subset && !others.empty())
    std::cout << "left out   " << others << "; points that move have none, see --subset"
              << std::endl;

  const std::function<bool(double)> callback =
      !options.quiet && isatty(fileno(stderr)) != 0 ? show_progress : std::function<bool(double)>();
  const auto np = CGAL::parameters::select_percentage(options.percentage)
                      .curvature_weight(options.curvature_weight)
                      .curvature_dependence(options.curvature_dependence)
                      .adaptivity(options.adaptivity)
                      .settings_of_the_paper(options.settings_of_the_paper)
                      .number_of_neighbors(options.neighbors)
                      .number_of_iterations(options.iterations)
                      .random_seed(options.seed)
                      .callback(callback);
  Point_set output = options.count
                         ? simplify(points, options, np.number_of_output_points(*options.count))
                         : simplify(points, options, np);
  write(options.output, output);
  if (!options.quiet)
    std::cout << "returned   " << output.size() << std::endl;
}

int main(int argc, char* argv[])
{
  try
  {
    if (const std::optional<Options> options = read_options(argc, argv))
      run(*options);
    return EXIT_SUCCESS;
  }
  catch (const std::exception& error)
  {
    std::cerr << "simplify_point_set: " << error.what() << std::endl;
    return EXIT_FAILURE;
  }
}
