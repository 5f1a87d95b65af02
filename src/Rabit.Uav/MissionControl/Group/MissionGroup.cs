using System;
using System.Collections.Generic;
using System.Collections.Immutable;
using System.Linq;
using Rabit.Geodesy;
using Rabit.Uav.Messages;

namespace Rabit.Uav.MissionControl;

/// <summary>
/// The part of a vehicle in a group that searches one area: reports, flies the lanes that are its share, and shares
/// what was seen. Works without a leader, and without the others: alone it has all lanes. One thread.
/// </summary>
internal sealed partial class MissionGroup(GroupOptions options, Action<string> log)
{
    /// <summary>Landing places are at least so far apart, metres.</summary>
    public const double MinLandingDistanceMetres = 10;

    // A vehicle that is this high above its landing place flies.
    private const double FlyingMetres = 5;

    // Messages of coverage, each of up to LaneCoverage.MaxLanes lanes.
    private const int MaxSeenBefore = 64;

    private const double UnlimitedSeconds = ushort.MaxValue;

    // The usual defaults of multirotors.
    private const double ClimbMetresPerSecond = 2.5;
    private const double SinkMetresPerSecond = 1.5;

    private readonly GroupMembers _members = new(options.SilentAfter);
    private readonly GroupDivision _division = new();
    private readonly CoverageExchange _coverage = new();
    private readonly GroupLog _log = new(log);
    private readonly SortedDictionary<int, LaneCoverage> _seenBefore = [];
    private FlightPlan? _plan;
    private MissionPlan? _keyed;
    private uint _key;
    private int _taken;
    private LaneShare _share;
    private TimeSpan? _doneSince;
    private bool _isSpent;
    private GroupReport _own;
    private int _seenCells;

    /// <summary>Our MAVLink system id; 0 while it is not known: nothing is sent or divided then.</summary>
    public byte SystemId { get; set; }

    /// <summary>Where what we send goes.</summary>
    public IGroupSender? Sender { get; set; }

    /// <summary>Null before there is a plan.</summary>
    public SharedLanes? Lanes { get; private set; }

    /// <summary>
    /// The most of the area that another vehicle reports as seen, 0 to 1; of one that is silent now, too.
    /// </summary>
    public double SeenFractionOfOthers => _members.All.Select(m => m.Report.SeenFraction).DefaultIfEmpty(0).Max();

    /// <summary>How often who flies which lanes has changed.</summary>
    public int DivisionChanges => _division.Changes;

    public GroupStatus Status(TimeSpan now) => new()
    {
        Members = _members.All.Select(m => new GroupMember
        {
            SystemId = m.SystemId,
            State = m.Report.State,
            IsPresent = _members.IsPresent(m.SystemId, now),
            IsTwice = _members.FindTwice(m.SystemId, now) is not null,
            Time = m.Time,
            Position = m.Report.Position,
            Lanes = _division.ShareOf(m.SystemId).Count,
            MetresLeft = m.Report.MetresLeft,
        }).ToImmutableArray(),
        DivisionAuthor = _division.Author,
        OwnShare = _division.ShareOf(SystemId),
        OwnMetresLeft = _own.MetresLeft,
        Lanes = Lanes?.Lanes.Count ?? 0,
        Validations = _validation?.TasksOf(SystemId).ToImmutableArray() ?? [],
        Followings = _following?.Entries.Select(e => e.Task).ToImmutableArray() ?? [],
        FollowedTracks = _links?.Tracks ?? [],
        Refused = _members.Refused + _division.Refused + _coverage.Refused + (_validation?.Refused ?? 0)
            + (_following?.Refused ?? 0),
    };

    public void Receive(MissionFlight flight, in Envelope<GroupReport> envelope)
        => _members.Receive(envelope, SystemId, KeyOf(flight.Mission), flight.Now);

    public void Receive(MissionFlight flight, in Envelope<LaneDivision> envelope)
    {
        NotePlan(flight);
        if (Lanes is not { } lanes || envelope.Content.LanesKey != lanes.Key)
            return;
        byte author = GroupDivision.AuthorOf(_own, SystemId, _members.Present(flight.Now));
        _division.Receive(envelope.SourceSystemId, envelope.Content, SystemId, author, lanes.Lanes.Count);
    }

    public void Receive(MissionFlight flight, in Envelope<LaneCoverage> envelope)
    {
        NotePlan(flight);
        if (Lanes is { } lanes && flight.Route is { } route)
            Take(flight, envelope.Content, lanes, route);
        else
            KeepForPlan(envelope.Content, KeyOf(flight.Mission));
    }

