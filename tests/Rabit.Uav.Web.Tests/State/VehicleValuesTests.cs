using System;
using System.Collections.Generic;
using System.Collections.Immutable;
using System.Globalization;
using System.Linq;
using System.Numerics;
using System.Text.Json;
using Rabit.Geodesy;
using Rabit.Uav.Messages;
using Rabit.Uav.Web.Collecting;
using Rabit.Uav.Web.State;
using Xunit;

namespace Rabit.Uav.Web.Tests.State;

/// <summary>What becomes of a flight as values of the page: bounded, whatever its length.</summary>
public sealed class VehicleValuesTests : IDisposable
{
    private static readonly GeodeticPosition Home = GeodeticPosition.FromDegrees(47.397, 8.544, 488);
    private static readonly LocalNedFrame Frame = LocalNedFrame.IgnoringGeoid(Home);

    private readonly PageState _state = new();
    private readonly ItemWriter _writer;

    public VehicleValuesTests() => _writer = new ItemWriter(_state);

    public void Dispose() => _writer.Dispose();

    [Theory]
    [InlineData(900, 900, 1)]
    [InlineData(1500, 750, 2)]
    [InlineData(20_000, 625, 32)]
    public void PathSeries_LongFlight_IsEvenlyThinned(int seconds, int expectedSamples, int expectedSpacing)
    {
        var path = new PathSeries("0");
        for (int second = 0; second < seconds; second++)
        {
            path.Add(Moment(second, north: second));
            if (second % 7 == 0)
                path.Write(_writer, _state);
        }

        path.Write(_writer, _state);
        double[] times = [.. Groups("0/path/").SelectMany(g => g.EnumerateArray()).Select(s => s[0].GetDouble())];
        Assert.Equal(expectedSamples, times.Length);
        Assert.All(times.Zip(times.Skip(1)), pair => Assert.Equal(expectedSpacing, pair.Second - pair.First));
        Assert.InRange(seconds - times[^1], 1, expectedSpacing);
    }

    [Fact]
    public void SeenCells_PictureOfAPart_MarksItsCells()
    {
        var seen = new SeenCells("0");
        seen.Mark(Moment(0, plan: Plan(200)));
        seen.Write(_writer, _state);
        seen.Mark(Moment(1, plan: Plan(200), picture: (1, 0, 100, 0, 200)));
        seen.Write(_writer, _state);

        JsonElement frame = Values()["0/seen"];
        int rows = frame.GetProperty("rows").GetInt32();
        int columns = frame.GetProperty("columns").GetInt32();
        Dictionary<string, JsonElement> values = Values();
        int marked = Enumerable.Range(0, rows)
            .SelectMany(row => values["0/seen/" + Text(row)].GetProperty("seen").GetString()!)
            .Sum(c => BitOperations.PopCount(
                uint.Parse(c.ToString(), NumberStyles.HexNumber, CultureInfo.InvariantCulture)));
        Assert.InRange((double)marked / (rows * columns), 0.48, 0.52);

        // Of the northern half none.
        Assert.DoesNotContain(Values()["0/seen/" + Text(rows - 1)].GetProperty("seen").GetString()!, c => c != '0');
    }

    [Fact]
    public void PlanItems_AnotherPlan_TakesTheOldFiguresAway()
    {
        var items = new PlanItems("0");
        items.Write(_writer, _state, Plan(200, keepOuts: 3, lanes: 300));
        Assert.Equal(3, Values().Count(v => v.Key.StartsWith("0/plan/keepout", StringComparison.Ordinal)));
        Assert.Equal(600, Groups("0/plan/lanes/").Sum(g => g.GetArrayLength()));
        items.Write(_writer, _state, Plan(200, keepOuts: 1, lanes: 2));
        Assert.Equal(1, Values().Count(v => v.Key.StartsWith("0/plan/keepout", StringComparison.Ordinal)));
        Assert.Equal(4, Groups("0/plan/lanes/").Sum(g => g.GetArrayLength()));
    }

    [Fact]
    public void TrackItems_ManyTracksOneAfterTheOther_TakeNoMorePlacesThanThereAre()
    {
        var items = new TrackItems("0", new PageChips(), imageChips: null);
        for (int first = 1; first < 2000; first += 50)
        {
            items.Write(_writer, _state, new TrackList(
                TimeSpan.Zero,
                Enumerable.Range(first, 300).Select(id => new TargetTrack { Id = id, Position = Home })));
            int[] shown = [.. Values().Where(v => v.Key.StartsWith("0/track/", StringComparison.Ordinal))
                .Select(v => v.Value.GetProperty("id").GetInt32()).Order()];
            Assert.Equal(Enumerable.Range(first + 100, TrackItems.MaxTracks), shown);
        }

        Assert.Equal(TrackItems.MaxTracks, _state.Count);
    }

