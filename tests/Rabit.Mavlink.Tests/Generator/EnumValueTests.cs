using System.Linq;
using Rabit.Mavlink.Generator.Model;
using Rabit.Mavlink.Generator.Reading;
using Xunit;

namespace Rabit.Mavlink.Tests.Generator;

/// <summary>Values that clash, or that the fields of their enum cannot carry.</summary>
public class EnumValueTests
{
    [Fact]
    public void Read_TwoNamesWithOneValue_IsAnErrorAtTheSecond()
    {
        DialectReadResult result = Definitions.ReadEnums(
            "<enum name='E'><entry name='E_A' value='1'/>\n<entry name='E_B' value='0x1'/></enum>");
        AssertOnly(
            result, DialectFaultKind.DuplicateEnumValue, 4, "E_B of enum E is 1, which is E_A in root.xml already",
            isWarning: false);
        Assert.Equal("E_A", result.Dialect.Enums.Single().Entries.Single().Name);
    }

    [Fact]
    public void Read_CommandWithTheNumberOfAnIncludedOne_NamesThatOneAndItsFile()
    {
        DialectReadResult result = ReadAboveCommon(
            "<enums>\n<enum name='MAV_CMD'><entry name='MAV_CMD_ACME_TAKEN' value='16'/></enum></enums>");
        AssertOnly(
            result, DialectFaultKind.DuplicateEnumValue, 3,
            "MAV_CMD_ACME_TAKEN of enum MAV_CMD is 16, which is MAV_CMD_NAV_WAYPOINT in common.xml already",
            isWarning: false);
        Assert.DoesNotContain(
            result.Dialect.Enums.Single(definition => definition.Name == "MAV_CMD").Entries,
            entry => entry.Name == "MAV_CMD_ACME_TAKEN");
    }

    [Fact]
    public void Check_CommandWithANumberThatThePackageHasElsewhere_IsAWarning()
    {
        Dialect dialect = Definitions.ReadWithPackage(
            ("acme.xml", "<include>common.xml</include><enums><enum name='MAV_CMD'><entry name='MAV_CMD_ACME_X' "
                + "value='42428'/></enum></enums>"));
        DialectFault fault = Assert.Single(CommandNumbers.Check(dialect, Definitions.All));
        Assert.Equal(
            (DialectFaultKind.CommandOfPackage, true, "folder/acme.xml", 2),
            (fault.Kind, fault.IsWarning, fault.Path, fault.Line));
        Assert.Contains("MAV_CMD_DO_SEND_BANNER in ardupilotmega.xml", fault.Reason);
        Assert.Empty(CommandNumbers.Check(Definitions.Package("storm32.xml"), Definitions.All));
    }

    [Fact]
    public void Read_ValueThatNoFieldCanCarry_IsAnErrorAtTheEntry()
    {
        DialectReadResult result = Definitions.Read(("root.xml",
            "<enums><enum name='E'>\n<entry name='E_A' value='300'/></enum></enums><messages><message id='1' "
                + "name='M'><field type='uint8_t' name='a' enum='E'/></message></messages>"));
        AssertOnly(
            result, DialectFaultKind.ValueFitsNoField, 3,
            "E_A of enum E is 300, which no field of that enum can carry: a of message M is of type uint8_t",
            isWarning: false);
    }

    [Theory]
    [InlineData("<param index='1' enum='E'/>", "")]
    [InlineData("", "<extensions/><field type='uint16_t' name='b' enum='E'/>")]
    public void Read_ValueThatAParameterOrASecondFieldCarries_IsNoError(string parameter, string field)
    {
        DialectReadResult result = Definitions.Read(("root.xml", $"""
            <enums><enum name="E"><entry name="E_A" value="300"/></enum><enum name="C"><entry name="C_A" value="1">{parameter}</entry></enum></enums>
            <messages><message id="1" name="M"><field type="uint8_t" name="a" enum="E"/>{field}</message></messages>
            """));
        Assert.DoesNotContain(result.Faults, fault => !fault.IsWarning);
        Assert.Equal(parameter.Length != 0, result.Faults.Any(fault => fault.Kind == DialectFaultKind.FieldTooNarrow));
    }

