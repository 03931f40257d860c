// Combination of several errors into one message.

#include <argos3/core/simulator/context/load_errors.h>

#include <catch2/catch.hpp>

#include <stdexcept>

namespace load_errors_test {

using namespace argos;

namespace {

std::string TextOf(const CLoadErrors& errors) {
  try {
    errors.ThrowIfAny();
  } catch (const CARGoSException& ex) {
    return ex.what();
  }
  return "";
}

}  // namespace

TEST_CASE("load errors: without errors nothing is thrown", "[bad_input]") {
  CLoadErrors errors;
  CHECK(errors.IsEmpty());
  CHECK(errors.Try("a step", [] {}));
  CHECK(TextOf(errors).empty());
}

TEST_CASE("load errors: a single error is reported unchanged", "[bad_input]") {
  CARGoSException inner("the cause");
  const CARGoSException outer("the effect", &inner);
  CLoadErrors errors;
  CHECK_FALSE(errors.Try("", [&] { throw outer; }));
  CHECK_FALSE(errors.IsEmpty());
  CHECK(TextOf(errors) == outer.what());
}

TEST_CASE("load errors: a context adds a level of nesting", "[bad_input]") {
  CLoadErrors errors;
  errors.Add("the arena", std::runtime_error("too small"));
  CHECK(TextOf(errors) == "[FATAL] the arena\n[FATAL] too small");
}

TEST_CASE("load errors: several errors are numbered, and duplicates removed", "[bad_input]") {
  CLoadErrors errors;
  errors.Add("", std::runtime_error("one"));
  errors.Add("part", std::runtime_error("two"));
  errors.Add("", std::runtime_error("one"));
  CHECK(TextOf(errors) ==
        "[FATAL] 2 errors in the experiment:\n"
        "[FATAL] 1. one\n"
        "[FATAL] 2. part\n"
        "[FATAL]    two");
}

TEST_CASE("load errors: consequences of reported errors are omitted", "[bad_input]") {
  CLoadErrors errors;
  CHECK_FALSE(errors.Try("", [] { throw CAlreadyReported("its medium is broken"); }));
  CHECK(errors.IsEmpty());
}

}  // namespace load_errors_test
