using System.Linq;
using Rabit.Mavlink.Generator.Model;
using Rabit.Mavlink.Generator.Reading;
using Xunit;

namespace Rabit.Mavlink.Tests.Generator;

public class DialectReaderTests
{
    [Fact]
    public void Read_AllXml_GivesEveryMessageAndEnum()
    {
        Assert.Equal(382, Definitions.All.Messages.Count);
        Assert.Equal(259, Definitions.All.Enums.Count);
        Assert.Equal(2325, Definitions.All.Enums.Sum(definition => definition.Entries.Count));
    }

    [Fact]
    public void WireFields_MixedSizes_SortedBySizeStableExtensionsLast()
    {
        MessageDefinition message = Definitions.ReadMessages("""
            <message id="1" name="ORDER">
              <field type="uint8_t" name="a"/><field type="uint16_t" name="b"/><field type="uint8_t[5]" name="c"/>
              <field type="uint64_t" name="d"/><field type="int16_t[2]" name="e"/><field type="float" name="f"/><field type="char" name="g"/>
              <extensions/>
              <field type="uint8_t" name="h"/><field type="double" name="i"/>
            </message>
            """).Dialect.Messages.Single();

        Assert.Equal("d f b e a c g h i", string.Join(" ", message.WireFields.Select(field => field.Name)));
        Assert.Equal("a b c d e f g h i", string.Join(" ", message.Fields.Select(field => field.Name)));
        Assert.Equal(new[] { 0, 8, 12, 14, 18, 19, 24, 25, 26 }, message.WireFields.Select(message.OffsetOf));
        Assert.Equal(25, message.MinLength);
        Assert.Equal(34, message.MaxLength);
    }

    [Fact]
    public void Read_ExtensionFields_LeaveTheChecksumByteAlone()
    {
        string Heartbeat(string end) => $"""
            <message id="0" name="HEARTBEAT">
              <field type="uint8_t" name="type"/><field type="uint8_t" name="autopilot"/><field type="uint8_t" name="base_mode"/>
              <field type="uint32_t" name="custom_mode"/><field type="uint8_t" name="system_status"/>
              <field type="uint8_t_mavlink_version" name="mavlink_version"/>{end}
            </message>
            """;
        Assert.Equal(50, Definitions.ReadMessages(Heartbeat("")).Dialect.Messages.Single().CrcExtra);
        Assert.Equal(
            50,
            Definitions.ReadMessages(Heartbeat("""<extensions/><field type="float" name="more"/>""")).Dialect.Messages
                .Single().CrcExtra);
    }

    [Fact]
    public void AddressOffset_CommandLong_IsAfterTheFloatsAndTheCommand()
    {
        MessageDefinition message = Definitions.All.Messages.Single(candidate => candidate.Name == "COMMAND_LONG");
        Assert.Equal(30, message.AddressOffset("target_system"));
        Assert.Equal(31, message.AddressOffset("target_component"));
        MessageDefinition broadcast = Definitions.All.Messages.Single(candidate => candidate.Name == "HEARTBEAT");
        Assert.Equal(-1, broadcast.AddressOffset("target_system"));
    }

    [Fact]
    public void Read_EnumInTwoFiles_MergesEntriesAndFlags()
    {
        DialectReadResult result = Definitions.Read(
            ("root.xml",
                """<include>other.xml</include><enums><enum name="E"><entry name="E_C" value="0b100"/><entry name="E_A" value="1"/></enum></enums>"""),
            ("other.xml",
                """<enums><enum name="E" bitmask="true"><entry name="E_A" value="0x1"/><entry name="E_B" value="2**1"/></enum></enums>"""));

        Assert.Empty(result.Faults);
        EnumDefinition merged = result.Dialect.Enums.Single();
        Assert.True(merged.IsBitmask);
        Assert.Equal(
            new[] { ("E_A", 1m), ("E_B", 2m), ("E_C", 4m) }, merged.Entries.Select(entry => (entry.Name, entry.Value)));
    }

    [Fact]
    public void Read_EntryWithoutValue_CountsOnFromOneAsMavgenDoes()
    {
        const string Xml = """<enum name="E"><entry name="E_A"/><entry name="E_B" value="7"/><entry name="E_C"/></enum>""";
        EnumDefinition definition = Definitions.ReadEnums(Xml).Dialect.Enums.Single();
        Assert.Equal(new[] { 1m, 7m, 8m }, definition.Entries.Select(entry => entry.Value));
    }

    [Fact]
    public void Read_DiamondOfIncludes_ReadsEachFileOnce()
    {
        DialectReadResult result = Definitions.Read(
            ("root.xml", "<include>left.xml</include><include>right.xml</include>"),
            ("left.xml", "<include>base.xml</include>"),
            ("right.xml", "<include>BASE.xml</include>"),
            ("base.xml",
                """<messages><message id="1" name="M"><field type="uint8_t" name="a"/></message></messages>"""));
        Assert.Empty(result.Faults);
        Assert.Equal("base.xml", result.Dialect.Messages.Single().File);
    }

    [Fact]
    public void Read_IncludeInOtherFolder_IsFoundByPathFirstThenByName()
    {
        var root = new DialectFile(
            @"C:\mine\root.xml", "<mavlink><include>../base/b.xml</include><include>far.xml</include></mavlink>");
        DialectReadResult result = DialectReader.Read(root,
        [
            new DialectFile("C:/elsewhere/b.xml", "<mavlink><messages><message id='9' name='WRONG'><field "
                + "type='uint8_t' name='a'/></message></messages></mavlink>"),
            new DialectFile("C:/base/b.xml", "<mavlink><messages><message id='1' name='NEAR'><field type='uint8_t' "
                + "name='a'/></message></messages></mavlink>"),
            new DialectFile("/package/far.xml", "<mavlink><messages><message id='2' name='FAR'><field type='uint8_t' "
                + "name='a'/></message></messages></mavlink>"),
        ]);
        Assert.Empty(result.Faults);
        Assert.Equal(new[] { "NEAR", "FAR" }, result.Dialect.Messages.Select(message => message.Name));
    }

    [Fact]
    public void Read_Descriptions_AreKeptOnOneLine()
    {
        MessageDefinition message = Definitions.ReadMessages("""
            <message id="1" name="M"><wip/><description>Two
               lines.</description><field type="uint8_t" name="a" units="m">How
               far.</field></message>
            """).Dialect.Messages.Single();
        Assert.Equal("Two lines.", message.Description);
        Assert.Equal("How far.", message.Fields[0].Description);
        Assert.Equal("m", message.Fields[0].Units);
        Assert.Equal(DefinitionMarks.WorkInProgress, message.Marks);
    }
}
