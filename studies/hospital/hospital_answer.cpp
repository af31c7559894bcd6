#include "studies/hospital/hospital_answer.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <set>

#include "engine/base/error.h"
#include "engine/base/parallel.h"
#include "engine/base/random/normal_draw.h"
#include "engine/config/nearest_name.h"
#include "studies/loss/study_loss.h"
#include "studies/statistics/quantiles.h"
#include "studies/statistics/resample.h"

namespace gurney::study {
namespace {

constexpr std::size_t kReplicates = 199, kSamplesOfReplicate = 500;
constexpr double kTail = 0.95;

/// Streams of random numbers: of all pieces, then four of each.
enum Stream : std::uint64_t { kCommon, kFloor, kRecord, kShift, kResample, kFirstPiece = 16 };
enum PieceStream : std::uint64_t { kCapacity, kDraw, kBraked, kTether, kOfPiece };

using Settings = std::vector<std::vector<Securing>>;  ///< of each room and item
using Row = std::vector<double>;                      ///< of one sample, or means

/// Columns of a row: beds out, loss, then 1 for each service that works, then the working share of
/// each room's copies.
enum Column : std::size_t { kBeds, kLoss, kFirstService };

/// Random numbers of consecutive samples, which all levels, settings and replicates have in common.
struct Draws {
  std::size_t first = 0;
  std::vector<MotionSample> motions;  ///< of each sample
  std::vector<PieceSample> pieces;    ///< of sample and piece

  std::size_t count() const { return motions.size(); }
};

class Model {
 public:
  Model(const Hospital& hospital, const Consequences& consequences, const OutcomeSource& source,
        const HospitalRequest& request)
      : hospital_(hospital),
        source_(source),
        request_(request),
        tree_(hospital, source.states(), lost_states(hospital, consequences)) {
    for (const Room& room : hospital.rooms) outcomes_.emplace_back(room.items.size());
    for (const Piece& piece : tree_.pieces)
      costs_.push_back(costs_of(hospital.rooms[piece.room].items[piece.item], consequences));
  }

  const HospitalTree& tree() const { return tree_; }
  std::size_t columns() const {
    return kFirstService + hospital_.services.size() + hospital_.rooms.size();
  }

  /// Outcomes of each setting that is asked for; errors of all.
  void prepare(const Settings& settings) {
    for (std::size_t room = 0; room < settings.size(); ++room)
      for (std::size_t item = 0; item < settings[room].size(); ++item) {
        const Securing& securing = settings[room][item];
        prepare(room, item, securing.brakes);
        if (securing.share < 1) prepare(room, item, Brakes::kOff);
      }
  }

  Draws draws(std::size_t first, std::size_t count) const {
    const std::size_t pieces = tree_.pieces.size();
    Draws draws{first, std::vector<MotionSample>(count), std::vector<PieceSample>(count * pieces)};
    for (std::size_t i = 0; i < count; ++i) {
      const std::size_t sample = first + i;
      draws.motions[i] = {normal(kCommon, sample), normal(kFloor, sample),
                          uniform(kRecord, sample)};
      for (std::size_t piece = 0; piece < pieces; ++piece)
        draws.pieces[i * pieces + piece] =
            source_.records() > 0 ? PieceSample{0, uniform(stream_of(piece) + kDraw, sample)}
                                  : PieceSample{normal(stream_of(piece) + kCapacity, sample), 0};
    }
    return draws;
  }

  /// States of all pieces at a level, sample by sample.
  std::vector<Reached> simulate(const Draws& draws, std::size_t level, const Settings& settings,
                                const Replicate& replicate) const {
    std::vector<Reached> reached(draws.count() * tree_.pieces.size());
    std::vector<std::size_t> all(tree_.pieces.size());
    std::iota(all.begin(), all.end(), std::size_t{0});
    renew(draws, level, settings, replicate, all, reached);
    return reached;
  }

  /// States anew of some pieces, whose setting has changed.
  void renew(const Draws& draws, std::size_t level, const Settings& settings,
             const Replicate& replicate, const std::vector<std::size_t>& pieces,
             std::vector<Reached>& reached) const {
    for (std::size_t i = 0; i < draws.count(); ++i)
      for (const std::size_t piece : pieces)
        reached[i * tree_.pieces.size() + piece] =
            reach(draws, i, piece, level, settings, replicate);
  }

