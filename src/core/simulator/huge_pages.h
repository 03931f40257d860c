#ifndef ARGOS3_CORE_SIMULATOR_HUGE_PAGES_H
#define ARGOS3_CORE_SIMULATOR_HUGE_PAGES_H

#include <cstddef>

namespace argos {

/**
 * Asks the system to back the heap, as it is now, by pages of 2 MB.
 *
 * A tick goes through a few kilobytes of each robot. In a large swarm most of these are on a page
 * of 4 kB of their own, more than the processor has places for in its table of pages. Nothing else
 * changes: what is in the heap stays where it is, and a system that cannot do this does nothing.
 *
 * @return the bytes that were asked for and granted; 0 for a heap below 64 MB, which is not worth
 *         it.
 */
size_t BackHeapByHugePages();

}  // namespace argos

#endif
