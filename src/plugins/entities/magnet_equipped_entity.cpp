#include <argos3/plugins/simulator/entities/magnet_equipped_entity.h>

#include <argos3/core/simulator/context/current.h>
#include <argos3/core/simulator/space/space_operations.h>
#include <argos3/plugins/simulator/entities/anchor_use.h>

namespace argos {

CMagnetEquippedEntity::CMagnetEquippedEntity(CComposableEntity* parent)
    : CMagnetEquippedEntity(parent, std::string()) {}

CMagnetEquippedEntity::CMagnetEquippedEntity(CComposableEntity* parent, const std::string& id)
    : CComposableEntity(parent, id) {}

void CMagnetEquippedEntity::Init(TConfigurationNode& tree) {
  CComposableEntity::Init(tree);
  auto& body = GetParent().GetComponent<CEmbodiedEntity>("body");
  TConfigurationNodeIterator child("magnet");
  for (child = child.begin(&tree); child != child.end(); ++child) {
    std::string anchor;
    CVector3 offset;
    GetNodeAttribute(*child, "anchor", anchor);
    GetNodeAttribute(*child, "offset", offset);
    auto magnet = std::make_unique<CMagnetEntity>(this);
    magnet->Init(*child);
    Mount(std::move(magnet), offset, body.GetAnchor(anchor));
  }
}

void CMagnetEquippedEntity::SetEnabled(bool enabled) {
  if (enabled == IsEnabled()) {
    return;
  }
  CComposableEntity::SetEnabled(enabled);
  for (const SInstance& instance : m_instances) {
    UseAnchor(instance.Anchor, enabled);
  }
}

void CMagnetEquippedEntity::AddMagnet(const std::string& id, const CVector3& offset,
                                      SAnchor& anchor, const CVector3& passiveField,
                                      const CVector3& activeField) {
  Mount(std::make_unique<CMagnetEntity>(
            this, id.empty() ? "magnet_" + std::to_string(GetNumMagnets()) : id, passiveField,
            activeField),
        offset, anchor);
}

void CMagnetEquippedEntity::Mount(std::unique_ptr<CMagnetEntity> magnet, const CVector3& offset,
                                  SAnchor& anchor) {
  CMagnetEntity& mounted = *magnet;
  AddComponent(*magnet.release());
  m_instances.push_back({mounted, offset, anchor});
  MountOnAnchor(anchor, *this);
  if (GetIndex() >= 0) {
    CallEntityOperation<CSpaceOperationAddEntity, CSpace, void>(CurrentSpace(), mounted);
  }
}

CMagnetEntity& CMagnetEquippedEntity::GetMagnet(UInt32 index) {
  if (index >= m_instances.size()) {
    THROW_ARGOSEXCEPTION("magnets \"" << GetContext() << GetId() << "\": no magnet " << index
                                      << "; there are " << m_instances.size()
                                      << ", numbered from 0");
  }
  return m_instances[index].Magnet;
}

REGISTER_STANDARD_SPACE_OPERATIONS_ON_COMPOSABLE(CMagnetEquippedEntity)

}  // namespace argos
