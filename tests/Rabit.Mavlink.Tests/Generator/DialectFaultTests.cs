using System.Linq;
using Rabit.Mavlink.Generator.Reading;
using Xunit;

namespace Rabit.Mavlink.Tests.Generator;

public class DialectFaultTests
{
    // Line 1 is <mavlink>, line 2 is <messages> or <enums>, line 3 is where the text of a test begins.
    private const int FirstLine = 3;

    [Fact]
    public void Read_NotXml_NamesFileLineAndCause()
    {
        var file = new DialectFile("a/bad.xml", "<mavlink>\n<messages>\n</mavlink>");
        DialectFault fault = DialectReader.Read(file, [file]).Faults.Single();
        AssertFault(fault, DialectFaultKind.Malformed, 3, "messages");
        Assert.Equal("a/bad.xml", fault.Path);
    }

    [Fact]
    public void Read_OtherRootElement_IsMalformed()
    {
        var file = new DialectFile("bad.xml", "<html/>");
        AssertFault(DialectReader.Read(file, []).Faults.Single(), DialectFaultKind.Malformed, 1, "html");
    }

    [Fact]
    public void Read_EntityBomb_IsMalformedAndNotExpanded()
    {
        var file = new DialectFile("bad.xml", "<!DOCTYPE m [<!ENTITY a 'aaaa'>]><mavlink>&a;</mavlink>");
        Assert.Equal(DialectFaultKind.Malformed, DialectReader.Read(file, []).Faults.Single().Kind);
    }

    [Theory]
    [InlineData("""<message id="1"/>""", "name")]
    [InlineData("""<message id="1" name="3D"/>""", "3D")]
    [InlineData("""<message id="1" name="A&quot;B"/>""", "A\"B")]
    [InlineData("""<message id="1" name="M"><field type="uint8_t"/></message>""", "M")]
    [InlineData("""<message id="1" name="M"><field type="uint8_t" name="a b"/></message>""", "a b")]
    public void Read_MissingOrBadName_IsMalformed(string message, string named) =>
        AssertOnlyFault(Definitions.ReadMessages(message), DialectFaultKind.Malformed, FirstLine, named);

    [Theory]
    [InlineData("""<message name="M"/>""", "M")]
    [InlineData("""<message id="x" name="M"/>""", "'x'")]
    [InlineData("""<message id="-1" name="M"/>""", "'-1'")]
    [InlineData("""<message id="16777216" name="M"/>""", "'16777216'")]
    [InlineData("""<message id="1" name="M"><field type="uint8_t[]" name="f"/></message>""", "f of message M")]
    [InlineData("""<message id="1" name="M"><field type="uint8_t[0]" name="f"/></message>""", "'0'")]
    [InlineData("""<message id="1" name="M"><field type="uint8_t[256]" name="f"/></message>""", "'256'")]
    [InlineData("""<message id="1" name="M"><field type="uint8_t[4" name="f"/></message>""", "uint8_t[4")]
    public void Read_BadIdOrArrayLength_IsMalformedNumber(string message, string named) =>
        AssertOnlyFault(Definitions.ReadMessages(message), DialectFaultKind.MalformedNumber, FirstLine, named);

    [Fact]
    public void Read_BadEnumValue_IsMalformedNumber() =>
        AssertOnlyFault(
            Definitions.ReadEnums("<enum name='E'>\n<entry name='E_A' value='1 1'/></enum>"),
            DialectFaultKind.MalformedNumber, FirstLine + 1, "E_A");

    [Fact]
    public void Read_IncludeNotGiven_NamesIt() =>
        AssertOnlyFault(
            Definitions.Read(("root.xml", "\n<include>nowhere.xml</include>")), DialectFaultKind.MissingInclude, 3,
            "nowhere.xml");

    [Fact]
    public void Read_IncludeCycle_ShowsTheCycle()
    {
        DialectReadResult result = Definitions.Read(
            ("root.xml", "<include>a.xml</include>"), ("a.xml", "<include>b.xml</include>"),
            ("b.xml", "<include>a.xml</include>"));
        AssertOnlyFault(result, DialectFaultKind.IncludeCycle, 2, "a.xml -> b.xml -> a.xml");
        Assert.Equal("folder/b.xml", result.Faults[0].Path);
    }