  /// Adds the numbers of one sample.
  void add(const Reached* reached, std::vector<char>& works, Row& row) const {
    tree_.tree.evaluate(reached, works);
    double loss = 0;
    for (std::size_t i = 0; i < tree_.pieces.size(); ++i)
      if (reached[i] != 0) loss += cost(costs_[i], reached[i]);
    row[kLoss] += loss;
    for (std::size_t i = 0; i < tree_.services.size(); ++i)
      row[kFirstService + i] += works[tree_.services[i]];
    int beds = 0;
    for (std::size_t room = 0; room < tree_.rooms.size(); ++room) {
      int working = 0;
      for (const FaultTree::Node copy : tree_.rooms[room]) working += works[copy];
      const int copies = hospital_.rooms[room].count;
      beds += hospital_.rooms[room].beds * (copies - working);
      row[kFirstService + tree_.services.size() + room] += static_cast<double>(working) / copies;
    }
    row[kBeds] += beds;
  }

  /// Means over samples.
  Row means(const std::vector<Reached>& reached, std::size_t count) const {
    Row sum(columns(), 0);
    std::vector<char> works(tree_.tree.size());
    for (std::size_t i = 0; i < count; ++i)
      add(reached.data() + i * tree_.pieces.size(), works, sum);
    for (double& each : sum) each /= static_cast<double>(count);
    return sum;
  }

  /// Rows of level and sample, by several threads.
  std::vector<std::vector<Row>> rows(const Settings& settings) const {
    constexpr std::size_t kBlock = 500;
    const std::size_t samples = request_.samples, blocks = (samples + kBlock - 1) / kBlock;
    std::vector<std::vector<Row>> all(hospital_.levels.size(),
                                      std::vector<Row>(samples, Row(columns(), 0)));
    parallel_for(blocks, request_.threads, [&](std::size_t block) {
      const std::size_t first = block * kBlock;
      const Draws part = draws(first, std::min(kBlock, samples - first));
      std::vector<char> works(tree_.tree.size());
      for (std::size_t level = 0; level < all.size(); ++level) {
        const std::vector<Reached> reached = simulate(part, level, settings, {});
        for (std::size_t i = 0; i < part.count(); ++i)
          add(reached.data() + i * tree_.pieces.size(), works, all[level][first + i]);
      }
    });
    return all;
  }

  std::vector<std::size_t> pieces_of(std::size_t room, std::size_t item) const {
    std::vector<std::size_t> found;
    for (std::size_t i = 0; i < tree_.pieces.size(); ++i)
      if (tree_.pieces[i].room == room && tree_.pieces[i].item == item) found.push_back(i);
    return found;
  }

 private:
  std::vector<std::vector<Reached>> lost_states(const Hospital& hospital,
                                                const Consequences& consequences) const {
    std::vector<std::vector<Reached>> lost;
    for (const Room& room : hospital.rooms) {
      lost.emplace_back();
      for (const HospitalItem& item : room.items) {
        Reached states = 0;
        for (std::size_t i = 0; i < consequences.limit_states().size(); ++i)
          if (const Consequence* const of = consequences.of(item.equipment, i);
              of != nullptr && of->service == Service::kLost)
            states |= Reached{1} << i;
        lost.back().push_back(states);
      }
    }
    return lost;
  }

  static std::vector<double> costs_of(const HospitalItem& item, const Consequences& consequences) {
    std::vector<double> costs;
    const equipment::StatedQuantity* const price = consequences.price_of(item.equipment);
    for (std::size_t i = 0; i < consequences.limit_states().size(); ++i) {
      const Consequence* const of = consequences.of(item.equipment, i);
      costs.push_back(
          price == nullptr || of == nullptr ? 0 : mean_of(*price) * mean_of(of->cost_ratio));
    }
    return costs;
  }

  static double cost(const std::vector<double>& costs, Reached reached) {
    double worst = 0;
    for (std::size_t i = 0; i < costs.size() && reached >> i != 0; ++i)
      if ((reached >> i & 1) != 0) worst = std::max(worst, costs[i]);
    return worst;
  }

