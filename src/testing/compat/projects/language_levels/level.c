int GetLevelOfC(void) {
  return 1;
}