    [Fact]
    public void LogItems_ManyLines_KeepsTheLast()
    {
        var log = new LiveLog();
        var items = new LogItems("0", log);
        for (int line = 0; line < 1000; line++)
        {
            log.Note(TimeSpan.FromSeconds(line), "test", "line " + Text(line));
            if (line % 20 == 0)
                items.Write(_writer, RecentItems<StatusText>.None);
        }

        for (int round = 0; round < 10; round++)
            items.Write(_writer, RecentItems<StatusText>.None);
        JsonElement[] lines = [.. Groups("0/log/")];
        Assert.Equal(200, lines.Length);
        Assert.Equal(
            Enumerable.Range(800, 200).Select(n => "line " + Text(n)),
            lines.OrderBy(l => l.GetProperty("n").GetInt32()).Select(l => l.GetProperty("text").GetString()!));
    }

    [Fact]
    public void VehicleItems_OtherVehicles_AreShownAndTakenAway()
    {
        var items = new VehicleItems("0");
        var other = new OtherVehicle(7, Home, 30, Angle.FromDegrees(90), TimeSpan.FromSeconds(1));
        items.Write(_writer, _state, Moment(1, others: [other]));
        Assert.Equal(7, Values()["0/other/0"].GetProperty("system").GetInt32());
        items.Write(_writer, _state, Moment(2));
        Assert.DoesNotContain("0/other/0", Values().Keys);
    }

    private static string Text(int number) => number.ToString(CultureInfo.InvariantCulture);

    private static FlightMoment Moment(
        double seconds, double north = 0, SearchPlan? plan = null,
        (long Number, double South, double North, double West, double East)? picture = null,
        IReadOnlyList<OtherVehicle>? others = null)
        => new()
        {
            Time = TimeSpan.FromSeconds(seconds),
            Vehicle = new VehicleState { PositionTime = TimeSpan.FromSeconds(seconds), Position = At(north, 0) },
            Mission = new MissionStatus { Plan = plan },
            Health = default,
            Imaging = picture is not { } p ? default : new ImagingStatus
            {
                Observations = 1,
                LastObservation = new CameraObservation
                {
                    Number = p.Number,
                    TopLeft = At(p.North, p.West),
                    TopRight = At(p.North, p.East),
                    BottomRight = At(p.South, p.East),
                    BottomLeft = At(p.South, p.West),
                },
            },
            Tracks = TrackList.None,
            Texts = RecentItems<StatusText>.None,
            Links = [],
            Managers = [],
            Others = others ?? [],
        };

    private static SearchPlan Plan(double side, int keepOuts = 0, int lanes = 0) => new()
    {
        Area = [At(0, 0), At(side, 0), At(side, side), At(0, side)],
        KeepOuts = [.. Enumerable.Range(0, keepOuts).Select(_ => ImmutableArray.Create(At(1, 1), At(2, 1), At(2, 2)))],
        Lanes = [.. Enumerable.Range(0, 2 * lanes).Select(n => At(n, n))],
        Home = Home,
    };

    private static GeodeticPosition At(double north, double east) => Frame.ToGeodetic(new NedPosition(north, east, 0));

    private IEnumerable<JsonElement> Groups(string prefix) => Values()
        .Where(v => v.Key.StartsWith(prefix, StringComparison.Ordinal))
        .OrderBy(v => int.Parse(v.Key[prefix.Length..], CultureInfo.InvariantCulture)).Select(v => v.Value);

    // As a browser that comes now has them.
    private Dictionary<string, JsonElement> Values()
    {
        var values = new Dictionary<string, JsonElement>(StringComparer.Ordinal);
        var message = new byte[PageState.MaxMessageBytes];
        long has = 0;
        for (bool isComplete = false; !isComplete;)
        {
            int length = _state.Fill(ref has, message, out isComplete);
            if (length == 0)
                break;
            using JsonDocument document = JsonDocument.Parse(message.AsMemory(0, length));
            foreach (JsonProperty set in document.RootElement.GetProperty("set").EnumerateObject())
            {
                values.Remove(set.Name);
                if (set.Value.ValueKind != JsonValueKind.Null)
                    values.Add(set.Name, set.Value.Clone());
            }
        }

        return values;
    }
}
