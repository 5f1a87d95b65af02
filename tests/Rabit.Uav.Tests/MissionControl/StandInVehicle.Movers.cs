using System;
using System.Collections.Generic;
using System.Linq;
using Rabit.Geodesy;
using Rabit.Uav.Messages;

namespace Rabit.Uav.Tests.MissionControl;

/// <summary>Targets that move, and the tracks that its Sensor Fusion makes of them.</summary>
internal sealed partial class StandInVehicle
{
    private const int FirstMoverTrack = 101;

    private static readonly TimeSpan MoverKept = TimeSpan.FromSeconds(25);

    private readonly Dictionary<int, int> _moverReports = [];

    /// <summary>Where each is at a time; null while it cannot be seen.</summary>
    public List<Func<TimeSpan, (double North, double East)?>> Movers { get; } = [];

    public TargetMotion MoverMotion { get; set; } = TargetMotion.Walking;

    /// <summary>Whether a mover is in the picture.</summary>
    public bool Sees(int mover)
    {
        if (Movers[mover](Now) is not var (n, e))
            return false;
        double height = Height - Ground(North, East);
        double forward = ((n - North) * Math.Cos(Yaw)) + ((e - East) * Math.Sin(Yaw));
        double right = ((e - East) * Math.Cos(Yaw)) - ((n - North) * Math.Sin(Yaw));
        return Math.Abs(forward) <= 0.45 * height && Math.Abs(right) <= 0.6 * height;
    }

    private IEnumerable<TargetReport> MoverReports()
        => Enumerable.Range(0, Movers.Count).Where(Sees).Select(i => new TargetReport
        {
            Class = DefaultTargetClasses.Red,
            Position = PlaceOf(Movers[i](Now)!.Value),
            PictureNumber = _picture,
            Index = 100 + i,
        });

    private void SeeMovers()
    {
        int before = Tracks.RemoveAll(t => t.Id >= FirstMoverTrack && Now - t.LastSeen > MoverKept);
        for (int i = 0; i < Movers.Count; i++)
        {
            if (!Sees(i))
                continue;
            int id = FirstMoverTrack + i;
            int reports = _moverReports.TryGetValue(i, out int count) ? count + 1 : 1;
            _moverReports[i] = reports;
            Tracks.RemoveAll(t => t.Id == id);
            Tracks.Add(MoverTrack(i, id, reports));
            before++;
        }

        if (before > 0)
            PostTracks();
    }

    private TargetTrack MoverTrack(int mover, int id, int reports)
    {
        (double n, double e) = Movers[mover](Now)!.Value;
        (double n, double e) earlier = Movers[mover](Now - TimeSpan.FromSeconds(1)) ?? (n, e);
        return new TargetTrack
        {
            Id = id,
            State = StateOf(id, reports),
            Decision = DecisionOf(id),
            Class = DefaultTargetClasses.Red,
            Motion = MoverMotion,
            Position = PlaceOf((n, e)),
            VelocityNed = new NedVector(n - earlier.n, e - earlier.e, 0),
            Covariance = new HorizontalCovariance(1, 0, 1),
            Time = Now,
            LastSeen = Now,
            Reports = reports,
            BestPictureNumber = _picture,
        };
    }

    private GeodeticPosition PlaceOf((double North, double East) at)
        => _frame.ToGeodetic(new NedPosition(at.North, at.East, 0));
}
