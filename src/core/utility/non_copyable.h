#ifndef ARGOS3_CORE_UTILITY_NON_COPYABLE_H
#define ARGOS3_CORE_UTILITY_NON_COPYABLE_H

namespace argos {

/** Base of classes whose objects can be neither copied nor moved. */
class CNonCopyable {
 public:
  CNonCopyable(const CNonCopyable&) = delete;
  CNonCopyable& operator=(const CNonCopyable&) = delete;

 protected:
  CNonCopyable() = default;
  ~CNonCopyable() = default;
};

}  // namespace argos

#endif
