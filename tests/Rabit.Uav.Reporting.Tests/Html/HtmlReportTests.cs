using System;
using System.IO;
using System.Linq;
using System.Text;
using System.Xml;
using System.Xml.Linq;
using Xunit;

namespace Rabit.Uav.Reporting.Tests;

/// <summary>The page that a person looks at after a flight.</summary>
public sealed class HtmlReportTests
{
    private static readonly XNamespace Html = "http://www.w3.org/1999/xhtml";

    [Fact]
    public void Write_PassedMission_SaysSoAndShowsEveryTarget()
    {
        string page = Page(MadeUpFlight.Summary(MadeUpFlight.Record()));
        Keep(page, "passed");
        XDocument document = Parse(page);

        Assert.Contains("Mission accomplished", Words(document));
        Assert.Contains("5 of 5 targets found", Words(document));
        Assert.Equal(5, document.Descendants(Html + "article").Count());
        Assert.Equal(5 * 4, document.Descendants(Html + "img").Count());   // three image chips and the whole picture
        Assert.Equal(
            ["box", "box other"],
            document.Descendants(Html + "i").Select(i => i.Attribute("class")!.Value)
                .Where(c => c.StartsWith("box", StringComparison.Ordinal)).Distinct());
        Assert.Contains("left:40%;top:50%;width:5%;height:8%", page);
        Assert.Contains("UavConsole --seed 7 --targets 5", Words(document));
    }

    [Fact]
    public void Write_FailedMission_NamesEveryReason()
    {
        string page = Page(MadeUpFlight.Summary(MadeUpFlight.Record(finds: 4, hasFalseTrack: true)));
        Keep(page, "failed");
        string words = Words(Parse(page));

        Assert.Contains("Mission failed", words);
        Assert.Contains("target T5 (magenta) was not found", words);
        Assert.Contains("track 8 (red) was confirmed and is not a target", words);
    }

    // By its own position a vehicle lands somewhere else than in truth.
    [Theory]
    [InlineData(null, "from home, by its own position")]
    [InlineData(0.9, "from home in truth; ")]
    public void Write_Landed_SaysByWhatTheDistanceGoes(double? truth, string expected)
    {
        FlightRecord record = MadeUpFlight.Record();
        var summary = new FlightSummary(record)
        {
            Mission = new MissionSummary(record, new MissionScore { DistanceFromHomeMetres = truth }),
        };

        Assert.Contains(expected, Words(Parse(Page(summary))));
    }

    [Fact]
    public void Write_AnyFlight_NeedsNothingFromOutsideAndIsSmall()
    {
        string page = Page(MadeUpFlight.Summary(MadeUpFlight.Record()));

        Assert.InRange(Encoding.UTF8.GetByteCount(page), 20_000, 2_000_000);
        foreach (string attribute in new[] { "src", "href", "action", "data" })
        {
            Assert.All(
                Parse(page).Descendants().Attributes(attribute),
                a => Assert.StartsWith("data:image/png;base64,", a.Value, StringComparison.Ordinal));
        }

        Assert.DoesNotContain("@import", page);
        Assert.DoesNotContain("url(", page.Replace("url(#observations)", string.Empty));
        Assert.DoesNotContain("http", page.Replace(Html.NamespaceName, string.Empty));
    }

    [Fact]
    public void Write_HostileTexts_AreTextsAndNothingElse()
    {
        FlightRecord record = MadeUpFlight.Record();
        string page = Page(MadeUpFlight.Summary(record));
        XDocument document = Parse(page);

        Assert.Contains("<script>alert(1)</script>", Words(document));
        Assert.Equal(2, document.Descendants(Html + "script").Count());
        Assert.DoesNotContain(page, c => char.IsControl(c) && c != '\n');
        Assert.DoesNotContain('\u202E', page);
    }

    [Fact]
    public void Write_NothingWasFlown_IsAPageAllTheSame()
    {
        XDocument document = Parse(Page(new FlightSummary(FlightRecord.Empty) { CommandLine = "UavConsole" }));

        Assert.Contains("A flight that was observed", Words(document));
    }

    [Fact]
    public void Write_MissionThatNeverBegan_SaysThatItDidNotFly()
    {
        var mission = new MissionSummary(FlightRecord.Empty, MadeUpTargets.Score(FlightRecord.Empty));
        XDocument document = Parse(Page(new FlightSummary(FlightRecord.Empty) { Mission = mission }));

        Assert.Contains("it did not fly", Words(document));
        Assert.Contains("target T1 (red) was not found", Words(document));
    }

    private static string Page(FlightSummary summary)
    {
        using var page = new StringWriter();
        HtmlReport.Write(page, summary);
        return page.ToString();
    }

    private static string Words(XDocument document) => document.Root!.Element(Html + "body")!.Value;

    // Strict: what is not well-formed throws.
    private static XDocument Parse(string page)
    {
        using var reader = XmlReader.Create(
            new StringReader(page), new XmlReaderSettings { DtdProcessing = DtdProcessing.Ignore, XmlResolver = null });
        return XDocument.Load(reader);
    }

    // A person looks at them too: RABIT_REPORTS names a folder for that.
    private static void Keep(string page, string name)
    {
        if (Environment.GetEnvironmentVariable("RABIT_REPORTS") is { Length: > 0 } folder)
            File.WriteAllText(Path.Combine(folder, $"report-{name}.html"), page);
    }
}
