using System;
using System.IO;
using System.Linq;
using System.Text;
using System.Text.Json;
using Rabit.Geodesy;
using Rabit.Uav.Messages;
using Xunit;

namespace Rabit.Uav.Simulation.Tests.Scoring;

/// <summary>Where the targets really are, as a file.</summary>
public sealed class TruthFileTests
{
    private static readonly TargetTruth Truth = new(
        GeodeticPosition.FromDegrees(47.39697, 8.54426, 488),
        [
            new TruthTarget("T1", DefaultTargetClasses.Red, GeodeticPosition.FromDegrees(47.3974, 8.545, 488)),
            new TruthTarget("T2", DefaultTargetClasses.Magenta, GeodeticPosition.FromDegrees(47.3978, 8.5453, 488)),
        ]);

    [Fact]
    public void Write_ThenParse_IsTheSame()
    {
        using var stream = new MemoryStream();
        TruthFile.Write(stream, Truth);

        AssertSame(Truth, TruthFile.Parse(Encoding.UTF8.GetString(stream.ToArray())));
    }

    [Fact]
    public void Write_OfAWorld_IsReadAsItsTargetsAndHasTheRestBeside()
    {
        var world = new SimulatedWorld(new SimulationOptions { Seed = 7 });
        using var stream = new MemoryStream();
        TruthFile.Write(stream, world);
        string json = Encoding.UTF8.GetString(stream.ToArray());

        AssertSame(TargetTruth.Of(world), TruthFile.Parse(json));
        using JsonDocument document = JsonDocument.Parse(json);
        Assert.Equal(7, document.RootElement.GetProperty("seed").GetInt64());
        Assert.Equal(JsonValueKind.Null, document.RootElement.GetProperty("flight").ValueKind);
    }

    [Fact]
    public void Of_AWorldAndTwoClasses_HasTargetsOfTheseAlone()
    {
        var world = new SimulatedWorld(new SimulationOptions { Seed = 7, TargetCount = 20 });

        TargetTruth truth = TargetTruth.Of(world, [DefaultTargetClasses.Red, DefaultTargetClasses.Blue]);

        Assert.NotEmpty(truth.Targets);
        Assert.All(
            truth.Targets,
            t => Assert.True(t.Class == DefaultTargetClasses.Red || t.Class == DefaultTargetClasses.Blue));
    }

    [Theory]
    [InlineData("{", "it is not JSON (line 1)")]
    [InlineData("[]", "it does not say \"format\": \"rabit-truth\"")]
    [InlineData("""{"format":"rabit-mission"}""", "it does not say \"format\": \"rabit-truth\"")]
    [InlineData("""{"format":"rabit-truth","version":2}""",
        "its version is not 1; home is missing; targets is not a list")]
    [InlineData(
        """{"format":"rabit-truth","version":1,"home":{"latitudeDegrees":91,"longitudeDegrees":"8"},"targets":[{"class":"pink and green stripes","latitudeDegrees":1,"longitudeDegrees":2},{"latitudeDegrees":1,"longitudeDegrees":2}]}""",
        "home: latitudeDegrees is not a number from -90 to 90; home: longitudeDegrees is not a number from -180 to "
            + "180; targets[0]: 'pink and green stripes' is not a class: 1 to 16 ASCII characters; targets[1] has no "
            + "class")]
    [InlineData(
        """{"format":"rabit-truth","version":1,"home":{"lat_deg":47,"lon_deg":8},"targets":[{"color":"red","lat_deg":1,"lon_deg":2},{"name":"T1","color":"red","lat_deg":1,"longitudeDegrees":2}]}""",
        "lat_deg is now latitudeDegrees (in home, targets[0], targets[1] 'T1'); lon_deg is now longitudeDegrees (in "
            + "home, targets[0]); color is now class (in targets[0], targets[1] 'T1')")]
    [InlineData(
        """{"format":"rabit-truth","version":1,"home":{"lat_deg":47,"longitudeDegrees":8},"targets":[{"class":"red","lat_deg":1,"longitudeDegrees":2},{"class":"red","lat_deg":1,"longitudeDegrees":2},{"class":"red","lat_deg":1,"longitudeDegrees":2}]}""",
        "lat_deg is now latitudeDegrees (in home, targets[0], targets[1] and 1 more)")]
    [InlineData(
        """{"format":"rabit-truth","version":1,"home":{"latitudeDegrees":1,"longitudeDegrees":8},"targets":[{"name":"T1","latitudeDegrees":1,"longitudeDegrees":2}]}""",
        "targets[0] 'T1' has no class")]
    public void Parse_BadFile_NamesAllThatIsWrong(string json, string expected)
    {
        var error = Assert.Throws<FormatException>(() => TruthFile.Parse(json));

        Assert.Equal(expected + ".", error.Message);
    }

    private static void AssertSame(TargetTruth expected, TargetTruth actual)
    {
        Assert.Equal(expected.Home.Latitude.Radians, actual.Home.Latitude.Radians, 10);
        Assert.Equal(expected.Targets.Select(t => (t.Name, t.Class)), actual.Targets.Select(t => (t.Name, t.Class)));
        Assert.All(
            expected.Targets.Zip(actual.Targets, (a, b) => (a, b)),
            p => Assert.Equal(p.a.Position.Longitude.Radians, p.b.Position.Longitude.Radians, 10));
    }
}
