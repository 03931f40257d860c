// Code of users of the utilities, in the order of the reference: datatypes, exceptions, general
// maths, strings, logging, colours, byte arrays, any, sets and others.

#include <argos3/core/utility/configuration/argos_exception.h>
#include <argos3/core/utility/configuration/command_line_arg_parser.h>
#include <argos3/core/utility/configuration/memento.h>
#include <argos3/core/utility/datatypes/any.h>
#include <argos3/core/utility/datatypes/byte_array.h>
#include <argos3/core/utility/datatypes/color.h>
#include <argos3/core/utility/datatypes/datatypes.h>
#include <argos3/core/utility/datatypes/set.h>
#include <argos3/core/utility/logging/argos_colored_text.h>
#include <argos3/core/utility/logging/argos_log.h>
#include <argos3/core/utility/math/angles.h>
#include <argos3/core/utility/math/general.h>
#include <argos3/core/utility/networking/tcp_socket.h>
#include <argos3/core/utility/profiler/profiler.h>
#include <argos3/core/utility/rate.h>
#include <argos3/core/utility/signal_processing.h>
#include <argos3/core/utility/string_utilities.h>

#include <catch2/catch.hpp>

#include <memory>
#include <thread>

namespace utility_test {

using namespace argos;
using Catch::WithinAbs;

/* 2.1 datatypes                        */

static_assert(std::is_same<Real, double>::value, "");
static_assert(std::is_same<SInt8, signed char>::value && std::is_same<UInt8, unsigned char>::value,
              "");
static_assert(std::is_same<SInt16, short>::value && std::is_same<UInt16, unsigned short>::value,
              "");
static_assert(std::is_same<SInt32, int>::value && std::is_same<UInt32, unsigned int>::value, "");
static_assert(std::is_same<SInt64, long long>::value &&
                  std::is_same<UInt64, unsigned long long>::value,
              "");

TEST_CASE("compat: 8-bit integers are printed as numbers", "[compat]") {
  std::ostringstream cStream;
  cStream << static_cast<UInt8>(65) << " " << static_cast<SInt8>(-3);
  CHECK(cStream.str() == "65 -3");
}

/* 2.2 exceptions                       */

static int Classify(int n_value) {
  if (n_value > 0)
    return 1;
  else
    THROW_ARGOSEXCEPTION("not positive: " << n_value << "!")
}

TEST_CASE("compat: exceptions and their macros work", "[compat]") {
  CHECK(Classify(3) == 1);
  try {
    Classify(-2);
  } catch (CARGoSException& ex) {
    CHECK(std::string(ex.what()) == "[FATAL] not positive: -2!");
    try {
      THROW_ARGOSEXCEPTION_NESTED("outer " << 1, ex);
    } catch (CARGoSException& ex2) {
      CHECK(std::string(ex2.what()) == "[FATAL] outer 1\n[FATAL] not positive: -2!");
    }
  }
  CARGoSException cAlone("alone");
  CHECK(std::string(cAlone.what()) == "[FATAL] alone");
  std::runtime_error cStd("std");
  CHECK(std::string(CARGoSException("with", &cStd).what()) == "[FATAL] with\n[FATAL] std");
  const std::exception& cBase = cAlone;
  CHECK(std::string(cBase.what()) == "[FATAL] alone");
  ARGOS_ASSERT(1 + 1 == 2, "arithmetic fails: " << 1)
  ARGOS_ASSERT(true, "with a semicolon");
}

/* 2.3 general maths                    */

TEST_CASE("compat: general maths works as documented", "[compat]") {
  CHECK(Abs(-3) == 3);
  CHECK(Abs(-3.5) == 3.5);
  CHECK(Abs(CRadians(-1.0)) == CRadians(1.0));
  CHECK(Abs(CDegrees(-1.0)) == CDegrees(1.0));
  Real fA = 1.0, fB = 2.0;
  const Real fC = 3.0;
  CHECK(Min(fA, fB) == 1.0);
  CHECK(Max(fA, fB) == 2.0);
  CHECK(Min(fA, fC) == 1.0);
  CHECK(Min<Real>(fA, 0.5f) == 0.5);
  CHECK(Max<Real>(0.5f, fB) == 2.0);
  CHECK(Max(0.0, fA) == 1.0);
  CHECK(Max(fA, 0.0) == 1.0);
  Max(fA, fB) = 7.0;
  CHECK(fB == 7.0);
  Min(fA, fB) = 0.0;
  CHECK(fA == 0.0);
  CHECK(Sign(-2.5) == -1);
  CHECK(Sign(0) == 0);
  CHECK(Sign(4) == 1);
  CHECK(Square(3.0) == 9.0);
  CHECK(Square(3.0f) == 9.0f);
  CHECK(Floor(2.7) == 2);
  CHECK(Floor(-2.5) == -3);
  CHECK(Floor(-2.0) == -3);
  CHECK(Ceil(2.3) == 3);
  CHECK(Ceil(-2.3) == -2);
  CHECK(Round(2.5) == 3);
  CHECK(Round(-2.5) == -3);
  CHECK(RoundClosestToZero(2.7) == 2);
  CHECK(RoundClosestToZero(-2.7) == -2);
  CHECK(DoubleEqAbsolute(100.0, 100.5, 0.01));
  CHECK_FALSE(DoubleEqAbsolute(1.0, 1.5, 0.01));
  CHECK(DoubleEq(1.0, 1.00005));
  CHECK_FALSE(DoubleEq(1.0, 1.0005));
  std::vector<std::pair<Real, Real> > vecPoints;
  vecPoints.push_back(std::make_pair(0.0, 0.0));
  vecPoints.push_back(std::make_pair(1.0, 2.0));
  vecPoints.push_back(std::make_pair(2.0, 2.0));
  CHECK(Interpolate(0.5, vecPoints) == 1.0);
  CHECK(Interpolate(-1.0, vecPoints) == -2.0);
  CHECK(Interpolate(3.0, vecPoints) == 2.0);
  CHECK_THAT(Log(Exp(2.0)), WithinAbs(2.0, 1e-15));
  CHECK(Sqrt(16.0) == 4.0);
  CHECK(Mod(7.5, 2.0) == 1.5);
}

/* 2.4 strings                          */

TEST_CASE("compat: strings work as documented", "[compat]") {
  CHECK(ToString(12) == "12");
  CHECK(ToString(true) == "true");
  CHECK(FromString<UInt32>("12") == 12);
  CHECK(FromString<bool>("true"));
  CHECK(FromString<Real>("1.5") == 1.5);
  Real pfValues[3];
  std::istringstream cStream("1, 2,3,9");
  ParseValues<Real>(cStream, 3, pfValues, ',');
  CHECK_FALSE(cStream.fail());
  CHECK(pfValues[1] == 2.0);
  ParseValues<Real>("4:5:6", 3, pfValues, ':');
  CHECK(pfValues[2] == 6.0);
  UInt32 unLines[2];
  ParseValues<UInt32>("7\n8", 2, unLines);
  CHECK(unLines[1] == 8);
  CHECK_THROWS_AS(ParseValues<Real>("1:2", 3, pfValues, ':'), CARGoSException);
  std::vector<std::string> vecTokens(1, "first");
  Tokenize("a  b c", vecTokens);
  Tokenize("d,,e", vecTokens, ",");
  CHECK(vecTokens == std::vector<std::string>{"first", "a", "b", "c", "d", "e"});
  CHECK(StringToUpperCase("aBc1") == "ABC1");
  CHECK(StringToLowerCase("aBc1") == "abc1");
  std::string strBuffer = "one two one";
  Replace(strBuffer, "one", "three");
  CHECK(strBuffer == "three two three");
  CHECK(MatchPattern("fb12", "^fb[[:digit:]]+$"));
  CHECK_FALSE(MatchPattern("fb", "^fb[[:digit:]]+$"));
  CHECK_FALSE(MatchPattern("fb", "("));
  ::setenv("ARGOS_COMPAT_TEST", "value", 1);
  strBuffer = "a/$ARGOS_COMPAT_TEST/b$ARGOS_COMPAT_TEST_UNSET";
  CHECK(ExpandEnvVariables(strBuffer) == "a/value/b");
  CHECK(strBuffer == "a/value/b");
}

/* 2.5 logging                          */

class CLogUser {
 public:
  std::string GetId() const { return "fb0"; }
  void Say() {
    RLOG << "hello" << std::endl;
    RLOGERR << "trouble" << std::endl;
  }
};

TEST_CASE("compat: logs work as documented", "[compat]") {
  std::ostringstream cStream;
  CARGoSLog cLog(cStream, SLogColor(ARGOS_LOG_ATTRIBUTE_BRIGHT, ARGOS_LOG_COLOR_GREEN));
  CHECK(cLog.IsColoredOutput());
  cLog.DisableColoredOutput();
  CHECK_FALSE(cLog.IsColoredOutput());
  cLog << "x = " << 1.5 << ' ' << true << std::endl;
  CHECK(cStream.str().empty());
  cLog.Flush();
  CHECK(cStream.str() == "x = 1.5 1\n");
  cLog.EnableColoredOutput();
  cLog << "green";
  cLog.Flush();
  CHECK(cStream.str() == "x = 1.5 1\n\033[1;32mgreen\033[0m");
  CHECK(&cLog.GetStream() == &cStream);
  std::thread([&] {
    cLog.AddThreadSafeBuffer();
    cLog << "thread";
  }).join();
  cLog.Flush();
  CHECK(cStream.str().find("thread") != std::string::npos);

  std::ostringstream cOut;
  std::streambuf* pcOld = LOG.GetStream().rdbuf(cOut.rdbuf());
  std::streambuf* pcOldErr = LOGERR.GetStream().rdbuf(cOut.rdbuf());
  LOG.DisableColoredOutput();
  LOGERR.DisableColoredOutput();
  CLogUser().Say();
  argos::LOG.Flush();
  argos::LOGERR.Flush();
  LOG.GetStream().rdbuf(pcOld);
  LOGERR.GetStream().rdbuf(pcOldErr);
  CHECK(cOut.str() == "[fb0] hello\n[fb0] trouble\n");
}

TEST_CASE("compat: text can be coloured", "[compat]") {
  static_assert(ARGOS_LOG_ATTRIBUTE_RESET == 0 && ARGOS_LOG_ATTRIBUTE_DIM == 2 &&
                    ARGOS_LOG_ATTRIBUTE_UNDERSCORE == 3 && ARGOS_LOG_ATTRIBUTE_BLINK == 5 &&
                    ARGOS_LOG_ATTRIBUTE_REVERSE == 7 && ARGOS_LOG_ATTRIBUTE_HIDDEN == 8,
                "");
  static_assert(ARGOS_LOG_COLOR_BLACK == 0 && ARGOS_LOG_COLOR_RED == 1 &&
                    ARGOS_LOG_COLOR_YELLOW == 3 && ARGOS_LOG_COLOR_BLUE == 4 &&
                    ARGOS_LOG_COLOR_MAGENTA == 5 && ARGOS_LOG_COLOR_CYAN == 6 &&
                    ARGOS_LOG_COLOR_WHITE == 7,
                "");
  SLogColor sColor(ARGOS_LOG_ATTRIBUTE_BLINK, ARGOS_LOG_COLOR_CYAN);
  EARGoSLogAttributes eAttribute = ARGOS_LOG_ATTRIBUTE_BLINK;
  EARGoSLogColors eColor = ARGOS_LOG_COLOR_CYAN;
  CHECK(sColor.Attribute == eAttribute);
  CHECK(sColor.Foreground == eColor);
  SLogColor sDefault;
  sDefault = sColor;
  std::ostringstream cStream;
  cStream << sDefault;
  CHECK(cStream.str() == "\033[5;36m");
  cStream << argos::red << argos::green << argos::yellow << argos::blue << argos::magenta
          << argos::cyan << argos::white << argos::reset;
  std::ostream& (*pcManipulator)(std::ostream&) = &argos::red;
  cStream << pcManipulator;
  CHECK(cStream.good());
}

/* 2.6 colours                          */

static const CColor STATIC_COLOR = CColor::ORANGE;

TEST_CASE("compat: colours work as documented", "[compat]") {
  CHECK(STATIC_COLOR == CColor(255, 140, 0));
  CColor cColor;
  CHECK(cColor == CColor::BLACK);
  CHECK(cColor != CColor::WHITE);
  cColor = CColor(10, 20, 30, 40);
  CHECK(cColor.GetRed() == 10);
  CHECK(cColor.GetGreen() == 20);
  CHECK(cColor.GetBlue() == 30);
  CHECK(cColor.GetAlpha() == 40);
  cColor.SetRed(1);
  cColor.SetGreen(2);
  cColor.SetBlue(3);
  cColor.SetAlpha(4);
  CHECK(cColor == CColor(1, 2, 3, 4));
  cColor.Set(5, 6, 7);
  CHECK(cColor == CColor(5, 6, 7, 255));
  cColor.Set("purple");
  CHECK(cColor == CColor::PURPLE);
  cColor.Set("9,8,7,6");
  CHECK(cColor == CColor(9, 8, 7, 6));
  CHECK_THROWS_AS(cColor.Set("no_color"), CARGoSException);
  CHECK_THAT(CColor::RED.ToGrayScale(), WithinAbs(0.299 * 255, 1e-12));
  CHECK(CColor(255, 0, 0, 0).Blend(CColor::BLUE) == CColor::BLUE);
  UInt32 unColor = cColor;
  UInt8 pnBytes[4];
  ::memcpy(pnBytes, &unColor, 4);
  CHECK((pnBytes[0] == 9 && pnBytes[1] == 8 && pnBytes[2] == 7 && pnBytes[3] == 6));
  std::ostringstream cOut;
  cOut << CColor::GRAY50 << " " << CColor(1, 2, 3, 4);
  CHECK(cOut.str() == "gray50 1,2,3,4");
  std::istringstream cIn("brown");
  cIn >> cColor;
  CHECK(cColor == CColor(165, 42, 42));
  const CColor* ppcAll[] = {&CColor::BLACK,  &CColor::WHITE,   &CColor::RED,    &CColor::GREEN,
                            &CColor::BLUE,   &CColor::MAGENTA, &CColor::CYAN,   &CColor::YELLOW,
                            &CColor::ORANGE, &CColor::BROWN,   &CColor::PURPLE, &CColor::GRAY10,
                            &CColor::GRAY20, &CColor::GRAY30,  &CColor::GRAY40, &CColor::GRAY50,
                            &CColor::GRAY60, &CColor::GRAY70,  &CColor::GRAY80, &CColor::GRAY90};
  CHECK(ppcAll[11]->GetRed() == 26);
  CHECK(ppcAll[19]->GetBlue() == 229);
  // the constants are not const, and user code relies on it
  CColor& cMutable = CColor::GRAY10;
  CHECK(&cMutable == &CColor::GRAY10);
}

/* 2.7 byte arrays                      */

static size_t SizeOf(const CByteArray& c_array) {
  return c_array.Size();
}

template <typename T>
static void CheckRoundTrip(const T& t_value, size_t un_size) {
  CByteArray cArray;
  cArray << t_value;
  CHECK(cArray.Size() == un_size);
  T tValue{};
  cArray >> tValue;
  CHECK(tValue == t_value);
  CHECK(cArray.Empty());
  cArray << t_value;
  CHECK(cArray.PopFront<T>() == t_value);
}

TEST_CASE("compat: byte arrays work as documented", "[compat]") {
  CHECK(SizeOf(10) == 10);
  CByteArray cEmpty;
  const CByteArray& cConst = cEmpty;
  CHECK(cConst.Empty());
  CHECK(cConst.ToCArray() == NULL);
  UInt8 punBuffer[3] = {1, 2, 3};
  CByteArray cArray(punBuffer, 3);
  CByteArray cCopy(cArray);
  CHECK(cCopy == cArray);
  CHECK(cArray.ToCArray()[2] == 3);
  cArray.ToCArray()[2] = 4;
  CHECK(static_cast<const CByteArray&>(cArray)[2] == 4);
  cArray[0] = 9;
  CHECK(cArray[0] == 9);
  CHECK_THROWS_AS(cArray[3], CARGoSException);
  CHECK_THROWS_AS(static_cast<const CByteArray&>(cArray)[3], CARGoSException);
  cArray.Resize(5, 7);
  CHECK(cArray[4] == 7);
  cArray.Resize(1);
  cArray.Swap(cCopy);
  CHECK(cArray.Size() == 3);
  cArray.Zero();
  CHECK((cArray.Size() == 3 && cArray[0] == 0));
  cArray.Clear();
  CHECK(cArray.Size() == 0);
  cArray = CByteArray(2, 5);
  cArray.AddBuffer(punBuffer, 3).AddBuffer(punBuffer, 1);
  CHECK(cArray.Size() == 6);
  UInt8 punFetched[2];
  cArray.FetchBuffer(punFetched, 2);
  CHECK((punFetched[0] == 5 && cArray.Size() == 4));
  CHECK_THROWS_AS(cArray.FetchBuffer(punBuffer, 100), CARGoSException);
  CByteArray* pcPart = cArray(1, 3);
  CHECK((pcPart->Size() == 2 && (*pcPart)[0] == 2));
  delete pcPart;
  pcPart = cArray(1);
  CHECK(pcPart->Size() == 3);
  delete pcPart;
  std::ostringstream cOut;
  cOut << CByteArray(punBuffer, 3);
  CHECK(cOut.str() == "CByteArray [ 1 2 3 ]\n");
}

TEST_CASE("compat: byte arrays are queues of numbers and strings", "[compat]") {
  CheckRoundTrip<UInt8>(200, 1);
  CheckRoundTrip<SInt8>(-100, 1);
  CheckRoundTrip<UInt16>(60000, 2);
  CheckRoundTrip<SInt16>(-30000, 2);
  CheckRoundTrip<UInt32>(4000000000U, 4);
  CheckRoundTrip<SInt32>(-2000000000, 4);
  CheckRoundTrip<UInt64>(1ULL << 63, 8);
  CheckRoundTrip<SInt64>(-(1LL << 62), 8);
  CheckRoundTrip<unsigned long int>(123456UL, sizeof(long));
  CheckRoundTrip<signed long int>(-123456L, sizeof(long));
  CheckRoundTrip<double>(0.375, 12);
  CheckRoundTrip<float>(-1024.5f, 12);
  CByteArray cArray;
  cArray << std::string("one") << std::string("two");
  CHECK(cArray.Size() == 8);
  std::string strOne, strTwo;
  cArray >> strOne >> strTwo;
  CHECK((strOne == "one" && strTwo == "two"));
  UInt32 unValue;
  CHECK_THROWS_AS(cArray >> unValue, CARGoSException);
  // network byte order
  cArray << static_cast<UInt16>(0x0102);
  CHECK((cArray[0] == 1 && cArray[1] == 2));
}

/* 2.8 the others                       */

TEST_CASE("compat: any stores values", "[compat]") {
  int nValue = 3;
  CAny cAny(&nValue);
  CAny cCopy(cAny);
  CAny cEmpty;
  CHECK(*any_cast<int*>(cCopy) == 3);
  CHECK(any_cast<const int*>(&cAny) == NULL);
  CHECK(*any_cast<int*>(&cAny) == &nValue);
  CHECK_THROWS(any_cast<double*>(cAny));
  cEmpty = 2.5;
  CHECK(any_cast<double>(cEmpty) == 2.5);
  cEmpty.swap(cAny);
  CHECK(any_cast<double>(cAny) == 2.5);
  cEmpty = cAny;
  const CAny& cConst = cEmpty;
  CHECK(any_cast<double>(cConst) == 2.5);
  CHECK(*any_cast<double>(&cConst) == 2.5);
  any_cast<double>(cEmpty) = 3.5;
  CHECK(any_cast<double>(cEmpty) == 3.5);
}

class CState : public CMemento {
 public:
  virtual void SaveState(CByteArray& c_buffer) { c_buffer << m_unState; }
  virtual void LoadState(CByteArray& c_buffer) { c_buffer >> m_unState; }
  UInt32 m_unState = 0;
};

TEST_CASE("compat: memento stores a state", "[compat]") {
  CState cA, cB;
  cA.m_unState = 5;
  CByteArray cBuffer;
  CMemento& cMemento = cA;
  cMemento.SaveState(cBuffer);
  cB.LoadState(cBuffer);
  CHECK(cB.m_unState == 5);
}

struct SBackwards {
  bool operator()(const int* a, const int* b) const { return *a > *b; }
};

TEST_CASE("compat: set works as documented", "[compat]") {
  int pn[3] = {1, 2, 3};
  CSet<int*, SBackwards> cSet;
  cSet.insert(&pn[1]);
  cSet.insert(&pn[0]);
  cSet.insert(&pn[2]);
  cSet.insert(&pn[2]);
  CHECK(cSet.size() == 3);
  CHECK(cSet.first() == &pn[2]);
  CHECK(cSet.last() == &pn[0]);
  const CSet<int*, SBackwards>& cConst = cSet;
  CHECK(cConst.first() == &pn[2]);
  CHECK(cConst.last() == &pn[0]);
  CHECK_FALSE(cConst.empty());
  CHECK(cSet.exists(&pn[0]));
  int nSum = 0;
  // the iterator's type does not depend on the comparison
  for (CSet<int*>::iterator it = cSet.begin(); it != cSet.end(); ++it)
    nSum = 10 * nSum + **it;
  CHECK(nSum == 321);
  CSet<int*>::const_iterator itConst = cSet.begin();
  CHECK(*itConst == &pn[2]);
  CSet<int*>::iterator itFound = cSet.find(&pn[1]);
  CHECK(*itFound == &pn[1]);
  cSet.erase(itFound);
  cSet.erase(&pn[0]);
  CHECK(cSet.size() == 1);
  CSet<int*, SBackwards> cCopy(cSet), cAssigned;
  cAssigned = cCopy;
  CHECK(cAssigned.size() == 1);
  cSet.clear();
  CHECK(cSet.empty());
  CSet<std::string> cNames;
  cNames.insert("b");
  cNames.insert("a");
  CHECK(cNames.begin()->size() == 1);
  CHECK(cNames.first() == "a");
}

TEST_CASE("compat: rate, statistics and filter work as documented", "[compat]") {
  CRate cRate(1000.0);
  CHECK(cRate.GetRate() == 1000.0);
  cRate.SetRate(500.0);
  cRate.Sleep();
  CHECK(cRate.ElapsedUS() < 1000000000ULL);
  CHECK(cRate.ElapsedS() >= 0.0);
  CStats cStats;
  cStats.Append(1.0);
  cStats.Append(3.0);
  CHECK(cStats.GetMean() == 2.0);
  CHECK_THAT(cStats.GetStdDev() * cStats.GetStdDev(), WithinAbs(cStats.GetVariance(), 1e-15));
  CRCLowPassFilter cFilter(0.5);
  CHECK(cFilter.Filter(4.0) == 4.0);
  CHECK(cFilter.Filter(0.0) == 2.0);
  cFilter.Reset();
  CHECK(cFilter.Filter(1.0) == 1.0);
}

TEST_CASE("compat: sockets work as documented", "[compat]") {
  CTCPSocket cServer, cClient, cAccepted;
  CHECK_FALSE(cServer.IsConnected());
  CTCPSocket cMoved(std::move(cAccepted));
  cMoved = CTCPSocket();
  CHECK(cMoved.GetStream() == -1);
  void (CTCPSocket::*pfnConnect)(const std::string&, SInt32) = &CTCPSocket::Connect;
  CHECK(pfnConnect != nullptr);
  cServer.Disconnect();
}

class CParser : public CCommandLineArgParser {
 public:
  virtual void PrintUsage(CARGoSLog& c_log) { CCommandLineArgParser::PrintUsage(c_log); }
  virtual void Parse(SInt32 n_argc, char** ppch_argv) {
    CCommandLineArgParser::Parse(n_argc, ppch_argv);
  }
};

TEST_CASE("compat: command lines are parsed", "[compat]") {
  CParser cParser;
  bool bFlag = false;
  std::string strFile;
  UInt32 unNumber = 0;
  cParser.AddFlag('f', "flag", "a flag", bFlag);
  cParser.AddArgument<std::string>('c', "file", "a file", strFile);
  cParser.AddArgument('n', "number", "a number", unNumber);
  char pchName[] = "program", pchFlag[] = "-f", pchFile[] = "--file", pchValue[] = "x.argos",
       pchN[] = "-n", pchFive[] = "5";
  char* ppchArgv[] = {pchName, pchFlag, pchFile, pchValue, pchN, pchFive};
  cParser.Parse(6, ppchArgv);
  CHECK(bFlag);
  CHECK(strFile == "x.argos");
  CHECK(unNumber == 5);
  std::ostringstream cStream;
  CARGoSLog cLog(cStream, SLogColor(), false);
  cParser.PrintUsage(cLog);
  cLog.Flush();
  CHECK(cStream.str().find("--number") != std::string::npos);
}

}  // namespace utility_test
