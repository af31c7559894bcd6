#include "engine/solver/contact_memory.h"

#include <gtest/gtest.h>

namespace gurney {
namespace {

BodyContact on_floor(std::size_t item, double x) {
  BodyContact contact;
  contact.side = {.item = item, .local = {x, 0, 0}};
  return contact;
}

/// A contact that remembers its own number.
BodyContactState remembered(const BodyContact& contact, double number) {
  BodyContactState state;
  state.contact = contact;
  state.deflection.x() = state.compression = number;
  return state;
}

std::vector<double> numbers_of(const std::vector<BodyContactState>& states) {
  std::vector<double> numbers;
  for (const BodyContactState& state : states) numbers.push_back(state.compression);
  return numbers;
}

// Points of one item near those before, in another order; one is new, and one of another item is
// nearer still but of another pair.
TEST(ContactMemory, GivesEachPointTheMemoryOfTheNearestOfItsPair) {
  std::vector<BodyContactState> states = {remembered(on_floor(0, 0.1), 1),
                                          remembered(on_floor(0, 0.2), 2),
                                          remembered(on_floor(1, 0.3), 3)};
  ContactMemory memory;
  const std::vector<BodyContact> contacts = {on_floor(0, 0.201), on_floor(0, 0.102),
                                             on_floor(0, 0.3), on_floor(1, 0.31)};
  memory.match(contacts, states);
  EXPECT_EQ(numbers_of(states), (std::vector<double>{2, 1, 0, 3}));
  for (std::size_t i = 0; i < contacts.size(); ++i)
    EXPECT_EQ(states[i].contact.side.local, contacts[i].side.local);
}

// The order of the pairs may change from search to search, as that of islands does.
TEST(ContactMemory, FindsPairsInAnyOrder) {
  std::vector<BodyContactState> states;
  for (std::size_t item = 0; item < 5; ++item)
    for (int point = 0; point < 2; ++point)
      states.push_back(remembered(on_floor(item, 0.1 * point), double(10 * item) + point));
  ContactMemory memory;
  std::vector<BodyContact> contacts;
  for (const std::size_t item : {3, 0, 4, 7, 1})
    for (int point = 0; point < 2; ++point) contacts.push_back(on_floor(item, 0.1 * point));
  memory.match(contacts, states);
  EXPECT_EQ(numbers_of(states), (std::vector<double>{30, 31, 0, 1, 40, 41, 0, 0, 10, 11}));
}

// Nearest first, each once: two points that were near one before share no memory; a far one keeps
// all but the deflection.
TEST(ContactMemory, GivesAMemoryOnceAndForgetsTheDeflectionOfWhatIsFar) {
  std::vector<BodyContactState> states = {remembered(on_floor(0, 0), 1),
                                          remembered(on_floor(0, 0.5), 2)};
  ContactMemory memory;
  memory.match({on_floor(0, 0.004), on_floor(0, 0.002)}, states);
  EXPECT_EQ(numbers_of(states), (std::vector<double>{2, 1}));
  EXPECT_EQ(states[0].deflection.x(), 0);
  EXPECT_EQ(states[1].deflection.x(), 1);
  memory.match({}, states);
  EXPECT_TRUE(states.empty());
  memory.match({on_floor(0, 0)}, states);
  EXPECT_EQ(numbers_of(states), std::vector<double>{0});
}

}  // namespace
}  // namespace gurney