    [Fact]
    public void Read_FileThatIncludesItself_IsACycle() =>
        AssertOnlyFault(
            Definitions.Read(("root.xml", "<include>root.xml</include>")), DialectFaultKind.IncludeCycle, 2,
            "root.xml -> root.xml");

    [Fact]
    public void Read_TwoMessagesOfOneId_NamesBothAndKeepsTheFirst()
    {
        DialectReadResult result = Definitions.ReadMessages(
            "<message id='5' name='A'><field type='uint8_t' name='a'/></message>\n<message id='5' name='B'><field "
                + "type='uint8_t' name='a'/></message>");
        AssertOnlyFault(
            result, DialectFaultKind.DuplicateMessageId, FirstLine + 1, "B has id 5, which A in root.xml has");
        Assert.Equal("A", result.Dialect.Messages.Single().Name);
    }

    [Fact]
    public void Read_TwoMessagesOfOneName_SaysWhereTheFirstIs() =>
        AssertOnlyFault(
            Definitions.ReadMessages(
                "<message id='5' name='A'><field type='uint8_t' name='a'/></message>\n<message id='6' name='A'><field "
                    + "type='uint8_t' name='a'/></message>"),
            DialectFaultKind.DuplicateMessageName, FirstLine + 1, "id 5");

    [Fact]
    public void Read_TwoFieldsOfOneName_LeavesTheMessageOut()
    {
        DialectReadResult result = Definitions.ReadMessages(
            "<message id='5' name='A'><field type='float' name='x'/>\n<field type='float' name='x'/></message><message "
                + "id='6' name='B'><field type='uint8_t' name='a'/></message>");
        AssertOnlyFault(result, DialectFaultKind.DuplicateField, FirstLine + 1, "called x");
        Assert.Equal("B", result.Dialect.Messages.Single().Name);
    }

    [Theory]
    [InlineData("int")]
    [InlineData("uint8")]
    [InlineData("")]
    [InlineData("string[4]")]
    public void Read_UnknownType_NamesFieldMessageAndType(string type) =>
        AssertOnlyFault(
            Definitions.ReadMessages($"<message id='5' name='A'>\n<field type='{type}' name='x'/></message>"),
            DialectFaultKind.UnknownType, FirstLine + 1, $"Field x of message A is of type '{type}'");

    [Fact]
    public void Read_PayloadOf256Bytes_IsTooLong()
    {
        Assert.Empty(
            Definitions.ReadMessages(
                "<message id='5' name='A'><field type='uint8_t[255]' name='x'/></message>").Faults);
        AssertOnlyFault(
            Definitions.ReadMessages(
                "<message id='5' name='A'><field type='uint8_t[254]' name='x'/><extensions/><field type='int16_t' "
                    + "name='y'/></message>"),
            DialectFaultKind.PayloadTooLong, FirstLine, "256");
    }

    [Fact]
    public void Read_EntryWithTwoValues_NamesBoth() =>
        AssertOnlyFault(
            Definitions.ReadEnums("<enum name='E'><entry name='E_A' value='1'/></enum>\n<enum name='E'><entry "
                + "name='E_A' value='2'/></enum>"),
            DialectFaultKind.ConflictingEnumValue, FirstLine + 1, "E_A of enum E is 2 here and 1 elsewhere");

    [Fact]
    public void Read_FieldOfUnknownEnum_NamesIt() =>
        AssertOnlyFault(
            Definitions.ReadMessages(
                "<message id='5' name='A'><field type='uint8_t' name='x' enum='NO_SUCH'/></message>"),
            DialectFaultKind.UnknownEnum, FirstLine, "NO_SUCH");

    [Fact]
    public void Read_SeveralFaults_ReportsAll() =>
        Assert.Equal(3, Definitions.ReadMessages("<message id='x' name='A'><field type='uint8_t' "
            + "name='a'/></message><message id='1' name='B'><field type='q' name='f'/><field type='q' "
            + "name='g'/></message>").Faults.Count);

    private static void AssertOnlyFault(DialectReadResult result, DialectFaultKind kind, int line, string named) =>
        AssertFault(Assert.Single(result.Faults), kind, line, named);

    private static void AssertFault(DialectFault fault, DialectFaultKind kind, int line, string named)
    {
        Assert.Equal(kind, fault.Kind);
        Assert.Equal(line, fault.Line);
        Assert.True(fault.Column > 0);
        Assert.Contains(named, fault.Reason);
    }
}
