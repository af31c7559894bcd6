#include "studies/plan/floor_records.h"

#include <algorithm>

namespace gurney::study {
namespace {

std::size_t size_of(const groundmotions::Record& record) {
  std::size_t histories = record.rotation ? 2 : 0;
  for (const auto& component : record.components) histories += component.has_value();
  return histories * static_cast<std::size_t>(record.samples()) * sizeof(double);
}

}  // namespace

FloorRecords::Shared FloorRecords::of(const Key& key,
                                      const std::function<groundmotions::Record()>& make) {
  std::promise<Shared> promise;
  {
    std::unique_lock lock(mutex_);
    const auto found = std::ranges::find(kept_, key, &Kept::key);
    if (found != kept_.end()) {
      kept_.splice(kept_.begin(), kept_, found);
      const std::shared_future<Shared> motion = found->motion;
      lock.unlock();
      return motion.get();
    }
    kept_.push_front({key, promise.get_future().share()});
  }
  try {
    const auto made = std::make_shared<const groundmotions::Record>(make());
    promise.set_value(made);
    count(key, *made);
    return made;
  } catch (...) {
    promise.set_exception(std::current_exception());
    forget(key);
    throw;
  }
}

void FloorRecords::count(const Key& key, const groundmotions::Record& record) {
  const std::lock_guard lock(mutex_);
  const auto made = std::ranges::find(kept_, key, &Kept::key);
  made->bytes = size_of(record);
  bytes_ += made->bytes;
  for (auto last = kept_.end(); bytes_ > most_ && last != kept_.begin();) {
    --last;
    if (last->bytes == 0) continue;
    bytes_ -= last->bytes;
    last = kept_.erase(last);
  }
}

void FloorRecords::forget(const Key& key) {
  const std::lock_guard lock(mutex_);
  std::erase_if(kept_, [&](const Kept& each) { return each.key == key; });
}

}  // namespace gurney::study
