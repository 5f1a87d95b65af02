using System;
using System.IO;
using System.Linq;
using System.Xml;
using System.Xml.Linq;
using Rabit.Geodesy;
using Rabit.Uav.Messages;
using Xunit;

namespace Rabit.Uav.Reporting.Tests;

/// <summary>What an operator passes on after a flight: when, who, where the targets are.</summary>
public sealed class ReportFactsTests
{
    private static readonly XNamespace Html = "http://www.w3.org/1999/xhtml";

    [Fact]
    public void Write_FlightByAClock_SaysDateTimeOperatorAndFile()
    {
        string hash = new('a', 64);
        string facts = FactsOf(new FlightSummary(MadeUpFlight.Record())
        {
            StartTime = new DateTimeOffset(2026, 3, 7, 14, 5, 9, TimeSpan.FromHours(2)),
            OperatorName = "J. <Miller>",
            MissionFile = "search.json",
            MissionFileSha256 = hash,
        });

        Assert.Contains("2026-03-07, Saturday", facts);
        Assert.Contains("14:05:09 +02:00 (12:05:09 UTC)", facts);
        Assert.Contains("J. <Miller>", facts);
        Assert.Contains("search.json SHA-256 aaaaaaaaaaaaaaaa…", facts.Replace("\n", string.Empty));
    }

    [Fact]
    public void Write_SimulatedFlight_SaysSimulatedAndNoDate()
        => Assert.Contains("simulated: no date", FactsOf(MadeUpFlight.Summary(MadeUpFlight.Record())));

    [Fact]
    public void Write_Targets_HaveTheNumberOfTheirTrackOnMapAndCards()
    {
        XDocument page = Page(MadeUpFlight.Summary(MadeUpFlight.Record(hasFalseTrack: true)));

        string[] cards = [.. page.Descendants(Html + "article").Select(a => FirstWord(a.Element(Html + "h3")!))];
        string[] map =
        [
            .. page.Descendants(Html + "svg").Single(s => (string?)s.Attribute("id") == "map")
                .Descendants(Html + "text").Where(t => (string?)t.Attribute("class") == "label").Select(t => t.Value),
        ];
        Assert.Equal(["1", "2", "3", "4", "5", "8"], cards);
        Assert.Equal(cards, map);
    }

    [Fact]
    public void Write_Target_HasCoordinatesToCopyAndItsWayFromHome()
    {
        FlightRecord record = MadeUpFlight.Record();
        TargetTrack first = record.Tracks.Tracks.Single(t => t.Id == 1);
        XElement card = Page(MadeUpFlight.Summary(record)).Descendants(Html + "article").First();
        string[] copied = [.. card.Descendants(Html + "button").Select(b => b.Attribute("data-copy")!.Value)];
        NedPosition ned = MadeUpSite.Frame.ToNed(first.Position);

        Assert.Equal(
            [
                FormattableString.Invariant(
                    $"{first.Position.Latitude.Degrees:0.0000000}, {first.Position.Longitude.Degrees:0.0000000}"),
                MgrsPosition.From(first.Position.Point).ToString(),
            ],
            copied);
        double metres = Math.Sqrt((ned.North * ned.North) + (ned.East * ned.East));
        double bearing = Math.Atan2(ned.East, ned.North) * 180 / Math.PI;
        Assert.Contains(FormattableString.Invariant($"{metres:0} m at {bearing:000}°"), card.Value);
    }

    [Fact]
    public void Write_TargetAboutThePole_HasNoMgrs()
    {
        var track = new TargetTrack
        {
            Id = 1,
            State = TrackState.Confirmed,
            Position = GeodeticPosition.FromDegrees(86, 12, 0),
        };
        var record = new FlightRecord { Tracks = new TrackList(TimeSpan.Zero, [track]) };

        Assert.DoesNotContain("MGRS", Page(new FlightSummary(record)).Root!.Value);
    }

    [Fact]
    public void Write_NothingFound_SaysItLarge()
    {
        FlightRecord record = MadeUpFlight.Record(finds: 0);
        XDocument page = Page(new FlightSummary(record) { Mission = new MissionSummary(record, score: null) });

        Assert.Contains(
            page.Descendants(Html + "p"),
            p => (string?)p.Attribute("class") == "nothing"
                && p.Value.StartsWith("nothing ", StringComparison.Ordinal));
    }

    [Fact]
    public void Write_EnergyKnown_HasALineOfWhatIsLeftAndOneOfWhatIsNeeded()
    {
        FlightSample[] samples = [.. MadeUpFlight.Record().Samples];
        for (int index = 0; index < samples.Length; index++)
        {
            samples[index].ChargeLeft = 0.9 - (index * 1e-4);
            samples[index].ChargeNeeded = double.NaN;
        }

        Assert.Single(Lines(samples, "line c-battery"), l => l.Split(' ').Length > 10);
        Assert.Empty(Lines(samples, "line c-needed"));
        for (int index = 0; index < samples.Length; index++)
            samples[index].ChargeNeeded = 0.3;
        Assert.Single(Lines(samples, "line c-needed"));
    }

    private static string[] Lines(FlightSample[] samples, string kind)
    {
        for (int index = 0; index < samples.Length; index++)
            samples[index].BatteryRemaining = double.NaN;
        return
        [
            .. Page(new FlightSummary(new FlightRecord { Samples = samples })).Descendants(Html + "polyline")
                .Where(p => (string?)p.Attribute("class") == kind).Select(p => p.Attribute("points")!.Value),
        ];
    }

    private static string FirstWord(XElement element)
        => element.Value.Split([' ', '\n'], StringSplitOptions.RemoveEmptyEntries)[0];

    private static string FactsOf(FlightSummary summary)
        => Page(summary).Descendants(Html + "dl").First(d => (string?)d.Attribute("class") == "facts").Value;

    private static XDocument Page(FlightSummary summary)
    {
        using var page = new StringWriter();
        HtmlReport.Write(page, summary);
        using var reader = XmlReader.Create(
            new StringReader(page.ToString()),
            new XmlReaderSettings { DtdProcessing = DtdProcessing.Ignore, XmlResolver = null });
        return XDocument.Load(reader);
    }
}