  void prepare(std::size_t room, std::size_t item, Brakes brakes) {
    Outcome& outcome = outcomes_[room][item][static_cast<std::size_t>(brakes)];
    const Room& of = hospital_.rooms[room];
    if (!outcome) outcome = source_.outcome(of.items[item], hospital_.storeys[of.storey], brakes);
  }

  double normal(std::uint64_t stream, std::size_t sample) const {
    return normal_draw(request_.seed, stream, sample);
  }
  double uniform(std::uint64_t stream, std::size_t sample) const {
    return uniform_draw(request_.seed, stream, sample);
  }
  static std::uint64_t stream_of(std::size_t piece) { return kFirstPiece + kOfPiece * piece; }

  Reached reach(const Draws& draws, std::size_t i, std::size_t piece, std::size_t level,
                const Settings& settings, const Replicate& replicate) const {
    const Piece& of = tree_.pieces[piece];
    const Securing& securing = settings[of.room][of.item];
    const auto happens = [&](PieceStream which, double chance) {
      return chance >= 1 ||
             (chance > 0 && uniform(stream_of(piece) + which, draws.first + i) < chance);
    };
    if (happens(kTether, securing.tether_holds)) return 0;
    const Brakes brakes = happens(kBraked, securing.share) ? securing.brakes : Brakes::kOff;
    const Outcome& outcome = outcomes_[of.room][of.item][static_cast<std::size_t>(brakes)];
    return outcome(level, draws.motions[i], draws.pieces[i * tree_.pieces.size() + piece],
                   replicate);
  }

  const Hospital& hospital_;
  const OutcomeSource& source_;
  const HospitalRequest& request_;
  HospitalTree tree_;
  std::vector<std::vector<double>> costs_;                     ///< of piece, state
  std::vector<std::vector<std::array<Outcome, 3>>> outcomes_;  ///< of room, item, brakes
};

/// One action on one group of pieces, and its outcome.
struct Candidate {
  const HospitalAction* action;
  std::size_t room, item;
  Securing securing;
  std::vector<std::size_t> pieces;
  double cost = 0;  ///< of all pieces
};

class Answering {
 public:
  Answering(const Hospital& hospital, const Consequences& consequences,
            const HospitalRequest& request)
      : hospital_(hospital),
        consequences_(consequences),
        request_(request),
        source_(request.results.empty()
                    ? curve_outcomes(hospital, consequences, hospital.correlation)
                    : run_outcomes(hospital, consequences, request.results)),
        model_(hospital, consequences, *source_, request) {
    for (const Room& room : hospital.rooms) {
      stated_.emplace_back();
      for (const HospitalItem& item : room.items) stated_.back().push_back(item.securing);
    }
    model_.prepare(stated_);
    for (const HospitalAction& action : hospital.actions) add_candidates(action);
    choose_objective();
  }

  HospitalAnswer answer() {
    HospitalAnswer answer;
    answer.pieces = model_.tree().pieces.size();
    answer.samples = request_.samples;
    answer.records = source_->records();
    answer.beds = hospital_.beds();
    answer.money = consequences_.money();
    rank(answer);
    replicate(answer);
    const std::vector<std::vector<Row>> rows = model_.rows(stated_);
    for (std::size_t level = 0; level < rows.size(); ++level)
      answer.levels.push_back(at_level(level, rows[level]));
    if (request_.results.empty()) add_extremes(answer);
    if (hospital_.hazard) answer.annual = annual();
    answer.cautions = cautions();
    return answer;
  }

 private:
  void add_candidates(const HospitalAction& action) {
    for (const auto& [room, item] : action.items) {
      Securing securing = stated_[room][item];
      if (action.brakes) {
        securing.brakes = *action.brakes;
        securing.share = 1;
      }
      if (action.tether_holds) securing.tether_holds = *action.tether_holds;
      Candidate each{&action, room, item, securing, model_.pieces_of(room, item), 0};
      each.cost = mean_of(action.cost) * static_cast<double>(each.pieces.size());
      Settings changed = stated_;
      changed[room][item] = securing;
      model_.prepare(changed);
      candidates_.push_back(std::move(each));
    }
  }

