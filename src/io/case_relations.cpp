#include "io/case_sections.hpp"

#include <floe/io/case_file.hpp>
#include <floe/response/stations.hpp>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

namespace floe::io {
namespace {

// The place of a name in a list; refuses one that is not there, with the nearest
std::size_t place_of(const toml::node& node, const std::vector<std::string>& known,
                     const std::string& full, const std::string& required,
                     const CaseSource& source) {
  const auto* text = node.as_string();
  const auto at = std::find(known.begin(), known.end(), text ? text->get() : "");
  if (text && at != known.end()) return static_cast<std::size_t>(at - known.begin());
  const std::string nearest = text ? nearest_name(text->get(), known) : "";
  source.refuse(node.source(),
                fmt::format("invalid {} = {} ({})", full, shown(node),
                            nearest.empty() ? required : fmt::format("did you mean {}?", nearest)));
}

// What can be named at the points of a case
class Names {
 public:
  Names(const Case& data, const CaseSource& source) : source_(source) {
    for (const NamedPoint& point : data.points) points_.push_back(point.name);
    for (const response::Quantity quantity : data.quantities)
      quantities_.emplace_back(response::name(quantity));
  }

  std::size_t point(const toml::node& node, const std::string& full) const {
    return place_of(node, points_, full, "must be one of output.points", source_);
  }
  std::size_t quantity(const toml::node& node, const std::string& full) const {
    return place_of(node, quantities_, full, "must be one of output.quantities", source_);
  }
  // Two elements of a list from `first`: a point and a quantity
  PointQuantity pair(const toml::array& list, std::size_t first, const std::string& full) const {
    return {point(list[first], fmt::format("{}[{}]", full, first)),
            quantity(list[first + 1], fmt::format("{}[{}]", full, first + 1))};
  }

 private:
  std::vector<std::string> points_, quantities_;
  const CaseSource& source_;  // borrowed
};

// A list of lists of so many elements
const toml::array& list_of_lists(const toml::node& node, std::size_t length,
                                 const std::string& full, const std::string& required,
                                 const CaseSource& source) {
  const toml::array* list = node.as_array();
  const bool good = list && std::all_of(list->begin(), list->end(), [&](const toml::node& element) {
                      return element.is_array() && element.as_array()->size() == length;
                    });
  if (!good)
    source.refuse(node.source(), fmt::format("invalid {} = {} ({})", full, shown(node), required));
  return *list;
}

std::vector<QuantityPair> read_pairs(const Section& output, const Names& names) {
  const std::string full = output.full_name("cross_spectra");
  std::vector<QuantityPair> pairs;
  for (const toml::node& element : list_of_lists(
           *output.find("cross_spectra"), 4, full,
           "must be lists [\"POINT\", \"QUANTITY\", \"POINT\", \"QUANTITY\"]", output.source())) {
    const std::string name = fmt::format("{}[{}]", full, pairs.size());
    pairs.push_back(
        {names.pair(*element.as_array(), 0, name), names.pair(*element.as_array(), 2, name)});
  }
  return pairs;
}

std::vector<CombinationTerm> read_terms(const Section& combination, const Names& names) {
  const std::string full = combination.full_name("terms");
  const NumberRule rule{"", "must be finite and not 0",
                        [](double x) { return std::isfinite(x) && x != 0.0; }};
  std::vector<CombinationTerm> terms;
  for (const toml::node& element :
       list_of_lists(*combination.find("terms"), 3, full,
                     "must be lists [\"POINT\", \"QUANTITY\", factor]", combination.source())) {
    const std::string name = fmt::format("{}[{}]", full, terms.size());
    const toml::array& list = *element.as_array();
    terms.push_back({names.pair(list, 0, name),
                     checked_number(list[2], name + "[2]", rule, combination.source())});
  }
  if (terms.empty())
    combination.source().refuse(combination.find("terms")->source(),
                                fmt::format("invalid {} = [] (must hold a term)", full));
  return terms;
}

// Of the plate at every point; by the regions of its mesh where there are any
std::vector<double> thickness_at_points(const Case& data) {
  std::vector<double> thickness(data.points.size(), data.plate.thickness);
  if (data.regions.empty()) return thickness;
  const mesh::MeshFile file = load_mesh(plate_source(data));
  const plate::PlateRegions regions = plate_regions(data, file.mesh.element_count(), file.groups);
  Points2 positions(2, std::ssize(data.points));
  std::vector<std::string> names;
  for (const NamedPoint& point : data.points) {
    positions.col(std::ssize(names)) = point.position;
    names.push_back(point.name);
  }
  const std::vector<Index> elements = response::elements_at(file.mesh, positions, names);
  for (std::size_t i = 0; i < thickness.size(); ++i)
    thickness[i] = regions.of(elements[i]).thickness;
  return thickness;
}

// σx, σy and τ = 6 Mxy / t² at the upper side of a point
std::vector<CombinationTerm> von_mises_terms(const Section& combination, const Names& names,
                                             const Case& data) {
  const toml::node& node = *combination.find("von_mises");
  const std::string full = combination.full_name("von_mises");
  const std::size_t point = names.point(node, full);
  const double thickness = thickness_at_points(data)[point];
  std::vector<CombinationTerm> terms;
  for (const auto& [quantity, factor] :
       {std::pair{response::Quantity::kSurfaceStressX, 1.0},
        std::pair{response::Quantity::kSurfaceStressY, 1.0},
        std::pair{response::Quantity::kTwistingMoment, 6.0 / (thickness * thickness)}}) {
    const auto at = std::find(data.quantities.begin(), data.quantities.end(), quantity);
    if (at == data.quantities.end())
      combination.source().refuse(
          node.source(), fmt::format("invalid {} = {} (output.quantities must hold {} for it)",
                                     full, shown(node), response::name(quantity)));
    terms.push_back({{point, static_cast<std::size_t>(at - data.quantities.begin())}, factor});
  }
  return terms;
}

Combination read_combination(const Section& combination, std::string name, const Names& names,
                             const Case& data) {
  const bool terms = combination.find("terms"), von_mises = combination.find("von_mises");
  if (terms == von_mises)
    combination.source().refuse(
        combination.place(),
        fmt::format("invalid {} (must have exactly one of terms, von_mises)", combination.name()));
  if (terms) return {std::move(name), Combination::Kind::kSum, read_terms(combination, names)};
  return {std::move(name), Combination::Kind::kVonMises, von_mises_terms(combination, names, data)};
}

}  // namespace

void read_relations(const Section& output, Case& data) {
  const Names names(data, output.source());
  if (output.find("cross_spectra")) data.relations.pairs = read_pairs(output, names);
  if (const toml::node* node = output.find("node_spectra")) {
    if (!node->is_boolean())
      output.source().refuse(node->source(),
                             fmt::format("invalid {} = {} (must be true or false)",
                                         output.full_name("node_spectra"), shown(*node)));
    data.node_spectra = node->as_boolean()->get();
  }
  const toml::table& table = named_table(output, "combinations");
  std::vector<std::string> known;
  for (const toml::key* name : keys_in_file_order(table)) known.emplace_back(name->str());
  const Section all(table, output.full_name("combinations"), output.source(), known);
  for (const std::string& name : known)
    data.relations.combinations.push_back(
        read_combination(all.table(name, {"terms", "von_mises"}), name, names, data));
}

}  // namespace floe::io
