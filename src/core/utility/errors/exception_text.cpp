#include <argos3/core/utility/errors/exception_text.h>

#include <argos3/core/utility/errors/argos_exception.h>

#include <cxxabi.h>

#include <cstdlib>
#include <memory>
#include <new>
#include <typeinfo>

namespace argos {

namespace {

std::string NameOfCurrentType() {
  const std::type_info* const type = abi::__cxa_current_exception_type();
  if (type == nullptr) {
    return "of an unknown type";
  }
  int status = 0;
  const std::unique_ptr<char, void (*)(void*)> name(
      abi::__cxa_demangle(type->name(), nullptr, nullptr, &status), &std::free);
  return std::string("of the type ") + (status == 0 ? name.get() : type->name());
}

std::string DescribeForeignException() {
  return "what was thrown is not a std::exception, but " + NameOfCurrentType();
}

}  // namespace

std::string DescribeCurrentException() {
  try {
    throw;
  } catch (const std::bad_alloc&) {
    return "not enough memory";
  } catch (const std::exception& error) {
    return error.what();
  } catch (...) {
    return DescribeForeignException();
  }
}

void ThrowWithCause(const std::string& what) {
  throw CARGoSException(what + '\n' + DescribeCurrentException());
}

}  // namespace argos
