#ifndef ARGOS3_CAMPAIGN_EXECUTION_RUN_MESSAGES_H
#define ARGOS3_CAMPAIGN_EXECUTION_RUN_MESSAGES_H

#include <argos3/campaign/execution/run_request.h>
#include <argos3/campaign/execution/run_result.h>

#include <string>
#include <string_view>
#include <utility>

namespace argos {

/**
 * Bodies of messages (message_stream.h), without loss: each bit of a number arrives. Between
 * processes of one program, so the format can change at any time.
 */
std::string EncodeRequest(const SRunRequest& request);
/** @throws CARGoSException if the bytes are none. */
SRunRequest DecodeRequest(std::string_view bytes);

/** @param id  of the request. */
std::string EncodeResult(UInt64 id, const SRunResult& result);
/** @throws CARGoSException if the bytes are none. */
std::pair<UInt64, SRunResult> DecodeResult(std::string_view bytes);

}  // namespace argos

#endif
