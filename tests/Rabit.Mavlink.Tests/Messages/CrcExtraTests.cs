using System;
using System.Globalization;
using System.Linq;
using System.Text.Json;
using Xunit;

namespace Rabit.Mavlink.Tests.Messages;

public class CrcExtraTests
{
    [Fact]
    public void All_CrcExtraJson_AgreesInNameChecksumByteAndLengths()
    {
        using JsonDocument document = TestData.Json(TestData.PathOf("crc-extra.json"));
        string[] expected = document.RootElement.EnumerateObject().Select(property =>
            $"{property.Name} {property.Value.GetProperty("name")} {property.Value.GetProperty("crc_extra")} "
                + $"{property.Value.GetProperty("min_len")} {property.Value.GetProperty("max_len")}")
            .OrderBy(line => line, StringComparer.Ordinal).ToArray();
        string[] actual = MavlinkDialect.All.Messages.Select(info =>
            string.Format(
                CultureInfo.InvariantCulture, "{0} {1} {2} {3} {4}", info.Id, info.Name, info.CrcExtra, info.MinLength,
                info.MaxLength))
            .OrderBy(line => line, StringComparer.Ordinal).ToArray();
        Assert.Equal(382, expected.Length);
        Assert.Equal(expected, actual);
    }

    [Fact]
    public void All_EveryMessageStruct_AgreesWithTheDialect()
    {
        Assert.Equal(MavlinkDialect.All.Count, MessageTypes.ById.Count);
        foreach (MavlinkMessageInfo info in MavlinkDialect.All.Messages)
        {
            IMavlinkMessage message = MessageTypes.New(MessageTypes.ById[info.Id]);
            Assert.Equal(
                (info.Id, info.CrcExtra, (int)info.MinLength, (int)info.MaxLength),
                (message.MessageId, message.CrcExtra, message.MinLength, message.MaxLength));
        }
    }

    [Fact]
    public void All_AddressFields_AreWhereTheDefinitionPutsThem()
    {
        foreach (MavlinkMessageInfo info in MavlinkDialect.All.Messages)
        {
            Rabit.Mavlink.Generator.Model.MessageDefinition definition = Generator.Definitions.All.Messages.Single(
                message => message.Id == info.Id);
            Assert.Equal(definition.AddressOffset("target_system"), info.TargetSystemOffset);
            Assert.Equal(definition.AddressOffset("target_component"), info.TargetComponentOffset);
        }
    }

    [Fact]
    public void All_AskedTwice_IsTheSameObject() => Assert.Same(MavlinkDialect.All, MavlinkDialect.All);
}
