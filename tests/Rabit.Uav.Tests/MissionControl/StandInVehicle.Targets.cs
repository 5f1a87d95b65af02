using System;
using System.Linq;
using Rabit.Geodesy;
using Rabit.Uav.Messages;

namespace Rabit.Uav.Tests.MissionControl;

/// <summary>Its camera sees the ground below it, and its Sensor Fusion makes tracks of the targets there.</summary>
internal sealed partial class StandInVehicle
{
    private bool _hasReported;

    // A picture of 0.9 by 0.68 of the height to each side, twice a second.
    private void TakePicture()
    {
        if (_hasReported)
            PostTracks();
        _hasReported = false;
        _imagingCommand.Fetch();
        Imaging = _imagingCommand.Value;
        if (!CameraSees || _imagingCommand.Value.Mode == ImagingMode.Off || Now < _nextPicture)
            return;
        _nextPicture = Now + TimeSpan.FromSeconds(0.5);
        var observation = new CameraObservation
        {
            SourceSystemId = 1,
            Number = ++_picture,
            Time = Now,
            TopLeft = Corner(0.45, -0.6),
            TopRight = Corner(0.45, 0.6),
            BottomRight = Corner(-0.45, 0.6),
            BottomLeft = Corner(-0.45, -0.6),
            Reports = [.. Enumerable.Range(0, Targets.Count).Where(IsSeen).Select(ReportOf), .. MoverReports()],
        };
        Observations.Add(observation);
        _searched.Push(observation);
        SeeTargets();
        SeeMovers();
    }

    private GeodeticPosition Corner(double forward, double right)
    {
        double height = Height - Ground(North, East);
        double n = height * ((forward * Math.Cos(Yaw)) - (right * Math.Sin(Yaw)));
        double e = height * ((forward * Math.Sin(Yaw)) + (right * Math.Cos(Yaw)));
        return _frame.ToGeodetic(new NedPosition(North + n, East + e, 0));
    }

    private void SeeTargets()
    {
        bool isNews = false;
        for (int i = 0; i < Targets.Count; i++)
        {
            if (!IsSeen(i))
                continue;
            (double n, double e, TargetClassName colour) = Targets[i];
            isNews = true;
            int at = Tracks.FindIndex(t => t.Id == i + 1);
            int reports = at < 0 ? 1 : Tracks[at].Reports + 1;
            TargetTrack track = MakeTrack(i + 1, n, e, colour, reports);
            if (at < 0)
                Tracks.Add(track);
            else
                Tracks[at] = track;
        }

        if (isNews)
            PostTracks();
    }

    /// <summary>A track of its own pictures, in its next unit of work.</summary>
    public void Report(TargetTrack track)
    {
        Tracks.Add(track);
        _hasReported = true;
    }

    private bool IsSeen(int target)
    {
        (double n, double e, _) = Targets[target];
        double height = Height - Ground(North, East);
        double forward = ((n - North) * Math.Cos(Yaw)) + ((e - East) * Math.Sin(Yaw));
        double right = ((e - East) * Math.Cos(Yaw)) - ((n - North) * Math.Sin(Yaw));
        return Math.Abs(forward) <= 0.45 * height && Math.Abs(right) <= 0.6 * height;
    }

    private TargetReport ReportOf(int target) => new()
    {
        Class = Targets[target].Colour,
        Position = _frame.ToGeodetic(new NedPosition(Targets[target].North, Targets[target].East, 0)),
        PictureNumber = _picture,
        Index = target,
    };

    public TargetTrack MakeTrack(
        int id, double n, double e, TargetClassName colour, int reports, TrackState? state = null)
        => new()
        {
            Id = id,
            State = state ?? StateOf(id, reports),
            Decision = DecisionOf(id),
            Class = colour,
            Position = _frame.ToGeodetic(new NedPosition(n, e, 0)),
            Covariance = new HorizontalCovariance(1, 0, 1),
            Time = Now,
            Reports = reports,
            BestPictureNumber = _picture,
        };

    private void Decide(TrackDecision decision)
    {
        if (IgnoresDecisions)
            return;
        Decisions[decision.TrackId] = decision.Decision;
        for (int i = 0; i < Tracks.Count; i++)
        {
            NedPosition at = _frame.ToNed(Tracks[i].Position);
            if (Tracks[i].Id != decision.TrackId)
                continue;
            Tracks[i] = decision.TrackId >= FirstMoverTrack
                ? MoverTrack(decision.TrackId - FirstMoverTrack, decision.TrackId, Tracks[i].Reports)
                : MakeTrack(Tracks[i].Id, at.North, at.East, Tracks[i].Class, Tracks[i].Reports);
        }

        PostTracks();
    }

    private TargetDecision DecisionOf(int id)
        => Decisions.TryGetValue(id, out TargetDecision decision) ? decision : TargetDecision.None;

    private TrackState StateOf(int id, int reports)
        => !Decisions.TryGetValue(id, out TargetDecision decision)
            ? reports >= 3 ? TrackState.Confirmed : TrackState.Tentative
            : decision == TargetDecision.Rejected ? TrackState.Rejected : TrackState.Confirmed;

    private void PostTracks()
    {
        _tracks.Value = new TrackList(Now, Tracks.OrderBy(t => t.Id));
        _tracks.Post();
    }
}
