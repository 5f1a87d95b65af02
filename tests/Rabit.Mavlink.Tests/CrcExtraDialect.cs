using System.Collections.Generic;
using System.Globalization;
using System.Text.Json;

namespace Rabit.Mavlink.Tests;

/// <summary>
/// A dialect made from crc-extra.json alone, so that framing is tested without the generated messages. It knows no
/// address fields.
/// </summary>
internal static class CrcExtraDialect
{
    public static MavlinkDialect All { get; } = Read();

    private static MavlinkDialect Read()
    {
        using JsonDocument document = TestData.Json(TestData.PathOf("crc-extra.json"));
        var messages = new List<MavlinkMessageInfo>();
        foreach (JsonProperty message in document.RootElement.EnumerateObject())
        {
            messages.Add(new MavlinkMessageInfo(
                int.Parse(message.Name, CultureInfo.InvariantCulture),
                message.Value.GetProperty("name").GetString()!,
                message.Value.GetProperty("crc_extra").GetByte(),
                message.Value.GetProperty("min_len").GetByte(),
                message.Value.GetProperty("max_len").GetByte(),
                -1,
                -1));
        }
        return new MavlinkDialect("crc-extra.json", messages);
    }
}
