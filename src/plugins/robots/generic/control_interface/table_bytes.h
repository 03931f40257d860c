#ifndef ARGOS3_PLUGINS_ROBOTS_GENERIC_CONTROL_INTERFACE_TABLE_BYTES_H
#define ARGOS3_PLUGINS_ROBOTS_GENERIC_CONTROL_INTERFACE_TABLE_BYTES_H

namespace argos {

class CByteArray;
class CLuaTable;

/** Sets @p field of a table to a list of bytes, as numbers. */
void SetBytes(CLuaTable& table, const char* field, const CByteArray& bytes);

}  // namespace argos

#endif
