// cannot be loaded, because it needs an undefined variable
extern int argosTestVariableThatNobodyDefines;
int* argosTestPointer = &argosTestVariableThatNobodyDefines;
