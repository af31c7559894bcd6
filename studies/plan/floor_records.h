#pragma once

#include <cstddef>
#include <functional>
#include <future>
#include <list>
#include <memory>
#include <mutex>

#include "groundmotions/record/record.h"

namespace gurney::study {

/// Motions of a building's floor, and synthetic motions of the ground, each made once for all
/// configurations and draws under it. Those asked for last are kept, up to a number of bytes, so
/// that memory does not grow with the study.
class FloorRecords {
 public:
  using Shared = std::shared_ptr<const groundmotions::Record>;

  explicit FloorRecords(std::size_t bytes) : most_(bytes) {}

  /// A ground motion times `scale`; `set` is of the building and its floor.
  struct Key {
    std::size_t set = 0, record = 0;
    double scale = 1;
    bool operator==(const Key&) const = default;
  };

  /// The motion of the floor, by `make` unless it is kept. May be called from several threads:
  /// those that ask for the same motion wait for the one that makes it.
  /// @throws what `make` throws
  Shared of(const Key& key, const std::function<groundmotions::Record()>& make);

 private:
  struct Kept {
    Key key;
    std::shared_future<Shared> motion;
    std::size_t bytes = 0;  ///< 0: it is being made
  };

  void count(const Key& key, const groundmotions::Record& record);
  void forget(const Key& key);

  std::mutex mutex_;
  std::list<Kept> kept_;  ///< that asked for last is the first
  std::size_t bytes_ = 0, most_;
};

}  // namespace gurney::study
