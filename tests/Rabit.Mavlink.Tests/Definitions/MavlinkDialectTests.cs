using System;
using System.Linq;
using Rabit.Mavlink.Messages;
using Rabit.Mavlink.Tests.Generator;
using Xunit;

namespace Rabit.Mavlink.Tests.Definitions;

public class MavlinkDialectTests
{
    private static readonly MavlinkMessageInfo Own = new(70_000, "OWN", 17, 4, 4, -1, -1);

    [Theory]
    [InlineData("minimal.xml")]
    [InlineData("common.xml")]
    [InlineData("ardupilotmega.xml")]
    [InlineData("uAvionix.xml")]
    public void Part_EveryFile_HasTheMessagesOfTheFileAndItsIncludes(string file)
    {
        MavlinkDialect dialect = typeof(MavlinkDialect).GetProperties()
            .Where(property => property.PropertyType == typeof(MavlinkDialect))
            .Select(property => (MavlinkDialect)property.GetValue(null)!)
            .Single(candidate => candidate.Name == file.Substring(0, file.IndexOf('.')));
        Assert.Equal(
            Generator.Definitions.Package(file).Messages.Select(message => message.Name),
            dialect.Messages.OrderBy(message => message.Id).Select(message => message.Name));
    }

    [Fact]
    public void Common_IsMadeOnceAndSmallerThanAll()
    {
        Assert.Same(MavlinkDialect.Common, MavlinkDialect.Common);
        Assert.Equal(382, MavlinkDialect.All.Count);
        Assert.InRange(MavlinkDialect.Common.Count, 200, 300);
        Assert.True(MavlinkDialect.ArduPilotMega.TryGetMessage("RANGEFINDER", out _));
        Assert.False(MavlinkDialect.Common.TryGetMessage("RANGEFINDER", out _));
        Assert.Null(MavlinkDialect.Common.FindDefinition(Rangefinder.MavlinkId));
        Assert.NotNull(MavlinkDialect.Common.FindDefinition(Heartbeat.MavlinkId));
    }

    [Fact]
    public void TryGetMessage_ByName_DoesNotCareForCase()
    {
        Assert.True(MavlinkDialect.Minimal.TryGetMessage("heartbeat", out MavlinkMessageInfo message));
        Assert.Equal((0, "HEARTBEAT", 50), (message.Id, message.Name, message.CrcExtra));
        Assert.False(MavlinkDialect.Minimal.TryGetMessage("HEART", out _));
    }

    [Fact]
    public void Combine_PartsThatOverlap_HasEachMessageOnce()
    {
        MavlinkDialect dialect = MavlinkDialect.Combine(
            "both", MavlinkDialect.Common, new MavlinkDialect("own", [Own]), MavlinkDialect.Minimal);
        Assert.Equal(("both", MavlinkDialect.Common.Count + 1), (dialect.Name, dialect.Count));
        Assert.True(dialect.TryGetMessage(70_000, out MavlinkMessageInfo own));
        Assert.Equal("OWN", own.Name);
        Assert.Equal("type", dialect.FindDefinition(Heartbeat.MavlinkId)!.Fields[0].Name);
        Assert.Null(dialect.FindDefinition(70_000));
        Assert.Equal("MAV_TYPE_GCS", dialect.FindEnum("MAV_TYPE")!.NameOf(6));
    }

    [Fact]
    public void Combine_NewerFormOfAMessage_TakesTheLongerOne()
    {
        var newer = new MavlinkDialect("newer", [new MavlinkMessageInfo(70_000, "OWN", 17, 4, 8, -1, -1)]);
        var older = new MavlinkDialect("older", [Own]);
        foreach (MavlinkDialect dialect
            in new[] { MavlinkDialect.Combine("a", newer, older), MavlinkDialect.Combine("b", older, newer) })
        {
            Assert.True(dialect.TryGetMessage(70_000, out MavlinkMessageInfo message));
            Assert.Equal(8, message.MaxLength);
        }
    }

    [Fact]
    public void Combine_OneIdForTwoMessages_NamesBoth()
    {
        var other = new MavlinkDialect("other", [new MavlinkMessageInfo(70_000, "THEIRS", 18, 4, 4, -1, -1)]);
        ArgumentException exception = Assert.Throws<ArgumentException>(
            () => MavlinkDialect.Combine("both", new MavlinkDialect("own", [Own]), other));
        Assert.Contains(
            "Dialect 'both': other has THEIRS (checksum byte 18) as message 70000, which is OWN (checksum byte 17) "
                + "already.",
            exception.Message);
    }

    [Fact]
    public void Combine_Nothing_KnowsNothing()
    {
        Assert.Equal(0, MavlinkDialect.Combine("none").Count);
        Assert.Throws<ArgumentNullException>(() => MavlinkDialect.Combine("none", null!));
        Assert.Throws<ArgumentException>(() => MavlinkDialect.Combine("none", [null!]));
    }

    [Theory]
    [InlineData("")]
    [InlineData("\u0002")]
    public void Create_DataOfAnotherVersion_SaysToCompileAgain(string data) =>
        Assert.Contains(
            "compile its project",
            Assert.Throws<InvalidOperationException>(() => MavlinkDialectData.Create(data, null)).Message);
}