    [Fact]
    public void Read_FieldTooNarrowForSomeValues_IsAWarningThatNamesTheFirst() =>
        AssertOnly(
            ReadAboveCommon("<messages>\n<message id='70000' name='M'>\n<field type='uint8_t' name='a' "
                + "enum='MAV_CMD'/></message></messages>"),
            DialectFaultKind.FieldTooNarrow, 4, "Field a of message M is of type uint8_t, which cannot carry MAV_CMD_",
            isWarning: true);

    [Fact]
    public void Read_NegativeValueInAnUnsignedField_IsAnError() =>
        AssertOnly(
            Definitions.Read(
                ("root.xml", "<enums><enum name='E'><entry name='E_A' value='-1'/></enum></enums><messages><message "
                    + "id='1' name='M'><field type='uint8_t' name='a' enum='E'/></message></messages>")),
            DialectFaultKind.ValueFitsNoField, 2, "E_A of enum E is -1", isWarning: false);

    [Fact]
    public void Read_EnumOfAFloatField_IsAWarning() =>
        AssertOnly(
            Definitions.Read(
                ("root.xml", "<enums><enum name='E'><entry name='E_A' value='1'/></enum></enums><messages><message "
                    + "id='1' name='M'>\n<field type='float' name='a' enum='E'/></message></messages>")),
            DialectFaultKind.EnumOfFloat, 3, "Field a of message M is a float", isWarning: true);

    [Fact]
    public void Read_MessageWithoutFields_IsAnErrorAndLeftOut()
    {
        DialectReadResult result = Definitions.ReadMessages(
            "<message id='1' name='M'><description>d</description></message>");
        AssertOnly(result, DialectFaultKind.NoFields, 3, "Message M has no field", isWarning: false);
        Assert.Empty(result.Dialect.Messages);
    }

    [Theory]
    [InlineData(64, 0)]
    [InlineData(65, 1)]
    public void Read_MoreThan64Fields_IsAnError(int count, int faults)
    {
        string fields = string.Concat(
            Enumerable.Range(0, count).Select(number => $"<field type='uint8_t' name='f{number}'/>"));
        DialectReadResult result = Definitions.ReadMessages($"<message id='1' name='M'>{fields}</message>");
        Assert.Equal(faults, result.Faults.Count);
        Assert.All(result.Faults, fault => Assert.Equal(DialectFaultKind.TooManyFields, fault.Kind));
        Assert.All(result.Faults, fault => Assert.Contains("65 fields", fault.Reason));
    }

    [Theory]
    [InlineData("<entry name='E_A' value='1'/><entry name='E_B' value='2'/><entry name='E_AB' value='3'/><entry "
        + "name='E_NONE' value='0'/>", 0)]
    [InlineData("<entry name='E_A' value='1'/>\n<entry name='E_B' value='3'/>", 1)]
    [InlineData("<entry name='E_TOP' value='2**63'/>", 0)]
    public void Read_BitMask_MayNameCombinationsOfNamedBitsOnly(string entries, int warnings)
    {
        DialectReadResult result = Definitions.ReadEnums($"<enum name='E' bitmask='true'>{entries}</enum>");
        Assert.Equal(warnings, result.Faults.Count);
        Assert.All(
            result.Faults,
            fault => Assert.Equal((DialectFaultKind.UnnamedBits, 4, true), (fault.Kind, fault.Line, fault.IsWarning)));
    }

    private static DialectReadResult ReadAboveCommon(string content)
    {
        var file = new DialectFile("folder/acme.xml", $"<mavlink><include>common.xml</include>\n{content}</mavlink>");
        return DialectReader.Read(file, [file, .. Definitions.PackageFiles]);
    }

    private static void AssertOnly(
        DialectReadResult result, DialectFaultKind kind, int line, string named, bool isWarning)
    {
        DialectFault fault = Assert.Single(result.Faults);
        Assert.Equal((kind, line, isWarning), (fault.Kind, fault.Line, fault.IsWarning));
        Assert.Contains(named, fault.Reason);
    }
}