    /// <summary>In each tick, after all that was received.</summary>
    public void Update(MissionFlight flight, MissionPhase phase)
    {
        if (SystemId == 0 || flight.Vehicle.PositionTime is null)
            return;
        NotePlan(flight);
        UpdateAltitude(flight);
        _own = ReportOf(flight, phase);
        (byte SystemId, GroupReport Report)[] present = _members.Present(flight.Now).ToArray();
        if (Lanes is { } lanes)
        {
            if (_division.Update(
                _own, SystemId, present, MetresLeftOf, m => Divide(flight, lanes, m), mayBalance: lanes.Changes > 0,
                flight.Now))
                Sender?.Send(DivisionOf(lanes));
            if (phase != MissionPhase.Searching)
                TakeShare(flight);
            UpdateValidation(flight, present);
            UpdateFollowing(flight, present);
            ShareSkipped(flight.Route!, lanes);
            if (_coverage.Update(lanes, flight.Route!.Coverage, flight.Now, present.Length > 0) is { } seen)
                Sender?.Send(seen);
        }

        _log.Update(
            present.Select(m => m.SystemId), _members.All.Select(m => m.SystemId),
            _members.Elsewhere(flight.Now).ToArray());
        foreach ((byte id, _, _) in _members.All)
            _log.UpdateTwice(id, _members.FindTwice(id, flight.Now));
        Sender?.Report(_own, flight.Now);
    }

    /// <summary>
    /// Before a lane, or between two: our share, and of it what others have not seen meanwhile.
    /// </summary>
    public void BeginLeg(MissionFlight flight)
    {
        TakeShare(flight);
        _isLaneLeft = false;
        if (flight.Route is not { Current: not null } route || route.Coverage.SeenCells == _seenCells)
            return;
        _seenCells = route.Coverage.SeenCells;
        route.LeaveOutSeen(flight.OverlapMetres);
    }

    /// <summary>What is left to fly becomes our share, where that has changed; not while a lane is flown.</summary>
    public void TakeShare(MissionFlight flight)
    {
        if (Lanes is not { } lanes || _taken == _division.Changes || flight.Route is not { } route)
            return;
        _taken = _division.Changes;
        LaneShare share = _division.ShareOf(SystemId);
        if (share.SystemId == 0)
            return;
        (_share, _doneSince, _isSpent) = (share, null, false);
        route.SeenToEachSideMetres = SeenToEachSide(flight);
        route.SetRest(lanes.Of(share), flight.OverlapMetres, flight.Position);
        string all = MissionNumbers.Of(lanes.Lanes.Count);
        string which = share.Count switch
        {
            0 => $"none of {all} lanes is ours",
            1 => $"lane {MissionNumbers.Of(share.First + 1)} of {all} is ours",
            _ => $"lanes {MissionNumbers.Of(share.First + 1)} to {MissionNumbers.Of(share.First + share.Count)} of "
                + $"{all} are ours",
        };
        flight.Log(
            $"{which}: vehicle {MissionNumbers.Of(_division.Author)} divided them among "
                + MissionNumbers.Of(_division.Shares.Length));
    }

    /// <summary>Whether a place is ours to see.</summary>
    public bool IsOurs(PlanePoint place)
        => _share.SystemId == 0 || Lanes?.IsBeside(_share, place, marginMetres: 1) != false;

    /// <summary>
    /// Our lanes are flown: whether we wait for lanes or targets of others; null where we do not.
    /// </summary>
    public string? FindWait(MissionFlight flight)
    {
        _doneSince ??= flight.Now;
        if (flight.Now - _doneSince.Value > options.MaxWait || !HasEnergyToTakeOver(flight))
            return null;
        int busy = _members.Present(flight.Now)
            .Count(m => m.Report.State == GroupMemberState.Available && m.Report.MetresLeft > 0);
        return busy > 0
            ? $"our lanes are flown; others still searching: {MissionNumbers.Of(busy)}"
            : AreLanesToBeDivided(flight.Now) ? "our lanes are flown; those of another vehicle are divided"
            : !HasOthers(flight) ? null
            : _validation?.IsPending == true ? "our lanes are flown; targets are still being validated"
            : _following?.IsPending == true ? "our lanes are flown; a target is still followed"
            : null;
    }

    // Another one left, or is held, with lanes to fly: who divides them does so as soon as it knows.
    private bool AreLanesToBeDivided(TimeSpan now)
    {
        var searching = new HashSet<byte>(_members.Present(now)
            .Where(m => m.Report.State == GroupMemberState.Available).Select(m => m.SystemId));
        return _division.Shares.Any(
            s => s.SystemId != SystemId && !searching.Contains(s.SystemId) && MetresLeftOf(s.SystemId) > 0);
    }

    // It would wait until its battery calls it home, as one that failed.
    private bool HasEnergyToTakeOver(MissionFlight flight)
    {
        EnergyStatus energy = flight.Energy.Status;
        bool isSpent = energy.IsKnown && energy.TimeToReturn.ExactSeconds < MinFollowSeconds + ReserveSeconds;
        if (isSpent && !_isSpent)
            flight.Log("our lanes are flown, and too little is left to take anything over");
        return !(_isSpent |= isSpent);
    }

