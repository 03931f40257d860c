#include <argos3/plugins/robots/prototype/simulator/prototype_assembly.h>

#include <argos3/core/simulator/geometry/articulation.h>
#include <argos3/core/utility/logging/argos_log.h>
#include <argos3/core/utility/math/angles.h>
#include <argos3/core/utility/text/string_utilities.h>
#include <argos3/plugins/robots/generic/simulator/described_parts.h>
#include <argos3/plugins/simulator/entities/value_checks.h>

#include <cmath>
#include <sstream>
#include <utility>

namespace argos {

namespace {

// m and rad: a link this far from its own position is warned of
constexpr Real kPlaceTolerance = 1e-3;
constexpr Real kTurnTolerance = 0.01;

struct SLinkNode {
  TConfigurationNode* Node = nullptr;
  SShapeDescription Shape;  // frame: link
  SBodyPose Described;  // pose that the XML of the link gives
  bool IsPlaced = false;
};

// one end of a joint
struct SJointEnd {
  size_t Link = 0;
  SBodyPose Frame;  // frame: link
};

struct SJointNode {
  TConfigurationNode* Node = nullptr;
  std::string Id;
  std::string Type;
  CVector3 Axis;
  std::optional<CRange<Real>> Limits;
  bool LinksCollide = false;
  SJointEnd Parent;
  SJointEnd Child;
  bool IsUsed = false;
};

SBodyPose ReadPose(TConfigurationNode& node) {
  SBodyPose pose;
  GetNodeAttributeOrDefault(node, "position", pose.Position, pose.Position);
  GetNodeAttributeOrDefault(node, "orientation", pose.Orientation, pose.Orientation);
  return pose;
}

/** Reads the elements, then places the links from the reference link on. */
class CAssembler {
 public:
  explicit CAssembler(TConfigurationNode& prototype) {
    TConfigurationNode& links = GetNode(prototype, "links");
    ReadLinks(links);
    if (NodeExists(prototype, "joints")) {
      ReadJoints(GetNode(prototype, "joints"));
    }
    GetNodeAttribute(links, "ref", m_reference);
    m_start = FindLink(m_reference, OwnerOf(links) + ": attribute \"ref\"");
  }

  SPrototypeAssembly Assemble(bool movable) {
    PlaceLinks();
    auto body = std::make_shared<SBodyDescription>();
    for (size_t i = 0; i < m_links.size(); ++i) {
      if (!m_links[i].IsPlaced) {
        THROW_ARGOSEXCEPTION(OwnerOf(*m_links[i].Node)
                             << ": no joint connects link \"" << m_result.Links[i].Id
                             << "\" to the reference link \"" << m_reference << "\"");
      }
      WarnIfElsewhere(i);
      body->Shapes.push_back(PlaceShape(i));
      body->Mass += body->Shapes.back().Mass;
    }
    if (!m_moving.Joints.empty()) {
      for (const SPlacedLink& link : m_result.Links) {
        m_moving.Anchors[link.Id] = link.Group;
      }
      m_moving.HasFixedBase = !movable;
      body->Articulation = std::make_shared<const SArticulation>(std::move(m_moving));
    } else if (movable) {
      body->GroundFriction = SGroundFrictionDescription();  // boxes have the same
    }
    m_result.Body = std::move(body);
    return std::move(m_result);
  }

 private:
  void ReadLinks(TConfigurationNode& links) {
    TConfigurationNodeIterator child("link");
    for (child = child.begin(&links); child != child.end(); ++child) {
      SPlacedLink placed;
      GetNodeAttribute(*child, "id", placed.Id);
      for (const SPlacedLink& other : m_result.Links) {
        if (other.Id == placed.Id) {
          THROW_ARGOSEXCEPTION(OwnerOf(*child)
                               << ": there is already a link \"" << placed.Id << "\"");
        }
      }
      SLinkNode link;
      link.Node = &*child;
      link.Shape = ReadSolid(*child);
      ReadIn(kMass, *child, "mass", link.Shape.Mass);
      link.Described = ReadPose(*child);
      m_links.push_back(link);
      m_result.Links.push_back(placed);
    }
    if (m_links.empty()) {
      THROW_ARGOSEXCEPTION(OwnerOf(links) << " needs at least one child <link>");
    }
  }

  void ReadJoints(TConfigurationNode& joints) {
    TConfigurationNodeIterator child("joint");
    for (child = child.begin(&joints); child != child.end(); ++child) {
      SJointNode joint;
      joint.Node = &*child;
      GetNodeAttributeOrDefault(*child, "id", joint.Id, "joint_" + ToString(m_joints.size()));
      for (const SJointNode& other : m_joints) {
        if (other.Id == joint.Id) {
          THROW_ARGOSEXCEPTION(OwnerOf(*child)
                               << ": there is already a joint \"" << joint.Id << "\"");
        }
      }
      ReadMotion(joint);
      bool disableCollision = true;
      GetNodeAttributeOrDefault(*child, "disable_collision", disableCollision, disableCollision);
      joint.LinksCollide = !disableCollision;
      joint.Parent = ReadEnd(*child, "parent");
      joint.Child = ReadEnd(*child, "child");
      m_joints.push_back(joint);
    }
  }

