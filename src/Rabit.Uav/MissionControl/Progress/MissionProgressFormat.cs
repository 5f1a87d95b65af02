using System;
using System.Collections.Generic;
using System.Collections.Immutable;
using System.Globalization;
using System.IO;
using System.Linq;
using System.Text;
using System.Text.Json;
using Rabit.Geodesy;
using Rabit.Uav.Json;
using Rabit.Uav.Messages;

namespace Rabit.Uav.MissionControl;

/// <summary>
/// The form of a progress file: one JSON object whose last property is the SHA-256 of the text before it, so that a
/// file that was cut off or changed is noticed.
/// </summary>
internal static class MissionProgressFormat
{
    /// <summary>250 000 cells and 2000 lanes take a fifth of it.</summary>
    public const int MaxTextLength = 2_000_000;

    private const int Version = 1;
    private const int MaxLegs = 10_000;
    private const int MaxCells = 1_000_000;

    // North and east of start and end, and half the width.
    private const string SkippedName = "skippedNorthEastHalfMetres";
    private const int NumbersOfSkipped = 5;
    private const string Seal = ",\"sha256\":\"";
    private const string End = "\"}\n";

    public static string Write(ProgressSnapshot snapshot)
    {
        using var stream = new MemoryStream();
        using (var json = new Utf8JsonWriter(stream))
            Write(json, snapshot);
        string text = Encoding.UTF8.GetString(stream.ToArray());
        string body = text.Remove(text.Length - 1);
        return body + Seal + Sha256Hex.Of(body) + End;
    }

    /// <exception cref="MissionProgressException">It is not complete, or of another version.</exception>
    public static MissionProgress Parse(string text, string name)
    {
        int seal = text.LastIndexOf(Seal, StringComparison.Ordinal);
        bool isWhole = seal >= 0 && text.Length == seal + Seal.Length + Sha256Hex.Length + End.Length
            && text.EndsWith(End, StringComparison.Ordinal)
            && string.CompareOrdinal(
                text, seal + Seal.Length, Sha256Hex.Of(text.Remove(seal)), 0, Sha256Hex.Length) == 0;
        if (!isWhole)
            throw new MissionProgressException(name, "it is not complete or was changed: its SHA-256 does not match");
        try
        {
            using JsonDocument document = JsonDocument.Parse(text);
            return Read(document.RootElement, name);
        }
        catch (JsonException e)
        {
            throw new MissionProgressException(name, "it is not JSON", e);
        }
    }

    private static void Write(Utf8JsonWriter json, ProgressSnapshot s)
    {
        json.WriteStartObject();
        json.WriteNumber("version", Version);
        json.WriteString("mission", s.MissionName);
        json.WriteString("missionSha256", s.Fingerprint);
        json.WriteString("savedUtc", s.SavedUtc.UtcDateTime.ToString("O", CultureInfo.InvariantCulture));
        json.WriteString("phase", s.Phase.ToString());
        json.WriteBoolean("isCommanding", s.IsCommanding);
        json.WriteBoolean("isInAir", s.IsInAir);
        json.WriteStartObject("home");
        Write(json, s.Home);
        json.WriteNumber("groundAltitudeAmslMetres", s.Home.AltitudeAmslMetres);
        json.WriteEndObject();
        json.WriteNumber("lanesFlown", s.LanesFlown);
        json.WriteNumber("flownMetresOfLane", s.FlownMetresOfLeg);
        json.WriteNumber("gapPasses", s.GapPasses);
        json.WriteStartArray("lanesNorthEastMetres");
        foreach (LaneSegment leg in s.Legs)
        {
            json.WriteNumberValue(leg.Start.North);
            json.WriteNumberValue(leg.Start.East);
            json.WriteNumberValue(leg.End.North);
            json.WriteNumberValue(leg.End.East);
        }

        json.WriteEndArray();
        json.WriteNumber("coverage", s.Coverage);
        WriteCells(json, s.Cells);
        ProgressTargets.Write(json, s);
        WriteSkipped(json, s.Skipped);
        s.Changes.Write(json);
        json.WriteEndObject();
    }

    public static void Write(Utf8JsonWriter json, GeodeticPosition position)
    {
        json.WriteNumber("latitudeDegrees", position.Latitude.Degrees);
        json.WriteNumber("longitudeDegrees", position.Longitude.Degrees);
    }

    private static void WriteCells(Utf8JsonWriter json, CoverageCells cells)
    {
        json.WriteStartObject("cells");
        json.WriteNumber("southMetres", cells.SouthWest.North);
        json.WriteNumber("westMetres", cells.SouthWest.East);
        json.WriteNumber("sideMetres", cells.CellMetres);
        json.WriteNumber("rows", cells.Rows);
        json.WriteNumber("columns", cells.Columns);
        json.WriteString("seen", Convert.ToBase64String(cells.Seen));
        json.WriteEndObject();
    }

