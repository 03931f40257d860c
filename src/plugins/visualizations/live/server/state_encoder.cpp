#include <argos3/plugins/simulator/visualizations/live/server/state_encoder.h>

namespace argos {

namespace {

bool HasSameSize(const SRecordedFloor* a, const SRecordedFloor* b) {
  return a == b || (a != nullptr && b != nullptr && a->Width == b->Width && a->Height == b->Height);
}

}  // namespace

// decoders refuse differences that do not go forward
bool CStateEncoder::NeedsKey(const SLiveState& state) const {
  return m_numFromKey >= kMaxStatesFromKey || m_table != state.Table ||
         state.Update.Tick <= m_tick || !HasSameSize(state.Update.Floor.get(), m_floor.get());
}

void CStateEncoder::AddFloor(const SRecordedFloor& floor, CBlockPacker& packer,
                             std::vector<std::string>& blocks) {
  SBlockHeader header;
  header.Kind = EBlock::Floor;
  m_bytes.clear();
  CByteWriter out(m_bytes);
  WriteFloor(floor, out);
  blocks.emplace_back(packer.Pack(header, m_bytes));
  ++m_numFloors;
}

void CStateEncoder::Encode(SLiveState& state, CBlockPacker& packer,
                           std::vector<std::string>& blocks) {
  SFrameUpdate& update = state.Update;
  const bool isKey = NeedsKey(state);
  if (isKey && update.Floor != nullptr && update.Floor != m_floor) {
    AddFloor(*update.Floor, packer, blocks);
  }
  if (m_table != state.Table) {
    update.IsRestart = true;
    update.NewTypes = state.Table->Types;
    update.Added = state.Table->Entities;
  }
  m_bytes.clear();
  m_encoder.Encode(update, isKey, m_bytes);
  m_numFromKey = isKey ? 1 : m_numFromKey + 1;
  update.IsRestart = false;
  update.NewTypes.clear();
  update.Added.clear();
  SBlockHeader header;
  header.Kind = EBlock::Frames;
  header.FirstTick = update.Tick;
  header.LastTick = update.Tick;
  header.FloorPlace = update.Floor != nullptr ? m_numFloors : 0;
  blocks.emplace_back(packer.Pack(header, m_bytes));
  m_table = state.Table;
  m_floor = update.Floor;
  m_tick = update.Tick;
}

}  // namespace argos
