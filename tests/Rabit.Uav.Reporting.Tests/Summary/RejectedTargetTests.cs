using System;
using System.IO;
using System.Linq;
using System.Text.Json;
using Xunit;

namespace Rabit.Uav.Reporting.Tests;

/// <summary>A target that was seen, and that the operator rejected, is not said to be missed.</summary>
public sealed class RejectedTargetTests
{
    // T1 is rejected, T5 missed.
    private static readonly FlightSummary Flight = Rejected(MadeUpFlight.Record(finds: 4));

    [Fact]
    public void Json_Targets_SayWhichIsRejected()
    {
        JsonElement root = JsonDocument.Parse(ExportedText.Text(SummaryJson.Write, Flight)).RootElement;
        Assert.Equal(
            ["T1 False True", "T2 True False", "T3 True False", "T4 True False", "T5 False False"],
            root.GetProperty("mission").GetProperty("targets").EnumerateArray().Select(
                t => $"{t.GetProperty("name")} {t.GetProperty("found")} {t.GetProperty("rejected")}"));
    }

    [Fact]
    public void GeoJson_Truth_SaysWhichIsRejected()
    {
        JsonElement[] truth = ExportedText.Features(Flight).Where(f => ExportedText.KindOf(f) == "truth")
            .Select(f => f.GetProperty("properties")).ToArray();
        Assert.Equal("T1", truth.Single(t => t.GetProperty("rejected").GetBoolean()).GetProperty("name").GetString());
        Assert.False(truth.Single(t => t.GetProperty("name").GetString() == "T1").GetProperty("found").GetBoolean());
    }

    [Fact]
    public void Csv_Truth_SaysWhichIsRejected()
    {
        string[] truth = ExportedText.Text(FlightExport.WriteCsv, Flight).Split('\n')
            .Where(l => l.StartsWith("truth", StringComparison.Ordinal)).ToArray();
        Assert.Contains(",rejected", truth[0]);
        Assert.Contains(",missed", truth[4]);
    }

    [Fact]
    public void Html_CardAndMap_SayThatItIsRejected()
    {
        using var page = new StringWriter();
        HtmlReport.Write(page, Flight);
        Assert.Contains("the operator rejected its track", page.ToString());
        Assert.Contains("T1: red, rejected", page.ToString());
        Assert.Contains("T5: magenta, missed", page.ToString());
    }

    [Fact]
    public void Texts_AnotherVehicleRejected_NameTheVehicleThatValidated()
    {
        FlightSummary flight = Rejected(MadeUpFlight.Record(finds: 4), isByVehicle: true);
        using var page = new StringWriter();
        HtmlReport.Write(page, flight);
        Assert.Contains("the vehicle that validated it rejected its track", page.ToString());
        Assert.Contains(", 1 rejected by the vehicle that validated it", page.ToString());
        using var text = new StringWriter();
        SummaryText.Write(text, flight);
        Assert.Contains("0 false, 1 rejected by the vehicle that validated it", text.ToString());
        JsonElement mission = JsonDocument.Parse(ExportedText.Text(SummaryJson.Write, flight)).RootElement
            .GetProperty("mission");
        Assert.Equal(1, mission.GetProperty("score").GetProperty("rejectedTrackIds").GetArrayLength());
    }

    private static FlightSummary Rejected(FlightRecord record, bool isByVehicle = false)
    {
        MissionScore score = MadeUpTargets.Score(record);
        TargetScore first = score.Targets[0];
        return new FlightSummary(record)
        {
            Mission = new MissionSummary(record, new MissionScore
            {
                Targets =
                [
                    new TargetScore
                    {
                        Name = first.Name, Class = first.Class, Position = first.Position, IsRejected = true,
                        IsRejectedByVehicle = isByVehicle,
                    },
                    .. score.Targets.Skip(1),
                ],
                RejectedTracks = isByVehicle ? [first.Track!] : [],
            }),
        };
    }
}
