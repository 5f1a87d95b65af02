using System;
using System.Linq;
using Rabit.Geodesy;
using Rabit.Uav.Messages;
using Rabit.Uav.MissionControl;
using Xunit;
using Xunit.Abstractions;

namespace Rabit.Uav.Simulation.Tests.Missions;

/// <summary>
/// A walker and a car go below trees and roofs while they are followed by pictures, and keep their tracks.
/// </summary>
public sealed class OccludedFollowTests(ITestOutputHelper output)
{
    private const double NearMetres = 12;

    // Half the diagonal of the picture at one metre of height: 400 of 530 pixels, and a little.
    private const double PictureMetresPerMetre = 0.76;

    private static readonly TimeSpan MaxAge = TimeSpan.FromSeconds(1);
    private static readonly TimeSpan MaxWait = TimeSpan.FromSeconds(8);

    [Fact, Trait("Category", "Long")]
    public void Search_TargetsGoBelowTreesAndRoofs_KeepTheirTracks()
    {
        Passage[] all = new[] { 2, 4, 9 }.SelectMany(Fly).ToArray();
        Assert.InRange(all.Sum(p => p.Kept), 18, int.MaxValue);
        Assert.InRange(all.Sum(p => p.Changed), 0, 1);
        Assert.InRange(all.Sum(p => p.NotSeenAgain), 0, 2);
    }

    private Passage[] Fly(int seed)
    {
        var options = new SimulationOptions
        {
            Seed = seed,
            Motions = [SimulatedMotion.Walking, SimulatedMotion.Vehicle],
            OccluderCount = 8,
        };
        using var flight = new SearchFlight(SearchFlight.FollowingPlan(
            options, "\"followSeconds\": 90, \"followSpeedMetresPerSecond\": 12"), options);
        Passage[] passages = flight.World.Targets.Where(t => t.Motion != SimulatedMotion.Standing)
            .Select(t => new Passage(t)).ToArray();
        flight.FlyUntil(
            f =>
            {
                foreach (Passage passage in passages)
                    passage.Look(f);
                return f.IsOver;
            },
            TimeSpan.FromMinutes(20));
        flight.End();

        foreach (Passage passage in passages)
            output.WriteLine($"seed {seed}: {passage}");
        return passages;
    }

    // The track of a target before it goes below something, and that when it is seen again soon after. One that is in
    // the open and outside the picture meanwhile, since another target is followed, is not hidden but left: that is
    // counted apart.
    private sealed class Passage(SimulatedTarget target)
    {
        private int _before;
        private TimeSpan _hiddenFrom;
        private TimeSpan _outSince;
        private bool _isWaiting;

        public int Kept { get; private set; }

        public int Changed { get; private set; }

        public int NotSeenAgain { get; private set; }

        public int Left { get; private set; }

        public void Look(SearchFlight flight)
        {
            TimeSpan now = flight.Reactor.Now;
            NedPosition place = target.PositionAt(now);
            bool isHidden = flight.World.Occluders.Any(o => o.Hides(place));
            int id = TrackAt(flight, place);
            if (isHidden && !_isWaiting && _before > 0)
                (_isWaiting, _hiddenFrom) = (true, now);
            if (isHidden)
                _outSince = now;
            else if (_isWaiting && id == 0 && IsOutsidePicture(flight, place))
                (_isWaiting, _before, Left) = (false, 0, Left + 1);
            else if (!_isWaiting)
                _before = id;
            else if (id > 0)
                End(id, flight);
            else if (now - _outSince > MaxWait)
                End(0, flight);
        }

        public override string ToString()
            => $"{target.Name}, {target.Motion}: kept {Kept}, changed {Changed}, not seen again {NotSeenAgain}, left {Left}";

        private static bool IsOutsidePicture(SearchFlight flight, NedPosition place)
        {
            NedPosition vehicle = flight.World.Truth.Pose.Position;
            double apart = Math.Sqrt(Math.Pow(place.North - vehicle.North, 2) + Math.Pow(place.East - vehicle.East, 2));
            return apart > PictureMetresPerMetre * (place.Down - vehicle.Down);
        }

        private void End(int id, SearchFlight flight)
        {
            _isWaiting = false;
            // It was below an edge only, for no whole second.
            if (_outSince - _hiddenFrom >= TimeSpan.FromSeconds(1))
            {
                Kept += id == _before ? 1 : 0;
                Changed += id > 0 && id != _before ? 1 : 0;
                NotSeenAgain += id == 0 ? 1 : 0;
            }

            _before = id;
        }

        private int TrackAt(SearchFlight flight, NedPosition place)
        {
            var frame = LocalNedFrame.IgnoringGeoid(flight.World.PositionOf(place));
            return flight.Tracks.Tracks
                .Where(t => t.Class == target.Class && t.State == TrackState.Confirmed
                    && flight.Reactor.Now - t.LastSeen <= MaxAge && Horizontal(frame.ToNed(t.Position)) < NearMetres)
                .Select(t => t.Id).FirstOrDefault();
        }

        private static double Horizontal(NedPosition p) => Math.Sqrt((p.North * p.North) + (p.East * p.East));
    }
}
