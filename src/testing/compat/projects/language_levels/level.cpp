static_assert(__cplusplus == EXPECTED_LEVEL, "the target is compiled with another level");
int GetLevel() {
  return 1;
}
