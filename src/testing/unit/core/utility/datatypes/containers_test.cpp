#include <argos3/core/utility/datatypes/any.h>
#include <argos3/core/utility/datatypes/datatypes.h>
#include <argos3/core/utility/datatypes/set.h>
#include <argos3/core/utility/string_utilities.h>

#include <catch2/catch.hpp>

#include <sstream>
#include <type_traits>

namespace containers_test {

using namespace argos;
using Catch::Contains;

// the types are part of the interface: overloads in code of users depend on them
static_assert(std::is_same_v<Real, double>);
static_assert(std::is_same_v<SInt8, signed char>);
static_assert(std::is_same_v<UInt8, unsigned char>);
static_assert(sizeof(UInt16) == 2 && sizeof(SInt16) == 2);
static_assert(std::is_same_v<SInt32, int>);
static_assert(std::is_same_v<UInt32, unsigned int>);
static_assert(std::is_same_v<SInt64, long long>);
static_assert(std::is_same_v<UInt64, unsigned long long>);

namespace {

struct SBase {
  virtual ~SBase() = default;
};
struct SDerived : public SBase {};

struct SEntry {
  int Key;
  int Id;
  bool operator==(const SEntry& other) const { return Id == other.Id; }
};
struct SByKey {
  bool operator()(const SEntry& a, const SEntry& b) const { return a.Key < b.Key; }
};

template <typename SET>
std::vector<int> Elements(const SET& set) {
  std::vector<int> elements;
  for (typename SET::iterator it = set.begin(); it != set.end(); ++it) {
    elements.push_back(*it);
  }
  return elements;
}

}  // namespace

TEST_CASE("datatypes: 8-bit integers print as numbers", "[core][datatypes]") {
  std::ostringstream stream;
  stream << SInt8(-65) << ' ' << UInt8(200);
  CHECK(stream.str() == "-65 200");
}

TEST_CASE("any: returns exactly the stored value", "[core][any]") {
  SDerived object;
  CAny any = &object;
  CHECK(any_cast<SDerived*>(any) == &object);
  CHECK(*any_cast<SDerived*>(&any) == &object);
  CHECK(any_cast<SBase*>(&any) == nullptr);
  const CAny& constant = any;
  CHECK(any_cast<SDerived*>(constant) == &object);
  CHECK(any_cast<SBase*>(&constant) == nullptr);
}

TEST_CASE("any: access as another type is an error that names both", "[core][any]") {
  CAny any = 3;
  const CAny& constant = any;
  CHECK_THROWS_WITH(any_cast<double>(any), Contains("found a value of type int, expected double"));
  CHECK_THROWS_AS(any_cast<double>(constant), CARGoSException);
  CAny empty;
  CHECK_THROWS_AS(any_cast<int>(empty), CARGoSException);
  CHECK(any_cast<int>(&empty) == nullptr);
  CHECK(any_cast<int>(static_cast<CAny*>(nullptr)) == nullptr);
}

TEST_CASE("any: copies, assignments and swaps", "[core][any]") {
  CAny first = std::string("x");
  CAny second = first;
  first = 7;
  CHECK(any_cast<std::string>(second) == "x");
  CHECK(any_cast<int>(first) == 7);
  first.swap(second);
  CHECK(any_cast<std::string>(first) == "x");
  second = first;
  any_cast<std::string>(second) = "y";
  CHECK(any_cast<std::string>(first) == "x");
  CHECK(any_cast<std::string>(second) == "y");
}

TEST_CASE("set: elements are sorted and unique", "[core][set]") {
  CSet<int> set;
  CHECK(set.empty());
  for (const int element : {3, 1, 2, 3, 1}) {
    set.insert(element);
  }
  CHECK(set.size() == 3);
  CHECK(Elements(set) == std::vector<int>{1, 2, 3});
  CHECK(set.first() == 1);
  CHECK(set.last() == 3);
  const CSet<int> copy(set);
  CHECK(copy.first() == 1);
  CHECK(copy.last() == 3);
  set.clear();
  CHECK(set.empty());
  set = copy;
  CHECK(set.size() == 3);
}

TEST_CASE("set: elements can be erased and found", "[core][set]") {
  CSet<int> set;
  for (int i = 0; i < 6; ++i) {
    set.insert(i);
  }
  set.erase(3);
  set.erase(33);
  CHECK(Elements(set) == std::vector<int>{0, 1, 2, 4, 5});
  CHECK(set.exists(4));
  CHECK_FALSE(set.exists(3));
  CSet<int>::iterator it = set.find(1);
  REQUIRE(it != set.end());
  set.erase(it);
  // erase() returns the iterator to the next element
  CHECK(*it == 2);
  CHECK(Elements(set) == std::vector<int>{0, 2, 4, 5});
  CHECK(set.find(1) == set.end());
}

TEST_CASE("set: == distinguishes elements, the comparator orders them", "[core][set]") {
  CSet<SEntry, SByKey> set;
  set.insert({2, 10});
  set.insert({1, 11});
  set.insert({2, 12});
  set.insert({2, 10});
  REQUIRE(set.size() == 3);
  // the iterator's type depends on the element only
  CSet<SEntry>::iterator it = set.begin();
  CHECK(it->Id == 11);
  ++it;
  CHECK(it->Id == 10);
  ++it;
  CHECK((*it).Id == 12);
  CHECK(set.exists({2, 12}));
  set.erase(SEntry{2, 10});
  CHECK(set.last().Id == 12);
  CHECK(set.size() == 2);
}

TEST_CASE("set: the order may be a function object or a function", "[core][set]") {
  CSet<int, bool (*)(int, int)> set;
  for (const int element : {1, 3, 2}) {
    set.insert(element, [](int a, int b) { return a > b; });
  }
  CHECK(set.first() == 3);
  CHECK(set.last() == 1);
  CHECK(set.exists(2));
  set.erase(2);
  CHECK(set.size() == 2);
}

TEST_CASE("set: an iterator converts to a const_iterator and gives write access", "[core][set]") {
  CSet<int> set;
  set.insert(5);
  CSet<int>::iterator it = set.begin();
  const CSet<int>::const_iterator constant = it;
  *it = 6;
  CHECK(*constant == 6);
}

}  // namespace containers_test
