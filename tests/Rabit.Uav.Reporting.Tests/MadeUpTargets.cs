using System;
using System.Collections.Generic;
using System.Linq;
using Rabit.Geodesy;
using Rabit.Uav.ImageProcessing;
using Rabit.Uav.Messages;
using static Rabit.Uav.Reporting.Tests.MadeUpSite;

namespace Rabit.Uav.Reporting.Tests;

/// <summary>
/// The five targets of the made-up flight, the tracks of them, and their score.
/// </summary>
internal static class MadeUpTargets
{
    public const int FalseTrackId = 8;

    /// <summary>The one track whose bearing is known: 35 degrees or 215, within 1.3.</summary>
    public const int BearingTrackId = 2;

    public static IReadOnlyList<TargetScore> Targets { get; } =
    [
        Target("T1", DefaultTargetClasses.Red, 48, 60),
        Target("T2", DefaultTargetClasses.Orange, 76, 131),
        Target("T3", DefaultTargetClasses.Blue, 104, 41),
        Target("T4", DefaultTargetClasses.Yellow, 121, 152),
        Target("T5", DefaultTargetClasses.Magenta, 33, 166),
    ];

    /// <summary>Compared with the truth: each target has the track of its colour.</summary>
    public static MissionScore Score(FlightRecord record)
    {
        TargetTrack[] confirmed = record.Tracks.Confirmed.ToArray();
        TargetScore[] targets =
        [
            .. Targets.Select(t => Found(t, confirmed.FirstOrDefault(c => c.Class == t.Class && c.Id != FalseTrackId)))
        ];
        return new MissionScore { Targets = targets, FalseTracks = [.. confirmed.Where(t => t.Id == FalseTrackId)] };
    }

    private static TargetScore Target(string name, TargetClassName targetClass, double north, double east)
        => new() { Name = name, Class = targetClass, Position = Frame.ToGeodetic(new NedPosition(north, east, 0)) };

    private static TargetScore Found(TargetScore target, TargetTrack? track)
    {
        NedPosition error = track is null
            ? default
            : LocalNedFrame.IgnoringGeoid(target.Position).ToNed(track.Position);
        return new TargetScore
        {
            Name = target.Name,
            Class = target.Class,
            Position = target.Position,
            Track = track,
            ErrorNorthMetres = error.North,
            ErrorEastMetres = error.East,
        };
    }

    /// <param name="finds">How many of the five targets are found.</param>
    /// <param name="hasFalseTrack">Whether a track is confirmed where there is nothing.</param>
    public static IEnumerable<TargetTrack> Tracks(int finds, bool hasFalseTrack)
    {
        (double N, double E)[] errors = [(0.6, -0.5), (-0.3, 0.8), (1.1, 0.2), (-0.4, -0.9), (0.2, 0.7)];
        for (int index = 0; index < finds; index++)
        {
            NedPosition truth = Frame.ToNed(Targets[index].Position);
            yield return Track(
                index + 1, Targets[index].Class, TrackState.Confirmed, truth.North + errors[index].N,
                truth.East + errors[index].E);
        }

        if (hasFalseTrack)
            yield return Track(FalseTrackId, DefaultTargetClasses.Red, TrackState.Confirmed, 88, 92);
        yield return Track(9, DefaultTargetClasses.Orange, TrackState.Tentative, 60, 100);
    }

    private static TargetTrack Track(int id, TargetClassName colour, TrackState state, double north, double east)
        => new()
        {
            Id = id,
            Class = colour,
            State = state,
            Position = Frame.ToGeodetic(new NedPosition(north, east, 0)),
            Covariance = new HorizontalCovariance(1.1, 0.3, 0.8),
            Reports = 12 + id,
            Misses = id % 3,
            SizeMetres = 1.02,
            Bearing = id == BearingTrackId
                ? new TargetBearing(Angle.FromDegrees(35), Angle.FromDegrees(1.2), BearingSymmetry.HalfTurn)
                {
                    SystematicSigma = Angle.FromDegrees(0.5),
                }
                : null,
            FirstSeen = TimeSpan.FromSeconds(40 + (15 * id)),
            LastSeen = TimeSpan.FromSeconds(60 + (18 * id)),
            BestPictureNumber = 100 + id,
            BestReportIndex = 0,
            OtherPictures = [new TrackPicture(200 + id, 0), new TrackPicture(300 + id, 0)],
        };

    /// <summary>A whole picture with the target, and another one at its side.</summary>
    public static PictureOverview Overview(TargetTrack track)
    {
        byte[] rgb = new byte[160 * 120 * 3];
        var random = new Random(track.Id);
        for (int i = 0; i < rgb.Length; i++)
            rgb[i] = (byte)(90 + random.Next(-18, 18));
        return new PictureOverview(
            track.BestPictureNumber, 160, 120, rgb,
            [new PictureBox(0, 0.4, 0.5, 0.05, 0.08), new PictureBox(1, 0.7, 0.2, 0.04, 0.05)]);
    }

    /// <summary>The parts of pictures around a target.</summary>
    public static IEnumerable<ImageChip> Chips(TargetTrack track)
        => [
            Chip(track, track.BestPictureNumber),
            .. track.OtherPictures.Select(o => Chip(track, o.PictureNumber)),
        ];

    private static ImageChip Chip(TargetTrack track, long picture)
    {
        const int Size = 48;
        var rgb = new byte[Size * Size * 3];
        uint css = track.Class == DefaultTargetClasses.Red ? 0xCD1C20u : 0x1C48CDu;
        var random = new Random(track.Id);
        for (int index = 0; index < Size * Size; index++)
        {
            bool isTarget = Math.Abs((index % Size) - 24) < 7 && Math.Abs((index / Size) - 24) < 7;
            int noise = random.Next(-18, 18);
            for (int channel = 0; channel < 3; channel++)
            {
                int ground = new[] { 96, 118, 74 }[channel];
                int value = isTarget ? (int)((css >> (16 - (8 * channel))) & 255) : ground;
                rgb[(index * 3) + channel] = (byte)Math.Max(0, Math.Min(255, value + noise));
            }
        }

        return new ImageChip(picture, track.BestReportIndex, Size, Size, rgb);
    }
}
