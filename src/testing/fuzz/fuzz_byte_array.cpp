// The input is the content of a byte array, as it may come from a socket or another robot. It is
// read as the values that its first byte selects, and as a table that was sent by a Lua script.

#include <argos3/testing/fuzz/fuzz_support.h>

#include <argos3/core/utility/datatypes/byte_array.h>
#include <argos3/core/utility/errors/argos_exception.h>
#include <argos3/core/wrappers/lua/lua_state.h>
#include <argos3/core/wrappers/lua/lua_utility.h>

#include <cstdlib>
#include <string>

using namespace argos;

namespace {

template <typename T>
void Take(CByteArray& bytes) {
  const CByteArray before = bytes;
  const auto value = bytes.PopFront<T>();
  // what was read can be written, and is read again as the same bytes
  CByteArray again;
  again << value;
  CByteArray copy = again;
  CByteArray rewritten;
  rewritten << copy.PopFront<T>();
  if (!(rewritten == again) || bytes.Size() >= before.Size()) {
    std::abort();
  }
}

void TakeValues(CByteArray bytes) {
  while (!bytes.Empty()) {
    switch (bytes.PopFront<UInt8>() % 10) {
      case 0:
        Take<UInt8>(bytes);
        break;
      case 1:
        Take<SInt16>(bytes);
        break;
      case 2:
        Take<UInt32>(bytes);
        break;
      case 3:
        Take<SInt64>(bytes);
        break;
      case 4:
        Take<double>(bytes);
        break;
      case 5:
        Take<float>(bytes);
        break;
      case 6:
        Take<std::string>(bytes);
        break;
      case 7: {
        UInt8 buffer[7];
        bytes.FetchBuffer(buffer, sizeof buffer);
        break;
      }
      case 8:
        bytes.Resize(bytes.PopFront<UInt8>());
        break;
      default:
        delete bytes(bytes.PopFront<UInt8>(), bytes.PopFront<SInt8>());
    }
  }
}

void TakeTable(const CByteArray& bytes) {
  static CLuaState lua;
  lua.Run([&bytes](lua_State* state) {
    CByteArray rest = bytes;
    if (!CLuaUtility::LuaDeserializeTable(rest, state)) {
      return;
    }
    // what was read can be sent, and is then read as a table of that size
    CByteArray sent;
    CLuaUtility::LuaSerializeTable(sent, state);
    CByteArray copy = sent;
    CByteArray again;
    if (!CLuaUtility::LuaDeserializeTable(copy, state) || !copy.Empty()) {
      std::abort();
    }
    CLuaUtility::LuaSerializeTable(again, state);
    // keys that are tables or vectors have no fixed order
    if (again.Size() != sent.Size()) {
      std::abort();
    }
  });
}

}  // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const CByteArray bytes(data, size);
  RunFuzzInput([&bytes] { TakeValues(bytes); });
  return RunFuzzInput([&bytes] { TakeTable(bytes); });
}
