#include "protocol/usb/enttec_message.h"

#include <gmock/gmock.h>

#include <algorithm>

#include "protocol/usb/enttec_widget_data.h"
#include "tests/protocol/allocation_counter.h"
#include "tests/protocol/packets.h"

namespace hazer::protocol {
namespace {

using test::Bytes;
using testing::ElementsAre;
using testing::IsEmpty;

struct Message {
    int label = 0;
    Bytes data;
    bool operator==(const Message&) const = default;
};

/// What a decoder makes of a stream that arrives in pieces of `size` bytes.
std::vector<Message> decode(EnttecDecoder& decoder, const Bytes& stream, std::size_t size) {
    std::vector<Message> messages;
    for (std::size_t at = 0; at < stream.size(); at += size) {
        const Bytes piece(stream.begin() + static_cast<std::ptrdiff_t>(at),
                          stream.begin() + static_cast<std::ptrdiff_t>(std::min(at + size, stream.size())));
        std::span<const std::uint8_t> rest(piece);
        while (const auto message = decoder.next(rest)) {
            messages.push_back({message->label, Bytes(message->data.begin(), message->data.end())});
        }
    }
    return messages;
}

std::vector<Message> decode(const Bytes& stream) {
    EnttecDecoder decoder;
    return decode(decoder, stream, stream.size());
}

Bytes joined(std::initializer_list<Bytes> parts) {
    Bytes whole;
    for (const Bytes& part : parts) whole.insert(whole.end(), part.begin(), part.end());
    return whole;
}

/// Written out by hand: status, start code and slots that hold both marks.
const Bytes kDmx{0x7E, 5, 6, 0, 0, 0, 0x7E, 0xE7, 0x7E, 9, 0xE7};
const Message kDmxMessage{5, {0, 0, 0x7E, 0xE7, 0x7E, 9}};

TEST(EnttecDecoder, FindsAMessageWhoseDataHoldBothMarks) {
    EXPECT_THAT(decode(kDmx), ElementsAre(kDmxMessage));
}

TEST(EnttecDecoder, TakesNoDataAndTheMostThatIsAllowed) {
    const Bytes most(600, 0xE7);
    EXPECT_THAT(decode({0x7E, 10, 0, 0, 0xE7}), ElementsAre(Message{10, {}}));
    EXPECT_THAT(decode(packEnttec(EnttecLabel::kReceivedDmx, most)), ElementsAre(Message{5, most}));
}

TEST(EnttecDecoder, ALengthBeyond600IsNoMessage) {
    Bytes longer{0x7E, 5, 0x59, 0x02};  // 601
    longer.resize(4 + 601);
    longer.push_back(0xE7);
    EXPECT_THAT(decode(joined({longer, kDmx})), ElementsAre(kDmxMessage));
}

// QLC+ adds signed bytes: 200 would be -56.
TEST(EnttecDecoder, TheLowByteOfALengthIsUnsigned) {
    EXPECT_THAT(decode(packEnttec(EnttecLabel::kReceivedDmx, Bytes(200, 1))),
                ElementsAre(Message{5, Bytes(200, 1)}));
}

TEST(EnttecDecoder, FindsTheSameWhereverTheStreamIsCut) {
    const Bytes stream = joined({{0x7E, 5, 6}, kDmx, {1, 2, 0x7E}, kDmx, {0x7E, 0x7E, 9, 0, 0}, kDmx, kDmx});
    const std::vector<Message> whole = decode(stream);
    EXPECT_EQ(std::ranges::count(whole, kDmxMessage), 4);
    for (std::size_t size = 1; size < stream.size(); ++size) {
        EnttecDecoder decoder;
        EXPECT_EQ(decode(decoder, stream, size), whole) << "pieces of " << size;
    }
}

TEST(EnttecDecoder, APrefixOfAMessageIsNone) {
    for (std::size_t size = 0; size < kDmx.size(); ++size) {
        EXPECT_THAT(decode(test::prefixOf(kDmx, size)), IsEmpty()) << size;
    }
}

TEST(EnttecDecoder, AFalseStartHidesNoMessageThatBeginsOneByteLater) {
    for (const std::uint8_t label : Bytes{0x7E, 0, 5}) {
        EXPECT_THAT(decode(joined({{0x7E, label}, kDmx, Bytes(600, 0)})), ElementsAre(kDmxMessage));
    }
    EXPECT_THAT(decode(joined({{0x7E}, kDmx, Bytes(700, 0)})), ElementsAre(kDmxMessage));
}

TEST(EnttecDecoder, CountsWhatBelongsToNoMessage) {
    EnttecDecoder decoder;
    decode(decoder, joined({{1, 2, 3}, kDmx, {4}, kDmx}), 7);
    EXPECT_EQ(decoder.skippedBytes(), 4U);
}

TEST(EnttecDecoder, EndlessStartsCostNoMemory) {
    EnttecDecoder decoder;
    const Bytes starts = joined({Bytes(5000, 0x7E), Bytes(5000, 2)});
    std::span<const std::uint8_t> rest(starts);
    const std::size_t before = hazer::test::allocationCount();
    EXPECT_FALSE(decoder.next(rest));
    EXPECT_EQ(hazer::test::allocationCount(), before);
    EXPECT_TRUE(rest.empty());
}

TEST(EnttecMessages, ArePackedAsTheyAreRead) {
    EXPECT_EQ(packEnttec(EnttecLabel::kReceivedDmx, kDmxMessage.data), kDmx);
    EXPECT_EQ(packEnttec(EnttecLabel::kSerialNumber), (Bytes{0x7E, 10, 0, 0, 0xE7}));
}

}  // namespace
}  // namespace hazer::protocol
