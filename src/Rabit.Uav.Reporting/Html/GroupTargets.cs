using System;
using System.Collections.Generic;
using System.Linq;
using Rabit.Uav.Messages;

namespace Rabit.Uav.Reporting.Html;

/// <summary>
/// A card for each target of a group: who found it, who validated it with which result, and what each vehicle saw of
/// it with its own camera.
/// </summary>
internal sealed class GroupTargets(PageWriter page, GroupFlightSummary data)
{
    private readonly TrackList _tracks = data.BestInformed.Flight.Record.Tracks;

    public void Write()
    {
        TargetTrack[] shown = ShownTracks();
        if (shown.Length == 0 && data.Score is null)
            return;
        page.Open("section").Element("h2", "Targets, and who validated them").Element(
            "p", $"As {GroupColours.Name(data.BestInformed.SystemId)} knows them, with its numbers; the pictures are "
                + "those of each vehicle's own camera, the whole picture and those beside it are of the first. One "
                + "that moves has a new number each time it comes into view. "
                + "Times are minutes and seconds since the start of the run.",
            "class", "note");
        page.Open("div", "class", "cards");
        foreach (TargetTrack track in shown)
            WriteTarget(track);
        foreach (TargetScore missed in data.Score?.Targets.Where(t => !t.IsFound) ?? [])
            WriteMissed(missed);
        page.Close();
        WriteOtherFollowings(shown);
        WriteOtherFalseTracks();
        page.Close();
    }

    // One that moves has a track for each time it came into view: there is one card for it, of the track that is the
    // true target where that is known, else of the newest one that is confirmed. What is false has its own.
    private TargetTrack[] ShownTracks()
    {
        var shown = new List<TargetTrack>();
        foreach (TargetTrack track in _tracks.Tracks.Where(t => t.State != TrackState.Tentative)
            .OrderByDescending(IsScored).ThenByDescending(t => t.State == TrackState.Confirmed)
            .ThenByDescending(t => t.LastSeen))
        {
            if (IsScored(track) || !shown.Exists(s => AreOneTarget(s, track)))
                shown.Add(track);
        }

        return shown.OrderBy(t => t.Id).ToArray();
    }

    private bool IsScored(TargetTrack track)
        => data.Score?.Targets.Any(s => s.Track == track) == true || IsFalse(track);

    private bool IsFalse(TargetTrack track) => data.Score?.FalseTracks.Contains(track) == true;

    private bool AreOneTarget(TargetTrack a, TargetTrack b)
        => !IsFalse(a) && data.FollowingsOf(a).Intersect(data.FollowingsOf(b)).Any();

    // Of those that only another vehicle has as a track.
    private void WriteOtherFollowings(TargetTrack[] shown)
    {
        FollowTask[] others = data.Followings.Except(shown.SelectMany(data.FollowingsOf)).ToArray();
        if (others.Length == 0)
            return;
        page.Open("ul", "class", "note");
        foreach (FollowTask task in others)
        {
            page.Element(
                "li", $"{TargetClassNames.Name(task.Class)} found by {GroupColours.Name(task.Finder)}, none of these "
                    + $"tracks; followed: {data.DescribeFollowing(task)}");
        }

        page.Close();
    }

    private void WriteOtherFalseTracks()
    {
        TargetTrack[] others = (data.Score?.FalseTracks ?? []).Where(t => !_tracks.Tracks.Contains(t)).ToArray();
        if (others.Length == 0)
            return;
        page.Open("ul", "class", "note");
        foreach (TargetTrack track in others)
        {
            GroupVehicleSummary? vehicle = data.Vehicles.FirstOrDefault(
                v => v.Flight.Record.Tracks.Tracks.Contains(track));
            string who = vehicle is null ? "another vehicle" : GroupColours.Name(vehicle.SystemId);
            page.Element(
                "li", $"{who} alone has a confirmed track of {TargetClassNames.Name(track.Class)} at "
                    + $"{TargetPlace.Decimal(track.Position)}, where there is no target");
        }

        page.Close();
    }

    private void WriteTarget(TargetTrack track)
    {
        TargetScore? target = data.Score?.Targets.FirstOrDefault(s => s.Track == track);
        ValidationTask? task = data.ValidationOf(track);
        (string state, string kind) = IsFalse(track) ? ("false", "false") : StateOf(task, track);
        page.OpenTargetCard(kind, FlightText.Number((long)track.Id), track.Class, state);
        WritePictures(track, task);
        page.Open("dl");
        if (target is not null)
        {
            page.Fact("is", target.Name);
            page.Fact("error", $"{FlightText.Number(target.ErrorMetres, "0.00")} m");
        }

        WriteValidation(task, track);
        page.Element("dt", "position").Open("dd").Element("span", TargetPlace.Decimal(track.Position), "class", "whole")
            .CopyButton(TargetPlace.Decimal(track.Position), "copy position").Close();
        page.Fact(
            "95 % ellipse",
            $"{FlightText.Number(track.Covariance.HalfMajorAxis95Metres, "0.0")} × "
                + $"{FlightText.Number(track.Covariance.HalfMinorAxis95Metres, "0.0")} m");
        page.Fact("seen", TimesOf(track));
        foreach (TargetTrack other in _tracks.Tracks.Where(
            t => t != track && t.State != TrackState.Tentative && !IsScored(t) && AreOneTarget(track, t)))
            page.Fact($"as track {FlightText.Number((long)other.Id)}", TimesOf(other));
        page.Close().Close();
    }

