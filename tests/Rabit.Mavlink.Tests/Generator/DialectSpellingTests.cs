using System.Linq;
using Rabit.Mavlink.Generator.Reading;
using Xunit;

namespace Rabit.Mavlink.Tests.Generator;

/// <summary>Names that the schema does not have: what the reader would otherwise pass over.</summary>
public class DialectSpellingTests
{
    private const string Message = "<message id='1' name='M'><field type='uint8_t' name='a'/></message>";

    [Theory]
    [InlineData("<mesages/>", 2, "'messages' is probably meant")]
    [InlineData("<messages>\n<mesage id='1' name='M'/></messages>", 3, "'message' is probably meant")]
    [InlineData("<messages>\n<Message id='1' name='M'/></messages>", 3, "'message' is probably meant")]
    [InlineData(
        "<messages><message id='1' name='M'><field type='uint8_t' name='a'/>\n<extension/></message></messages>", 3,
        "'extensions' is probably meant")]
    [InlineData("<enums><enum name='E'><entry name='E_A' value='1'>\n<parm index='1'/></entry></enum></enums>", 3,
        "'param' is probably meant")]
    [InlineData("<messages>\n<field type='uint8_t' name='a'/></messages>", 3,
        "'field' cannot stand in 'messages'; it belongs in 'message'")]
    [InlineData("<message id='1' name='M'/>", 2, "belongs in 'messages'")]
    [InlineData("<messages><enums/></messages>", 2, "belongs in 'mavlink'")]
    [InlineData("<messages><message id='1' name='M'>\n<field type='uint8_t' name='a' unit='m'/></message></messages>",
        3, "'units' is probably meant")]
    [InlineData("<messages><message id='1' name='M'>\n<field type='uint8_t' name='a' enm='E'/></message></messages>", 3,
        "'enum' is probably meant")]
    [InlineData("<enums><enum name='E'>\n<entry name='E_A' valu='7'/></enum></enums>", 3, "'value' is probably meant")]
    [InlineData("<enums>\n<enum name='E' bitmsk='true'/></enums>", 3, "'bitmask' is probably meant")]
    public void Read_MisspeltOrMisplacedName_IsAnErrorAtItsLine(string content, int line, string hint)
    {
        DialectFault fault = Assert.Single(Definitions.Read(("root.xml", content)).Faults);
        Assert.Equal((DialectFaultKind.MisspeltName, line, false), (fault.Kind, fault.Line, fault.IsWarning));
        Assert.Contains(hint, fault.Reason);
        Assert.True(fault.Column > 0);
    }

    [Theory]
    [InlineData("<owner>We</owner>", "'owner' in 'mavlink'")]
    [InlineData("<messages colour='red'/>", "'colour' of 'messages'")]
    [InlineData("<messages><message id='1' name='M' units='m'><field type='uint8_t' name='a'/></message></messages>",
        "'units' of 'message' (it is one of 'param' or 'field')")]
    public void Read_NameThatIsNearNoOther_IsAWarning(string content, string named)
    {
        DialectFault fault = Assert.Single(Definitions.Read(("root.xml", content)).Faults);
        Assert.Equal((DialectFaultKind.UnknownName, true), (fault.Kind, fault.IsWarning));
        Assert.Contains(named, fault.Reason);
    }

    [Fact]
    public void Read_EverythingThatTheSchemaHas_IsAccepted() => Assert.Empty(Definitions.Read(("root.xml", """
        <version>3</version><dialect>9</dialect>
        <enums><enum name="E" bitmask="true"><wip since="2024-01"><description>x</description></wip><description>A <b>word</b>.</description>
          <entry value="1" name="E_A" hasLocation="true" altitudeOnly="false" isDestination="false" missionOnly="true">
            <superseded since="2024-01" replaced_by="E_B">Because.</superseded><description>d</description>
            <param index="1" label="l" units="m" multiplier="1E-2" instance="true" enum="E" decimalPlaces="2" increment="1" minValue="0" maxValue="1"
              reserved="false" default="NaN">p</param></entry></enum></enums>
        <messages><message id="1" name="M"><deprecated since="2024-01" replaced_by="" remove_on_date="2030-01"/><description>d</description>
          <field type="uint8_t" name="a" print_format="0x%x" enum="E" display="bitmask" units="m" increment="1" minValue="0" maxValue="1" multiplier="1E-2"
            default="0" instance="true" invalid="0"><description>f</description></field>
          <extensions/><field type="uint8_t" name="b">g</field></message></messages>
        """)).Faults);

    [Fact]
    public void Read_NamesInANamespaceOfTheirOwn_AreLeftAlone()
    {
        var file = new DialectFile(
            "root.xml",
            "<mavlink xmlns:xsi='http://www.w3.org/2001/XMLSchema-instance' "
                + "xsi:noNamespaceSchemaLocation='mavlink.xsd' xmlns:a='urn:acme'><a:owner x='1'/><messages "
                + $"a:y='2'>{Message}</messages></mavlink>");
        DialectReadResult result = DialectReader.Read(file, [file]);
        Assert.Empty(result.Faults);
        Assert.Equal("M", result.Dialect.Messages.Single().Name);
    }
}
