// defines a function that other libraries of the tests use
#define ARGOS_TEST_JOIN_EXPANDED(A, B) A##B
#define ARGOS_TEST_JOIN(A, B) ARGOS_TEST_JOIN_EXPANDED(A, B)

extern "C" int ARGOS_TEST_JOIN(argosTestNeeded, ARGOS_TEST_NUMBER)() {
  return ARGOS_TEST_NUMBER;
}