    /// <summary>Whether nothing is left to do: the others have seen the area, and wait for nothing.</summary>
    /// <param name="flight">The state of the mission; with a plan.</param>
    public bool IsSearched(MissionFlight flight)
    {
        NotePlan(flight);
        return flight.RequiredCoverage > 0 && flight.SeenFraction >= flight.CoverageGoal
            && _validation?.IsPending != true && _following?.IsPending != true;
    }

    // Another plan is another area: the operator has changed it.
    private void NotePlan(MissionFlight flight)
    {
        if (ReferenceEquals(flight.Plan, _plan))
            return;
        uint before = _key;
        bool isFirst = _plan is null;
        _plan = flight.Plan;
        Lanes = new SharedLanes(KeyOf(flight.Mission), _plan!.Lanes, flight.Mission.LaneSpacingMetres);
        _division.Clear();
        _coverage.Clear();
        (_share, _doneSince, _isSpent, _skippedShared) = (default, null, false, 0);
        if (!isFirst && _key != before)
            _members.Clear();
        foreach (LaneCoverage seen in _seenBefore.Values)
            Take(flight, seen, Lanes, flight.Route!);
        _seenBefore.Clear();
    }

    private void Take(MissionFlight flight, in LaneCoverage seen, SharedLanes lanes, SearchRoute route)
    {
        IReadOnlyList<SkippedLane> skipped = _coverage.Receive(seen, lanes, route.Coverage);
        if (skipped.Count > 0)
            LeaveOut(flight, route, skipped);
    }

    // A vehicle that waits on the ground has no plan yet; what was seen then is not flown over again. Each message has
    // all that its sender knows of some lanes.
    private void KeepForPlan(in LaneCoverage seen, uint lanesKey)
    {
        bool isRoom = _seenBefore.Count < MaxSeenBefore || _seenBefore.ContainsKey(seen.FirstLane);
        if (isRoom && seen.LanesKey == lanesKey)
            _seenBefore[seen.FirstLane] = seen;
    }

    private uint KeyOf(MissionPlan mission)
    {
        if (!ReferenceEquals(mission, _keyed))
            (_keyed, _key) = (mission, MissionFingerprint.OfLanes(mission));
        return _key;
    }

    private double MetresLeftOf(byte systemId)
        => systemId == SystemId ? _own.MetresLeft : _members.Find(systemId)?.MetresLeft ?? 0;

    private LaneDivision DivisionOf(SharedLanes lanes) => new()
    {
        LanesKey = lanes.Key,
        Number = _division.Number,
        Shares = _division.Shares,
    };

    private static (ImmutableArray<LaneShare> Shares, bool IsEnough) Divide(
        MissionFlight flight, SharedLanes lanes, IReadOnlyList<(byte SystemId, GroupReport Report)> members)
    {
        double seen = SeenToEachSide(flight) / flight.Mission.HeightMetres;
        ImmutableArray<LaneShare> shares = LaneDivider.Divide(
            lanes.Lanes, lanes.MetresLeft, members.Select(m => MemberOf(flight, m, seen)).ToArray(), out bool isEnough);
        return (shares, isEnough);
    }

    // The others have cameras as ours: what they see differs by their heights.
    private static LaneDivider.Member MemberOf(
        MissionFlight flight, (byte SystemId, GroupReport Report) member, double seenToEachSidePerHeight)
    {
        GroupReport report = member.Report;
        PlanePoint landing = PlaceOf(flight, report.LandingPlace);
        double height = report.SearchAltitudeAmslMetres - report.LandingPlace.AltitudeAmslMetres;
        double climb = Math.Max(0, report.SearchAltitudeAmslMetres - report.Position.AltitudeAmslMetres);
        double seen = seenToEachSidePerHeight * height;
        return new LaneDivider.Member(
            member.SystemId, PlaceOf(flight, report.Position), report.SpeedMetresPerSecond,
            report.SearchTime.ExactSeconds, landing, (climb / ClimbMetresPerSecond) + (height / SinkMetresPerSecond),
            LaneThinning.LanesPerPass(seen, flight.Mission.LaneSpacingMetres));
    }

    private static PlanePoint PlaceOf(MissionFlight flight, GeodeticPosition position)
    {
        NedPosition at = flight.Plan!.Frame.ToNed(position);
        return new PlanePoint(at.North, at.East);
    }

    // 0 where that is not known.
    private static double SeenToEachSide(MissionFlight flight)
    {
        MissionPlan mission = flight.Mission;
        return flight.Options.SwathMetres?.Invoke(mission) is { } width
            ? Math.Max(0, (width / 2) - (LaneThinning.SwayFraction * mission.HeightMetres))
            : 0;
    }
}
