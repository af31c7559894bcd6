#include "engine/base/memory.h"

#include <new>

namespace gurney {

void require_memory(std::size_t bytes) {
  void* volatile memory = ::operator new(bytes);  // volatile: or a compiler may leave it out
  ::operator delete(memory);
}

}  // namespace gurney
