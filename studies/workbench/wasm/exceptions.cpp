#include <cstdint>
#include <cstdlib>
#include <new>
#include <typeinfo>

// C++ exceptions, which Debian's libc++abi for WebAssembly is built without: the functions of the Itanium
// C++ ABI that code compiled with -fwasm-exceptions calls. One thread; objects thrown are C++ only.

namespace {

/// The first members of libc++abi's classes of type information, in their order.
class CatchType : public std::type_info {
 public:
  ~CatchType() override;
  virtual void unused_1() const;
  virtual void unused_2() const;
  virtual bool can_catch(const CatchType* thrown, void*& object) const = 0;
};

/// Stands before an object that is thrown; its address is that of the exception.
struct alignas(16) Header {
  const CatchType* type;
  void* (*destroy)(void*);  ///< destructors return their object here
  void* caught_as;          ///< the object as the base class that is caught
  int handlers;   ///< that have caught it and not ended; negative: thrown again by one of them
  Header* outer;  ///< caught before

  void* object() { return this + 1; }
};

Header* header_of(void* object) { return static_cast<Header*>(object) - 1; }

Header* caught = nullptr;

std::uintptr_t unsigned_number(const std::uint8_t*& at) {
  std::uintptr_t value = 0;
  for (int shift = 0;; shift += 7) {
    const std::uint8_t byte = *at++;
    value |= std::uintptr_t(byte & 0x7f) << shift;
    if (byte < 0x80) return value;
  }
}

std::intptr_t signed_number(const std::uint8_t*& at) {
  std::uintptr_t value = 0;
  int shift = 0;
  std::uint8_t byte = 0;
  do {
    byte = *at++;
    value |= std::uintptr_t(byte & 0x7f) << shift;
    shift += 7;
  } while (byte >= 0x80);
  if ((byte & 0x40) != 0 && shift < 32) value |= ~std::uintptr_t(0) << shift;
  return std::intptr_t(value);
}

constexpr std::uint8_t kOmitted = 0xff;

/// Number of the type in the function's table of types that catches the exception; 0: none.
/// @param pad    number of the landing pad in the function
/// @param table  language-specific data area of the function
std::uintptr_t selector_of(Header& thrown, std::uintptr_t pad, const std::uint8_t* table) {
  if (table == nullptr) return 0;
  if (*table++ != kOmitted) unsigned_number(table);
  const std::uint8_t* types = nullptr;
  if (*table++ != kOmitted) {
    const std::uintptr_t offset = unsigned_number(table);
    types = table + offset;
  }
  ++table;  // encoding of call sites: ULEB128
  const std::uintptr_t length = unsigned_number(table);
  const std::uint8_t* const actions = table + length;
  std::uintptr_t action = 0;
  for (std::uintptr_t i = 0; i <= pad; ++i) {
    unsigned_number(table);
    action = unsigned_number(table);
  }
  if (action == 0) return 0;
  for (const std::uint8_t* at = actions + action - 1;;) {
    const std::intptr_t type = signed_number(at);
    if (type > 0) {
      const auto* const wanted = reinterpret_cast<const CatchType* const*>(types)[-type];
      void* object = thrown.object();
      if (wanted == nullptr || wanted->can_catch(thrown.type, object)) {
        thrown.caught_as = object;
        return std::uintptr_t(type);
      }
    }
    const std::uint8_t* const here = at;
    const std::intptr_t next = signed_number(at);
    if (next == 0) return 0;
    at = here + next;
  }
}

[[noreturn]] void start(Header* thrown) { __builtin_wasm_throw(0, thrown); }

}  // namespace

extern "C" {

struct {
  std::uintptr_t pad;
  const std::uint8_t* table;
  std::uintptr_t selector;
} __wasm_lpad_context;

int _Unwind_CallPersonality(void* exception) {
  __wasm_lpad_context.selector = selector_of(*static_cast<Header*>(exception),
                                             __wasm_lpad_context.pad, __wasm_lpad_context.table);
  return 0;
}

int __gxx_wasm_personality_v0() { return 0; }

void* __cxa_allocate_exception(std::size_t size) {
  void* const memory = std::malloc(sizeof(Header) + size);
  if (memory == nullptr) std::abort();
  return new (memory) Header{} + 1;
}

void __cxa_free_exception(void* object) { std::free(header_of(object)); }

[[noreturn]] void __cxa_throw(void* object, std::type_info* type, void* (*destroy)(void*)) {
  Header* const thrown = header_of(object);
  thrown->type = static_cast<const CatchType*>(type);
  thrown->destroy = destroy;
  start(thrown);
}

void* __cxa_get_exception_ptr(void* exception) {
  return static_cast<Header*>(exception)->caught_as;
}

void* __cxa_begin_catch(void* exception) {
  auto* const thrown = static_cast<Header*>(exception);
  thrown->handlers = std::abs(thrown->handlers) + 1;
  if (thrown != caught) {
    thrown->outer = caught;
    caught = thrown;
  }
  return thrown->caught_as;
}

void __cxa_end_catch() {
  Header* const thrown = caught;
  if (thrown == nullptr) return;
  const bool again = thrown->handlers < 0;
  thrown->handlers += again ? 1 : -1;
  if (thrown->handlers != 0) return;
  caught = thrown->outer;
  if (again) return;
  if (thrown->destroy != nullptr) thrown->destroy(thrown->object());
  std::free(thrown);
}

[[noreturn]] void __cxa_rethrow() {
  if (caught == nullptr) std::abort();
  caught->handlers = -caught->handlers;
  start(caught);
}

}  // extern "C"
