#ifndef ARGOS3_CAMPAIGN_REPORT_REPORT_TEXT_H
#define ARGOS3_CAMPAIGN_REPORT_REPORT_TEXT_H

// private: numbers and users' text in reports

#include <argos3/core/utility/datatypes/datatypes.h>

#include <exception>
#include <string>

namespace argos {

/** Four significant digits, or whole up to a million; "-" if it is missing (NaN). */
std::string FormatNumber(Real value);
/** All digits that are needed to read the same number; empty if it is missing. */
std::string FormatExactly(Real value);
/** "2 to 5". */
std::string FormatRange(Real lower, Real upper);
/** "p = 0.012" or "p < 0.001". */
std::string FormatPValue(Real value);
/** Of seconds: "12.3 s", "4 min 5 s", "3 h 20 min". */
std::string FormatDuration(Real seconds);
/** "95 %". */
std::string FormatLevel(Real level);

/**
 * Users' text for a page: &, <, >, quotes are escaped; control characters, except for tab and
 * newline, and bytes that are not UTF-8 become U+FFFD.
 */
std::string EscapeHTML(const std::string& text);

/** Users' text without control characters, on one line; bytes that are not UTF-8: U+FFFD. */
std::string MakeLine(const std::string& text);

/** A field of a CSV file (RFC 4180), on one line. */
std::string QuoteField(const std::string& text);

/** "spread (m)", with blanks for '_'. @param unit  may be empty. */
std::string MakeLabel(const std::string& name, const std::string& unit);

/** The message of an exception on one line, without "[FATAL]". */
std::string DescribeProblem(const std::exception& error);

/** "1 run", "2 runs". */
std::string Count(size_t count, const std::string& noun);

}  // namespace argos

#endif
