using System.Globalization;
using System.IO;
using System.Linq;
using System.Text.Json;
using Rabit.Geodesy;
using Rabit.Uav.Messages;
using Xunit;

namespace Rabit.Uav.Reporting.Tests;

/// <summary>Where a target points, in everything that is written of a flight.</summary>
public sealed class TargetBearingTests
{
    private static readonly FlightSummary Flight = MadeUpFlight.Summary(MadeUpFlight.Record());

    [Theory]
    [InlineData(BearingSymmetry.None, 35, "35° ±2°")]
    [InlineData(BearingSymmetry.None, 359.8, "0° ±2°")]
    [InlineData(BearingSymmetry.HalfTurn, 35, "35/215° ±2°")]
    [InlineData(BearingSymmetry.QuarterTurn, 35, "35/125/215/305° ±2°")]
    public void Text_Bearing_NamesAllDirections(BearingSymmetry symmetry, double degrees, string expected)
        => Assert.Equal(
            expected,
            FlightText.Bearing(new TargetBearing(Angle.FromDegrees(degrees), Angle.FromDegrees(1.3), symmetry)));

    [Fact]
    public void Json_Tracks_SayTheirBearingsOrNull()
    {
        using var stream = new MemoryStream();
        SummaryJson.Write(stream, Flight);
        using JsonDocument json = JsonDocument.Parse(stream.ToArray());
        JsonElement[] tracks =
            [.. json.RootElement.GetProperty("mission").GetProperty("tracks").EnumerateArray()];
        JsonElement known = tracks.Single(t => t.GetProperty("id").GetInt32() == MadeUpTargets.BearingTrackId);
        Assert.Equal(35, known.GetProperty("bearingDegrees").GetDouble(), 1e-9);
        Assert.Equal(1.3, known.GetProperty("bearingDeviationDegrees").GetDouble(), 1e-9);
        Assert.Equal("HalfTurn", known.GetProperty("bearingSymmetry").GetString());
        foreach (JsonElement other in tracks.Where(t => t.GetProperty("id").GetInt32() != MadeUpTargets.BearingTrackId))
        {
            Assert.Equal(JsonValueKind.Null, other.GetProperty("bearingDegrees").ValueKind);
            Assert.Equal(JsonValueKind.Null, other.GetProperty("bearingDeviationDegrees").ValueKind);
            Assert.Equal(JsonValueKind.Null, other.GetProperty("bearingSymmetry").ValueKind);
        }
    }

    [Fact]
    public void TextAndPage_KnownBearing_IsThere()
    {
        using var text = new StringWriter(CultureInfo.InvariantCulture);
        SummaryText.Write(text, Flight);
        Assert.Contains(" reports, bearing 35/215° ±2°", text.ToString());

        using var page = new StringWriter(CultureInfo.InvariantCulture);
        HtmlReport.Write(page, Flight);
        string html = page.ToString();
        Assert.Contains("35/215° ±2°</dd>", html);
        Assert.Single(html.Split('\n'), l => l.Contains("class=\"bearing\""));
    }

    [Fact]
    public void Exports_KnownBearing_IsThere()
    {
        string[] lines = ExportedText.Text(FlightExport.WriteCsv, Flight).Split('\n');
        Assert.EndsWith("bearing_deg,bearing_deviation_deg,bearing_symmetry", lines[0].TrimEnd());
        Assert.Single(lines, l => l.TrimEnd().EndsWith(",35.00,1.30,HalfTurn", System.StringComparison.Ordinal));
        JsonElement target = Assert.Single(
            ExportedText.Features(Flight), f => f.GetProperty("properties").TryGetProperty("bearingDegrees", out _));
        Assert.Equal(35, target.GetProperty("properties").GetProperty("bearingDegrees").GetDouble(), 1e-9);
    }
}
