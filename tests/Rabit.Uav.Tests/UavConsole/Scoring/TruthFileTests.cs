using System;
using System.IO;
using System.Linq;
using System.Text;
using UavConsole;
using Xunit;

namespace Rabit.Uav.Tests.UavConsole;

/// <summary>Where the targets really are, as a file.</summary>
public sealed class TruthFileTests
{
    [Fact]
    public void Write_ThenParse_IsTheSame()
    {
        using var stream = new MemoryStream();
        TruthFile.Write(stream, MadeUpFlight.Truth);

        Truth read = TruthFile.Parse(Encoding.UTF8.GetString(stream.ToArray()), "truth.json");

        Assert.Equal(MadeUpFlight.Truth.Home.Latitude.Radians, read.Home.Latitude.Radians, 10);
        Assert.Equal(MadeUpFlight.Truth.Targets.Select(t => (t.Name, t.Class)), read.Targets.Select(t => (t.Name, t.Class)));
        Assert.All(read.Targets.Zip(MadeUpFlight.Truth.Targets, (a, b) => (a, b)), p => Assert.Equal(p.b.Position.Longitude.Radians, p.a.Position.Longitude.Radians, 10));
    }

    [Theory]
    [InlineData("{", "it is no JSON (line 1)")]
    [InlineData("[]", "it does not say \"format\": \"rabit-truth\"")]
    [InlineData("""{"format":"rabit-mission"}""", "it does not say \"format\": \"rabit-truth\"")]
    [InlineData("""{"format":"rabit-truth","version":2}""", "its version is not 1; home is missing; targets is not a list")]
    [InlineData(
        """{"format":"rabit-truth","version":1,"home":{"lat_deg":91,"lon_deg":"8"},"targets":[{"color":"pink with blue dots","lat_deg":1,"lon_deg":2},7]}""",
        "home: lat_deg is not a number from -90 to 90; home: lon_deg is not a number from -180 to 180; targets[0]: 'pink with blue dots' is no name of a target class (1 to 16 ASCII characters); targets[1] has no color")]
    public void Parse_BadFile_NamesAllThatIsWrong(string json, string expected)
    {
        var error = Assert.Throws<ArgumentException>(() => TruthFile.Parse(json, "t.json"));

        Assert.StartsWith("--truth t.json: " + expected + ".", error.Message, StringComparison.Ordinal);
    }
}