    private static MissionProgress Read(JsonElement root, string name)
    {
        var faults = new List<string>();
        var fields = new JsonFields(root, string.Empty, faults);
        int version = fields.RequiredWholeNumber("version");
        if (version != Version)
        {
            throw new MissionProgressException(
                name, FormattableString.Invariant($"it is of version {version}; version {Version} is read"));
        }

        JsonFields home = fields.RequiredObject("home");
        bool isPhase = Enum.TryParse(fields.Text("phase"), out MissionPhase phase);
        bool isTime = DateTimeOffset.TryParse(
            fields.Text("savedUtc"), CultureInfo.InvariantCulture, DateTimeStyles.AssumeUniversal,
            out DateTimeOffset saved);
        var progress = new MissionProgress
        {
            MissionName = fields.Text("mission") ?? string.Empty,
            Fingerprint = fields.Text("missionSha256") ?? string.Empty,
            SavedUtc = saved,
            Phase = phase,
            IsCommanding = fields.Flag("isCommanding") ?? false,
            IsInAir = fields.Flag("isInAir") ?? false,
            Home = ReadPosition(home, home.RequiredNumber("groundAltitudeAmslMetres")),
            LanesFlown = fields.RequiredWholeNumber("lanesFlown"),
            FlownMetresOfLeg = fields.RequiredNumber("flownMetresOfLane"),
            GapPasses = fields.RequiredWholeNumber("gapPasses"),
            Legs = ReadLegs(fields),
            Coverage = fields.RequiredNumber("coverage"),
            Cells = ReadCells(fields.RequiredObject("cells"), faults),
            Targets = ProgressTargets.Read(fields, "targets", faults),
            RejectedTargets = ProgressTargets.Read(fields, "rejectedTargets", faults),
            Skipped = ReadSkipped(fields),
            Changes = ProgressChanges.Read(fields, faults),
        };
        if (!isPhase || !isTime)
            faults.Add("phase or savedUtc is missing");
        if (progress.LanesFlown < 0 || progress.LanesFlown > progress.LaneCount)
            faults.Add("lanesFlown is not a number of lanes");
        return faults.Count == 0 ? progress : throw new MissionProgressException(name, string.Join("; ", faults));
    }

    public static GeodeticPosition ReadPosition(JsonFields fields, double altitude)
    {
        double latitude = fields.RequiredNumber("latitudeDegrees");
        double longitude = fields.RequiredNumber("longitudeDegrees");
        if (Math.Abs(latitude) <= 90 && Math.Abs(longitude) <= 180)
            return GeodeticPosition.FromDegrees(latitude, longitude, altitude);
        fields.Missing("a position");
        return default;
    }

    private static ImmutableArray<LaneSegment> ReadLegs(JsonFields fields)
    {
        int count = fields.Array("lanesNorthEastMetres")?.GetArrayLength() ?? 0;
        double[] numbers = fields.RequiredNumbers("lanesNorthEastMetres", Math.Min(count / 4, MaxLegs) * 4);
        var legs = ImmutableArray.CreateBuilder<LaneSegment>(numbers.Length / 4);
        for (int i = 0; i < numbers.Length; i += 4)
        {
            legs.Add(new LaneSegment(
                new PlanePoint(numbers[i], numbers[i + 1]), new PlanePoint(numbers[i + 2], numbers[i + 3])));
        }

        return legs.MoveToImmutable();
    }

    // Files of earlier versions have none.
    private static ImmutableArray<SkippedLane> ReadSkipped(JsonFields fields)
    {
        int count = Math.Min((fields.Array(SkippedName)?.GetArrayLength() ?? 0) / NumbersOfSkipped, MaxLegs);
        if (count == 0)
            return [];
        double[] n = fields.RequiredNumbers(SkippedName, count * NumbersOfSkipped);
        return Enumerable.Range(0, count).Select(i => i * NumbersOfSkipped).Select(i => new SkippedLane(
            new LaneSegment(new PlanePoint(n[i], n[i + 1]), new PlanePoint(n[i + 2], n[i + 3])), n[i + 4]))
            .ToImmutableArray();
    }

    private static void WriteSkipped(Utf8JsonWriter json, ImmutableArray<SkippedLane> skipped)
    {
        json.WriteStartArray(SkippedName);
        foreach (SkippedLane lane in skipped)
        {
            json.WriteNumberValue(lane.Leg.Start.North);
            json.WriteNumberValue(lane.Leg.Start.East);
            json.WriteNumberValue(lane.Leg.End.North);
            json.WriteNumberValue(lane.Leg.End.East);
            json.WriteNumberValue(lane.HalfMetres);
        }

        json.WriteEndArray();
    }

    private static CoverageCells ReadCells(JsonFields fields, List<string> faults)
    {
        int rows = fields.RequiredWholeNumber("rows");
        int columns = fields.RequiredWholeNumber("columns");
        double side = fields.RequiredNumber("sideMetres");
        var corner = new PlanePoint(fields.RequiredNumber("southMetres"), fields.RequiredNumber("westMetres"));
        try
        {
            byte[] seen = Convert.FromBase64String(fields.Text("seen") ?? string.Empty);
            bool isGrid = rows >= 0 && columns >= 0 && (long)rows * columns <= MaxCells && side > 0
                && seen.Length == CoverageCells.BytesFor(rows, columns);
            if (isGrid)
                return new CoverageCells(corner, side, rows, columns, seen);
        }
        catch (FormatException)
        {
            // The fault below names it.
        }

        faults.Add("cells is no grid with one bit for each cell");
        return CoverageCells.None;
    }
}
