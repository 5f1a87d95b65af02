using System;
using System.Collections.Generic;
using System.Linq;
using System.Text.RegularExpressions;
using System.Xml.Linq;
using Rabit.Mavlink.Generator.Emitting;
using Rabit.Mavlink.Generator.Model;
using Rabit.Mavlink.Generator.Reading;
using Xunit;

namespace Rabit.Mavlink.Tests.Generator;

/// <summary>
/// The definition files of the package: described, and valid for mavgen, so that both can be fed with the same files.
/// </summary>
public class DefinitionFileTests
{
    private static readonly string[] Order =
        ["wip", "deprecated", "superseded", "description", "entry", "param", "field", "extensions"];

    public static TheoryData<string> Files { get; } =
        [.. Definitions.PackageFiles.Select(file => System.IO.Path.GetFileName(file.Path))];

    [Theory]
    [MemberData(nameof(Files))]
    public void File_AsTheSchemaRequires_HasMarksThenDescriptionThenContent(string name)
    {
        XElement root = XElement.Parse(
            Definitions.PackageFiles.Single(file => System.IO.Path.GetFileName(file.Path) == name).Text);
        foreach (XElement element
            in root.Descendants().Where(element => element.Name.LocalName is "message" or "enum" or "entry"))
        {
            // Fields and the "extensions" between them may alternate.
            int[] order = element.Elements()
                .Select(child => Math.Min(Array.IndexOf(Order, child.Name.LocalName), 6)).ToArray();
            Assert.True(
                order.SequenceEqual(order.OrderBy(place => place)),
                $"{name}: the children of {element.Attribute("name")?.Value} are out of order");
        }

        foreach (XElement mark
            in root.Descendants().Where(element => element.Name.LocalName is "deprecated" or "superseded"))
        {
            Assert.Matches(new Regex("^20[0-9]{2}-(0[1-9]|1[012])$"), mark.Attribute("since")?.Value);
            Assert.NotNull(mark.Attribute("replaced_by"));
        }
    }

    [Theory]
    [MemberData(nameof(Files))]
    public void Read_FileOfThePackage_GivesNoFaults(string name) =>
        Assert.Empty(
            DialectReader.Read(
                Definitions.PackageFiles.Single(file => System.IO.Path.GetFileName(file.Path) == name),
                Definitions.PackageFiles).Faults);

    [Fact]
    public void Definitions_OfThePackage_DescribeEveryMessageFieldAndCommand()
    {
        Assert.Empty(
            Definitions.All.Messages.Where(message => message.Description is null).Select(message => message.Name));
        Assert.Empty(
            Definitions.All.Enums.Single(definition => definition.Name == "MAV_CMD").Entries
                .Where(entry => entry.Description is null).Select(entry => entry.Name));
        Assert.Empty(
            Definitions.All.Messages.SelectMany(message => message.Fields
                .Where(field => field.Description is null).Select(field => message.Name + "." + field.Name)));
    }

    [Fact]
    public void Definitions_ReplacedByNames_AreMessagesOrEntriesOrEmpty()
    {
        HashSet<string> known =
        [
            .. Definitions.All.Messages.Select(message => message.Name),
            .. Definitions.All.Enums.SelectMany(definition => definition.Entries).Select(entry => entry.Name)
        ];
        IEnumerable<string?> replacements = Definitions.All.Messages.Select(message => message.ReplacedBy)
            .Concat(
                Definitions.All.Enums.SelectMany(definition => definition.Entries).Select(entry => entry.ReplacedBy));
        Assert.DoesNotContain(replacements, name => name is not null && !known.Contains(name));
    }

    [Fact]
    public void Emit_MessageFieldAndCommand_AreDocumentedInTheirOwnWords()
    {
        IReadOnlyList<GeneratedSource> sources = CSharpEmitter.Emit(Definitions.All, new EmitOptions("Check"));
        string Text(string name) => sources.Single(source => source.Name == name + ".g.cs").Text;

        Assert.Contains(
            "/// <summary>State of one battery: cells, current, charge used and left. <c>BATTERY_STATUS</c>",
            Text("BatteryStatus"), StringComparison.Ordinal);
        Assert.Contains(
            "/// <summary>Latitude. <c>lat</c>, int32_t. Unit: degE7.", Text("GlobalPositionInt"),
            StringComparison.Ordinal);
        Assert.Contains(
            "/// <summary>Go to a position. <c>MAV_CMD_NAV_WAYPOINT</c>.</summary>", Text("MavCmd"),
            StringComparison.Ordinal);
        Assert.Contains(
            "/// <para>Replaced by MISSION_ITEM_INT.</para>", Text("MissionItem"), StringComparison.Ordinal);
        Assert.Contains(
            "Not called like its field, since a C# member cannot have the name of its type.", Text("Airspeed"),
            StringComparison.Ordinal);
    }
}