  /// Keeps what another action has done to the same pieces.
  static Securing secured(const Candidate& candidate, Securing now) {
    if (candidate.action->brakes) {
      now.brakes = candidate.securing.brakes;
      now.share = 1;
    }
    if (candidate.action->tether_holds) now.tether_holds = candidate.securing.tether_holds;
    return now;
  }

  void choose_objective() {
    const std::size_t levels = hospital_.levels.size();
    ranked_level_ = levels / 2;
    if (request_.at) {
      const auto found = std::ranges::find_if(hospital_.levels, [&](double level) {
        return std::abs(level - *request_.at) <= 1e-9 * level;
      });
      require(found != hospital_.levels.end(),
              fmt::format("--at {}: {} has the levels {} m/s", *request_.at, hospital_.path,
                          fmt::join(hospital_.levels, ", ")));
      ranked_level_ = static_cast<std::size_t>(found - hospital_.levels.begin());
    }
    const std::string by = !request_.by.empty()   ? request_.by
                           : hospital_.beds() > 0 ? "beds"
                                                  : "loss";
    std::vector<std::string> known{"beds", "loss"};
    for (const HospitalService& service : hospital_.services) known.push_back(service.name);
    const auto found = std::ranges::find(known, by);
    require(found != known.end(), fmt::format("--by '{}': must be beds, loss or a service{}", by,
                                              config::suggestion(by, known)));
    objective_ = static_cast<std::size_t>(found - known.begin());
    ranked_by_ = objective_ == kBeds   ? "beds out of use"
                 : objective_ == kLoss ? "loss"
                                       : "chance that " + by + " is lost";
  }

  /// The number that the ranking makes small.
  double objective(const Row& row) const {
    return objective_ < kFirstService ? row[objective_] : 1 - row[objective_];
  }

  /// The action that gains most for its cost, again and again, each on top of those before it.
  void rank(HospitalAnswer& answer) {
    answer.ranked_at = hospital_.levels[ranked_level_];
    answer.ranked_by = ranked_by_;
    if (candidates_.empty()) return;
    const Draws draws = model_.draws(0, request_.samples);
    Settings settings = stated_;
    std::vector<Reached> reached = model_.simulate(draws, ranked_level_, settings, {});
    Row now = model_.means(reached, draws.count());
    answer.before = objective(now);
    std::vector<std::size_t> left(candidates_.size());
    for (std::size_t i = 0; i < left.size(); ++i) left[i] = i;
    bool taken = true;
    while (!left.empty()) {
      std::vector<Row> after(left.size());
      parallel_for(left.size(), request_.threads, [&](std::size_t i) {
        after[i] = with(candidates_[left[i]], draws, settings, reached).second;
      });
      const std::size_t best = best_of(left, now, after);
      const Candidate& chosen = candidates_[left[best]];
      const double gain = objective(now) - objective(after[best]);
      taken = taken && gain > 0;
      answer.ranking.push_back(ranked(chosen, now, after[best], taken));
      order_.push_back({left[best], taken});
      if (taken) {
        reached = with(chosen, draws, settings, reached).first;
        settings[chosen.room][chosen.item] = secured(chosen, settings[chosen.room][chosen.item]);
        now = after[best];
      }
      left.erase(left.begin() + static_cast<std::ptrdiff_t>(best));
    }
  }

  std::pair<std::vector<Reached>, Row> with(const Candidate& candidate, const Draws& draws,
                                            Settings settings, std::vector<Reached> reached) const {
    Securing& securing = settings[candidate.room][candidate.item];
    securing = secured(candidate, securing);
    model_.renew(draws, ranked_level_, settings, {}, candidate.pieces, reached);
    Row row = model_.means(reached, draws.count());
    return {std::move(reached), std::move(row)};
  }

  std::size_t best_of(const std::vector<std::size_t>& left, const Row& now,
                      const std::vector<Row>& after) const {
    const auto worth = [&](std::size_t i) {
      const double gain = objective(now) - objective(after[i]);
      const double cost = candidates_[left[i]].cost;
      return gain > 0 && cost == 0 ? std::numeric_limits<double>::infinity()
             : cost == 0           ? gain
                                   : gain / cost;
    };
    std::size_t best = 0;
    for (std::size_t i = 1; i < left.size(); ++i)
      if (worth(i) > worth(best)) best = i;
    return best;
  }

