// uses a function of another library, with which it is linked or not
#define ARGOS_TEST_JOIN_EXPANDED(A, B) A##B
#define ARGOS_TEST_JOIN(A, B) ARGOS_TEST_JOIN_EXPANDED(A, B)

extern "C" int ARGOS_TEST_JOIN(argosTestNeeded, ARGOS_TEST_NUMBER)();

extern "C" int ARGOS_TEST_JOIN(argosTestNeeding, ARGOS_TEST_NUMBER)() {
  return ARGOS_TEST_JOIN(argosTestNeeded, ARGOS_TEST_NUMBER)();
}
