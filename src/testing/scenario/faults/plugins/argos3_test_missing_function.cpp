// A library with a function that is not defined anywhere, and which is never called.

namespace argosTest {

int DefinedNowhere(int);

__attribute__((visibility("default"))) int CallIt() {
  return DefinedNowhere(1);
}

}  // namespace argosTest