  RankedAction ranked(const Candidate& chosen, const Row& now, const Row& after, bool taken) const {
    RankedAction action;
    action.name = chosen.action->name;
    const Room& room = hospital_.rooms[chosen.room];
    action.group = room.name + "/" + room.items[chosen.item].name;
    action.pieces = static_cast<int>(chosen.pieces.size());
    action.cost = chosen.cost;
    action.gain.value = objective(now) - objective(after);
    action.beds = now[kBeds] - after[kBeds];
    action.loss = now[kLoss] - after[kLoss];
    action.left = objective(taken ? after : now);
    action.taken = taken;
    return action;
  }

  Replicate replicate_of(std::size_t number) const {
    Replicate replicate;
    replicate.shift = normal_draw(request_.seed, kShift, number);
    if (source_->records() == 0) return replicate;
    const auto times =
        statistics::resampled_times(source_->records(), request_.seed + kResample, number);
    for (std::size_t record = 0; record < times.size(); ++record)
      replicate.records.insert(replicate.records.end(), static_cast<std::size_t>(times[record]),
                               record);
    return replicate;
  }

  /// Means of every level, and gains of the ranking, with other records.
  void replicate(HospitalAnswer& answer) {
    means_.assign(hospital_.levels.size(), std::vector<Row>(kReplicates));
    std::vector<std::vector<double>> gains(order_.size(), std::vector<double>(kReplicates));
    parallel_for(kReplicates, request_.threads, [&](std::size_t number) {
      const Replicate of = replicate_of(number);
      const Draws draws =
          model_.draws(request_.samples + number * kSamplesOfReplicate, kSamplesOfReplicate);
      for (std::size_t level = 0; level < means_.size(); ++level) {
        std::vector<Reached> reached = model_.simulate(draws, level, stated_, of);
        means_[level][number] = model_.means(reached, draws.count());
        if (level == ranked_level_) add_gains(draws, of, number, std::move(reached), gains);
      }
    });
    for (std::size_t i = 0; i < order_.size(); ++i)
      answer.ranking[i].gain = around(answer.ranking[i].gain.value, gains[i]);
  }

  void add_gains(const Draws& draws, const Replicate& of, std::size_t number,
                 std::vector<Reached> reached, std::vector<std::vector<double>>& gains) const {
    Settings settings = stated_;
    double now = objective(means_[ranked_level_][number]);
    for (std::size_t i = 0; i < order_.size(); ++i) {
      const Candidate& candidate = candidates_[order_[i].first];
      Settings changed = settings;
      Securing& securing = changed[candidate.room][candidate.item];
      securing = secured(candidate, securing);
      std::vector<Reached> after = reached;
      model_.renew(draws, ranked_level_, changed, of, candidate.pieces, after);
      const double then = objective(model_.means(after, draws.count()));
      gains[i][number] = now - then;
      if (!order_[i].second) continue;
      settings = std::move(changed);
      reached = std::move(after);
      now = then;
    }
  }

  static Answer around(double value, const std::vector<double>& replicates) {
    const double tail = (1 - kTail) / 2;
    return {value,
            {std::min(value, statistics::quantile_of(replicates, tail)),
             std::max(value, statistics::quantile_of(replicates, 1 - tail))}};
  }

  Answer of_column(double value, std::size_t level, std::size_t column) const {
    std::vector<double> replicates;
    for (const Row& row : means_[level]) replicates.push_back(row[column]);
    return around(value, replicates);
  }

  LevelAnswer at_level(std::size_t level, const std::vector<Row>& rows) {
    Row mean(model_.columns(), 0);
    std::vector<double> beds, loss;
    for (const Row& row : rows) {
      for (std::size_t i = 0; i < mean.size(); ++i) mean[i] += row[i];
      beds.push_back(row[kBeds]);
      loss.push_back(row[kLoss]);
    }
    for (double& each : mean) each /= static_cast<double>(rows.size());
    found_.push_back(mean);
    LevelAnswer answer;
    answer.pgv = hospital_.levels[level];
    answer.beds_out = of_column(mean[kBeds], level, kBeds);
    answer.loss = of_column(mean[kLoss], level, kLoss);
    answer.beds_out_p95 = statistics::quantile_of(beds, kTail);
    answer.loss_p95 = statistics::quantile_of(loss, kTail);
    std::size_t column = kFirstService;
    for (const HospitalService& service : hospital_.services)
      answer.services.push_back(service_answer(service.name, mean, level, column++));
    for (const Room& room : hospital_.rooms)
      answer.rooms.push_back(service_answer(room.name, mean, level, column++));
    return answer;
  }