    private string TimesOf(TargetTrack track)
    {
        TimeSpan offset = data.BestInformed.ClockOffset;
        return $"{FlightText.Clock(offset + track.FirstSeen)} to {FlightText.Clock(offset + track.LastSeen)}";
    }

    private void WriteMissed(TargetScore target)
    {
        page.OpenTargetCard("missed", target.Name, target.Class, FlightText.ResultOf(target));
        page.Element(
            "p",
            target.IsRejected
                ? $"It was seen, and {FlightText.RejectedBy(target)} rejected its track."
                : "No vehicle has a confirmed track of this class within 10 m.",
            "class", "note").Close();
    }

    // Targets of a class that moves are not validated.
    private void WriteFollowing(TargetTrack track)
    {
        IReadOnlyList<FollowTask> tasks = data.FollowingsOf(track);
        page.Fact("followed", tasks.Count == 0 ? "no" : string.Join("; ", tasks.Select(data.DescribeFollowing)));
    }

    private void WriteValidation(ValidationTask? found, TargetTrack track)
    {
        if (found is not { } task)
        {
            if (track.Motion == TargetMotion.Standing)
                page.Fact("validation", "none was asked for");
            else
                WriteFollowing(track);
            return;
        }

        page.Fact("found by", GroupColours.Name(task.Finder));
        page.Fact("validated by", task.IsRejectedByOperator ? "none: rejected by the operator"
            : task.State == ValidationState.Closed
            ? $"{GroupColours.Name(task.Validator)}: {task.Result.ToString().ToLowerInvariant()}"
            : task.Validator == 0 ? "none: no vehicle could" : GroupColours.Name(task.Validator) + ": not finished");
    }

    // One that moves is lost once it is followed no longer: what counts is that it was.
    private (string State, string Kind) StateOf(ValidationTask? task, TargetTrack track) => task switch
    {
        { State: ValidationState.Closed, Result: ValidationResult.Confirmed } => ("validated", "found"),
        { State: ValidationState.Closed, Result: ValidationResult.Rejected } => ("rejected", "false"),
        null when track.State == TrackState.Rejected => ("rejected", "false"),
        null when data.FollowingsOf(track).Any(t => t.InView > TimeSpan.Zero || t.Result == FollowResult.Followed)
            => ("followed", "found"),
        null => (track.State == TrackState.Confirmed ? "found" : track.State.ToString().ToLowerInvariant(), "found"),
        _ => ("not validated", "found alone"),
    };

    // The best of each vehicle, of finder and validator first; of the first one more, and the whole picture.
    private void WritePictures(TargetTrack track, ValidationTask? task)
    {
        var views = data.Vehicles.Select((v, i) => (Vehicle: v, Index: i, Own: OwnTrack(v, track)))
            .Where(v => v.Own is not null && PicturesOf(v.Vehicle).HasBest(v.Own))
            .OrderBy(v => v.Vehicle.SystemId == task?.Finder ? 0 : v.Vehicle.SystemId == task?.Validator ? 1 : 2)
            .ToArray();
        if (views.Length == 0)
            return;
        page.Open("div", "class", "views");
        foreach ((GroupVehicleSummary vehicle, int index, TargetTrack? own) in views)
        {
            page.Open("figure");
            PicturesOf(vehicle).WriteBest(own!);
            page.Open("figcaption");
            GroupColours.WriteName(page, index, vehicle.SystemId);
            page.Close().Close();
        }

        page.Close();
        PicturesOf(views[0].Vehicle).WriteOthers(views[0].Own!);
    }

    private ReportPictures PicturesOf(GroupVehicleSummary vehicle)
        => new(page, vehicle.Flight.Record, $"the camera of {GroupColours.Name(vehicle.SystemId)}");

    // A vehicle's own track of a target, with a picture.
    private static TargetTrack? OwnTrack(GroupVehicleSummary vehicle, TargetTrack track)
        => vehicle.Flight.Record.Tracks.Tracks
            .Where(t => t.Class == track.Class && t.MarkerId == track.MarkerId && t.BestPictureNumber >= 0)
            .Where(t => TrackValidation.AreOnePlace(t.Position, track.Position))
            .OrderBy(t => TrackValidation.Metres(t.Position, track.Position)).FirstOrDefault();
}
