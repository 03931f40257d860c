// cannot be loaded: it needs a variable that nobody defines
extern int argosTestVariableThatNobodyDefines;
int* argosTestPointer = &argosTestVariableThatNobodyDefines;