  static void ReadMotion(SJointNode& joint) {
    TConfigurationNode& node = *joint.Node;
    GetNodeAttribute(node, "type", joint.Type);
    const bool turns = joint.Type == "revolute";
    if (joint.Type == "fixed" || joint.Type == "spherical") {
      return;
    }
    if (!turns && joint.Type != "prismatic") {
      THROW_ARGOSEXCEPTION(
          OwnerOf(node) << ": unknown type \"" << joint.Type << "\""
                        << DidYouMean(joint.Type, {"fixed", "prismatic", "revolute", "spherical"}));
    }
    GetNodeAttribute(node, "axis", joint.Axis);
    if (!(joint.Axis.Length() > 0.0)) {
      THROW_ARGOSEXCEPTION(OwnerOf(node) << ": attribute \"axis\" must not be zero, got \""
                                         << joint.Axis << "\"");
    }
    joint.Axis.Normalize();
    if (NodeAttributeExists(node, "limit")) {
      CRange<Real> limits;
      GetNodeAttribute(node, "limit", limits);
      if (turns && std::max(-limits.GetMin(), limits.GetMax()) > 180.0) {
        THROW_ARGOSEXCEPTION(OwnerOf(node)
                             << ": attribute \"limit\" must be within -180:180 degrees, got \""
                             << limits << "\"");
      }
      const Real unit = turns ? ARGOS_PI / 180.0 : 1.0;
      joint.Limits = CRange<Real>(limits.GetMin() * unit, limits.GetMax() * unit);
    }
  }

  SJointEnd ReadEnd(TConfigurationNode& joint, const std::string& tag) const {
    TConfigurationNode& node = GetNode(joint, tag);
    std::string link;
    GetNodeAttribute(node, "link", link);
    return {FindLink(link, OwnerOf(node) + ": attribute \"link\""), ReadPose(node)};
  }

  size_t FindLink(const std::string& id, const std::string& owner) const {
    std::vector<std::string> known;
    for (size_t i = 0; i < m_result.Links.size(); ++i) {
      if (m_result.Links[i].Id == id) {
        return i;
      }
      known.push_back(m_result.Links[i].Id);
    }
    THROW_ARGOSEXCEPTION(owner << ": there is no link \"" << id << "\"" << DidYouMean(id, known));
  }

  // breadth first, so that a joint moves a group of a higher number relative to one of a lower
  void PlaceLinks() {
    m_result.Links[m_start].Pose = m_links[m_start].Described;
    m_links[m_start].IsPlaced = true;
    std::vector<size_t> order = {m_start};
    for (size_t next = 0; next < order.size(); ++next) {
      for (SJointNode& joint : m_joints) {
        const bool isParent = joint.Parent.Link == order[next];
        if (joint.IsUsed || (!isParent && joint.Child.Link != order[next])) {
          continue;
        }
        joint.IsUsed = true;
        order.push_back(Attach(joint, isParent ? joint.Parent : joint.Child,
                               isParent ? joint.Child : joint.Parent));
      }
    }
  }

  size_t Attach(const SJointNode& joint, const SJointEnd& from, const SJointEnd& to) {
    if (m_links[to.Link].IsPlaced) {
      THROW_ARGOSEXCEPTION(OwnerOf(*joint.Node)
                           << ": joint \"" << joint.Id << "\" closes a loop, since \""
                           << m_result.Links[to.Link].Id << "\" is already connected to \""
                           << m_reference << "\"; joints must form a tree");
    }
    const SPlacedLink& near = m_result.Links[from.Link];
    SPlacedLink& far = m_result.Links[to.Link];
    const SBodyPose frame = Compose(near.Pose, from.Frame);
    far.Pose = Compose(frame, Invert(to.Frame));
    far.Group = near.Group;
    m_links[to.Link].IsPlaced = true;
    if (joint.Type == "fixed") {
      return to.Link;
    }
    far.Group = static_cast<UInt32>(m_moving.GetNumLinks());
    SJointDescription moving;
    moving.Id = joint.Id;
    using EKind = SJointDescription::EKind;
    moving.Kind = joint.Type == "revolute"    ? EKind::Hinge
                  : joint.Type == "prismatic" ? EKind::Slider
                                              : EKind::Ball;
    moving.Parent = m_result.Links[joint.Parent.Link].Group;
    moving.Child = m_result.Links[joint.Child.Link].Group;
    moving.Pivot = frame.Position;
    moving.Axis = joint.Axis;
    moving.Axis.Rotate(frame.Orientation);
    moving.Limits = joint.Limits;
    moving.LinksCollide = joint.LinksCollide;
    m_moving.Joints.push_back(moving);
    return to.Link;
  }

  void WarnIfElsewhere(size_t number) const {
    const SLinkNode& link = m_links[number];
    if (!NodeAttributeExists(*link.Node, "position")) {
      return;
    }
    const SBodyPose& pose = m_result.Links[number].Pose;
    const SBodyPose difference = Compose(Invert(link.Described), pose);
    const Real turn = 2.0 * std::acos(std::min<Real>(1.0, std::abs(difference.Orientation.GetW())));
    if (difference.Position.Length() > kPlaceTolerance || turn > kTurnTolerance) {
      LOGERR << "[WARNING] " << OwnerOf(*link.Node) << ": the joints put link \""
             << m_result.Links[number].Id << "\" at \"" << pose.Position << "\", turned by \""
             << pose.Orientation << "\", not at its own position \"" << link.Described.Position
             << "\" and orientation" << std::endl;
    }
  }

  SShapeDescription PlaceShape(size_t number) const {
    const SPlacedLink& link = m_result.Links[number];
    SShapeDescription shape = m_links[number].Shape;
    const SBodyPose pose = Compose(link.Pose, {shape.Offset, shape.Orientation});
    shape.Offset = pose.Position;
    shape.Orientation = pose.Orientation;
    shape.Link = link.Group;
    return shape;
  }

  std::vector<SLinkNode> m_links;
  std::vector<SJointNode> m_joints;
  std::string m_reference;
  size_t m_start = 0;
  SArticulation m_moving;
  SPrototypeAssembly m_result;
};

}  // namespace

SPrototypeAssembly AssemblePrototype(TConfigurationNode& prototype, bool movable) {
  return CAssembler(prototype).Assemble(movable);
}

}  // namespace argos
