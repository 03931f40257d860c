#include <argos3/plugins/simulator/visualizations/scene/camera_timeline.h>

#include <argos3/core/utility/configuration/argos_exception.h>

namespace argos {

namespace {

void CheckSlot(std::size_t slot) {
  if (slot >= kNumPlacements) {
    THROW_ARGOSEXCEPTION("The camera has no placement " << slot << "; placements are numbered 0 to "
                                                        << kNumPlacements - 1);
  }
}

}  // namespace

void CCameraTimeline::SetPlacement(std::size_t slot, const SCameraPlacement& placement) {
  CheckSlot(slot);
  m_placements[slot] = placement;
  m_isSet[slot] = true;
}

void CCameraTimeline::AddKeyframe(const SKeyframe& keyframe) {
  CheckSlot(keyframe.Placement);
  if (!m_keyframes.empty() && keyframe.Step < m_keyframes.back().Step) {
    THROW_ARGOSEXCEPTION("The camera's keyframe at step "
                         << keyframe.Step << " follows one at step " << m_keyframes.back().Step
                         << "; steps must not decrease");
  }
  if (m_loop > 0 && keyframe.Step > m_loop) {
    THROW_ARGOSEXCEPTION("The camera's keyframe at step "
                         << keyframe.Step << " is after the timeline's loop of " << m_loop
                         << " ticks");
  }
  m_keyframes.push_back(keyframe);
}

void CCameraTimeline::InterpolateFromLastKeyframe() {
  if (m_keyframes.empty()) {
    THROW_ARGOSEXCEPTION(
        "The camera's timeline begins with <interpolate>; it must begin with a <keyframe>");
  }
  if (m_keyframes.back().Interpolate) {
    THROW_ARGOSEXCEPTION(
        "The camera's timeline has two <interpolate> in a row; put a <keyframe> between them");
  }
  m_keyframes.back().Interpolate = true;
}

void CCameraTimeline::CheckGlides() const {
  for (std::size_t i = 0; i < m_keyframes.size(); ++i) {
    const SKeyframe& from = m_keyframes[i];
    const SKeyframe& to = m_keyframes[(i + 1) % m_keyframes.size()];
    const bool isParallel = m_placements[from.Placement].OrthographicHeight > 0.0;
    const bool endsParallel = m_placements[to.Placement].OrthographicHeight > 0.0;
    const bool hasSuccessor = m_loop > 0 || i + 1 < m_keyframes.size();
    if (from.Interpolate && hasSuccessor && isParallel != endsParallel) {
      THROW_ARGOSEXCEPTION("The camera glides from placement "
                           << from.Placement << " to placement " << to.Placement
                           << ", of which only one is orthographic; give both the same projection, "
                              "or leave out <interpolate> between them");
    }
  }
}

SCameraPlacement CCameraTimeline::ComputeAt(std::uint32_t tick) const {
  if (m_keyframes.empty()) {
    return m_placements[0];
  }
  const bool loops = m_loop > 0;
  std::uint64_t step = loops ? tick % m_loop : tick;
  const std::size_t count = m_keyframes.size();
  std::size_t next = 0;
  while (next < count && m_keyframes[next].Step <= step) {
    ++next;
  }
  if (next == 0 && !loops) {
    return m_placements[0];
  }
  // the last keyframe of a round counts until the first one of the next
  const SKeyframe& current = m_keyframes[next == 0 ? count - 1 : next - 1];
  if (next == 0) {
    step += m_loop;
  }
  const bool hasSuccessor = next < count || loops;
  if (!current.Interpolate || !hasSuccessor) {
    return m_placements[current.Placement];
  }
  ARGOS_ASSERT(current.Step <= step,
               "a keyframe of step " << current.Step << " counts in step " << step);
  const SKeyframe& successor = m_keyframes[next % count];
  const bool wraps = next == 0 || next == count;
  const std::uint64_t end = std::uint64_t{successor.Step} + (wraps ? m_loop : 0);
  const double share =
      static_cast<double>(step - current.Step) / static_cast<double>(end - current.Step);
  return Interpolate(m_placements[current.Placement], m_placements[successor.Placement], share);
}

}  // namespace argos
