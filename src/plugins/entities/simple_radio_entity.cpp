#include <argos3/plugins/simulator/entities/simple_radio_entity.h>

#include <argos3/core/simulator/entity/robots_code.h>
#include <argos3/core/simulator/space/space.h>
#include <argos3/core/utility/datatypes/digest.h>
#include <argos3/plugins/simulator/entities/value_checks.h>

#include <algorithm>

namespace argos {

namespace {

void AddBytes(CDigest& digest, const CByteArray& message) {
  digest.Add(message.Size());
  for (size_t i = 0; i < message.Size(); ++i) {
    digest.Add(message.ToCArray()[i]);
  }
}

}  // namespace

CSimpleRadioEntity::CSimpleRadioEntity(CComposableEntity* parent) : CMediumMember(parent) {}

CSimpleRadioEntity::CSimpleRadioEntity(CComposableEntity* parent, const std::string& id, Real range)
    : CMediumMember(parent, id, CVector3()) {
  SetRange(range);
}

CSimpleRadioEntity::~CSimpleRadioEntity() {
  ClearMedium();
}

void CSimpleRadioEntity::Init(TConfigurationNode& tree) {
  CMediumMember::Init(tree);
  GetNodeAttribute(tree, "range", m_range);
  RequireNotNegative(m_range, OwnerOf(tree), "attribute \"range\" (m)");
}

void CSimpleRadioEntity::Reset() {
  CMediumMember::Reset();
  m_spare.Shrink(m_messages, 0);
  m_numOld = 0;
  m_outbox.clear();
}

void CSimpleRadioEntity::SetRange(Real range) {
  CRobotsCode::CheckOwn(*this, "SetRange()");
  RequireNotNegative(range, "radio \"" + GetContext() + GetId() + "\"", "range (m)");
  KeepForReset(m_range);
  m_range = range;
}

void CSimpleRadioEntity::ReceiveMessage(const CVector3& origin, const CByteArray& message) {
  CRobotsCode::CheckOwn(*this, "ReceiveMessage()");
  TMessage& received = m_spare.Append(m_messages);
  received.first = origin;
  received.second = message;
}

void CSimpleRadioEntity::Send(std::vector<CByteArray>& outbox) {
  if (CRobotsCode::MayRun()) {
    CRobotsCode::CheckOwn(*this, "Send()");
  }
  if (m_outbox.empty()) {
    m_outbox.swap(outbox);
  } else {
    std::move(outbox.begin(), outbox.end(), std::back_inserter(m_outbox));
  }
  outbox.clear();
}

void CSimpleRadioEntity::Read(std::vector<CByteArray>& read) {
  m_spareBytes.Shrink(read, 0);
  for (TMessage& message : m_messages) {
    m_spareBytes.Append(read).Swap(message.second);
  }
  m_spare.Shrink(m_messages, 0);
  m_numOld = 0;
}

void CSimpleRadioEntity::DropOldMessages() {
  if (m_numOld > 0) {
    std::rotate(m_messages.begin(), m_messages.begin() + static_cast<std::ptrdiff_t>(m_numOld),
                m_messages.end());
    m_spare.Shrink(m_messages, m_messages.size() - m_numOld);
  }
  m_numOld = m_messages.size();
}

void CSimpleRadioEntity::Deliver(const CVector3& origin, const std::vector<CByteArray>& messages) {
  for (const CByteArray& message : messages) {
    ReceiveMessage(origin, message);
  }
  m_numOld = m_messages.size();
}

void CSimpleRadioEntity::UpdateDigest(CDigest& digest) const {
  CMediumMember::UpdateDigest(digest);
  digest.Add(m_range);
  digest.Add(m_messages.size());
  for (const TMessage& message : m_messages) {
    AddBytes(digest, message.second);
  }
  digest.Add(m_outbox.size());
  for (const CByteArray& message : m_outbox) {
    AddBytes(digest, message);
  }
}

REGISTER_STANDARD_SPACE_OPERATIONS_ON_ENTITY(CSimpleRadioEntity)

}  // namespace argos
