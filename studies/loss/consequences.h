#pragma once

#include <map>
#include <string>
#include <vector>

#include "equipment/catalogue/uncertainty.h"
#include "studies/limit_states/limit_state.h"

namespace gurney::study {

/// How badly people near an item may be hurt, mildest first.
enum class Injury { kNone, kMinor, kSerious };

/// What an item can still do, best first: it goes on; it has to be looked at; it is out of use.
enum class Service { kKept, kCheck, kLost };

const char* name_of(Injury injury);
const char* name_of(Service service);

/// What follows where an item reaches a limit state.
struct Consequence {
  equipment::StatedQuantity cost_ratio;  ///< of the price of the item, >= 0
  equipment::StatedQuantity days;        ///< out of use, >= 0
  Injury injury = Injury::kNone;
  Service service = Service::kKept;
};

/// Expected value of a stated number: the mean of its distribution, else its value.
double mean_of(const equipment::StatedQuantity& quantity);

/// A number in sample `sample`: drawn where it has a distribution, else its value. It depends on the
/// arguments alone.
/// @param name  of the number among all of a file
double sampled(const equipment::StatedQuantity& quantity, const std::string& name,
               std::uint64_t seed, std::uint64_t sample);

/// Prices of items and what follows from each limit state (docs/loss.md).
class Consequences {
 public:
  /// @throws Error with all errors, each with file:line:column
  static Consequences read(const std::string& path);
  static Consequences read(config::Document& document);

  const std::string& path() const { return path_; }
  const std::string& currency() const { return currency_; }
  int year() const { return year_; }
  std::string money() const;  ///< "USD (2020)"

  /// The states that have a consequence for some item, in the order of the file.
  const std::vector<LimitState>& limit_states() const { return states_; }

  /// @returns nullptr for an item without a price
  const equipment::StatedQuantity* price_of(const std::string& item) const;
  std::vector<std::string> priced_items() const;

  /// @param state  index in limit_states()
  /// @returns nullptr where nothing follows for this item
  const Consequence* of(const std::string& item, std::size_t state) const;

 private:
  struct Row {
    std::size_t state;
    std::vector<std::string> items;  ///< empty: all
    Consequence consequence;
  };

  std::string path_, currency_;
  int year_ = 0;
  std::map<std::string, equipment::StatedQuantity> prices_;
  std::vector<LimitState> states_;
  std::vector<Row> rows_;
};

/// The shipped file, equipment/consequences.toml.
std::string usual_consequences();

}  // namespace gurney::study
