#pragma once

#include <vector>

namespace gurney {

/// Puts the elements of another list behind those of `list`.
template <class T, class List>
void append_all(std::vector<T>& list, const List& more) {
  list.insert(list.end(), more.begin(), more.end());
}

}  // namespace gurney