  ServiceAnswer service_answer(const std::string& name, const Row& mean, std::size_t level,
                               std::size_t column) const {
    return {name, of_column(mean[column], level, column), {}, {}};
  }

  /// Services with other correlations than the stated one: none, and full.
  void add_extremes(HospitalAnswer& answer) {
    for (const bool together : {false, true}) {
      const auto source = curve_outcomes(hospital_, consequences_, together ? 1 : 0);
      Model model(hospital_, consequences_, *source, request_);
      model.prepare(stated_);
      const std::vector<std::vector<Row>> rows = model.rows(stated_);
      for (std::size_t level = 0; level < rows.size(); ++level)
        for (std::size_t i = 0; i < hospital_.services.size(); ++i) {
          double works = 0;
          for (const Row& row : rows[level]) works += row[kFirstService + i];
          ServiceAnswer& of = answer.levels[level].services[i];
          (together ? of.dependent : of.independent) =
              works / static_cast<double>(request_.samples);
        }
    }
  }

  /// Annual rate of a column's value, or of 1 less that.
  Answer rate_of(std::size_t column, bool complement) const {
    const auto rate = [&](const auto& row_of) {
      std::vector<double> values;
      for (std::size_t level = 0; level < hospital_.levels.size(); ++level) {
        const double value = row_of(level)[column];
        values.push_back(complement ? 1 - value : value);
      }
      return rate_of_shares(hospital_.levels, values, hospital_.hazard->curve);
    };
    std::vector<double> replicates;
    for (std::size_t number = 0; number < kReplicates; ++number)
      replicates.push_back(
          rate([&](std::size_t level) -> const Row& { return means_[level][number]; }));
    return around(rate([&](std::size_t level) -> const Row& { return found_[level]; }), replicates);
  }

  AnnualAnswer annual() const {
    AnnualAnswer answer;
    for (std::size_t i = 0; i < hospital_.services.size(); ++i)
      answer.lost.emplace_back(hospital_.services[i].name, rate_of(kFirstService + i, true));
    answer.beds_out = rate_of(kBeds, false);
    answer.loss = rate_of(kLoss, false);
    return answer;
  }

  std::vector<std::string> cautions() const {
    std::vector<std::string> all = source_->cautions();
    std::set<std::string> unpriced;
    for (const Room& room : hospital_.rooms)
      for (const HospitalItem& item : room.items)
        if (consequences_.price_of(item.equipment) == nullptr) unpriced.insert(item.equipment);
    if (!unpriced.empty())
      all.push_back(fmt::format("no price, and so no loss: {}", fmt::join(unpriced, ", ")));
    if (hospital_.hazard)
      all.push_back(
          fmt::format("of a year: nothing counts below {:g} m/s, and above {:g} m/s it is as there",
                      hospital_.levels.front(), hospital_.levels.back()));
    return all;
  }

  const Hospital& hospital_;
  const Consequences& consequences_;
  const HospitalRequest& request_;
  std::unique_ptr<OutcomeSource> source_;
  Model model_;
  Settings stated_;
  std::vector<Candidate> candidates_;
  std::vector<std::pair<std::size_t, bool>> order_;  ///< candidate, and whether it is taken
  std::size_t objective_ = 0, ranked_level_ = 0;
  std::string ranked_by_;
  std::vector<std::vector<Row>> means_;  ///< of level, replicate
  std::vector<Row> found_;               ///< of level
};

}  // namespace

HospitalAnswer hospital_answer(const Hospital& hospital, const Consequences& consequences,
                               const HospitalRequest& request) {
  return Answering(hospital, consequences, request).answer();
}

}  // namespace gurney::study
