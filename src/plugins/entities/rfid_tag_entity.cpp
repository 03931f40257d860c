#include <argos3/plugins/simulator/entities/rfid_tag_entity.h>

#include <argos3/core/simulator/context/current.h>
#include <argos3/core/simulator/entity/composable_entity.h>
#include <argos3/core/simulator/entity/robots_code.h>
#include <argos3/core/simulator/space/space_operations.h>
#include <argos3/core/utility/datatypes/digest.h>
#include <argos3/core/utility/string_utilities.h>
#include <argos3/plugins/simulator/entities/read_medium.h>
#include <argos3/core/utility/text/classic_locale.h>

#include <algorithm>

namespace argos {

namespace {

constexpr UInt32 kDefaultMemory = 16;  // bytes
constexpr UInt32 kMaxMemory = 1 << 20;  // bytes; a larger value is assumed to be a mistake
// these serve drawing only
constexpr Real kDiameter = 0.03;  // m
constexpr Real kThickness = 0.002;  // m
constexpr CColor kColor(226, 168, 56);

const SAppearance& LyingTag() {
  static const SAppearance appearance{.Parts = {MakeRFIDTagPart(CVector3())}};
  return appearance;
}

CByteArray ReadData(TConfigurationNode& tree) {
  UInt32 memory = kDefaultMemory;
  GetNodeAttributeOrDefault(tree, "memory", memory, memory);
  if (memory > kMaxMemory) {
    THROW_ARGOSEXCEPTION(OwnerOf(tree) << ": attribute \"memory\" (bytes) must be at most "
                                       << kMaxMemory << ", got " << memory);
  }
  CByteArray data(memory);
  std::string text;
  GetNodeAttributeOrDefault(tree, "data", text, text);
  if (text.empty()) {
    return data;
  }
  std::vector<SInt32> numbers(1 + std::count(text.begin(), text.end(), ','));
  try {
    CTextInput stream(text);
    SetStrictParsing(stream, true);
    ParseValues<SInt32>(stream, static_cast<UInt32>(numbers.size()), numbers.data(), ',');
    const auto [least, greatest] = std::minmax_element(numbers.begin(), numbers.end());
    if (*least < 0 || *greatest > 255) {
      THROW_ARGOSEXCEPTION((*least < 0 ? *least : *greatest) << " is out of range");
    }
  } catch (std::exception& error) {
    THROW_ARGOSEXCEPTION_NESTED(
        OwnerOf(tree)
            << ": attribute \"data\" must be numbers from 0 to 255 separated by commas, got \""
            << text << "\"",
        error);
  }
  if (numbers.size() > memory) {
    THROW_ARGOSEXCEPTION(OwnerOf(tree) << ": attribute \"data\" has " << numbers.size()
                                       << " bytes, which exceed the memory of " << memory);
  }
  for (size_t i = 0; i < numbers.size(); ++i) {
    data[i] = static_cast<UInt8>(numbers[i]);
  }
  return data;
}

}  // namespace

SVisualPart MakeRFIDTagPart(const CVector3& position) {
  SVisualPart part;
  part.Kind = SVisualPart::EKind::Cylinder;
  part.Position = position;
  part.Size = CVector3(kDiameter, kDiameter, kThickness);
  part.Color = kColor;
  return part;
}

CRFIDTagEntity::CRFIDTagEntity() : CRFIDTagEntity(nullptr) {}

CRFIDTagEntity::CRFIDTagEntity(CComposableEntity* parent) : CMediumMember(parent) {}

CRFIDTagEntity::CRFIDTagEntity(CComposableEntity* parent, const std::string& id,
                               const CVector3& position, const CByteArray& data)
    : CMediumMember(parent, id, position), m_data(data), m_initData(data) {}

CRFIDTagEntity::~CRFIDTagEntity() {
  ClearMedium();
}

void CRFIDTagEntity::Init(TConfigurationNode& tree) {
  CMediumMember::Init(tree);
  m_initData = ReadData(tree);
  m_data = m_initData;
  if (!HasParent()) {
    SetMedium(ReadMedium<CRegistry>(tree, CurrentSimulator(), "an RFID medium"));
    Enable();
  }
}

void CRFIDTagEntity::Reset() {
  CMediumMember::Reset();
  m_data = m_initData;
}

void CRFIDTagEntity::SetData(const CByteArray& data) {
  if (data.Size() != m_data.Size()) {
    THROW_ARGOSEXCEPTION("RFID tag \"" << GetContext() << GetId() << "\" has a memory of "
                                       << m_data.Size() << " bytes, got " << data.Size());
  }
  if (CRobotsCode::MayRun() &&
      CRobotsCode::ChangesLater(*this, "SetData()", [this, data] { SetData(data); })) {
    return;
  }
  m_data = data;
}

bool CRFIDTagEntity::TryWrite(size_t offset, const CByteArray& bytes) {
  if (CRobotsCode::MayRun()) {
    CRobotsCode::CheckShared(*this, "TryWrite()");
  }
  if (offset > m_data.Size() || bytes.Size() > m_data.Size() - offset) {
    return false;
  }
  std::copy_n(bytes.ToCArray(), bytes.Size(), m_data.ToCArray() + offset);
  return true;
}

const std::string& CRFIDTagEntity::GetTagId() const {
  return m_tagId.empty() ? GetId() : m_tagId;
}

void CRFIDTagEntity::SetNumberInMedium(UInt32 number) {
  m_numberInMedium = number;
  // the ids of parents are final by now
  m_tagId = GetContext() + GetId();
}

const SAppearance* CRFIDTagEntity::GetAppearance() const {
  return HasParent() ? nullptr : &LyingTag();
}

void CRFIDTagEntity::UpdateDigest(CDigest& digest) const {
  CMediumMember::UpdateDigest(digest);
  for (size_t i = 0; i < m_data.Size(); ++i) {
    digest.Add(m_data.ToCArray()[i]);
  }
}

REGISTER_STANDARD_SPACE_OPERATIONS_ON_ENTITY(CRFIDTagEntity)

REGISTER_ENTITY(
    CRFIDTagEntity, "rfid_tag", "the authors of this project", "1.0",
    "A passive radio tag that robots can read and write.",
    R"(A tag with a small memory. Robots with the sensor "rfid" read the tags near them, those with the actuator "rfid"
write to the nearest one. It has no body: it neither collides with bodies nor occludes them.

REQUIRED XML

  <arena size="10,10,2">
    <rfid_tag id="t1" position="0.4,2.3,0" medium="rfid" />
  </arena>

with its medium:

  <media>
    <rfid id="rfid" />
  </media>

ATTRIBUTES

  id           text, required: unique among the entities of the arena.
  position     "x,y,z", m, default "0,0,0": in the world frame.
  orientation  "z,y,x", degrees, default "0,0,0": for drawing only.
  medium       text, required: the id of an RFID medium.

OPTIONAL XML

  <arena size="10,10,2">
    <rfid_tag id="t1" position="0.4,2.3,0" medium="rfid" memory="4" data="1,20,255" />
  </arena>

  memory  integer in [0,1048576], default 16: bytes of the memory.
  data    numbers from 0 to 255 separated by commas, default none: the first bytes of the memory at the start and
          after a reset; the rest is 0.

Boxes, cylinders and robots carry tags if their elements contain them; readers see the id "crate.rfid_tags_0.t1":

  <arena size="10,10,2">
    <box id="crate" size="0.3,0.2,0.2" movable="true" mass="2.5">
      <body position="0.4,0.3,0" />
      <rfid_tags medium="rfid">
        <rfid_tag id="t1" position="0,0,0.2" memory="8" />
      </rfid_tags>
    </box>
  </arena>

  rfid_tags@medium             text, required: the id of an RFID medium.
  rfid_tags/rfid_tag@id        text, default rfid_tag_0, rfid_tag_1, ...
  rfid_tags/rfid_tag@position  "x,y,z", m, default "0,0,0": in the frame of the anchor.
  rfid_tags/rfid_tag@anchor    text, default "origin": a frame of the body.
)",
    "Usable")

}  // namespace argos
